//! What a planner answers: what it found, why there is no plan, and what a move reaches.

use crate::real::Real;
use crate::state::State;
use core::ops::{BitOr, BitOrAssign};

/// What a check found, as a set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Findings(u8);

impl Findings {
    /// The jerk is above its limit.
    pub const EXCEEDS_JERK: Self = Self(1);
    /// The acceleration is above its limit.
    pub const EXCEEDS_ACCELERATION: Self = Self(2);
    /// The velocity is above its limit.
    pub const EXCEEDS_VELOCITY: Self = Self(4);
    /// Position or velocity is not continuous, or not where the struct says.
    pub const JUMPS: Self = Self(8);
    /// The move leaves the positions between its ends.
    pub const OVERSHOOTS: Self = Self(16);
    /// The move starts outside its limits, or is bound to leave them.
    pub const STARTS_OUTSIDE: Self = Self(32);

    /// The set as the sum of 1, 2, 4, 8, 16 and 32; 0 for a clean move.
    pub const fn bits(self) -> u8 {
        self.0
    }

    pub(crate) fn when(self, found: bool) -> Self {
        if found { self } else { Self::default() }
    }
}

impl BitOr for Findings {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl BitOrAssign for Findings {
    fn bitor_assign(&mut self, other: Self) {
        *self = *self | other;
    }
}

/// Why there is no plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error {
    /// A number of a state is infinite or not a number, a limit is not a number, or the motion is beyond the range of the real type.
    NotFinite,
    /// The limits are not around 0, or neither jerk nor acceleration is finite.
    Limits,
    /// The target is outside the limits, or the axis must have left them before, or will.
    Target,
    /// The duration or the cycle is negative, infinite or not a number.
    Duration,
    /// The states of several axes do not lie on the straight line from their start to their end.
    Line,
    /// There is no axis, or the slices have different lengths.
    Axes,
}

/// The lowest and the highest position, velocity and acceleration of a move, each at its own time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes<R> {
    /// The lowest of each.
    pub lowest: State<R>,
    /// The highest of each.
    pub highest: State<R>,
}

impl<R: Real> Extremes<R> {
    /// The extremes of one state.
    pub(crate) fn of(state: State<R>) -> Self {
        Self {
            lowest: state,
            highest: state,
        }
    }

    pub(crate) fn include_position(&mut self, p: R) {
        include(&mut self.lowest.position, &mut self.highest.position, p);
    }

    pub(crate) fn include_velocity(&mut self, v: R) {
        include(&mut self.lowest.velocity, &mut self.highest.velocity, v);
    }

    pub(crate) fn include_acceleration(&mut self, a: R) {
        include(
            &mut self.lowest.acceleration,
            &mut self.highest.acceleration,
            a,
        );
    }

    /// The highest magnitude of the velocity.
    pub(crate) fn speed(&self) -> R {
        self.lowest
            .velocity
            .abs()
            .at_least(self.highest.velocity.abs())
    }

    /// The highest magnitude of the acceleration.
    pub(crate) fn acceleration(&self) -> R {
        self.lowest
            .acceleration
            .abs()
            .at_least(self.highest.acceleration.abs())
    }

    /// Whether the positions leave those between `p0` and `p1` by more than `rounding`.
    pub(crate) fn overshoots(&self, p0: R, p1: R, rounding: R) -> bool {
        let (near, far) = if p0 < p1 { (p0, p1) } else { (p1, p0) };
        self.lowest.position < near - rounding || self.highest.position > far + rounding
    }
}

fn include<R: Real>(lowest: &mut R, highest: &mut R, x: R) {
    if x < *lowest {
        *lowest = x;
    }
    if x > *highest {
        *highest = x;
    }
}
