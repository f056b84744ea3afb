//! The trapezoid that never fails: the fastest motion between two velocities within the limits.

use crate::findings::Error;
use crate::liba::Trap;
use crate::real::Real;
use crate::roots::larger_root;
use crate::state::{Boundary, Saturation, dips};

/// The magnitudes of two accelerations of opposite signs: of the positive one, and of the negative one.
pub(super) fn rise_and_fall<R: Real>(one: R, other: R) -> [R; 2] {
    if one > other { [one, -other] } else { [other, -one] }
}

impl<R: Real> Trap<R> {
    /// Plans the fastest move there is within the magnitude of `velocity` and two accelerations of opposite signs, in either order: the
    /// positive one limits the acceleration towards larger positions, the negative one the acceleration towards smaller ones.
    ///
    /// Boundary velocities beyond `±velocity` are limited to it. An infinite velocity means no limit. A target behind the axis, or nearer than
    /// the way to stop, is reached by turning. A move without displacement and without velocity has the duration 0.
    ///
    /// [`Error::Limits`] if a limit is 0, if both accelerations have one sign, or if an acceleration is infinite, because the velocity
    /// would jump; [`Error::NotFinite`] if an argument is not a number, or a position, the duration, or a
    /// velocity without a limit infinite; nothing else fails.
    ///
    /// ```
    /// use atraj::{Boundary, Trap};
    /// // 1 m to go at 4 m/s: too near to stop, so the axis passes the target and comes back.
    /// let trap = Trap::fastest(5.0, 4.0, -2.0, Boundary { p0: 0.0, p1: 1.0, v0: 4.0, v1: 0.0 })?;
    /// assert_eq!((trap.a0, trap.a1), (-2.0, 4.0));
    /// assert_eq!((trap.position(trap.t), trap.velocity(trap.t)), (1.0, 0.0));
    /// # Ok::<(), atraj::Error>(())
    /// ```
    #[inline(always)] // saves a copy of the struct, and the double-S, which wants the duration alone, the rest of the plan
    pub fn fastest(velocity: R, acceleration: R, deceleration: R, boundary: Boundary<R>) -> Result<Self, Error> {
        let vm = velocity.magnitude();
        let [rise, fall] = rise_and_fall(acceleration, deceleration);
        let Boundary { p0, p1, v0, v1 } = boundary.limit_velocities(vm, Saturation::Numbers);
        let limits = vm > R::ZERO && rise > R::ZERO && fall > R::ZERO;
        if !(limits && boundary.is_numbers() && rise.is_finite() && fall.is_finite()) {
            return Err(Error::of_plan([vm, rise, fall], boundary, Error::Limits));
        }
        let (h, dv) = (p1 - p0, v1 - v0);
        // The ramp that leads from the start straight to the end.
        let direct = (v0 + R::HALF * dv) * (dv.abs() / if dv < R::ZERO { fall } else { rise });
        let down_first = dips(h, direct, p0.abs() + p1.abs(), [v0, v1]);

        // In the axis in which the first ramp goes up.
        let [h, v0_up, v1_up] = [h, v0, v1].map(|x| x.negate_if(down_first));
        let (first, second) = if down_first { (fall, rise) } else { (rise, fall) };
        let mut up = (vm - v0_up) / first;
        let mut down = (vm - v1_up) / second;
        let by_way_of_vm = R::HALF * (v0_up + vm) * up + R::HALF * (v1_up + vm) * down;
        // Without a cruise the longer ramp is the unknown: the other one follows without losing digits.
        let (cruise, peak) = if h >= by_way_of_vm {
            ((h - by_way_of_vm) / vm, vm)
        } else if first < second {
            [up, down] = meeting_ramps(h, [v0_up, v1_up], first, second);
            (R::ZERO, v0_up + first * up)
        } else {
            [down, up] = meeting_ramps(h, [v1_up, v0_up], second, first);
            (R::ZERO, v1_up + second * down)
        };
        let [vc, a0, a1] = [peak, first, -second].map(|x| x.negate_if(down_first));
        let trap = Self {
            t: up + cruise + down,
            p0,
            p1,
            v0,
            v1,
            vc,
            ta: up,
            cruise_end: up + cruise,
            pa: p0 + v0 * up + R::HALF * a0 * up * up,
            pd: p1 - vc * down - R::HALF * a1 * down * down,
            a0,
            a1,
        };
        if trap.t.is_finite() && v0.is_finite() { Ok(trap) } else { Err(Error::NotFinite) }
    }
}

/// Durations of two ramps that meet at their highest velocity and together cover the displacement `h`: the first one from the velocity `v` at the
/// acceleration `first`, the second one to the velocity `end` at the deceleration `second`. The duration of the first ramp is the root of a quadratic.
fn meeting_ramps<R: Real>(h: R, [v, end]: [R; 2], first: R, second: R) -> [R; 2] {
    let (ratio, dv) = (first / second, end - v);
    let offset = dv / second;
    let beyond = h + offset * (v + R::HALF * dv);
    let t = larger_root(v / first, -(beyond + beyond) / (first * (R::ONE + ratio)));
    // Where the first ramp is the direct one, the root may come out shorter than the ramp by rounding.
    let t = t.at_least((dv / first).at_least(R::ZERO));
    [t, (ratio * t - offset).at_least(R::ZERO)]
}
