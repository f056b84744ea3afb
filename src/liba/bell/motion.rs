//! The seven phases of the double-S, and position, velocity, acceleration and jerk in each.

use super::Bell;
use crate::real::Real;
use crate::sampling::{Edge, Run, Sampled, in_phase};

/// The seven phases in order of time, each with its interval and its jerk, and the standstill around them.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Phase {
    /// `x <= 0`: no jerk.
    Before,
    /// `0 < x < taj`: jerk `jm`.
    AccelerationRises,
    /// `taj <= x < ta - taj`: no jerk.
    AccelerationHolds,
    /// `ta - taj <= x < ta`: jerk `-jm`.
    AccelerationFalls,
    /// `ta <= x < ta + tv`: no jerk.
    Cruise,
    /// `ta + tv <= x < t - td + tdj`: jerk `-jm`.
    DecelerationRises,
    /// `t - td + tdj <= x < t - tdj`: no jerk.
    DecelerationHolds,
    /// `t - tdj <= x < t`: jerk `jm`.
    DecelerationFalls,
    /// `x >= t`: no jerk.
    After,
}

impl Phase {
    pub(crate) const ALL: [Self; 9] = [
        Self::Before,
        Self::AccelerationRises,
        Self::AccelerationHolds,
        Self::AccelerationFalls,
        Self::Cruise,
        Self::DecelerationRises,
        Self::DecelerationHolds,
        Self::DecelerationFalls,
        Self::After,
    ];
}

impl<R: Real> Bell<R> {
    /// Position at time `x`, s. Before the start it is `p0`, after the end and for a NaN `p1`.
    pub fn position(&self, x: R) -> R {
        let Self { p0, p1, v0, v1, .. } = *self;
        if self.is_backward() {
            -self.forward_position(x, -p0, -p1, -v0, -v1)
        } else {
            self.forward_position(x, p0, p1, v0, v1)
        }
    }

    /// Velocity at time `x`, s. Before the start it is `v0`, after the end and for a NaN `v1`.
    pub fn velocity(&self, x: R) -> R {
        let Self { v0, v1, .. } = *self;
        if self.is_backward() { -self.forward_velocity(x, -v0, -v1) } else { self.forward_velocity(x, v0, v1) }
    }

    /// Acceleration at time `x`, s. Outside the move and for a NaN it is 0.
    pub fn acceleration(&self, x: R) -> R {
        match self.phase(x, is_not_from) {
            Phase::Before | Phase::Cruise | Phase::After => R::ZERO,
            phase => self.orient(self.forward_acceleration_in(phase, x)),
        }
    }

    /// Jerk at time `x`, s, both ends included. Outside the move and for a NaN it is 0.
    pub fn jerk(&self, x: R) -> R {
        // Rounding may make neighbouring borders cross. The order of these questions is the C function's.
        let jerk = if x < self.ta {
            if x >= self.ta - self.taj {
                -self.jm
            } else if x < self.taj && x >= R::ZERO {
                self.jm
            } else {
                return R::ZERO;
            }
        } else if x < self.t - self.td + self.tdj {
            if x >= self.ta + self.tv {
                -self.jm
            } else {
                return R::ZERO;
            }
        } else if x <= self.t && x >= self.t - self.tdj {
            self.jm
        } else {
            return R::ZERO;
        };
        self.orient(jerk)
    }

    fn is_backward(&self) -> bool {
        self.p0 > self.p1
    }

    fn forward_position(&self, x: R, p0: R, p1: R, v0: R, v1: R) -> R {
        self.position_in(self.phase(x, is_below), x, p0, p1, v0, v1)
    }

    fn forward_velocity(&self, x: R, v0: R, v1: R) -> R {
        self.velocity_in(self.phase(x, is_below), x, v0, v1)
    }

    /// A computed value of the forward axis in the caller's axis.
    pub(crate) fn orient(&self, y: R) -> R {
        y.negate_if(self.is_backward())
    }

