//! One axis from any state to any state, planned in motion.
//!
//! [`Move::plan`] finds the fastest motion within limits of velocity, acceleration and jerk. It fails for no state that is made of
//! numbers: a start outside the limits comes inside in the fastest way, a target behind is reached by turning.
//!
//! ```
//! use atraj::online::{Limits, Move, State};
//! let limits = Limits::symmetric(30.0, 10.0, 5.0);
//! let mut axis = Move::default();
//! axis.plan(&limits, State::at(0.0), State::at(10.0)).expect("numbers");
//! // In mid-motion, another target.
//! let now = axis.state_at(0.7);
//! axis.plan(&limits, now, State::at(-2.0)).expect("numbers");
//! assert_eq!(axis.position(axis.t), -2.0);
//! ```

mod border;
mod motion;
mod part;
pub(crate) mod plan;

use crate::real::Real;
pub use crate::state::State;
pub use motion::Phase;

/// What an axis can do. The highest values are above 0, the lowest ones below 0. An infinite limit is no limit, but the jerk or the
/// acceleration is finite.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Limits<R> {
    /// Highest velocity.
    pub vmax: R,
    /// Lowest velocity, negative.
    pub vmin: R,
    /// Highest acceleration.
    pub amax: R,
    /// Lowest acceleration, negative.
    pub amin: R,
    /// Highest jerk.
    pub jmax: R,
    /// Lowest jerk, negative.
    pub jmin: R,
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

/// A move: phases of constant jerk from one state to another.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Move<R> {
    /// Duration, s.
    pub t: R,
    /// Number of phases.
    pub phases: u32,
    /// The phases in order of time. Behind the last one is a phase without duration, the end.
    pub phase: [Phase<R>; 16],
}

impl<R: Real> Default for Move<R> {
    fn default() -> Self {
        Self {
            t: R::ZERO,
            phases: 0,
            phase: [Phase::default(); 16],
        }
    }
}

impl<R: Real> State<R> {
    /// At rest.
    pub fn at(position: R) -> Self {
        Self {
            position,
            velocity: R::ZERO,
            acceleration: R::ZERO,
        }
    }
}

impl<R: Real> Limits<R> {
    /// The same limits in both directions, in liba's order.
    pub fn symmetric(jerk: R, acceleration: R, velocity: R) -> Self {
        let [j, a, v] = [jerk, acceleration, velocity].map(|limit| limit.magnitude());
        Self {
            vmax: v,
            vmin: -v,
            amax: a,
            amin: -a,
            jmax: j,
            jmin: -j,
        }
    }
}

impl<R: Real> Move<R> {
    /// Position, velocity and acceleration at time `x`, s: the start of another plan.
    pub fn state_at(&self, x: R) -> State<R> {
        let [position, velocity, acceleration, _] = self.state(x);
        State {
            position,
            velocity,
            acceleration,
        }
    }
}
