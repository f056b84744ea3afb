//! What a filled double-S or trapezoid reaches, and what is wrong with it.

use super::trap::rise_and_fall;
use crate::findings::{Error, Extremes, Findings};
use crate::liba::{Bell, Trap, bell::motion::Phase, trap::motion::Phase as TrapPhase};
use crate::real::Real;
use crate::state::{Boundary, State};

impl<R: Real> Bell<R> {
    /// Examines the move against the magnitudes of `jerk`, `acceleration` and `velocity`; an infinite limit is no limit. Any plan may
    /// be examined, a plan of the C library's too. [`Error::NotFinite`] if a field is not finite or a limit is NaN.
    ///
    /// Up to 64 ulps are allowed: of |p| + |v| T for positions, of |v| + |a| T for velocities, of the limits for acceleration and jerk.
    ///
    /// ```
    /// use atraj::{Bell, Boundary, Findings};
    /// // One ramp covers the way, and liba's plan of it forgets the limit of the acceleration.
    /// let boundary = Boundary { p0: 0.0, p1: 10.0, v0: 7.5, v1: 0.0 };
    /// let plan = Bell::new(30.0, 2.5, 10.0, boundary).expect("a plan");
    /// assert_eq!(plan.check(30.0, 2.5, 10.0), Ok(Findings::EXCEEDS_ACCELERATION));
    /// let fastest = Bell::fastest(30.0, 2.5, 10.0, boundary)?;
    /// assert_eq!(fastest.check(30.0, 2.5, 10.0), Ok(Findings::OVERSHOOTS));
    /// # Ok::<(), atraj::Error>(())
    /// ```
    pub fn check(&self, jerk: R, acceleration: R, velocity: R) -> Result<Findings, Error> {
        let Self { t, tv, ta, td, taj, tdj, p0, p1, v0, v1, .. } = *self;
        let fields = [t, tv, ta, td, taj, tdj, p0, p1, v0, v1, self.vm, self.jm, self.am, self.dm];
        let limits @ [jm, am, vm] = [jerk, acceleration, velocity].map(|limit| limit.abs());
        Error::NotFinite.unless(fields.iter().all(|x| x.is_finite()) && limits.iter().all(|&x| x >= R::ZERO))?;
        let reached = self.extremes();
        let few = R::DOUBT; // 64 ulps
        let of_velocity = few * (reached.speed() + reached.acceleration() * t);
        let of_position = few * (p0.abs() + p1.abs() + reached.speed() * t);
        let jerk = if taj > R::ZERO || tdj > R::ZERO { self.jm.abs() } else { R::ZERO };
        Ok(Findings::EXCEEDS_JERK.when(jerk > jm + few * jm)
            | Findings::EXCEEDS_ACCELERATION.when(reached.acceleration() > am + few * am)
            | Findings::EXCEEDS_VELOCITY.when(reached.speed() > vm + of_velocity)
            | Findings::JUMPS.when(self.jumps(of_position, of_velocity))
            | Findings::OVERSHOOTS.when(reached.overshoots(p0, p1, of_position)))
    }

    /// The lowest and the highest position, velocity and acceleration between 0 and `t`.
    pub fn extremes(&self) -> Extremes<R> {
        let mut reached = Extremes::of(State { position: self.p0, velocity: self.v0, acceleration: R::ZERO });
        reached.include_position(self.p1);
        reached.include_velocity(self.v1);
        reached.include_velocity(self.orient(self.vm));
        if self.ta > R::ZERO {
            reached.include_acceleration(self.orient(self.jm * self.taj));
            reached.include_acceleration(self.orient(self.am));
        }
        if self.td > R::ZERO {
            reached.include_acceleration(self.orient(-self.jm * self.tdj));
            reached.include_acceleration(self.orient(self.dm));
        }
        // Where the velocity passes through 0 the axis turns.
        let Self { t, ta, td, taj, tdj, am, dm, .. } = *self;
        let turns = [
            self.turn(self.orient(self.v0), am, taj, ta),
            self.turn(self.orient(self.v1), -dm, tdj, td).map(|z| t - z),
        ];
        for x in turns.into_iter().flatten() {
            reached.include_position(self.position(x));
        }
        reached
    }

    /// When a ramp between `v` and `vm` passes through the velocity 0, counted from the end at `v`. The ramp lasts `duration`, each of
    /// its jerk parts `tj`, and reaches the acceleration `a`.
    fn turn(&self, v: R, a: R, tj: R, duration: R) -> Option<R> {
        let two = R::from(2);
        let passes_0 = v < R::ZERO && self.vm > R::ZERO || v > R::ZERO && self.vm < R::ZERO;
        passes_0.then_some(())?;
        let in_jerk_part = (-two * v / self.jm).sqrt();
        let in_hold = R::HALF * tj - v / a;
        if in_jerk_part <= tj {
            Some(in_jerk_part)
        } else if in_hold <= duration - tj {
            Some(in_hold)
        } else {
            Some(duration - (two * self.vm / self.jm).sqrt())
        }
    }

