//! `atraj/move.h`: one axis from any state to any state.

use super::{answer, sample, write, write_extremes};
use crate::capi::{Number, a_float, assert_same_layout, of, of_mut, value};
use crate::online::{Limits, Move, Phase};
use crate::state::State;
use core::ffi::{c_int, c_uint};

/// @brief What an axis can do. Each pair of limits is around 0. An infinite limit is no limit. A jerk, or both accelerations, are finite.
#[repr(C)]
pub struct atraj_limits {
    /// highest velocity, unit/s
    pub vmax: a_float,
    /// lowest velocity, unit/s, negative
    pub vmin: a_float,
    /// highest acceleration, unit/s^2
    pub amax: a_float,
    /// lowest acceleration, unit/s^2, negative
    pub amin: a_float,
    /// highest jerk, unit/s^3
    pub jmax: a_float,
    /// lowest jerk, unit/s^3, negative
    pub jmin: a_float,
}
assert_same_layout!(atraj_limits, Limits<Number>, vmax vmin amax amin jmax jmin);

/// @brief Where an axis is at one instant.
#[repr(C)]
pub struct atraj_state {
    /// position, unit
    pub p: a_float,
    /// velocity, unit/s
    pub v: a_float,
    /// acceleration, unit/s^2
    pub a: a_float,
}
assert_same_layout!(atraj_state, State<Number>, p = position v = velocity a = acceleration);

/// @brief A phase of constant jerk, and the state of the axis at its start.
#[repr(C)]
pub struct atraj_phase {
    /// when it starts, s
    pub t: a_float,
    /// how long it lasts, s
    pub duration: a_float,
    /// position at its start, unit
    pub p: a_float,
    /// velocity at its start, unit/s
    pub v: a_float,
    /// acceleration at its start, unit/s^2
    pub a: a_float,
    /// jerk, unit/s^3
    pub j: a_float,
}
assert_same_layout!(atraj_phase, Phase<Number>, t = start duration p = position v = velocity a = acceleration j = jerk);

/// @brief A planned move of one axis: phases of constant jerk. It may be copied.
///
/// Before the start the axis is at the start. After the end it moves on with the acceleration of the end: an axis that ends at rest stays,
/// and an axis that ends with a velocity keeps it. So the state at any time is the start of another plan.
#[repr(C)]
pub struct atraj_move {
    /// total duration, s
    pub t: a_float,
    /// number of phases
    pub phases: c_uint,
    /// the phases in order of time; after the last one is a phase without duration, the end
    pub phase: [atraj_phase; 16],
}
assert_same_layout!(atraj_move, Move<Number>, t phases = count phase);

/// @brief Fill limits that are the same in both directions, in the order of `a_trajbell_gen`. The signs are ignored.
/// @param limits points to the limits to fill; nothing happens if it is NULL
/// @param jm maximum jerk, unit/s^3; `am` acceleration, unit/s^2; `vm` velocity, unit/s
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_limits_init(limits: *mut atraj_limits, jm: a_float, am: a_float, vm: a_float) {
    // SAFETY: `limits` is NULL or valid by the contract of this module, and the layouts are the same.
    if let Some(limits) = unsafe { of_mut(limits) } {
        *limits = Limits::symmetric(jm.into(), am.into(), vm.into());
    }
}

/// @brief Plan the fastest move from any state to a state within the limits.
///
/// If the start violates the limits, the axis returns within them in minimum time and then stays within them. The target may be anywhere: behind,
/// or nearer than the stopping distance.
/// @return 0, or a sum of `ATRAJ_OVERSHOOTS`, `ATRAJ_STARTS_OUTSIDE` and `ATRAJ_ENDS_LEAVING`; else an `atraj_error`: `ATRAJ_ERR_NULL`,
/// `ATRAJ_ERR_NOT_FINITE`, `ATRAJ_ERR_LIMITS`, or `ATRAJ_ERR_TARGET` if `to` is outside the limits or the axis must have left them before
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_plan(
    ctx: *mut atraj_move, limits: *const atraj_limits, from: *const atraj_state, to: *const atraj_state,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    answer(|| unsafe { Some(of_mut(ctx)?.plan(of(limits)?, *of(from)?, *of(to)?)) })
}