    /// The phase at `x`; `is_ahead(x, border)` decides whether a border is ahead of `x`. The quantities ask in different ways, which
    /// differ where a border is NaN.
    // Each caller has its own copy: the phase becomes a place in the code instead of a value.
    #[inline(always)]
    fn phase(&self, x: R, is_ahead: impl Fn(R, R) -> bool) -> Phase {
        if x < self.ta {
            if is_ahead(x, self.taj) {
                if x <= R::ZERO { Phase::Before } else { Phase::AccelerationRises }
            } else if x < self.ta - self.taj {
                Phase::AccelerationHolds
            } else {
                Phase::AccelerationFalls
            }
        } else if x < self.t - self.td + self.tdj {
            if is_ahead(x, self.ta + self.tv) { Phase::Cruise } else { Phase::DecelerationRises }
        } else if x < self.t {
            if x < self.t - self.tdj { Phase::DecelerationHolds } else { Phase::DecelerationFalls }
        } else {
            Phase::After
        }
    }

    /// Position in the forward axis. The time `z` counts from the border that the formula of the phase refers to.
    #[inline(always)]
    pub(crate) fn position_in(&self, phase: Phase, x: R, p0: R, p1: R, v0: R, v1: R) -> R {
        match phase {
            Phase::Before => p0,
            Phase::AccelerationRises => p0 + v0 * x + jerk_distance(self.jm, x),
            Phase::AccelerationHolds => p0 + v0 * x + ramp_distance(self.am, x, self.taj),
            Phase::AccelerationFalls => {
                let z = x - self.ta;
                self.cruise_line(p0, v0, self.ta, z) - jerk_distance(self.jm, z)
            }
            Phase::Cruise => self.cruise_line(p0, v0, self.ta, x - self.ta),
            Phase::DecelerationRises => {
                let z = x - (self.t - self.td);
                self.cruise_line(p1, v1, -self.td, z) - jerk_distance(self.jm, z)
            }
            Phase::DecelerationHolds => {
                let z = x - (self.t - self.td);
                self.cruise_line(p1, v1, -self.td, z) + ramp_distance(self.dm, z, self.tdj)
            }
            Phase::DecelerationFalls => {
                let z = x - self.t;
                p1 + v1 * z + jerk_distance(self.jm, z)
            }
            Phase::After => p1,
        }
    }

    /// Position on the line of the cruise phase at the time `z` from its border with a ramp. The ramp lasts `duration` and has the
    /// position `p` and the velocity `v` at its other end.
    fn cruise_line(&self, p: R, v: R, duration: R, z: R) -> R {
        p + R::HALF * (self.vm + v) * duration + self.vm * z
    }

    /// Velocity in the forward axis.
    #[inline(always)]
    pub(crate) fn velocity_in(&self, phase: Phase, x: R, v0: R, v1: R) -> R {
        match phase {
            Phase::Before => v0,
            Phase::AccelerationRises => v0 + jerk_velocity(self.jm, x),
            Phase::AccelerationHolds => v0 + self.am * (x - R::HALF * self.taj),
            Phase::AccelerationFalls => self.vm - jerk_velocity(self.jm, x - self.ta),
            Phase::Cruise => self.vm,
            Phase::DecelerationRises => self.vm - jerk_velocity(self.jm, x - (self.t - self.td)),
            Phase::DecelerationHolds => self.vm + self.dm * (x - self.t + self.td - R::HALF * self.tdj),
            Phase::DecelerationFalls => v1 + jerk_velocity(self.jm, x - self.t),
            Phase::After => v1,
        }
    }

    /// Acceleration in the forward axis.
    #[inline(always)]
    fn forward_acceleration_in(&self, phase: Phase, x: R) -> R {
        match phase {
            Phase::Before | Phase::Cruise | Phase::After => R::ZERO,
            Phase::AccelerationRises => self.jm * x,
            Phase::AccelerationHolds => self.am,
            Phase::AccelerationFalls => -self.jm * (x - self.ta),
            Phase::DecelerationRises => -self.jm * (x - self.t + self.td),
            Phase::DecelerationHolds => self.dm,
            Phase::DecelerationFalls => self.jm * (x - self.t),
        }
    }

