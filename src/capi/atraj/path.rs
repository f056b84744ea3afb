//! `atraj/path.h`: waypoints without stops.

use super::r#move::{atraj_limits, atraj_move, atraj_state};
use super::{answer, done, list, list_mut};
use crate::capi::{Number, a_float};
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::path;
use crate::state::State;
use core::ffi::{c_int, c_uint};

/// @brief How many numbers of working memory a path needs: `ATRAJ_PATH_SIZE` for an array.
/// @return how many `a_float` the array `work` has; 0 if `axes` is 0 or above 100, or `sections` is 0 or above 65,536
#[unsafe(no_mangle)]
pub extern "C" fn atraj_path_size(axes: usize, sections: usize) -> usize {
    path::path_size(axes, sections).unwrap_or(0)
}

/// @brief Plan a path: several axes pass given points at the same times, and stop nowhere unless they must.
///
/// Waypoints may repeat, axes may stand still, and paths may reverse. If no point repeats, the path is not longer than one
/// that stops at every point. `atraj_path_moves` makes the motions of the sections. A point whose state is given splits a path: plan two.
///
/// The work is bounded, and linear in the sections. Each step takes at most 12 times the work of one pass over all
/// sections and axes, and 24 factorisations with `2 * axes + 1` rows a section.
/// @param states points to `(sections + 1) * axes` states, point by point. Every position is given, and the first and
/// the last state whole. A start outside the limits returns within them in the first section. The other velocities and
/// accelerations are written.
/// @param durations points to room for `sections` durations, which are written, s; 0 for a section in which nothing
/// moves
/// @param limits points to the limits of the axes
/// @param sections number of sections: one less than points
/// @param steps how many steps the planner may take, at most 1024; 0: as many as the path needs, at most 48. A start that
/// cannot stop before the next point, or an end that cannot be reached from the last one at rest, takes up to 8 times as
/// many more. Where the steps make a path longer than it was before them, all are taken twice.
/// @param work points to `atraj_path_size(axes, sections)` numbers, which need not be initialised
/// @return 0, or a sum of `ATRAJ_STARTS_OUTSIDE` and `ATRAJ_ENDS_LEAVING`; else the `atraj_error` of an axis as
/// `atraj_moves_sync` returns it, or `ATRAJ_ERR_NULL` if a pointer is NULL, or `atraj_path_size` is 0. On an error nothing
/// but `work` is written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_path_plan(
    states: *mut atraj_state, durations: *mut a_float, limits: *const atraj_limits, axes: usize, sections: usize,
    steps: c_uint, work: *mut a_float,
) -> c_int {
    // SAFETY: both functions have the same contract.
    unsafe { plan(path::plan_path, states, durations, limits, axes, axes, sections, steps, work) }
}

/// @brief Improve a path that `atraj_path_plan` has planned, or this function: as often as there is time.
///
/// A path never gets longer, and is possible after every call, except for rounding in the last phase of the first
/// section. It may change between two calls. Drop sections that are passed. Begin with the state under way, and with what is left of
/// the duration of its section. Append points at rest, with sections of the duration 0: they are stretched until they are
/// possible. If the states and durations are impossible otherwise, the path is planned again from the start. The other
/// arguments are those of `atraj_path_plan`.
/// @param states points to `(sections + 1) * axes` states, point by point, all of them given
/// @param durations points to the durations of the `sections` sections, s
/// @return as `atraj_path_plan`; `ATRAJ_ERR_NOT_FINITE` also if a state between is not made of numbers,
/// `ATRAJ_ERR_DURATION` if a duration is negative, infinite or not a number
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_path_improve(
    states: *mut atraj_state, durations: *mut a_float, limits: *const atraj_limits, axes: usize, sections: usize,
    steps: c_uint, work: *mut a_float,
) -> c_int {
    // SAFETY: both functions have the same contract.
    unsafe { plan(path::improve_path, states, durations, limits, axes, axes, sections, steps, work) }
}

