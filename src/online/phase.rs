//! A phase of constant jerk, and its evaluation.

use crate::real::{Real, target::keep_branch};
use crate::roots::root_between;
use crate::state::State;

/// A phase of constant jerk, and the state of the axis at its start.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Phase<R> {
    /// When it starts, s.
    pub start: R,
    /// How long it lasts, s.
    pub duration: R,
    /// Position at its start.
    pub position: R,
    /// Velocity at its start.
    pub velocity: R,
    /// Acceleration at its start.
    pub acceleration: R,
    /// The jerk.
    pub jerk: R,
}

impl<R: Real> Phase<R> {
    /// The time `x` of the move in the phase, s. The end has no duration: from there the axis moves on. A NaN and an infinite time are at
    /// the end, where a setpoint is finite.
    #[inline(always)]
    pub(super) fn time(&self, x: R) -> R {
        let passed = (x - self.start).at_least(R::ZERO);
        if self.duration > R::ZERO {
            passed.at_most(self.duration)
        } else if passed < R::INFINITY {
            keep_branch();
            passed
        } else {
            R::ZERO
        }
    }

    pub(crate) fn state(&self) -> State<R> {
        State { position: self.position, velocity: self.velocity, acceleration: self.acceleration }
    }

    #[inline(always)]
    pub(crate) fn position(&self, z: R) -> R {
        let Self { position, velocity, acceleration, jerk, .. } = *self;
        position + z * (velocity + z * (R::HALF * acceleration + z * jerk * R::SIXTH))
    }

    #[inline(always)]
    pub(crate) fn velocity(&self, z: R) -> R {
        let Self { velocity, acceleration, jerk, .. } = *self;
        velocity + z * (acceleration + R::HALF * z * jerk)
    }

    #[inline(always)]
    pub(crate) fn acceleration(&self, z: R) -> R {
        self.acceleration + z * self.jerk
    }

    /// Begins with the short phase `before`, of a move of the duration `t`. The phase stays if this changes an acceleration or a velocity by more
    /// than rounding, or if this rounding error may be beyond the range of the real type. Returns whether it begins there.
    pub(super) fn join(&mut self, before: &Self, t: R) -> bool {
        let shorter = before.duration;
        let acceleration = self.acceleration - shorter * self.jerk;
        let step = (acceleration - before.acceleration).abs();
        let step_behind = (self.acceleration - before.acceleration(shorter)).abs();
        let duration = shorter + self.duration;
        let size = acceleration.abs() + self.acceleration(self.duration).abs();
        // What the velocity changes by travels for the whole move.
        let fits = (size * duration * t).is_finite()
            && step <= R::from(16) * R::EPSILON * (size + self.jerk.abs() * t)
            && shorter / duration * (step + step_behind) <= R::from(8) * R::EPSILON * size;
        if fits {
            (self.start, self.duration, self.acceleration) = (before.start, duration, acceleration);
        }
        fits
    }

    /// When the axis gets to `position` between two times, if it does. It does not turn between them, and it is at `far` in the end.
    pub(super) fn time_between(&self, from: R, to: R, far: R, position: R) -> Option<R> {
        let direction = R::ONE.copysign(far - self.position(from));
        let beyond = |z: R| direction * (self.position(z) - position);
        let is_between = beyond(from) < R::ZERO && direction * (far - position) >= R::ZERO;
        is_between.then(|| root_between(from, to, |z| (beyond(z), direction * self.velocity(z))))
    }

    /// Whether the velocity may pass 0 in the phase before `next`: between its ends, or on the way to an extreme and back.
    pub(super) fn may_turn(&self, next: &Self) -> bool {
        let Self { velocity: v, acceleration: a, .. } = *self;
        v * next.velocity <= R::ZERO || v * a <= R::ZERO && a * self.acceleration(self.duration) < R::ZERO
    }

    /// Whether `z` is a time inside the phase.
    pub(super) fn lasts_beyond(&self, z: R) -> bool {
        z > R::ZERO && z < self.duration
    }

    /// Where the axis turns, in order: the times in the phase at which its velocity passes 0. Other values mean nothing.
    pub(crate) fn turns(&self) -> [R; 2] {
        let Self { velocity, acceleration, jerk, .. } = *self;
        let d = acceleration * acceleration - (velocity + velocity) * jerk;
        let sum = -(acceleration + d.sqrt().copysign(acceleration));
        let (one, other) = ((velocity + velocity) / sum, sum / jerk);
        if one < other { [one, other] } else { [other, one] }
    }
}

#[cfg(test)]
mod tests {
    use super::Phase;

    /// The acceleration steps from 1 down by ulps of it, and the shorter phase takes a part of the duration. A step is rounding up to 16 ulps of the
    /// accelerations at both ends, 32; what it changes the mean acceleration by is rounding up to 8.
    #[test]
    fn phases_with_a_step_of_rounding_are_joined() {
        let is_joined = |ulps: f64, part: f64| {
            let mut phase = Phase { acceleration: 1.0, duration: 1.0 - part, ..Phase::default() };
            let before = Phase { acceleration: 1.0 - ulps * f64::EPSILON, duration: part, ..Phase::default() };
            phase.join(&before, 1.0)
        };
        assert!(is_joined(24.0, 0.25) && !is_joined(24.0, 0.5) && !is_joined(40.0, 1e-6));
    }
}
