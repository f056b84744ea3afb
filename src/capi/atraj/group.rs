//! `atraj/group.h`: several axes between main loop and interrupt.

use super::clock::atraj_clock;
use super::r#move::{atraj_limits, atraj_move, atraj_state};
use super::{answer, done, list, list_mut};
use crate::capi::{Number, a_float, assert_same_layout, of, value};
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::machine::{Group, GroupPlanner, GroupTicker, group::Course};
use core::cell::Cell;
use core::ffi::{c_int, c_uint, c_void};

/// What is new in a tick of a group.
#[repr(C)]
pub enum atraj_tick {
    /// a plan takes over in this tick
    ATRAJ_TICK_BEGINS = 1,
    /// from this tick on the motion is at its end: all axes are at their targets, or stand in a hold
    ATRAJ_TICK_ENDS = 2,
}
use atraj_tick::*;

/// @brief What a group follows. Its members are the library's own.
#[repr(C)]
pub struct atraj_course {
    /// the path of the caller
    pub path: [*mut c_void; 2],
    /// when it is at its end, s
    pub end: a_float,
    /// the time of the moves
    pub clock: atraj_clock,
}
assert_same_layout!(atraj_course, Course<'static, Number>, path end clock);

/// @brief Several axes between a main loop, which plans, and a timer interrupt, which asks for setpoints. Its members are the library's own.
#[repr(C)]
pub struct atraj_group {
    /// who may use which motion, and when
    pub words: [c_uint; 6],
    /// from one tick to the next, s
    pub period: a_float,
    /// the states of the caller
    pub states: [*mut c_void; 2],
    /// the moves of the caller
    pub moves: [*mut c_void; 2],
    /// the positions of the caller
    pub positions: [[*mut c_void; 2]; 2],
    /// one is in force, one may wait for its tick, one is planned
    pub courses: [atraj_course; 3],
}
assert_same_layout!(atraj_group, Group<'static, Number>, words = handover period states moves positions courses);

/// @brief Put `n` axes in their states. Those in motion go on until a plan takes over. Neither main loop nor
/// interrupt may use the group meanwhile.
/// @param period from one tick to the next, s
/// @param states points to the states of the `n` axes. They are the group's from now on.
/// @param moves points to room for `3 * n` moves, which need not be initialised. It is the group's from now on.
/// @return 0; else an `atraj_error`: `ATRAJ_ERR_NULL` also if `n` is 0, `ATRAJ_ERR_DURATION` if the period is not above 0
/// or not finite, or `ATRAJ_ERR_NOT_FINITE`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_group_init(
    ctx: *mut atraj_group, period: a_float, states: *mut atraj_state, moves: *mut atraj_move, n: usize,
) -> c_int {
    answer(|| {
        // SAFETY: the pointers are NULL or valid by the contract of this module, and nobody else uses them now.
        let (states, moves) = unsafe { (list_mut(states, n)?, list_mut(moves, n.wrapping_mul(3))?) };
        let group = (!ctx.is_null()).then(|| ctx.cast::<Group<'static, Number>>())?;
        let period = period.into();
        done(Group::prepare(period, states, moves).map(|(states, moves)| {
            // In place: as a value it would take more stack than any plan.
            // SAFETY: the group is writable. Zeros are numbers, words and moves; the references are written next.
            unsafe {
                group.write_bytes(0, 1);
                (&raw mut (*group).states).write(states);
                (&raw mut (*group).moves).write(moves);
                (&raw mut (*group).positions).write(Cell::new([&[]; 2]));
                for place in 0..3 {
                    let course = (&raw mut (*group).courses).cast::<Course<'static, Number>>().add(place);
                    (&raw mut (*course).path).write(&[]);
                }
                (*group).begin(period);
            }
        }))
    })
}

/// @brief The next setpoints. For the timer interrupt, once in each tick.
///
/// It takes about as long as `atraj_clock_state` of each axis, whatever the main loop does.
/// @param states points to room for the states of the axes in this tick
/// @return 0, `ATRAJ_TICK_BEGINS`, `ATRAJ_TICK_ENDS`, or the sum of both; `ATRAJ_ERR_NULL` if a pointer is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_group_tick(ctx: *mut atraj_group, states: *mut atraj_state) -> c_int {
    // SAFETY: the pointers are NULL or valid, and there is one interrupt, by the contract of this module.
    let ticked =
        unsafe { of(ctx).and_then(|group| Some(GroupTicker::of(group).tick(list_mut(states, group.states.len())?))) };
    let word = |is: bool, word: atraj_tick| if is { word as c_int } else { 0 };
    ticked.map_or(Error::Axes as c_int, |tick| word(tick.begins, ATRAJ_TICK_BEGINS) + word(tick.ends, ATRAJ_TICK_ENDS))
}

/// @brief Keep each motion that is planned from now on between two positions of each axis until its end, up to 128 ulps.
/// For the main loop.
///
/// A line, path or change of the rate that would leave them is `ATRAJ_ERR_POSITION`, and so is a target if no motion
/// to it stays between them. An axis that cannot stop between them stops as fast as it can.
/// @param lowest points to the lowest positions of the `n` axes, unit, `highest` to the highest; an infinite one is no
/// limit. Both stay the caller's, and must stay as they are. Both NULL: any positions, as after `atraj_group_init`.
/// @return 0; else an `atraj_error`: `ATRAJ_ERR_NULL`, `ATRAJ_ERR_NOT_FINITE` if a position is not a number, or
/// `ATRAJ_ERR_LIMITS` if the lowest is not below the highest. Then the positions stay as they were.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_group_within(
    ctx: *mut atraj_group, lowest: *const a_float, highest: *const a_float,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module. The interrupt changes only what is atomic.
    answer(|| unsafe {
        let group: &Group<'static, Number> = of(ctx)?;
        let n = group.states.len();
        let are_given = !(lowest.is_null() && highest.is_null());
        let positions = if are_given { [list(lowest, n)?, list(highest, n)?] } else { [&[][..]; 2] };
        done(GroupPlanner::of(group).within(positions))
    })
}