/// @brief Plan a path through zones: as `atraj_path_plan`, with limits for every section. A state at a point keeps the
/// limits of both sections.
/// @param limits points to `sections * axes` limits, section by section
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_path_plan_zones(
    states: *mut atraj_state, durations: *mut a_float, limits: *const atraj_limits, axes: usize, sections: usize,
    steps: c_uint, work: *mut a_float,
) -> c_int {
    // SAFETY: both functions have the same contract.
    unsafe {
        plan(path::plan_path, states, durations, limits, axes.wrapping_mul(sections), axes, sections, steps, work)
    }
}

/// @brief Plan the motions of a path: the moves of all axes for the first section, then of all axes for the second one, as
/// `atraj_clock_rate` takes them.
///
/// `atraj_moves_sync` makes the motions of a section, with its duration as the least one. In a section of the duration 0
/// the moves stand.
/// @param moves points to room for `sections * axes` moves, which need not be initialised
/// @param limits points to the limits of the axes
/// @param states points to the `(sections + 1) * axes` states that `atraj_path_plan` or `atraj_path_improve` has written
/// @param durations points to the `sections` durations that it has written, s
/// @return the findings of all sections as `atraj_moves_sync`, else an error as `atraj_path_improve` returns it, and
/// `ATRAJ_ERR_TARGET` also if a state is outside the limits of the section before it. Then no move is written. Two
/// errors are found while the moves are written, section by section, and leave those up to this section:
/// `ATRAJ_ERR_DURATION` if a section takes longer than its duration, by more than the root of the rounding (1.5e-8, or
/// 3.5e-4 in float) times the duration of the path, and `ATRAJ_ERR_NOT_FINITE` if a motion is beyond the range of the
/// real type.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_path_moves(
    moves: *mut atraj_move, limits: *const atraj_limits, states: *const atraj_state, durations: *const a_float,
    axes: usize, sections: usize,
) -> c_int {
    // SAFETY: both functions have the same contract.
    unsafe { write_moves(moves, limits, axes, states, durations, axes, sections) }
}

/// @brief Plan the motions of a path through zones: as `atraj_path_moves`, with limits for every section.
/// @param limits points to `sections * axes` limits, section by section
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_path_moves_zones(
    moves: *mut atraj_move, limits: *const atraj_limits, states: *const atraj_state, durations: *const a_float,
    axes: usize, sections: usize,
) -> c_int {
    // SAFETY: both functions have the same contract.
    unsafe { write_moves(moves, limits, axes.wrapping_mul(sections), states, durations, axes, sections) }
}

/// @brief How far the motions of a path leave the straight lines between its points: the greatest distance, in the
/// space of all axes, of the motion from the line between the points of its section.
///
/// It is a bound from above, by less than 1 % and rounding. A line ends at its points, so overshoot counts.
/// @param moves points to the `sections * axes` moves that `atraj_path_moves` has written
/// @return unit; NaN if `moves` is NULL, if `atraj_path_size` is 0, or if a number of the moves is not finite or has no
/// square within the range of the real type
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_path_deviation(moves: *const atraj_move, axes: usize, sections: usize) -> a_float {
    let moves = path::path_size(axes, sections).and_then(|_| {
        // SAFETY: `moves` is NULL or points to as many values by the contract of this module.
        unsafe { list(moves, axes * sections) }
    });
    path::path_deviation(moves.unwrap_or_default(), axes).into()
}

/// # Safety
/// Each pointer is NULL or points to as many values as the headers say; `limits` to `count`.
unsafe fn write_moves(
    moves: *mut atraj_move, limits: *const atraj_limits, count: usize, states: *const atraj_state,
    durations: *const a_float, axes: usize, sections: usize,
) -> c_int {
    // SAFETY: each pointer is NULL or points to as many values by the contract of this function.
    answer(|| unsafe {
        path::path_size(axes, sections)?;
        let (moves, limits) = (list_mut(moves, axes * sections)?, list(limits, count)?);
        let (states, durations) = (list(states, axes * (sections + 1))?, list(durations, sections)?);
        Some(path::path_moves(moves, limits, states, durations, axes))
    })
}

