//! `atraj/steps.h`: the times at which a stepper motor steps.

use super::r#move::{atraj_move, atraj_phase, atraj_state};
use super::{answer, done, put};
use crate::capi::{Number, a_float, assert_same_layout, of, of_mut};
use crate::machine::{StepStream, Steps};
use core::ffi::{c_int, c_uint};

/// @brief The steps of a motor that follows a move. Copy it to look ahead.
#[repr(C)]
pub struct atraj_steps {
    /// position of line 0, unit
    pub offset: a_float,
    /// from one line to the next, unit
    pub step: a_float,
    /// the library's own
    pub from: a_float,
    /// the library's own
    pub to: a_float,
    /// the line of the motor: the steps up less the steps down, from the line at the start on
    pub count: c_int,
    /// the library's own
    pub far: c_int,
    /// the library's own
    pub phase: c_uint,
}
assert_same_layout!(atraj_steps, Steps<Number>, offset step from to count far phase);

/// @brief Begin with the steps of a move. The motor stands at the last line that is not above the start.
/// @param offset position of line 0, unit; half a step more or less keeps the motor within half a step of the axis
/// @param step from one line to the next, unit
/// @return 0; else an `atraj_error`: `ATRAJ_ERR_NULL`, `ATRAJ_ERR_LIMITS` if `step` is not above 0, or
/// `ATRAJ_ERR_NOT_FINITE`, also if the move goes further from `offset` than 1000000000 steps, in `float` 8388608
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_steps_init(
    ctx: *mut atraj_steps, r#move: *const atraj_move, offset: a_float, step: a_float,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { put(ctx, || Some(Steps::new(of(r#move)?, offset.into(), step.into()))) }
}

/// @brief Go on with another move from its start, and keep the motor where it is. So no step is lost where the moves meet: a line between
/// the motor and the start is passed at the time 0.
/// @return 0; else an `atraj_error`: `ATRAJ_ERR_NULL`, or `ATRAJ_ERR_NOT_FINITE` as in `atraj_steps_init`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_steps_follow(ctx: *mut atraj_steps, next: *const atraj_move) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    answer(|| unsafe { done(of_mut(ctx)?.follow(of(next)?)) })
}

/// @brief The next step until the end of the move.
///
/// The motor steps up when the axis passes the next line, and down when the axis passes the line of the motor on its way back. No
/// time is before the time of the step before, and after the last step the motor is at the line of the end.
/// @param move points to the move that the steps belong to
/// @param time NULL or the place for the time of the step since the start of the move, s; untouched if there is no step
/// @return 1 for a step towards larger positions, -1 for one back, 0 if there is no step any more or a pointer is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_steps_next(
    ctx: *mut atraj_steps, r#move: *const atraj_move, time: *mut a_float,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    let Some(step) = (unsafe { of_mut(ctx).zip(of(r#move)).and_then(|(steps, of)| steps.next(of)) }) else { return 0 };
    // SAFETY: `time` is NULL or writable by the contract of this module.
    unsafe { super::write([time], Some([step.time])) };
    step.direction
}

/// @brief The steps of a motor that follows a stream of states, one a tick, whatever makes them. Its members are the library's own.
#[repr(C)]
pub struct atraj_step_stream {
    /// from one tick to the next, s
    pub period: a_float,
    /// the least time between two steps, s
    pub between: a_float,
    /// the least time before a step in the other direction, s
    pub reversal: a_float,
    /// when the last step was, s after the start of this tick
    pub last: a_float,
    /// of the last step: 1, -1, or 0 before the first one
    pub direction: c_int,
    /// the lines of the motor
    pub steps: atraj_steps,
    /// the motion in this tick
    pub phase: atraj_phase,
    /// the state at its end
    pub end: atraj_state,
}
assert_same_layout!(atraj_step_stream, StepStream<Number>, period between reversal last direction steps phase end);

/// @brief Begin with the steps of a stream of states. The motor is at the nearest step, and stays within half a step.
/// @param step travel per step, unit
/// @param period from one tick to the next, s
/// @param now points to the state of the stream
/// @return 0; else an `atraj_error`: `ATRAJ_ERR_NULL`, `ATRAJ_ERR_LIMITS` if `step` is not above 0, `ATRAJ_ERR_DURATION`
/// if the period is not above 0 or not finite, or `ATRAJ_ERR_NOT_FINITE`, also if the position is further from 0 than
/// 1000000000 steps, in `float` 8388608
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_step_stream_init(
    ctx: *mut atraj_step_stream, step: a_float, period: a_float, now: *const atraj_state,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { put(ctx, || Some(StepStream::new(step.into(), period.into(), *of(now)?))) }
}

/// @brief Keep a least time between two steps, and before a step in the other direction: what the driver of the motor
/// needs. A step for which there is no time in its tick waits for the next one.
/// @param between least time between two steps, s
/// @param reversal least time before a step in the other direction and before the first one, s
/// @return 0; else an `atraj_error`: `ATRAJ_ERR_NULL`, or `ATRAJ_ERR_DURATION` if a time is negative or not finite
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_step_stream_wait(
    ctx: *mut atraj_step_stream, between: a_float, reversal: a_float,
) -> c_int {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    answer(|| unsafe { done(of_mut(ctx)?.wait(between.into(), reversal.into())) })
}

/// @brief Begin a tick. Steps that were not fetched in the tick before come at once, so no step is lost.
/// @param now points to the state of the stream at the end of the tick
/// @return 0; else `ATRAJ_ERR_NULL`, or `ATRAJ_ERR_NOT_FINITE` as in `atraj_step_stream_init`; then the tick does not begin
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_step_stream_tick(ctx: *mut atraj_step_stream, now: *const atraj_state) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    answer(|| unsafe { done(of_mut(ctx)?.tick(*of(now)?)) })
}

/// @brief The next step of the tick.
/// @param time NULL or the place for the time of the step since the start of the tick, s; untouched if there is no step
/// @return 1 for a step towards larger positions, -1 for one back, 0 if there is no step any more or `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_step_stream_next(ctx: *mut atraj_step_stream, time: *mut a_float) -> c_int {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let Some(step) = (unsafe { of_mut(ctx).and_then(StepStream::next) }) else { return 0 };
    // SAFETY: `time` is NULL or writable by the contract of this module.
    unsafe { super::write([time], Some([step.time])) };
    step.direction
}

/// @brief Where the motor is, in steps from 0: the steps up less the steps down, and where it began. 0 if `ctx` is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_step_stream_count(ctx: *const atraj_step_stream) -> c_int {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { of(ctx) }.map_or(0, StepStream::count)
}
