//! `atraj/move.h`: several axes that move together.

use super::r#move::{atraj_limits, atraj_move, atraj_state};
use super::{ATRAJ_ERR_NULL, array, code};
use crate::capi::{Number, a_float};
use crate::findings::Findings;
use crate::online::{Error, Limits, Move, State};
use crate::together;
use core::ffi::c_int;

/// @brief Plan several axes for the same duration: the shortest one that is possible for each.
///
/// The duration is at least `duration` and a multiple of `cycle`, up to rounding. An axis whose fastest move takes as long makes its
/// fastest move. From rest to rest an axis with more time makes its fastest move in slow motion. Any other axis with more time cruises at
/// one velocity, where this is possible.
/// One axis alone is stretched, or ends on a tick of the clock.
/// @param axes points to `n` moves, which need not be initialised; all are untouched on an error
/// @param limits points to the limits of the `n` axes
/// @param from points to the `n` states at the start
/// @param to points to the `n` states at the end
/// @param n number of axes
/// @param duration least duration, s; 0: as short as can be
/// @param cycle period of the clock, s; 0: any duration
/// @return 0, or a sum of `ATRAJ_OVERSHOOTS`, `ATRAJ_STARTS_OUTSIDE` and `ATRAJ_ENDS_LEAVING`; else the `atraj_error` of an axis,
/// `ATRAJ_ERR_DURATION` if `duration` or `cycle` is negative, infinite or not a number, or `ATRAJ_ERR_NULL` if a pointer is NULL or `n` is 0
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_moves_sync(
    axes: *mut atraj_move,
    limits: *const atraj_limits,
    from: *const atraj_state,
    to: *const atraj_state,
    n: usize,
    duration: a_float,
    cycle: a_float,
) -> c_int {
    // SAFETY: both functions have the same contract.
    unsafe {
        plan(
            together::synchronise,
            axes,
            limits,
            from,
            to,
            n,
            duration,
            cycle,
        )
    }
}

/// @brief Plan several axes on the straight line from their start to their end: the fastest motion on it.
///
/// The axis with the longest way leads, within the tightest limits of all. The duration is at least `duration` and a multiple of `cycle`, but
/// for rounding.
/// @param axes points to `n` moves, which need not be initialised; all are untouched on an error
/// @param limits points to the limits of the `n` axes
/// @param from points to the `n` states at the start
/// @param to points to the `n` states at the end
/// @param n number of axes
/// @param duration least duration, s; 0: as short as can be
/// @param cycle period of the clock, s; 0: any duration
/// @return as `atraj_moves_sync`; `ATRAJ_ERR_LINE` if the velocities and accelerations do not point along the line
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_moves_line(
    axes: *mut atraj_move,
    limits: *const atraj_limits,
    from: *const atraj_state,
    to: *const atraj_state,
    n: usize,
    duration: a_float,
    cycle: a_float,
) -> c_int {
    // SAFETY: both functions have the same contract.
    unsafe { plan(together::line, axes, limits, from, to, n, duration, cycle) }
}

/// @brief Plan several axes for the same duration, each between its own lowest and highest position.
///
/// As `atraj_moves_sync`. An axis that would leave its positions on a slower way makes its fastest move and waits, or it stops, waits and
/// goes. Where it has no time to stop on its way, all axes take longer.
/// @param axes points to `n` moves, which need not be initialised; all are untouched on an error
/// @param limits points to the limits of the `n` axes
/// @param from points to the `n` states at the start
/// @param to points to the `n` states at the end
/// @param lowest points to the `n` lowest positions, unit; an infinite one is no limit
/// @param highest points to the `n` highest positions, unit; an infinite one is no limit
/// @param n number of axes
/// @param duration least duration, s; 0: as short as can be
/// @param cycle period of the clock, s; 0: any duration
/// @return as `atraj_moves_sync` and `atraj_move_within`: `ATRAJ_ERR_POSITION` if the fastest move of an axis leaves its positions, or if the
/// axis cannot stop between them
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_moves_sync_within(
    axes: *mut atraj_move,
    limits: *const atraj_limits,
    from: *const atraj_state,
    to: *const atraj_state,
    lowest: *const a_float,
    highest: *const a_float,
    n: usize,
    duration: a_float,
    cycle: a_float,
) -> c_int {
    if lowest.is_null() || highest.is_null() {
        return ATRAJ_ERR_NULL as c_int;
    }
    // SAFETY: not NULL, so each points to `n` numbers by the contract of this module; the layouts are the same.
    let positions = unsafe {
        [lowest, highest].map(|list| core::slice::from_raw_parts(list.cast::<Number>(), n))
    };
    // SAFETY: both functions have the same contract.
    unsafe {
        plan(
            |axes, limits, from, to, duration, cycle| {
                together::synchronise_within(axes, limits, from, to, positions, duration, cycle)
            },
            axes,
            limits,
            from,
            to,
            n,
            duration,
            cycle,
        )
    }
}

/// @brief Stop axes that move on a straight line, on this line: a feed hold. Each move becomes its stop, which begins at its time 0.
///
/// The axis with the longest way makes its fastest stop within the tightest limits of all. So no reserve is needed.
/// @param axes points to `n` planned moves on a straight line; all are untouched on an error
/// @param limits points to the limits of the `n` axes
/// @param n number of axes
/// @param x time since the start of the moves, s
/// @return as `atraj_move_stop`; `ATRAJ_ERR_LINE` if the moves are not on one straight line, `ATRAJ_ERR_NULL` also if `n` is 0
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_moves_line_stop(
    axes: *mut atraj_move,
    limits: *const atraj_limits,
    n: usize,
    x: a_float,
) -> c_int {
    if axes.is_null() || limits.is_null() {
        return ATRAJ_ERR_NULL as c_int;
    }
    // SAFETY: not NULL, so each points to `n` values by the contract of this module; the layouts are the same.
    let (axes, limits) = unsafe {
        (
            array::<Move<Number>>(axes.cast(), n),
            core::slice::from_raw_parts(limits.cast::<Limits<Number>>(), n),
        )
    };
    code(together::line_stop(axes, limits, x.into()))
}

/// # Safety
/// Each pointer is NULL or points to `n` values.
unsafe fn plan(
    plan: impl FnOnce(
        &mut [Move<Number>],
        &[Limits<Number>],
        &[State<Number>],
        &[State<Number>],
        Number,
        Number,
    ) -> Result<Findings, Error>,
    axes: *mut atraj_move,
    limits: *const atraj_limits,
    from: *const atraj_state,
    to: *const atraj_state,
    n: usize,
    duration: a_float,
    cycle: a_float,
) -> c_int {
    if axes.is_null() || limits.is_null() || from.is_null() || to.is_null() {
        return ATRAJ_ERR_NULL as c_int;
    }
    // SAFETY: not NULL, so each points to `n` values by the contract of this function; the layouts are the same.
    let (axes, limits, from, to) = unsafe {
        (
            array::<Move<Number>>(axes.cast(), n),
            core::slice::from_raw_parts(limits.cast::<Limits<Number>>(), n),
            core::slice::from_raw_parts(from.cast::<State<Number>>(), n),
            core::slice::from_raw_parts(to.cast::<State<Number>>(), n),
        )
    };
    code(plan(axes, limits, from, to, duration.into(), cycle.into()))
}