/// @brief How many numbers of working memory `atraj_path_plan_near` needs: `ATRAJ_PATH_SIZE_NEAR` for an array.
/// @return how many `a_float` the array `work` has; 0 if `axes` is 0 or above 100, or `sections` is 0 or above 32,768
#[unsafe(no_mangle)]
pub extern "C" fn atraj_path_size_near(axes: usize, sections: usize) -> usize {
    path::path_size_near(axes, sections).unwrap_or(0)
}

/// @brief Plan a path through fly-by zones: as `atraj_path_plan`, but each axis passes a waypoint within a tolerance.
///
/// The path is not longer than the one through the points. It is planned first, so `steps` bounds the work twice. Points
/// that repeat are one point, with the least of their tolerances. Points whose zones overlap take more steps than there
/// are by default: leave some of them out.
/// @param states as for `atraj_path_plan`; the positions between start and end are written too
/// @param tolerances points to `(sections - 1) * axes` numbers for the points between start and end, point by point: how
/// far the position of an axis may be from the given one; 0: it is exact
/// @param work points to `atraj_path_size_near(axes, sections)` numbers, which need not be initialised
/// @return as `atraj_path_plan`; `ATRAJ_ERR_LIMITS` also if a tolerance is negative, `ATRAJ_ERR_NOT_FINITE` if one is
/// infinite or not a number, `ATRAJ_ERR_NULL` also if `atraj_path_size_near` is 0
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_path_plan_near(
    states: *mut atraj_state, durations: *mut a_float, limits: *const atraj_limits, tolerances: *const a_float,
    axes: usize, sections: usize, steps: c_uint, work: *mut a_float,
) -> c_int {
    // SAFETY: each pointer is NULL or points to as many values as the header says.
    answer(|| unsafe {
        let work = list_mut(work, path::path_size_near(axes, sections)?)?;
        let (states, durations) = (list_mut(states, axes * (sections + 1))?, list_mut(durations, sections)?);
        let (limits, tolerances) = (list(limits, axes)?, list(tolerances, axes * (sections - 1))?);
        Some(path::plan_path_near(states, durations, limits, tolerances, axes, steps, work))
    })
}

/// @brief Plan a path that stays near the straight lines between its points, and the moves of its sections. Where it
/// leaves a line too far, points are added in the middle of the section, as often as it is necessary.
///
/// Each of at most 24 rounds plans a path as `atraj_path_plan`. Points that `atraj_path_plan_near` has moved by at most
/// `r` may be given: the path is within `tolerance + r` of the lines between those that it was given.
/// @param moves points to room for `room * axes` moves, which are written as by `atraj_path_moves`
/// @param states points to room for `(room + 1) * axes` states, point by point. The `(sections + 1) * axes` states of the
/// given points stand first, as for `atraj_path_plan`; those of all points are written.
/// @param durations points to room for `room` durations, which are written, s
/// @param places points to room for `sections + 1` numbers: at which point of the path each given point stands. The last
/// one is how many sections the path has.
/// @param limits points to the limits of the axes
/// @param tolerance how far the path may leave its lines, in the space of all axes, unit
/// @param sections number of given sections: one less than given points
/// @param room how many sections the path may get
/// @param steps how many steps each round may take, as for `atraj_path_plan`
/// @param work points to `atraj_path_size(axes, room)` numbers, which need not be initialised
/// @return as `atraj_path_moves`; `ATRAJ_ERR_LIMITS` also if the tolerance is not above 0, `ATRAJ_ERR_NOT_FINITE` if it
/// is infinite or not a number, `ATRAJ_ERR_NULL` if there is no room for the given points. `ATRAJ_ERR_POSITION` if the
/// room or the rounds end before the path is near enough. Then a path that leaves its lines farther is written, and
/// `atraj_path_deviation` says how far: give more room, or let the end velocities point along the lines.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_path_contour(
    moves: *mut atraj_move, states: *mut atraj_state, durations: *mut a_float, places: *mut usize,
    limits: *const atraj_limits, tolerance: a_float, axes: usize, sections: usize, room: usize, steps: c_uint,
    work: *mut a_float,
) -> c_int {
    // SAFETY: both functions have the same contract.
    unsafe { contour(moves, states, durations, places, limits, axes, tolerance, axes, sections, room, steps, work) }
}