/// @brief Plan the fastest move to a state, as `atraj_move_plan` does, that stays between two positions until its end.
///
/// Where the fastest stop would leave a position, the axis brakes harder, and turns at this position, then at the other one if it must. It is refused
/// only if no move stays between the positions: the hardest brake leaves them, or the state `to` cannot be reached from within them.
/// @param lowest lowest position, unit; minus infinity: none
/// @param highest highest position, unit, above `lowest`; infinity: none
/// @return as `atraj_move_plan`; `ATRAJ_ERR_POSITION` if no move stays between the positions up to 128 ulps of them and of four times its way,
/// `ATRAJ_ERR_NOT_FINITE` also if one of them is not a number, `ATRAJ_ERR_LIMITS` also if `lowest` is not below `highest`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_within(
    ctx: *mut atraj_move, limits: *const atraj_limits, from: *const atraj_state, to: *const atraj_state,
    lowest: a_float, highest: a_float,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    answer(|| unsafe { Some(of_mut(ctx)?.within(of(limits)?, *of(from)?, *of(to)?, lowest.into(), highest.into())) })
}

/// @brief Plan the fastest move from any state to the velocity `v1`, unit/s, and the acceleration `a1`, unit/s^2,
/// within the limits. The position is free.
/// @return as `atraj_move_plan`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_reach(
    ctx: *mut atraj_move, limits: *const atraj_limits, from: *const atraj_state, v1: a_float, a1: a_float,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    answer(|| unsafe { Some(of_mut(ctx)?.reach(of(limits)?, *of(from)?, v1.into(), a1.into())) })
}

/// @brief Plan the fastest stop: `atraj_move_reach` with `v1` and `a1` 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_stop(
    ctx: *mut atraj_move, limits: *const atraj_limits, from: *const atraj_state,
) -> c_int {
    // SAFETY: both functions have the same contract.
    unsafe { atraj_move_reach(ctx, limits, from, 0.0, 0.0) }
}

/// @brief Plan the fastest move to a target that moves on at constant velocity.
///
/// The move ends level with the target, with its velocity, at the position `target->p + t * target->v`.
/// @param target points to the state of the target at the start
/// @return as `atraj_move_plan`; `ATRAJ_ERR_TARGET` if `target->a` is not 0, or `target->v` is not strictly inside the limits
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_meet(
    ctx: *mut atraj_move, limits: *const atraj_limits, from: *const atraj_state, target: *const atraj_state,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    answer(|| unsafe { Some(of_mut(ctx)?.meet(of(limits)?, *of(from)?, *of(target)?)) })
}

/// @brief Plan the next moments of an axis that follows a signal: call it in every tick, drive one tick of the plan, and call it again.
///
/// The signal is taken to go on with its jerk for the time `horizon`. If the axis can meet it after this time, the move lasts exactly this
/// long and varies smoothly with the signal, so noise does not make the jerk chatter. An axis that is on a signal at rest or at a constant
/// velocity stays on it. A signal that is farther away is chased with whatever limits the signal leaves over.
///
/// `ctx->t` is `horizon`, or later in a chase. The plan keeps the limits, and the axis can keep them from then on. A signal beyond the limits is followed as well as they
/// allow; the plan then lasts as long as `atraj_move_plan` takes to where the signal is now.
/// @param from points to the state of the axis
/// @param signal points to the state of the signal
/// @param jerk jerk of the signal, unit/s^3; 0 if it is not known. If it is estimated from noisy data, filter it first
/// @param horizon time until the axis is to be next to the signal, s; a longer one smooths more
/// @return 0, or a sum of findings as `atraj_move_plan`; else `ATRAJ_ERR_NULL`, `ATRAJ_ERR_NOT_FINITE`, `ATRAJ_ERR_LIMITS`, or
/// `ATRAJ_ERR_DURATION` if `horizon` is not above 0 or not finite
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_track(
    ctx: *mut atraj_move, limits: *const atraj_limits, from: *const atraj_state, signal: *const atraj_state,
    jerk: a_float, horizon: a_float,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    answer(|| unsafe { Some(of_mut(ctx)?.track(of(limits)?, *of(from)?, *of(signal)?, jerk.into(), horizon.into())) })
}

