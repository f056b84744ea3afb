//! `atraj/codes.h`: what the functions of `atraj.h` find and refuse.

use crate::capi::assert_named;
use crate::findings::{Error, Findings, NOTHING};
use core::ffi::{c_char, c_int};

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
    /// the move leaves the positions between its ends by more than rounding: by more than 128 ulps in a plan between any states, 64 in
    /// a check; a rounding is `a_float`'s epsilon times `|p0| + |p1| + v*t`, with the highest speed `v`; such a
    /// plan counts no more than four times its way for `v*t`
    ATRAJ_OVERSHOOTS = 16,
    /// the move starts outside its limits, or will unavoidably exceed them
    ATRAJ_STARTS_OUTSIDE = 32,
    /// the axis will unavoidably exceed its limits after the move: the acceleration at the end does not vanish at once
    ATRAJ_ENDS_LEAVING = 64,
    /// the path ends before its clock has the rate
    ATRAJ_RATE_NOT_REACHED = 128,
}
use atraj_finding::*;

/// Why a function failed.
#[repr(C)]
#[derive(Clone, Copy)]
pub enum atraj_error {
    /// a pointer is NULL, or there is no axis
    ATRAJ_ERR_NULL = -1,
    /// a number is infinite or not a number, a limit is not a number, or the move is beyond the range of `a_float`
    ATRAJ_ERR_NOT_FINITE = -2,
    /// a limit is 0 or has the wrong sign or order, neither a jerk nor both accelerations are finite, or a step or damping is out of range
    ATRAJ_ERR_LIMITS = -3,
    /// the target is outside the limits, or the axis must have left them before
    ATRAJ_ERR_TARGET = -4,
    /// a duration, cycle, period, horizon or frequency is out of range, or a duration is too short for the motion
    ATRAJ_ERR_DURATION = -5,
    /// the states do not lie on the straight line from start to end
    ATRAJ_ERR_LINE = -6,
    /// the axis leaves the positions between which it has to stay
    ATRAJ_ERR_POSITION = -7,
    /// the tick at which the plan was to take over has begun, or is too far ahead, or a change of a clock is before the last one
    ATRAJ_ERR_LATE = -8,
    /// for your program, where `a_trajbell_gen` or `a_trajtrap_gen` returns 0: no function returns this code
    ATRAJ_ERR_UNREACHABLE = -9,
    /// this needs an axis at rest
    ATRAJ_ERR_MOVING = -10,
}
pub(super) use atraj_error::*;

assert_named! { Findings::MEMBERS;
    Findings::EXCEEDS_JERK.bits() => ATRAJ_EXCEEDS_JERK,
    Findings::EXCEEDS_ACCELERATION.bits() => ATRAJ_EXCEEDS_ACCELERATION,
    Findings::EXCEEDS_VELOCITY.bits() => ATRAJ_EXCEEDS_VELOCITY,
    Findings::JUMPS.bits() => ATRAJ_JUMPS,
    Findings::OVERSHOOTS.bits() => ATRAJ_OVERSHOOTS,
    Findings::STARTS_OUTSIDE.bits() => ATRAJ_STARTS_OUTSIDE,
    Findings::ENDS_LEAVING.bits() => ATRAJ_ENDS_LEAVING,
    Findings::RATE_NOT_REACHED.bits() => ATRAJ_RATE_NOT_REACHED,
}
assert_named! { Error::ALL;
    Error::Axes => ATRAJ_ERR_NULL,
    Error::NotFinite => ATRAJ_ERR_NOT_FINITE,
    Error::Limits => ATRAJ_ERR_LIMITS,
    Error::Target => ATRAJ_ERR_TARGET,
    Error::Duration => ATRAJ_ERR_DURATION,
    Error::Line => ATRAJ_ERR_LINE,
    Error::Position => ATRAJ_ERR_POSITION,
    Error::Late => ATRAJ_ERR_LATE,
    Error::Unreachable => ATRAJ_ERR_UNREACHABLE,
    Error::Moving => ATRAJ_ERR_MOVING,
}

/// @brief The English sentence for a code, for a log or a display.
///
/// A sum of findings has a sentence for each finding, gravest first:
/// `for (; code > 0; code &= code - 1) puts(atraj_message(code));`
/// @param code what a function returned: 0, an `atraj_finding`, a sum of findings, or an `atraj_error`
/// @return a static string, never NULL; of a sum the sentence of the lowest finding; else "this code is unknown"
#[unsafe(no_mangle)]
pub extern "C" fn atraj_message(code: c_int) -> *const c_char {
    let sentence = match code {
        0 => Some(NOTHING),
        1.. => Findings::MEMBERS.iter().find(|row| code & c_int::from(row.0.bits()) != 0).map(|row| row.2),
        _ => Error::ALL.iter().find(|row| code == row.0 as c_int).map(|row| row.1),
    };
    sentence.unwrap_or(c"this code is unknown").as_ptr()
}
