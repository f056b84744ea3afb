//! `atraj/axis.h`: an axis between main loop and interrupt.

use super::r#move::{atraj_limits, atraj_move, atraj_state};
use super::{answer, done, write_state};
use crate::capi::{Number, a_float, assert_same_layout, of, of_mut};
use crate::machine::{Axis, Planner, Ticker};
use core::ffi::{c_int, c_uint};

/// @brief An axis between a main loop, which plans, and a timer interrupt, which asks for setpoints. Its members are the library's own.
#[repr(C)]
pub struct atraj_axis {
    /// who may use which move, and when
    pub words: [c_uint; 6],
    /// from one tick to the next, s
    pub period: a_float,
    /// one is in force, one may wait for its tick, one is planned
    pub moves: [atraj_move; 3],
}
assert_same_layout!(atraj_axis, Axis<Number>, words = handover period moves);

/// @brief Put an axis in the state `now`. An axis in motion goes on until a plan takes over. Neither main loop nor
/// interrupt may use the axis meanwhile.
/// @param period from one tick to the next, s
/// @return 0; else an `atraj_error`: `ATRAJ_ERR_NULL`, `ATRAJ_ERR_DURATION` if the period is not above 0 or not finite,
/// or `ATRAJ_ERR_NOT_FINITE`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_axis_init(ctx: *mut atraj_axis, period: a_float, now: *const atraj_state) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module, and nobody else uses the axis now.
    answer(|| unsafe { done(of_mut(ctx)?.init(period.into(), *of(now)?)) })
}

/// @brief The next setpoint. For the timer interrupt, once in each tick.
///
/// It takes about as long as `atraj_move_state`, whatever the main loop does. Tick `n` of a move gives its state at `n`
/// periods, with the bits of `atraj_move_state`: nothing adds up. In `float` the number of ticks has 24 bits, so an
/// axis that moves on after its end needs a new plan within 16 million ticks.
/// @param now NULL or the place for the state of the axis in this tick; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_axis_tick(ctx: *mut atraj_axis, now: *mut atraj_state) {
    // SAFETY: the pointers are NULL or valid, and there is one interrupt, by the contract of this module.
    unsafe { write_state(now, of(ctx).map(|axis| Ticker::of(axis).tick())) };
}

/// @brief Plan the fastest move to a state, and let it take over some ticks ahead. For the main loop.
///
/// The plan starts from the state that the axis will have in tick `n + lead`, where `n` is the last tick before the
/// call. Until that tick the axis goes on in its move. If another plan still waits for its tick, the new plan replaces
/// it, and takes over in that tick or earlier.
/// @param lead number of ticks: as many as a plan takes, rounded up, and one more
/// @return as `atraj_move_plan`; `ATRAJ_ERR_LATE` if the plan came after its tick, or if `lead` is 0 or above
/// 134217727. On an error the axis goes on in its move. A plan that waits goes on waiting, unless the new one was to
/// take over before it and came late. On several processors `ATRAJ_ERR_LATE` may be a
/// false alarm, if the other one is in this very tick.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_axis_go(
    ctx: *mut atraj_axis, limits: *const atraj_limits, to: *const atraj_state, lead: c_uint,
) -> c_int {
    // SAFETY: the pointers are NULL or valid, and there is one main loop, by the contract of this module.
    answer(|| unsafe { Some(Planner::of(of(ctx)?).go(of(limits)?, *of(to)?, lead)) })
}

/// @brief As `atraj_axis_go`, to the velocity `v1`, unit/s, and the acceleration `a1`, unit/s^2. The position is free.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_axis_reach(
    ctx: *mut atraj_axis, limits: *const atraj_limits, v1: a_float, a1: a_float, lead: c_uint,
) -> c_int {
    // SAFETY: the pointers are NULL or valid, and there is one main loop, by the contract of this module.
    answer(|| unsafe { Some(Planner::of(of(ctx)?).reach(of(limits)?, v1.into(), a1.into(), lead)) })
}

/// @brief As `atraj_axis_go`, to the fastest stop. The position is free.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_axis_stop(ctx: *mut atraj_axis, limits: *const atraj_limits, lead: c_uint) -> c_int {
    // SAFETY: both functions have the same contract.
    unsafe { atraj_axis_reach(ctx, limits, 0.0, 0.0, lead) }
}

/// @brief Follow a signal, as `atraj_move_track` does, from some ticks ahead on. For every round of the main loop.
///
/// The signal is taken to go on with its jerk until the plan takes over, and for the time `horizon` from then on. The
/// shorter the time to the next call, the smaller the error.
/// @param signal points to the state of the signal in the last tick before the call
/// @param jerk jerk of the signal, unit/s^3; 0 if it is not known
/// @param horizon time from the takeover until the axis is to be next to the signal, s; at least `lead` ticks, up to
/// twice as many if the plan replaces one that waits
/// @param lead as for `atraj_axis_go`
/// @return as `atraj_move_track` and `atraj_axis_go`; `ATRAJ_ERR_NOT_FINITE` also if the signal leaves the range of `a_float`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_axis_track(
    ctx: *mut atraj_axis, limits: *const atraj_limits, signal: *const atraj_state, jerk: a_float, horizon: a_float,
    lead: c_uint,
) -> c_int {
    // SAFETY: the pointers are NULL or valid, and there is one main loop, by the contract of this module.
    answer(|| unsafe {
        let mut planner = Planner::of(of(ctx)?);
        Some(planner.track(of(limits)?, *of(signal)?, jerk.into(), horizon.into(), lead))
    })
}
