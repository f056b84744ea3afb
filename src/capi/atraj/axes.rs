//! `atraj/move.h`: several axes that move together.

use super::r#move::{atraj_limits, atraj_move, atraj_state};
use super::{answer, list, list_mut};
use crate::capi::a_float;
use crate::several;
use core::ffi::c_int;

/// @brief Plan several axes for the same duration: the shortest one that is possible for each.
///
/// The duration is at least `duration` and a multiple of `cycle`, up to rounding. An axis whose fastest move takes as
/// long makes its fastest move. From rest to rest an axis with more time makes its fastest move in slow motion. Any
/// other axis with more time cruises at one velocity, where this is possible. One axis alone is stretched, or ends on a
/// tick of the clock. Plan again when something has changed. A loop that plans in every tick should give its period as
/// `cycle`: then the axes arrive at a tick.
/// @param axes points to `n` moves, which need not be initialised; all are untouched on an error
/// @param limits points to the limits of the `n` axes, `from` and `to` to their states at start and end
/// @param duration least duration, s; 0: as short as can be
/// @param cycle period of the clock, s; 0: any duration
/// @return 0, or a sum of `ATRAJ_OVERSHOOTS`, `ATRAJ_STARTS_OUTSIDE` and `ATRAJ_ENDS_LEAVING`; else the `atraj_error`
/// of an axis, `ATRAJ_ERR_DURATION` if `duration` or `cycle` is negative, infinite or not a number, or `ATRAJ_ERR_NULL`
/// if a pointer is NULL or `n` is 0
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_moves_sync(
    axes: *mut atraj_move, limits: *const atraj_limits, from: *const atraj_state, to: *const atraj_state, n: usize,
    duration: a_float, cycle: a_float,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    answer(|| unsafe {
        let (axes, limits) = (list_mut(axes, n)?, list(limits, n)?);
        Some(several::synchronise(axes, limits, list(from, n)?, list(to, n)?, duration.into(), cycle.into()))
    })
}

/// @brief Plan several axes on the straight line from their start to their end: the fastest motion on it.
///
/// One axis leads, within the tightest limits of all, and the others follow in proportion. The arguments are those of
/// `atraj_moves_sync`.
/// @return as `atraj_moves_sync`; `ATRAJ_ERR_LINE` if the velocities and accelerations do not point along the line
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_moves_line(
    axes: *mut atraj_move, limits: *const atraj_limits, from: *const atraj_state, to: *const atraj_state, n: usize,
    duration: a_float, cycle: a_float,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    answer(|| unsafe {
        let (axes, limits) = (list_mut(axes, n)?, list(limits, n)?);
        Some(several::line(axes, limits, list(from, n)?, list(to, n)?, duration.into(), cycle.into()))
    })
}

/// @brief Plan several axes as `atraj_moves_sync` does, each between its own lowest and highest position.
///
/// An axis that would leave its positions on a slower way makes its fastest move and waits, or it stops, waits and
/// goes, or it is slower between its turns at the positions. Where none is possible, all axes take longer.
/// @param lowest points to the `n` lowest positions, unit, `highest` to the highest; an infinite one is no limit
/// @return as `atraj_moves_sync` and `atraj_move_within`: `ATRAJ_ERR_POSITION` if no move of an axis stays between its
/// positions, or if an axis has to wait, but cannot stop between them or come to its end from rest there
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_moves_sync_within(
    axes: *mut atraj_move, limits: *const atraj_limits, from: *const atraj_state, to: *const atraj_state,
    lowest: *const a_float, highest: *const a_float, n: usize, duration: a_float, cycle: a_float,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    answer(|| unsafe {
        let (axes, limits, from, to) = (list_mut(axes, n)?, list(limits, n)?, list(from, n)?, list(to, n)?);
        let positions = [list(lowest, n)?, list(highest, n)?];
        Some(several::synchronise_within(axes, limits, from, to, positions, duration.into(), cycle.into()))
    })
}

/// @brief Stop axes that move on a straight line, on this line: a feed hold. Each move becomes its stop, which begins
/// at its time 0. One axis makes its fastest stop within the tightest limits of all, and the others follow in proportion. So no reserve
/// is needed.
/// @param axes points to `n` planned moves on a straight line; all are untouched on an error
/// @param limits points to the limits of the `n` axes
/// @param time since the start of the moves, s
/// @return as `atraj_move_stop`; `ATRAJ_ERR_LINE` if the moves are not on one straight line, `ATRAJ_ERR_NULL` also if
/// `n` is 0
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_moves_line_stop(
    axes: *mut atraj_move, limits: *const atraj_limits, n: usize, time: a_float,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    answer(|| unsafe { Some(several::line_stop(list_mut(axes, n)?, list(limits, n)?, time.into())) })
}
