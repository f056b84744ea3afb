//! `atraj/clock.h`: the clock of a path.

use super::r#move::{atraj_limits, atraj_move};
use super::{ATRAJ_ERR_NULL, code, write};
use crate::capi::{Number, a_float, assert_same_layout, nan};
use crate::findings::Findings;
use crate::machine::clock::Clock;
use crate::online::{Limits, Move};
use core::ffi::c_int;

/// @brief The time of a path as a move itself. Its members are the library's own.
#[repr(C)]
pub struct atraj_clock {
    /// when the last change of the rate began, s
    pub begin: a_float,
    /// the time of the path since then
    pub time: atraj_move,
}
assert_same_layout!(atraj_clock, Clock<Number>, begin time);

/// @brief Start a clock at the time 0. It runs as planned: its time is the time of the path.
/// @param ctx points to a clock, which need not be initialised; nothing happens if it is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_clock_start(ctx: *mut atraj_clock) {
    if !ctx.is_null() {
        // SAFETY: `ctx` is writable by the contract of this module, and the layouts are the same.
        unsafe { ctx.cast::<Clock<Number>>().write(Clock::new()) };
    }
}

/// @brief Go to another rate: 1 as planned, 0 hold, 1/2 override, -1 back along the path.
///
/// Until the end of the path, or until its start if the rate is negative, no axis exceeds its limits, nothing jumps, and the path is kept. This is proved
/// for each part of the motion, not sampled. So the limits must be larger than the limits of the plans, by a reserve for the clock.
/// @param ctx points to a clock; untouched on an error
/// @param moves points to `sections * n` moves, section by section: of all axes for the first section, then of all axes for the second one. Each move begins where
/// the move of its axis before it ends, and the moves of a section have one duration, as `atraj_moves_sync` and `atraj_moves_line` plan them.
/// @param limits points to the limits of the `n` axes, which are the limits of their plans and a reserve
/// @param n number of axes
/// @param sections number of sections; 1 for a single set of moves
/// @param x time since the start of the clock, s, not before the last change
/// @param rate of the time of the path
/// @return 0; else an `atraj_error`: `ATRAJ_ERR_NULL` also if `n` or `sections` is 0, `ATRAJ_ERR_NOT_FINITE`, `ATRAJ_ERR_LIMITS` also if no axis moves or all limits of an
/// acceleration or a jerk are infinite, or `ATRAJ_ERR_TARGET` if no change within the limits is found
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_clock_rate(
    ctx: *mut atraj_clock,
    moves: *const atraj_move,
    limits: *const atraj_limits,
    n: usize,
    sections: usize,
    x: a_float,
    rate: a_float,
) -> c_int {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let clock = unsafe { ctx.cast::<Clock<Number>>().as_mut() };
    let (Some(clock), false, false) = (clock, moves.is_null(), limits.is_null()) else {
        return ATRAJ_ERR_NULL as c_int;
    };
    // SAFETY: not NULL, so each points to as many values by the contract of this module; the layouts are the same.
    let (moves, limits) = unsafe {
        (
            core::slice::from_raw_parts(moves.cast::<Move<Number>>(), n.wrapping_mul(sections)),
            core::slice::from_raw_parts(limits.cast::<Limits<Number>>(), n),
        )
    };
    let changed = clock.rate(moves, limits, x.into(), rate.into());
    code(changed.map(|()| Findings::default()))
}

/// @brief When the last rate is reached.
/// @param ctx points to a clock
/// @return time since the start of the clock, s; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_clock_until(ctx: *const atraj_clock) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Clock<Number>>().as_ref() } {
        Some(clock) => clock.until().into(),
        None => nan(),
    }
}

/// @brief The time of the path.
/// @param ctx points to a clock
/// @param x time since the start of the clock, s
/// @return time since the start of the path, s; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_clock_time(ctx: *const atraj_clock, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Clock<Number>>().as_ref() } {
        Some(clock) => clock.time(x.into()).into(),
        None => nan(),
    }
}

/// @brief State of an axis of the path: position, velocity, acceleration and jerk.
/// @param ctx points to a clock; if it is NULL, all results are NaN
/// @param moves points to the move of the axis in the first section, `moves + axis` of `atraj_clock_rate`; if it is NULL, all results are NaN
/// @param n number of axes: the next move of the axis is `n` moves behind
/// @param sections number of sections; all results are NaN if `n` or `sections` is 0
/// @param x time since the start of the clock, s
/// @param pos position, unit: NULL or the place for the result
/// @param vel velocity, unit/s: NULL or the place for the result
/// @param acc acceleration, unit/s^2: NULL or the place for the result
/// @param jer jerk, unit/s^3: NULL or the place for the result
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_clock_state(
    ctx: *const atraj_clock,
    moves: *const atraj_move,
    n: usize,
    sections: usize,
    x: a_float,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
    jer: *mut a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let clock = unsafe { ctx.cast::<Clock<Number>>().as_ref() };
    let state = match clock {
        Some(clock) if !(moves.is_null() || n == 0 || sections == 0) => {
            let count = n.wrapping_mul(sections - 1).wrapping_add(1);
            // SAFETY: not NULL, and the axis has a move in each section by the contract of this module; the layouts are the same.
            let moves = unsafe { core::slice::from_raw_parts(moves.cast::<Move<Number>>(), count) };
            clock.state(moves, n, x.into()).map(Into::into)
        }
        _ => [a_float::NAN; 4],
    };
    // SAFETY: each output is NULL or writable by the contract of this module.
    unsafe { write([pos, vel, acc, jer], state) };
}