    /// Whether two phases disagree at their border by more than this rounding error, or the borders are not in order.
    fn jumps(&self, of_position: R, of_velocity: R) -> bool {
        let Self { t, tv, ta, td, taj, tdj, .. } = *self;
        let [p0, p1, v0, v1] = [self.p0, self.p1, self.v0, self.v1].map(|y| self.orient(y));
        let borders = [R::ZERO, taj, ta - taj, ta, ta + tv, t - td + tdj, t - tdj, t];
        let at = |phase, x| (self.position_in(phase, x, p0, p1, v0, v1), self.velocity_in(phase, x, v0, v1));
        let late = R::DOUBT * t;
        let in_order = borders.iter().zip(borders.iter().skip(1)).all(|(&x, &y)| x <= y + late);
        let mut meetings = borders.iter().zip(Phase::ALL.iter().zip(Phase::ALL.iter().skip(1)));
        let fits = |(&x, (&before, &after)): (&R, (&Phase, &Phase))| {
            let ((p, v), (q, w)) = (at(before, x), at(after, x));
            (p - q).abs() <= of_position && (v - w).abs() <= of_velocity
        };
        !(in_order && meetings.all(fits))
    }
}

impl<R: Real> Trap<R> {
    /// Examines the move against the magnitude of `velocity` and two accelerations of opposite signs, in either order; an infinite limit
    /// is no limit, and a limit of 0 allows none. Any plan may be examined, a plan of the C library's too. [`Error::NotFinite`] if a field is
    /// not finite or a limit is NaN; [`Error::Limits`] if both accelerations have one sign.
    ///
    /// Up to 64 ulps are allowed: of |p| + |v| T for positions, of |v| + |a| T for velocities, of the limits for acceleration.
    pub fn check(&self, velocity: R, acceleration: R, deceleration: R) -> Result<Findings, Error> {
        let Self { t, p0, p1, v0, v1, vc, ta, cruise_end, pa, pd, .. } = *self;
        let [rise, fall] = rise_and_fall(acceleration, deceleration);
        let vm = velocity.abs();
        let fields = [t, p0, p1, v0, v1, vc, ta, cruise_end, pa, pd, self.a0, self.a1];
        Error::NotFinite.unless(fields.iter().all(|x| x.is_finite()))?;
        let limits = [vm, rise, fall];
        if !limits.iter().all(|&x| x >= R::ZERO) {
            return Err(Error::of_plan(limits, Boundary { p0, p1, v0, v1 }, Error::Limits));
        }
        let reached = self.extremes();
        let few = R::DOUBT; // 64 ulps
        // The clock may pass a short ramp in no time, so the ramp counts though it is not among the extremes.
        let steepest = self.a0.abs().at_least(self.a1.abs());
        let of_velocity = few * (reached.speed() + steepest * t);
        let of_position = few * (p0.abs() + p1.abs() + reached.speed() * t);
        let (lowest, highest) = (reached.lowest.acceleration, reached.highest.acceleration);
        let steep = highest > rise + few * rise || -lowest > fall + few * fall;
        Ok(Findings::EXCEEDS_ACCELERATION.when(steep)
            | Findings::EXCEEDS_VELOCITY.when(reached.speed() > vm + of_velocity)
            | Findings::JUMPS.when(self.jumps(of_position, of_velocity))
            | Findings::OVERSHOOTS.when(reached.overshoots(p0, p1, of_position)))
    }

    /// The lowest and the highest position, velocity and acceleration between 0 and `t`.
    pub fn extremes(&self) -> Extremes<R> {
        let Self { t, v0, vc, ta, cruise_end, .. } = *self;
        let mut reached = Extremes::of(State {
            position: self.p0,
            velocity: v0,
            acceleration: if ta > R::ZERO { self.a0 } else { self.acceleration(R::ZERO) },
        });
        // The ends of the cruise, because the clock may pass a short ramp, and its turn, in no time.
        for position in [self.pa, self.pd, self.p1] {
            reached.include_position(position);
        }
        reached.include_velocity(vc);
        reached.include_velocity(self.v1);
        if cruise_end > ta {
            reached.include_acceleration(R::ZERO);
        }
        reached.include_acceleration(self.acceleration(t));
        // Where the velocity passes through 0 the axis turns.
        for (x, from, to) in [(-v0 / self.a0, R::ZERO, ta), (cruise_end - vc / self.a1, cruise_end, t)] {
            if x > from && x < to {
                reached.include_position(self.position(x));
            }
        }
        reached
    }

    /// Whether two phases disagree at their border by more than this rounding error, or the borders are not in order.
    fn jumps(&self, of_position: R, of_velocity: R) -> bool {
        let late = R::DOUBT * self.t;
        let in_order = self.ta >= R::ZERO && self.ta <= self.cruise_end + late && self.cruise_end <= self.t + late;
        let at = |phase, x| (self.position_in(phase, x), self.velocity_in(phase, x));
        let fits = |before, after, x| {
            let ((p, v), (q, w)) = (at(before, x), at(after, x));
            (p - q).abs() <= of_position && (v - w).abs() <= of_velocity
        };
        !(in_order
            && fits(TrapPhase::Before, TrapPhase::Accelerate, R::ZERO)
            && fits(TrapPhase::Accelerate, TrapPhase::Cruise, self.ta)
            && fits(TrapPhase::Cruise, TrapPhase::Decelerate, self.cruise_end)
            && fits(TrapPhase::Decelerate, TrapPhase::After, self.t))
    }
}
