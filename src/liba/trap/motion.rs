//! The three phases of the trapezoid, and position, velocity and acceleration in each.

use super::Trap;
use crate::real::Real;
use crate::sampling::{Edge, Run, Sampled, in_phase, sampled};

/// The three phases in order of time, each with its interval, and the standstill around them.
#[derive(Clone, Copy)]
pub(crate) enum Phase {
    /// `x <= 0`.
    Before,
    /// `0 < x < ta`.
    Accelerate,
    /// `ta <= x < cruise_end`.
    Cruise,
    /// `cruise_end <= x < t`.
    Decelerate,
    /// `x >= t`.
    After,
}

impl<R: Real> Trap<R> {
    /// Position at time `x`, s. Before the start and for a NaN it is `p0`, after the end `p1`.
    pub fn position(&self, x: R) -> R {
        self.position_in(self.phase(x), x)
    }

    /// Velocity at time `x`, s. Before the start and for a NaN it is `v0`, after the end `v1`.
    pub fn velocity(&self, x: R) -> R {
        self.velocity_in(self.phase(x), x)
    }

    /// Acceleration at time `x`, s, both ends included. Outside the move and for a NaN it is 0.
    pub fn acceleration(&self, x: R) -> R {
        if x < self.ta {
            if x >= R::ZERO { self.a0 } else { R::ZERO }
        } else if x >= self.cruise_end && x <= self.t {
            self.a1
        } else {
            R::ZERO
        }
    }

    sampled! { 3, "Position, velocity and acceleration" }

    /// The phase of position and velocity at `x`.
    #[inline(always)]
    fn phase(&self, x: R) -> Phase {
        if x >= self.ta {
            if x < self.cruise_end {
                Phase::Cruise
            } else if x < self.t {
                Phase::Decelerate
            } else {
                Phase::After
            }
        } else if x > R::ZERO {
            Phase::Accelerate
        } else {
            Phase::Before
        }
    }

    #[inline(always)]
    pub(crate) fn position_in(&self, phase: Phase, x: R) -> R {
        match phase {
            Phase::Before => self.p0,
            Phase::Accelerate => self.p0 + self.v0 * x + R::HALF * self.a0 * x * x,
            Phase::Cruise => self.pa + self.vc * (x - self.ta),
            Phase::Decelerate => {
                let z = x - self.cruise_end;
                self.pd + self.vc * z + R::HALF * self.a1 * z * z
            }
            Phase::After => self.p1,
        }
    }

    #[inline(always)]
    pub(crate) fn velocity_in(&self, phase: Phase, x: R) -> R {
        match phase {
            Phase::Before => self.v0,
            Phase::Accelerate => self.v0 + self.a0 * x,
            Phase::Cruise => self.vc,
            Phase::Decelerate => self.vc + self.a1 * (x - self.cruise_end),
            Phase::After => self.v1,
        }
    }
}

impl<R: Real> Sampled<R, 3, 7> for Trap<R> {
    fn borders(&self) -> [Edge<R>; 7] {
        let Self { t, ta, cruise_end, .. } = *self;
        [
            Edge::Below(R::ZERO),
            Edge::UpTo(R::ZERO),
            Edge::Below(ta),
            Edge::Below(cruise_end),
            Edge::Below(t),
            Edge::UpTo(t),
            // A NaN counts as before the start, and this border tells it from a time after the end.
            Edge::UpTo(R::INFINITY),
        ]
    }

    fn each(&self, x: R) -> [R; 3] {
        [self.position(x), self.velocity(x), self.acceleration(x)]
    }

    fn together(&self, x: R) -> [R; 3] {
        let acceleration = self.acceleration(x);
        in_phase!(self.phase(x), PHASE of Before Accelerate Cruise Decelerate After => [
            self.position_in(PHASE, x),
            self.velocity_in(PHASE, x),
            acceleration,
        ])
    }

    fn fill(&self, run: Run<'_, R, 3>) {
        let trap = *self;
        let acceleration = trap.acceleration(run.x);
        in_phase!(trap.phase(run.x), PHASE of Before Accelerate Cruise Decelerate After => run.fill(|x| [
            trap.position_in(PHASE, x),
            trap.velocity_in(PHASE, x),
            acceleration,
        ]))
    }
}