/// @brief Position, unit: the first one before the start, the last one for a NaN or infinite `time`, and after the end
/// that of an axis that moves on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_pos(ctx: *const atraj_move, time: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    value(unsafe { of(ctx) }, |ctx| ctx.position(time.into()))
}

/// @brief Velocity, unit/s: the first one before the start, the last one for a NaN or infinite `time`, and after the end
/// that of an axis that moves on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_vel(ctx: *const atraj_move, time: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    value(unsafe { of(ctx) }, |ctx| ctx.velocity(time.into()))
}

/// @brief Acceleration, unit/s^2: the first one before the start, the last one after the end and for a NaN `time`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_acc(ctx: *const atraj_move, time: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    value(unsafe { of(ctx) }, |ctx| ctx.acceleration(time.into()))
}

/// @brief Jerk, unit/s^3: 0 before the start, after the end and for a NaN `time`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_jer(ctx: *const atraj_move, time: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    value(unsafe { of(ctx) }, |ctx| ctx.jerk(time.into()))
}

/// @brief State of a move at one time: position, velocity, acceleration and jerk. It is the start of another plan.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_state(
    ctx: *const atraj_move, time: a_float, pos: *mut a_float, vel: *mut a_float, acc: *mut a_float, jer: *mut a_float,
) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write([pos, vel, acc, jer], of(ctx).map(|ctx| ctx.state(time.into()))) };
}

/// @brief Sample a move: positions, velocities, accelerations and jerks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_sample(
    ctx: *const atraj_move, start: a_float, dt: a_float, n: usize, pos: *mut a_float, vel: *mut a_float,
    acc: *mut a_float, jer: *mut a_float,
) -> usize {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { sample(of(ctx), [pos, vel, acc, jer], n, |ctx, to| ctx.sample_into(start.into(), dt.into(), to)) }
}

/// @brief The lowest and the highest position, velocity and acceleration from start to end, each at its own time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_extremes(
    ctx: *const atraj_move, lowest: *mut atraj_state, highest: *mut atraj_state,
) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write_extremes(of(ctx).map(Move::extremes), lowest.cast(), highest.cast()) };
}

/// @brief Examine a move against limits, before it runs: what it exceeds, whether it jumps, and whether its phases lead to its end.
///
/// A step of the acceleration exceeds a finite jerk. Any struct may be examined. The function reads its numbers alone, and judges limits and
/// jumps by code of its own. Up to 64 ulps are allowed: of `|p| + |v| t` for positions; for velocities of `|v|`, what the accelerations
/// add, the velocities in which the jerk ends those at the start and at the end, and what the limits allow in the time of the move; of
/// `|a| + |j| t` for accelerations, where a step counts the limit of the jerk; of the limits for jerks; 128 where the move turns outside of
/// its ends. What a 0 proves is in `proofs/README.md`.
/// @return 0 or a sum of `atraj_finding`, also the ones of a plan; else `ATRAJ_ERR_NULL`, `ATRAJ_ERR_LIMITS`, or `ATRAJ_ERR_NOT_FINITE` if a
/// number of the move is not finite or a limit is not a number
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_check(ctx: *const atraj_move, limits: *const atraj_limits) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    answer(|| unsafe { Some(of(ctx)?.check(of(limits)?)) })
}

/// @brief When a move is at the position `p`, unit, for the first time.
/// @return time since the start, s, not after the end; NaN if the axis never is at `p` until then
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_time_at(ctx: *const atraj_move, p: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let time = unsafe { of(ctx) }.and_then(|ctx| ctx.time_at(p.into()));
    time.map_or(a_float::NAN, Into::into)
}