/// @brief Plan the fastest move of each axis to its state, each for itself. For the main loop, while the interrupt ticks.
/// @param limits points to the limits of the `n` axes, `to` to their states at the end
/// @param lead number of ticks until the plan takes over: as many as a plan takes, rounded up, and one more
/// @return as `atraj_move_plan`; `ATRAJ_ERR_LATE` as for `atraj_axis_go`. On an error the motion goes on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_group_go(
    ctx: *mut atraj_group, limits: *const atraj_limits, to: *const atraj_state, lead: c_uint,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { plan(ctx, limits, |group, limits| Some(group.go(limits, list(to, limits.len())?, lead))) }
}

/// @brief As `atraj_group_go`, but all axes arrive in the same tick: `atraj_moves_sync` with the period as its cycle.
/// @return as `atraj_moves_sync` and `atraj_group_go`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_group_sync(
    ctx: *mut atraj_group, limits: *const atraj_limits, to: *const atraj_state, lead: c_uint,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { plan(ctx, limits, |group, limits| Some(group.sync(limits, list(to, limits.len())?, lead))) }
}

/// @brief As `atraj_group_go`, but on the straight line to the states: `atraj_moves_line` with the period as its cycle.
/// @return as `atraj_moves_line` and `atraj_group_go`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_group_line(
    ctx: *mut atraj_group, limits: *const atraj_limits, to: *const atraj_state, lead: c_uint,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { plan(ctx, limits, |group, limits| Some(group.line(limits, list(to, limits.len())?, lead))) }
}

/// @brief Follow a path from its time `s` on: 0 from its start.
///
/// While the axes move, another path may take over at its time `s`, if it has the state of the axes there: so a path is
/// continued. Its time runs at the rate 1, or else at the rate in force.
/// @param limits points to the limits of the `n` axes for a change of the rate. The moves are taken as they are.
/// @param moves points to `sections * n` moves, as `atraj_path_moves` writes them. They must stay as they are until a
/// later plan of another motion has begun.
/// @param s time of the path at the takeover, s
/// @return 0; else `ATRAJ_ERR_TARGET` if a section does not begin where the one before ends, if its moves do not have
/// one duration, if `s` is not on the path, if the axes are not on the path then, or while the rate changes;
/// `ATRAJ_ERR_LATE` as for `atraj_axis_go`, or `ATRAJ_ERR_NULL`, also if `sections` is 0
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_group_path(
    ctx: *mut atraj_group, limits: *const atraj_limits, moves: *const atraj_move, sections: usize, s: a_float,
    lead: c_uint,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe {
        plan(ctx, limits, |group, limits| {
            let moves = list(moves, limits.len().wrapping_mul(sections))?;
            Some(group.path(limits, moves, s.into(), lead))
        })
    }
}

/// @brief The time of the motion in force after `lead` ticks, s: there `atraj_group_path` can continue it.
///
/// Where a tick comes between both calls, the path is `ATRAJ_ERR_TARGET`: ask again.
/// @return NaN if `ctx` is NULL, or where a plan would be `ATRAJ_ERR_LATE`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_group_time(ctx: *const atraj_group, lead: c_uint) -> a_float {
    // SAFETY: `ctx` is NULL or valid, and nobody else plans, by the contract of this module.
    let time = unsafe { of(ctx).and_then(|group| GroupPlanner::of(group).time(lead).ok()) };
    value(time.as_ref(), |time| *time)
}

/// @brief Go to another rate of the motion, on its line or path: 1 as planned, 0 feed hold, 1/2 override, -1 back.
/// @param limits points to the limits of the `n` axes, which are the limits of their plans and a reserve
/// @return as `atraj_clock_rate`: where the axes rest, before a motion or after it, 0 for a hold, and
/// `ATRAJ_RATE_NOT_REACHED` for 1, since there is nothing to go on with; `ATRAJ_ERR_TARGET` also if the axes move each for
/// itself; `ATRAJ_ERR_LATE` as for `atraj_axis_go`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_group_rate(
    ctx: *mut atraj_group, limits: *const atraj_limits, rate: a_float, lead: c_uint,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { plan(ctx, limits, |group, limits| Some(group.rate(limits, rate.into(), lead))) }
}

/// @brief Stop on the line or path, if all axes then stand within twice the time of the slowest axis' own stop; else
/// each axis as fast as it can. A line that is not slowed down stops on itself in any case. From a stop on the line or path
/// `atraj_group_rate` can lead on.
/// @return as `atraj_move_stop`; `ATRAJ_ERR_LATE` as for `atraj_axis_go`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_group_stop(ctx: *mut atraj_group, limits: *const atraj_limits, lead: c_uint) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { plan(ctx, limits, |group, limits| Some(group.stop(limits, lead))) }
}

/// The planner of a group, with the limits of its axes.
///
/// # Safety
/// `ctx` is NULL or valid, and no other planner uses it; `limits` is NULL or has one element for each axis.
unsafe fn plan(
    ctx: *const atraj_group, limits: *const atraj_limits,
    plan: impl FnOnce(&mut GroupPlanner<'_, 'static, Number>, &[Limits<Number>]) -> Option<Result<Findings, Error>>,
) -> c_int {
    // SAFETY: by the contract of this function. The interrupt changes only what is atomic.
    answer(|| unsafe {
        let group = of(ctx)?;
        plan(&mut GroupPlanner::of(group), list(limits, group.states.len())?)
    })
}
