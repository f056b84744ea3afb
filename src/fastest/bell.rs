//! The double-S that never fails: the fastest motion between two velocities within the limits.

use super::border::ScaledBorder;
use crate::findings::Error;
use crate::liba::{Bell, Trap};
use crate::real::{Real, target};
use crate::state::{Boundary, Saturation, dips};

impl<R: Real> Bell<R> {
    /// Plans the fastest move there is within the magnitudes of `jerk`, `acceleration` and `velocity`; their signs are ignored.
    ///
    /// Boundary velocities beyond `±velocity` are limited to it. An infinite limit is no limit. A jerk, or both accelerations, are finite. A target behind
    /// the axis, or nearer than it can stop, is reached by turning back. A move without displacement and without velocity has the duration 0.
    ///
    /// [`Error::Limits`] if a limit is 0, or these are all infinite; [`Error::NotFinite`] if an argument is not a
    /// number, or a position, the duration, or a velocity without a limit infinite; nothing else fails.
    ///
    /// ```
    /// use atraj::{Bell, Boundary, online::Error};
    /// // 0.1 m to go at 2 m/s: too near to stop, so the axis passes the target and comes back.
    /// let boundary = Boundary { p0: 0.0, p1: 0.1, v0: 2.0, v1: 0.0 };
    /// assert_eq!(Bell::new(30.0, 10.0, 5.0, boundary), Err(Error::Unreachable));
    /// let bell = Bell::fastest(30.0, 10.0, 5.0, boundary).expect("the arguments are numbers");
    /// assert_eq!((bell.position(bell.t), bell.velocity(bell.t)), (0.1, 0.0));
    /// ```
    pub fn fastest(jerk: R, acceleration: R, velocity: R, boundary: Boundary<R>) -> Result<Self, Error> {
        let (jm, am, vm) = (jerk.magnitude(), acceleration.magnitude(), velocity.magnitude());
        let limits_are_positive = jm > R::ZERO && am > R::ZERO && vm > R::ZERO;
        let limits_an_acceleration = jm < R::INFINITY || am < R::INFINITY;
        if !(limits_are_positive && limits_an_acceleration && boundary.is_numbers()) {
            return Err(Error::of_plan([jm, am, vm], boundary, Error::Limits));
        }
        let boundary = boundary.limit_velocities(vm, Saturation::Numbers);
        let Boundary { p0, p1, v0, v1 } = boundary;
        if p0 == p1 && v0 == v1 {
            let bell = Self { p0, p1, v0, v1, vm: v0, ..Self::default() };
            return if v0.is_finite() { Ok(bell) } else { Err(Error::NotFinite) };
        }
        let mut jm = Self::resolved_jerk(jm, am, vm, boundary);
        let mut bell = Self::default();
        // A second time if a jerk part is too short for the clock. One call of `within` keeps the struct in registers.
        for _ in 0..2 {
            bell = Self::within(jm, am, vm, boundary);
            let part = Self::shortest_part(bell.t);
            if am >= R::HALF * jm * part {
                break;
            }
            jm = am / part;
        }
        // Between equal velocities the direct ramp takes no time. Else a move takes some, unless its jerk is below the range of the real type.
        let is_there = (p1 - p0).abs() <= R::DOUBT * p0.abs() + R::DOUBT * p1.abs() && v0 == v1 && v0.is_finite();
        let lasts = bell.t > R::ZERO || is_there;
        if lasts && bell.t.is_finite() { Ok(bell) } else { Err(Error::NotFinite) }
    }

    /// The shortest jerk part that the clock of a move of this duration resolves. A shorter one would show as a spike in the evaluated acceleration.
    fn shortest_part(duration: R) -> R {
        R::from(8) * R::EPSILON * duration
    }

    /// `jm`, or the jerk for the duration of the trapezoid, if `jm` is so high that the two moves hardly differ.
    fn resolved_jerk(jm: R, am: R, vm: R, boundary: Boundary<R>) -> R {
        let Boundary { p0, p1, v0, v1 } = boundary;
        let tj = am / jm;
        let blink = R::from(16) * R::EPSILON;
        let is_blink = tj * am <= blink * (v0.abs() + v1.abs()) || tj * tj * am <= blink * blink * (p1 - p0).abs();
        if !is_blink {
            return jm;
        }
        let trap = Trap::fastest(vm, am, -am, boundary);
        trap.map_or(jm, |trap| (am / Self::shortest_part(trap.t)).at_most(jm))
    }

    /// The fastest move; the jerk is finite.
    fn within(jm: R, am: R, vm: R, boundary: Boundary<R>) -> Self {
        let Boundary { p0, p1, v0, v1 } = boundary;
        let [h, forward_v0, forward_v1] = target::forward(p1 - p0, v0, v1);
        // A product takes a fraction of the time of a quotient.
        let per_jerk = R::ONE / jm;
        let limit = am * per_jerk;
        // A limit whose square is out of range is never reached.
        let limit = if limit * limit < R::INFINITY { limit } else { R::INFINITY };
        let border = ScaledBorder { v0: forward_v0 * per_jerk, dv: (forward_v1 - forward_v0) * per_jerk, limit };
        let h = h * per_jerk;
        let direct = border.direct();
        let positions = (p0.abs() + p1.abs()) * per_jerk;
        let dips = dips(h, direct, positions, [forward_v0, forward_v1]);
        let border = if dips { border.mirrored() } else { border };
        let [h, direct, from] = [h, direct, forward_v0].map(|x| x.negate_if(dips));

        let (by_way_of_vm, cruise_from) = border.by_way_of((vm - from) * per_jerk);
        let ([up, down], cruise, peak) = if h >= cruise_from {
            (by_way_of_vm, (h - cruise_from) / (vm * per_jerk), vm)
        } else {
            let [up, down] = border.first_over(h, direct);
            ([up, down], R::ZERO, from + jm * up.tj * (up.t - up.tj))
        };
        Self {
            t: up.t + cruise + down.t,
            tv: cruise,
            ta: up.t,
            td: down.t,
            taj: up.tj,
            tdj: down.tj,
            p0,
            p1,
            v0,
            v1,
            vm: peak.negate_if(dips),
            jm: jm.negate_if(dips),
            am: (jm * up.tj).negate_if(dips),
            dm: (-jm * down.tj).negate_if(dips),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::liba::Bell;
    use crate::state::Boundary;

    #[test]
    fn the_shortest_jerk_part_lasts_8_ulps_of_the_duration() {
        let boundary = Boundary { p0: 0.0, p1: 1.0, v0: 0.0, v1: 0.0 };
        let bell = Bell::fastest(f64::INFINITY, 1.0, 9.0, boundary).expect("a plan");
        assert!((bell.taj / (bell.t * f64::EPSILON) - 8.0).abs() < 0.1);
    }
}