    /// Position and velocity in the forward axis, acceleration and jerk in the caller's axis.
    #[inline(always)]
    fn forward_state(&self, x: R, p0: R, p1: R, v0: R, v1: R) -> [R; 4] {
        in_phase!(self.phase(x, is_below), PHASE of Before AccelerationRises AccelerationHolds AccelerationFalls Cruise
            DecelerationRises DecelerationHolds DecelerationFalls After => [
            self.position_in(PHASE, x, p0, p1, v0, v1),
            self.velocity_in(PHASE, x, v0, v1),
            self.acceleration(x),
            self.jerk(x),
        ])
    }
}

impl<R: Real> Sampled<R, 4, 10> for Bell<R> {
    fn borders(&self) -> [Edge<R>; 10] {
        let Self { t, tv, ta, td, taj, tdj, .. } = *self;
        [
            Edge::Below(R::ZERO),
            Edge::UpTo(R::ZERO),
            Edge::Below(taj),
            Edge::Below(ta - taj),
            Edge::Below(ta),
            Edge::Below(ta + tv),
            Edge::Below(t - td + tdj),
            Edge::Below(t - tdj),
            Edge::Below(t),
            Edge::UpTo(t),
        ]
    }

    fn each(&self, x: R) -> [R; 4] {
        [self.position(x), self.velocity(x), self.acceleration(x), self.jerk(x)]
    }

    #[inline(always)]
    fn together(&self, x: R) -> [R; 4] {
        let Self { p0, p1, v0, v1, .. } = *self;
        if self.is_backward() {
            let [p, v, a, j] = self.forward_state(x, -p0, -p1, -v0, -v1);
            [-p, -v, a, j]
        } else {
            self.forward_state(x, p0, p1, v0, v1)
        }
    }

    fn fill(&self, run: Run<'_, R, 4>) {
        let bell = *self;
        let phase = bell.phase(run.x, is_below);
        if phase != bell.phase(run.x, is_not_from) {
            return run.fill(|x| bell.each(x));
        }
        // Products with the direction turn the ends once, and the results without a branch. The factors of accelerations are turned once.
        let direction = bell.orient(R::ONE);
        let [p0, p1, v0, v1] = [bell.p0, bell.p1, bell.v0, bell.v1].map(|y| direction * y);
        let [jm, am, dm] = [bell.jm, bell.am, bell.dm].map(|y| direction * y);
        let turned = Self { jm, am, dm, ..bell };
        let jerk = bell.jerk(run.x);
        in_phase!(phase, PHASE of Before AccelerationRises AccelerationHolds AccelerationFalls Cruise
            DecelerationRises DecelerationHolds DecelerationFalls After => run.fill(|x| [
            direction * bell.position_in(PHASE, x, p0, p1, v0, v1),
            direction * bell.velocity_in(PHASE, x, v0, v1),
            turned.forward_acceleration_in(PHASE, x),
            jerk,
        ]))
    }
}

/// How position and velocity ask for a border: a NaN is not ahead.
fn is_below<R: Real>(x: R, border: R) -> bool {
    x < border
}

/// How acceleration asks for a border: a NaN is ahead.
#[expect(clippy::neg_cmp_op_on_partial_ord, reason = "a NaN border is ahead")]
fn is_not_from<R: Real>(x: R, border: R) -> bool {
    !(x >= border)
}

// Where the original has the time until a border, these have a negative time since it. Rounding knows no sign and neither time
// is 0, so the bits are the same.

/// Distance that the jerk `j` adds in the time `z`.
fn jerk_distance<R: Real>(j: R, z: R) -> R {
    j * z * z * z / R::from(6)
}

/// Velocity that the jerk `j` adds in the time `z`.
fn jerk_velocity<R: Real>(j: R, z: R) -> R {
    R::HALF * j * z * z
}

/// Distance that a ramp to the acceleration `a` adds in the time `z`, of which its jerk part took `tj`.
fn ramp_distance<R: Real>(a: R, z: R, tj: R) -> R {
    let three_z = R::from(3) * z;
    a * (three_z * z - three_z * tj + tj * tj) / R::from(6)
}
