//! `atraj.h`: what liba does not have.

mod axes;
mod bell;
mod r#move;
mod poly;
mod sample;
mod trap;

pub use axes::*;
pub use bell::*;
pub use r#move::*;
pub use poly::*;
pub use sample::*;
pub use trap::*;

use super::{Number, a_float};
use crate::findings::{Extremes, Findings};

/// Bits of what a check finds.
#[repr(C)]
pub enum atraj_finding {
    /// the jerk is above its limit
    ATRAJ_EXCEEDS_JERK = 1,
    /// the acceleration is above its limit
    ATRAJ_EXCEEDS_ACCELERATION = 2,
    /// the velocity is above its limit
    ATRAJ_EXCEEDS_VELOCITY = 4,
    /// position or velocity is not continuous, or not where the struct says
    ATRAJ_JUMPS = 8,
    /// the move leaves the positions between its ends
    ATRAJ_OVERSHOOTS = 16,
    /// the move starts outside its limits, or is bound to leave them
    ATRAJ_STARTS_OUTSIDE = 32,
}

/// What a function returns that cannot answer.
#[repr(C)]
pub enum atraj_error {
    /// a pointer is NULL, or there is no axis
    ATRAJ_ERR_NULL = -1,
    /// a number is infinite or not a number, a limit is not a number, or the move is beyond the range of `a_float`
    ATRAJ_ERR_NOT_FINITE = -2,
    /// the limits are not around 0, or none of jerk and acceleration is finite
    ATRAJ_ERR_LIMITS = -3,
    /// the target is outside the limits, or the axis must have left them before, or will
    ATRAJ_ERR_TARGET = -4,
    /// the duration or the cycle is negative, infinite or not a number
    ATRAJ_ERR_DURATION = -5,
    /// the states do not lie on the straight line from start to end
    ATRAJ_ERR_LINE = -6,
}
use atraj_error::*;

const _: () = assert!(
    atraj_finding::ATRAJ_EXCEEDS_JERK as u8 == Findings::EXCEEDS_JERK.bits()
        && atraj_finding::ATRAJ_EXCEEDS_ACCELERATION as u8 == Findings::EXCEEDS_ACCELERATION.bits()
        && atraj_finding::ATRAJ_EXCEEDS_VELOCITY as u8 == Findings::EXCEEDS_VELOCITY.bits()
        && atraj_finding::ATRAJ_JUMPS as u8 == Findings::JUMPS.bits()
        && atraj_finding::ATRAJ_OVERSHOOTS as u8 == Findings::OVERSHOOTS.bits()
        && atraj_finding::ATRAJ_STARTS_OUTSIDE as u8 == Findings::STARTS_OUTSIDE.bits()
);

/// Writes the extremes where an output is not NULL.
///
/// # Safety
/// Each output is NULL or has room for three values.
unsafe fn write_extremes(extremes: Extremes<Number>, lowest: *mut a_float, highest: *mut a_float) {
    for (output, state) in [(lowest, extremes.lowest), (highest, extremes.highest)] {
        if !output.is_null() {
            let values = [state.position, state.velocity, state.acceleration].map(Into::into);
            // SAFETY: by the contract of this function.
            unsafe { output.cast::<[a_float; 3]>().write(values) };
        }
    }
}
