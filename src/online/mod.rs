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

pub use crate::findings::Error;
pub use crate::limits::Limits;
use crate::real::Real;
pub use crate::state::State;
pub use motion::Phase;

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
