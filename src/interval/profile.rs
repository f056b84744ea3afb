//! The acceleration of a motion on the border.

use super::ramp::{PerJerk, Ramp};
use crate::real::Real;

/// The acceleration of a motion on the border: it rises, (holds), falls, (holds) and rises. Where the axis cruises, the fall pauses at 0.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Profile<R> {
    /// The profile belongs to the mirrored axis.
    pub mirrored: bool,
    /// How far the acceleration rises at the start.
    pub first: R,
    /// The acceleration after the first rise.
    pub peak: R,
    /// How long the peak holds, s.
    pub top: R,
    /// How far the acceleration falls in the middle.
    pub fall: R,
    /// How long the fall pauses at 0, with the highest velocity, s.
    pub cruise: R,
    /// The acceleration after the fall.
    pub trough: R,
    /// How long the trough holds, s.
    pub bottom: R,
    /// How far the acceleration rises at the end.
    pub last: R,
}

impl<R: Real> Profile<R> {
    /// Makes it the motion in the other order of time.
    #[inline(never)] // for its size: it is asked in several places
    pub fn reverse(&mut self) {
        (self.first, self.last) = (self.last, self.first);
        (self.peak, self.trough) = (-self.trough, -self.peak);
        (self.top, self.bottom) = (self.bottom, self.top);
    }

    /// The ramp that the motion is, if one of its rises has no duration.
    pub fn as_ramp(&self) -> Ramp<R> {
        let ramp = if self.first > R::ZERO {
            Ramp { mirrored: false, rise: self.first, peak: self.peak, hold: self.top, fall: self.fall }
        } else {
            Ramp { mirrored: true, rise: self.fall, peak: -self.trough, hold: self.bottom, fall: self.last }
        };
        ramp.mirrored_if(self.mirrored)
    }

    /// Makes it fall by `x` more. The first rise grows by `more` and the last one by `rest`, which are `x` in sum. Each number grows by
    /// itself, because a small peak after a long rise has a smaller rounding error than the rise.
    pub fn fall_by(&mut self, x: R, more: R, rest: R) {
        (self.first, self.peak) = (self.first + more, self.peak + more);
        self.fall = self.fall + x;
        (self.trough, self.last) = (self.trough - rest, self.last + rest);
    }

    /// Duration of the motion, s. The jerks belong to the profile's axis.
    pub fn duration(&self, per_jerk: PerJerk<R>) -> R {
        per_jerk.gu * (self.first + self.last) + per_jerk.gd * self.fall + (self.top + self.cruise + self.bottom)
    }
}

/// A phase of constant jerk whose place in the move is not known yet.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Segment<R> {
    /// Acceleration at the start.
    pub from: R,
    pub jerk: R,
    /// s
    pub duration: R,
}

impl<R: Real> Segment<R> {
    pub fn new(from: R, jerk: R, duration: R) -> Self {
        Self { from, jerk, duration }
    }

    /// Position and velocity at the start, from both at the end.
    pub fn start(&self, position: R, velocity: R) -> (R, R) {
        let Self { from, jerk, duration: t } = *self;
        let to = from + jerk * t;
        let sum = from + to;
        // In the other order of time, accelerations have the other sign.
        let displacement = t * (velocity - R::SIXTH * (t * (to + sum)));
        (position - displacement, velocity - R::HALF * t * sum)
    }
}

pub(crate) const MOST_SEGMENTS: usize = 7;
