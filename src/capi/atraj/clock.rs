//! `atraj/clock.h`: the clock of a path.

use super::r#move::{atraj_limits, atraj_move};
use super::{answer, list, write};
use crate::capi::{Number, a_float, assert_same_layout, of, of_mut, value};
use crate::machine::Clock;
use core::ffi::{c_int, c_uint};

/// @brief The time of a path as a move itself. Its members are the library's own.
#[repr(C)]
pub struct atraj_clock {
    /// when the last change of the rate begins, s
    pub begin: a_float,
    /// when the rate is reached, s
    pub reached: a_float,
    /// when the change before the last one began, s
    pub begin_before: a_float,
    /// 1 if `time` is the position of the lead, else 0
    pub is_led: c_uint,
    /// 1 if `before` is the position of the lead, else 0
    pub was_led: c_uint,
    /// the time of the path since the last change
    pub time: atraj_move,
    /// the time of the path before the last change
    pub before: atraj_move,
    /// the move of the lead, if the axes stop on a straight line
    pub lead: atraj_move,
}
assert_same_layout!(atraj_clock, Clock<Number>, begin reached = until begin_before is_led was_led time before lead);

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
/// Until the end of the path, or until its start if the rate is negative, no axis exceeds its limits, nothing jumps,
/// and the path is kept. This is proved for each part of the motion, not sampled. So the limits must be larger than the
/// limits of the plans, by a reserve for the clock. At an end where the path is at rest its time stands still.
/// @param moves points to `sections * n` moves, section by section: of all axes for the first section, then of all axes
/// for the second one. Each move begins where the move of its axis before it ends, and the moves of a section have one
/// duration, as `atraj_moves_sync` and `atraj_moves_line` plan them.
/// @param limits points to the limits of the `n` axes, which are the limits of their plans and a reserve
/// @param sections number of sections; 1 for a single set of moves
/// @param time since the start of the clock, s. It may be ahead: until then the clock goes on as it did. Only one
/// change can wait
/// @return 0, or `ATRAJ_RATE_NOT_REACHED` if the path ends before; else an `atraj_error`: `ATRAJ_ERR_NULL` also if `n` or
/// `sections` is 0, `ATRAJ_ERR_NOT_FINITE`, `ATRAJ_ERR_LIMITS`, `ATRAJ_ERR_LATE` if `time` is before the last change, or
/// `ATRAJ_ERR_TARGET` if the clock can neither change within the limits nor go on to the end of the path, or if the
/// rate is negative and the path begins in motion
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_clock_rate(
    ctx: *mut atraj_clock, moves: *const atraj_move, limits: *const atraj_limits, n: usize, sections: usize,
    time: a_float, rate: a_float,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    answer(|| unsafe {
        let moves = list(moves, n.wrapping_mul(sections));
        Some(of_mut(ctx)?.rate(moves?, list(limits, n)?, time.into(), rate.into()))
    })
}

/// @brief When the last rate is reached: time since the start of the clock, s. If it is not reached, the end of the path.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_clock_until(ctx: *const atraj_clock) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    value(unsafe { of(ctx) }, Clock::until)
}

/// @brief Make `time` the new 0 of the clock: after hours a `float` resolves the time too coarsely.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_clock_rebase(ctx: *mut atraj_clock, time: a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    if let Some(clock) = unsafe { of_mut(ctx) } {
        clock.rebase(time.into());
    }
}

/// @brief The time of the path, s since its start, at `time` of the clock. Until the first change it is `time`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_clock_time(ctx: *const atraj_clock, time: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    value(unsafe { of(ctx) }, |clock| clock.time(time.into()))
}

/// @brief State of an axis of the path at `time` of the clock: position, velocity, acceleration and jerk.
/// @param moves points to the move of the axis in the first section, `moves + axis` of `atraj_clock_rate`
/// @param n number of axes: the next move of the axis is `n` moves later
/// @param sections number of sections. All results are NaN if `n` or `sections` is 0, or `ctx` or `moves` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_clock_state(
    ctx: *const atraj_clock, moves: *const atraj_move, n: usize, sections: usize, time: a_float, pos: *mut a_float,
    vel: *mut a_float, acc: *mut a_float, jer: *mut a_float,
) {
    let has_moves = n > 0 && sections > 0;
    let count = n.wrapping_mul(sections.wrapping_sub(1)).wrapping_add(1);
    // SAFETY: the pointers are NULL or valid, and the axis has a move in each section, by the contract of this module.
    unsafe {
        let given = of(ctx).filter(|_| has_moves).and_then(|clock| Some((clock, list(moves, count)?)));
        write([pos, vel, acc, jer], given.map(|(clock, moves)| clock.state(moves, n, time.into())));
    }
}