/// @brief Plan a path that stays near its lines through zones: as `atraj_path_contour`, with limits for every given
/// section. Both halves of a section keep its limits.
/// @param limits points to `sections * axes` limits, given section by given section
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_path_contour_zones(
    moves: *mut atraj_move, states: *mut atraj_state, durations: *mut a_float, places: *mut usize,
    limits: *const atraj_limits, tolerance: a_float, axes: usize, sections: usize, room: usize, steps: c_uint,
    work: *mut a_float,
) -> c_int {
    let count = axes.wrapping_mul(sections);
    // SAFETY: both functions have the same contract.
    unsafe { contour(moves, states, durations, places, limits, count, tolerance, axes, sections, room, steps, work) }
}

/// # Safety
/// Each pointer is NULL or points to as many values as the headers say; `limits` to `count`.
unsafe fn contour(
    moves: *mut atraj_move, states: *mut atraj_state, durations: *mut a_float, places: *mut usize,
    limits: *const atraj_limits, count: usize, tolerance: a_float, axes: usize, sections: usize, room: usize,
    steps: c_uint, work: *mut a_float,
) -> c_int {
    // SAFETY: each pointer is NULL or points to as many values by the contract of this function.
    answer(|| unsafe {
        path::path_size(axes, sections)?;
        let work = list_mut(work, path::path_size(axes, room)?)?;
        let path = path::Contour {
            moves: list_mut(moves, axes * room)?,
            states: list_mut(states, axes * (room + 1))?,
            durations: list_mut(durations, room)?,
            places: list_mut(places, sections + 1)?,
        };
        Some(path::plan_contour(path, list(limits, count)?, tolerance.into(), axes, steps, work))
    })
}

/// @brief Lower the limits of the velocities such that the axes together are nowhere faster than the feed: the norm of
/// their velocities. `atraj_path_plan_zones`, `atraj_path_moves_zones` and `atraj_path_contour_zones` take such limits.
///
/// Each axis of a section gets the part `w` of its feed, with `w * w = 15 / 16 * d * d + 1 / (16 * axes)` for the
/// direction `d` of its line. The squares add up to 1, so the feed is kept at all times, however a path moves between its
/// points. On a line it moves at 96.8 % of the feed or more. Where an axis moves across the line of a section, as at a
/// corner, it has little of the feed.
/// @param limits points to the `sections * axes` limits, section by section, which are lowered
/// @param states points to the `(sections + 1) * axes` states of the points
/// @param feeds points to the feeds of the `sections` sections, unit/s; an infinite one sets no limit
/// @return 0, or an error as `atraj_path_plan` returns it, `ATRAJ_ERR_LIMITS` also if a feed is not above 0,
/// `ATRAJ_ERR_NOT_FINITE` if it is not a number. On an error no limit changes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_path_feed(
    limits: *mut atraj_limits, states: *const atraj_state, feeds: *const a_float, axes: usize, sections: usize,
) -> c_int {
    // SAFETY: each pointer is NULL or points to as many values as the header says.
    answer(|| unsafe {
        path::path_size(axes, sections)?;
        let (limits, states) = (list_mut(limits, axes * sections)?, list(states, axes * (sections + 1))?);
        done(path::limit_feed(limits, states, list(feeds, sections)?, axes))
    })
}

/// How a path is planned.
type Plan =
    fn(&mut [State<Number>], &mut [Number], &[Limits<Number>], usize, u32, &mut [Number]) -> Result<Findings, Error>;

/// # Safety
/// Each pointer is NULL or points to as many values as the headers say; `limits` to `count`.
unsafe fn plan(
    plan: Plan, states: *mut atraj_state, durations: *mut a_float, limits: *const atraj_limits, count: usize,
    axes: usize, sections: usize, steps: c_uint, work: *mut a_float,
) -> c_int {
    // SAFETY: each pointer is NULL or points to as many values by the contract of this function.
    answer(|| unsafe {
        let work = list_mut(work, path::path_size(axes, sections)?)?;
        let (states, durations) = (list_mut(states, axes * (sections + 1))?, list_mut(durations, sections)?);
        Some(plan(states, durations, list(limits, count)?, axes, steps, work))
    })
}
