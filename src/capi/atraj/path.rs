//! `atraj/path.h`: way points without stops.

use super::r#move::{atraj_limits, atraj_state};
use super::{ATRAJ_ERR_NULL, array, code};
use crate::capi::{Number, a_float};
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::state::State;
use crate::together::path;
use core::ffi::{c_int, c_uint};

/// @brief How many numbers of working memory a path needs: `axes * (28 * sections - 12) + sections * (sections + 12)`.
/// @param axes number of axes
/// @param sections number of sections: one less than points
/// @return how many `a_float` the array `work` has; 0 if `axes` or `sections` is 0 or above 4,096
#[unsafe(no_mangle)]
pub extern "C" fn atraj_path_size(axes: usize, sections: usize) -> usize {
    path::path_size(axes, sections).unwrap_or(0)
}

/// @brief Plan a path: several axes pass given points at the same times, and stop nowhere unless they must.
///
/// Any points are possible: points that repeat, axes that stay, ways to and fro. No path is longer than one that stops at every point.
/// `atraj_moves_sync` makes the motions of section `k`:
/// `atraj_moves_sync(moves, limits, states + k * axes, states + (k + 1) * axes, axes, durations[k], cycle);`
/// A point whose state is given splits a path: plan two.
///
/// The work is bounded. Each step takes at most 12 times the work of one pass over all sections and axes, and 24 factorisations of a matrix
/// with as many rows as sections.
/// @param states points to `(sections + 1) * axes` states, point by point. Every position is given, and the first and the last state whole. A
/// start outside the limits comes inside in the first section. The other velocities and accelerations are written.
/// @param durations points to room for `sections` durations, which are written, s; 0 for a section in which nothing moves
/// @param limits points to the limits of the axes
/// @param axes number of axes
/// @param sections number of sections: one less than points
/// @param steps how many steps the planner may take, at most 1024; 0: as many as the path needs, at most 48
/// @param work points to `atraj_path_size(axes, sections)` numbers, whatever they are
/// @return 0, or a sum of `ATRAJ_STARTS_OUTSIDE` and `ATRAJ_ENDS_LEAVING`; else the `atraj_error` of an axis as `atraj_moves_sync` returns
/// it, `ATRAJ_ERR_TARGET` also if points repeat at an end at which an axis is bound to leave its limits, or `ATRAJ_ERR_NULL` if a pointer is
/// NULL, or `axes` or `sections` is 0 or above 4,096. On an error nothing but `work` is written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_path_plan(
    states: *mut atraj_state,
    durations: *mut a_float,
    limits: *const atraj_limits,
    axes: usize,
    sections: usize,
    steps: c_uint,
    work: *mut a_float,
) -> c_int {
    // SAFETY: both functions have the same contract.
    unsafe {
        plan(
            path::plan_path,
            states,
            durations,
            limits,
            axes,
            axes,
            sections,
            steps,
            work,
        )
    }
}

/// @brief Improve a path that `atraj_path_plan` has planned, or this function: as often as there is time.
///
/// A path gets no longer, and is possible after every call. It may change between two calls. Drop sections that are passed. Begin with the state
/// under way, and with what is left of the duration of its section. Append points at rest, with sections of the duration 0: they are
/// stretched until they are possible. If the states and durations are impossible otherwise, the path is planned anew.
/// @param states points to `(sections + 1) * axes` states, point by point, all of them given
/// @param durations points to the durations of the `sections` sections, s
/// @param limits points to the limits of the axes
/// @param axes number of axes
/// @param sections number of sections: one less than points
/// @param steps how many steps the planner may take, at most 1024; 0: as many as the path needs, at most 48
/// @param work points to `atraj_path_size(axes, sections)` numbers, whatever they are
/// @return as `atraj_path_plan`; `ATRAJ_ERR_NOT_FINITE` also if a state between is not made of numbers, `ATRAJ_ERR_DURATION` if a duration is
/// negative, infinite or not a number
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_path_improve(
    states: *mut atraj_state,
    durations: *mut a_float,
    limits: *const atraj_limits,
    axes: usize,
    sections: usize,
    steps: c_uint,
    work: *mut a_float,
) -> c_int {
    // SAFETY: both functions have the same contract.
    unsafe {
        plan(
            path::improve_path,
            states,
            durations,
            limits,
            axes,
            axes,
            sections,
            steps,
            work,
        )
    }
}

/// @brief Plan a path through zones: as `atraj_path_plan`, with limits for every section.
///
/// A state at a point keeps the limits of both sections.
/// @param states points to `(sections + 1) * axes` states, point by point, as for `atraj_path_plan`
/// @param durations points to room for `sections` durations, which are written, s
/// @param limits points to `sections * axes` limits, section by section
/// @param axes number of axes
/// @param sections number of sections: one less than points
/// @param steps how many steps the planner may take, at most 1024; 0: as many as the path needs, at most 48
/// @param work points to `atraj_path_size(axes, sections)` numbers, whatever they are
/// @return as `atraj_path_plan`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_path_plan_zones(
    states: *mut atraj_state,
    durations: *mut a_float,
    limits: *const atraj_limits,
    axes: usize,
    sections: usize,
    steps: c_uint,
    work: *mut a_float,
) -> c_int {
    let count = axes.wrapping_mul(sections);
    // SAFETY: both functions have the same contract.
    unsafe {
        plan(
            path::plan_path,
            states,
            durations,
            limits,
            count,
            axes,
            sections,
            steps,
            work,
        )
    }
}

/// How a path is planned.
type Plan = fn(
    &mut [State<Number>],
    &mut [Number],
    &[Limits<Number>],
    u32,
    &mut [Number],
) -> Result<Findings, Error>;

/// # Safety
/// Each pointer is NULL or points to as many values as the headers say; `limits` to `count`.
unsafe fn plan(
    plan: Plan,
    states: *mut atraj_state,
    durations: *mut a_float,
    limits: *const atraj_limits,
    count: usize,
    axes: usize,
    sections: usize,
    steps: c_uint,
    work: *mut a_float,
) -> c_int {
    let size = atraj_path_size(axes, sections);
    let is_null = states.is_null() || durations.is_null() || limits.is_null() || work.is_null();
    if is_null || size == 0 {
        return ATRAJ_ERR_NULL as c_int;
    }
    // SAFETY: not NULL, so each points to as many values by the contract of this function; the layouts are the same.
    let (states, durations, limits, work) = unsafe {
        (
            array::<State<Number>>(states.cast(), axes * (sections + 1)),
            array::<Number>(durations.cast(), sections),
            core::slice::from_raw_parts(limits.cast::<Limits<Number>>(), count),
            array::<Number>(work.cast(), size),
        )
    };
    code(plan(states, durations, limits, steps, work))
}
