//! `atraj/move.h`: one axis from any state to any state.

use super::{ATRAJ_ERR_NULL, array, code, write};
use crate::capi::{Number, a_float, assert_same_layout, nan};
use crate::online::{Limits, Move, Phase};
use crate::sampling::MOST_SAMPLES;
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
assert_same_layout!(
    atraj_state,
    State<Number>,
    p = position,
    v = velocity,
    a = acceleration
);

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
assert_same_layout!(
    atraj_phase,
    Phase<Number>,
    t = start,
    duration = duration,
    p = position,
    v = velocity,
    a = acceleration,
    j = jerk
);

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
    /// the phases in order of time; behind the last one is a phase without duration, the end
    pub phase: [atraj_phase; 16],
}
assert_same_layout!(
    atraj_move,
    Move<Number>,
    t = t,
    phases = count,
    phase = phase
);

/// @brief Fill limits that are the same in both directions, in the order of `a_trajbell_gen`. The signs are ignored.
/// @param limits points to the limits to fill; nothing happens if it is NULL
/// @param jm maximum jerk, unit/s^3
/// @param am maximum acceleration, unit/s^2
/// @param vm maximum velocity, unit/s
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_limits_init(
    limits: *mut atraj_limits,
    jm: a_float,
    am: a_float,
    vm: a_float,
) {
    // SAFETY: `limits` is NULL or valid by the contract of this module, and the layouts are the same.
    if let Some(limits) = unsafe { limits.cast::<Limits<Number>>().as_mut() } {
        *limits = Limits::symmetric(jm.into(), am.into(), vm.into());
    }
}

/// @brief Plan the fastest move from any state to a state within the limits.
///
/// A start outside the limits comes inside in the fastest way and keeps the limits from then on. The target may be anywhere: behind,
/// or nearer than the way to stop.
/// @param ctx points to an instance of a move, which need not be initialised; untouched on an error
/// @param limits points to the limits
/// @param from points to the state at the start
/// @param to points to the state at the end
/// @return 0, or a sum of `ATRAJ_OVERSHOOTS`, `ATRAJ_STARTS_OUTSIDE` and `ATRAJ_ENDS_LEAVING`; else an `atraj_error`: `ATRAJ_ERR_NULL`,
/// `ATRAJ_ERR_NOT_FINITE`, `ATRAJ_ERR_LIMITS`, or `ATRAJ_ERR_TARGET` if `to` is outside the limits or the axis must have left them before
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_plan(
    ctx: *mut atraj_move,
    limits: *const atraj_limits,
    from: *const atraj_state,
    to: *const atraj_state,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { (moves(ctx), limits_of(limits), state(from), state(to)) } {
        (Some(ctx), Some(limits), Some(from), Some(to)) => code(ctx.plan(limits, from, to)),
        _ => ATRAJ_ERR_NULL as c_int,
    }
}

/// @brief Plan the fastest move to a state, as `atraj_move_plan` does, if it stays between two positions until its end.
///
/// If it does not, an axis in the state `from` cannot stop between the positions, or the state `to` cannot be reached from rest between
/// them. An axis that can stop there, and that has a target at rest there, is never refused.
/// @param ctx points to an instance of a move, which need not be initialised; untouched on an error
/// @param limits points to the limits
/// @param from points to the state at the start
/// @param to points to the state at the end
/// @param lowest lowest position, unit; minus infinity: none
/// @param highest highest position, unit, above `lowest`; infinity: none
/// @return as `atraj_move_plan`; `ATRAJ_ERR_POSITION` if the fastest move leaves the positions by more than 128 roundings,
/// `ATRAJ_ERR_NOT_FINITE` also if one of them is not a number, `ATRAJ_ERR_LIMITS` also if `lowest` is not below `highest`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_within(
    ctx: *mut atraj_move,
    limits: *const atraj_limits,
    from: *const atraj_state,
    to: *const atraj_state,
    lowest: a_float,
    highest: a_float,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { (moves(ctx), limits_of(limits), state(from), state(to)) } {
        (Some(ctx), Some(limits), Some(from), Some(to)) => {
            code(ctx.within(limits, from, to, lowest.into(), highest.into()))
        }
        _ => ATRAJ_ERR_NULL as c_int,
    }
}

/// @brief Plan the fastest move from any state to a velocity and an acceleration within the limits. The position is free.
/// @param ctx points to an instance of a move, which need not be initialised; untouched on an error
/// @param limits points to the limits
/// @param from points to the state at the start
/// @param v1 velocity at the end, unit/s
/// @param a1 acceleration at the end, unit/s^2
/// @return as `atraj_move_plan`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_reach(
    ctx: *mut atraj_move,
    limits: *const atraj_limits,
    from: *const atraj_state,
    v1: a_float,
    a1: a_float,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { (moves(ctx), limits_of(limits), state(from)) } {
        (Some(ctx), Some(limits), Some(from)) => {
            code(ctx.reach(limits, from, v1.into(), a1.into()))
        }
        _ => ATRAJ_ERR_NULL as c_int,
    }
}

/// @brief Plan the fastest stop. The position is free.
/// @param ctx points to an instance of a move, which need not be initialised; untouched on an error
/// @param limits points to the limits
/// @param from points to the state at the start
/// @return as `atraj_move_plan`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_stop(
    ctx: *mut atraj_move,
    limits: *const atraj_limits,
    from: *const atraj_state,
) -> c_int {
    // SAFETY: both functions have the same contract.
    unsafe { atraj_move_reach(ctx, limits, from, 0.0, 0.0) }
}

/// @brief Plan the fastest move to a target that moves on at constant velocity.
///
/// The move ends beside the target, with its velocity, at the position `target->p + t * target->v`.
/// @param ctx points to an instance of a move, which need not be initialised; untouched on an error
/// @param limits points to the limits
/// @param from points to the state at the start
/// @param target points to the state of the target at the start
/// @return as `atraj_move_plan`; `ATRAJ_ERR_TARGET` if `target->a` is not 0, or `target->v` is not inside the limits or is on them
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_meet(
    ctx: *mut atraj_move,
    limits: *const atraj_limits,
    from: *const atraj_state,
    target: *const atraj_state,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { (moves(ctx), limits_of(limits), state(from), state(target)) } {
        (Some(ctx), Some(limits), Some(from), Some(target)) => code(ctx.meet(limits, from, target)),
        _ => ATRAJ_ERR_NULL as c_int,
    }
}

/// @brief Plan one tick of an axis that follows a signal: call it in every tick, drive one tick of the plan, and call it again.
///
/// The signal is taken to go on with its acceleration. Where the axis can be beside it after the time `horizon`, the axis gets there in just
/// this time, and `ctx->t` is `horizon`: the answer changes evenly with the signal, so noise does not switch the jerk. Where the signal is
/// farther, the axis meets it as fast as it can, as `atraj_move_meet` does. A signal beyond the limits is followed as well as they allow.
/// @param ctx points to an instance of a move, which need not be initialised; untouched on an error
/// @param limits points to the limits
/// @param from points to the state of the axis
/// @param signal points to the state of the signal
/// @param horizon time until the axis is to be beside the signal, s
/// @return 0, or a sum of findings as `atraj_move_plan`; else `ATRAJ_ERR_NULL`, `ATRAJ_ERR_NOT_FINITE`, `ATRAJ_ERR_LIMITS`, or
/// `ATRAJ_ERR_DURATION` if `horizon` is not above 0 or not finite
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_track(
    ctx: *mut atraj_move,
    limits: *const atraj_limits,
    from: *const atraj_state,
    signal: *const atraj_state,
    horizon: a_float,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { (moves(ctx), limits_of(limits), state(from), state(signal)) } {
        (Some(ctx), Some(limits), Some(from), Some(signal)) => {
            code(ctx.track(limits, from, signal, horizon.into()))
        }
        _ => ATRAJ_ERR_NULL as c_int,
    }
}

/// @brief Position of a move.
/// @param ctx points to a planned instance of a move
/// @param x time since the start, s
/// @return position, unit: the first one before the start, the last one for a NaN or infinite `x`, and after the end that of an axis that moves
/// on; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_pos(ctx: *const atraj_move, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Move<Number>>().as_ref() } {
        Some(ctx) => ctx.position(x.into()).into(),
        None => nan(),
    }
}

/// @brief Velocity of a move.
/// @param ctx points to a planned instance of a move
/// @param x time since the start, s
/// @return velocity, unit/s: the first one before the start, the last one for a NaN or infinite `x`, and after the end that of an axis that moves
/// on; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_vel(ctx: *const atraj_move, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Move<Number>>().as_ref() } {
        Some(ctx) => ctx.velocity(x.into()).into(),
        None => nan(),
    }
}

/// @brief Acceleration of a move.
/// @param ctx points to a planned instance of a move
/// @param x time since the start, s
/// @return acceleration, unit/s^2: the first one before the start, the last one after the end and for a NaN `x`; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_acc(ctx: *const atraj_move, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Move<Number>>().as_ref() } {
        Some(ctx) => ctx.acceleration(x.into()).into(),
        None => nan(),
    }
}

/// @brief Jerk of a move.
/// @param ctx points to a planned instance of a move
/// @param x time since the start, s
/// @return jerk, unit/s^3: 0 before the start, after the end and for a NaN `x`; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_jer(ctx: *const atraj_move, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Move<Number>>().as_ref() } {
        Some(ctx) => ctx.jerk(x.into()).into(),
        None => nan(),
    }
}

/// @brief State of a move: position, velocity, acceleration and jerk at one time.
///
/// Each quantity has the bits that its single function gives. The state is the start of another plan.
/// @param ctx points to a planned instance of a move; if it is NULL, all results are NaN
/// @param x time since the start, s
/// @param pos position, unit: NULL or the place for the result
/// @param vel velocity, unit/s: NULL or the place for the result
/// @param acc acceleration, unit/s^2: NULL or the place for the result
/// @param jer jerk, unit/s^3: NULL or the place for the result
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_state(
    ctx: *const atraj_move,
    x: a_float,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
    jer: *mut a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let state = match unsafe { ctx.cast::<Move<Number>>().as_ref() } {
        Some(ctx) => ctx.state(x.into()).map(Into::into),
        None => [a_float::NAN; 4],
    };
    // SAFETY: each output is NULL or writable by the contract of this module.
    unsafe { write([pos, vel, acc, jer], state) };
}

/// @brief Sample a move: positions, velocities, accelerations and jerks at evenly spaced times.
///
/// Sample `k` belongs to the time `x0 + k*dt`. It has the bits that the single functions give for this time.
/// @param ctx points to a planned instance of a move
/// @param x0 time of sample 0 since the start, s
/// @param dt time from one sample to the next, s; it may be 0 or negative
/// @param n number of samples
/// @param pos position, unit: NULL or an array of `n`
/// @param vel velocity, unit/s: NULL or an array of `n`
/// @param acc acceleration, unit/s^2: NULL or an array of `n`
/// @param jer jerk, unit/s^3: NULL or an array of `n`
/// @return number of samples written: `n` or 2147483647, whichever is less; 0 if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_sample(
    ctx: *const atraj_move,
    x0: a_float,
    dt: a_float,
    n: usize,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
    jer: *mut a_float,
) -> usize {
    let n = n.min(MOST_SAMPLES);
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let Some(ctx) = (unsafe { ctx.cast::<Move<Number>>().as_ref() }) else {
        return 0;
    };
    // SAFETY: each output is NULL or has room for `n` values by the contract of this module.
    let outputs = [pos, vel, acc, jer].map(|output| unsafe { array::<Number>(output.cast(), n) });
    ctx.sample_into(x0.into(), dt.into(), outputs);
    n
}

/// @brief The lowest and the highest position, velocity and acceleration of a move from its start to its end, each at its own time.
/// @param ctx points to a planned instance of a move; nothing happens if it is NULL
/// @param lowest NULL or the place for the lowest ones
/// @param highest NULL or the place for the highest ones
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_extremes(
    ctx: *const atraj_move,
    lowest: *mut atraj_state,
    highest: *mut atraj_state,
) {
    // SAFETY: the pointers are NULL or valid by the contract of this module, and the layouts are the same.
    unsafe {
        if let Some(ctx) = ctx.cast::<Move<Number>>().as_ref() {
            super::write_extremes(ctx.extremes(), lowest.cast(), highest.cast());
        }
    }
}

/// @brief Examine a move against limits, before it runs: what it exceeds, whether it jumps or ends elsewhere than its phases lead.
///
/// A step of the acceleration exceeds a finite jerk. Any struct may be examined. The function reads its numbers alone, and has nothing in
/// common with the planners. Up to 64 roundings are allowed: of `|p| + |v| t` for positions; for velocities of `|v|`, what the accelerations
/// add and what the limits allow in the time of the move; of `|a| + |j| t` for accelerations; of the limits for jerks.
/// @param ctx points to a move
/// @param limits points to the limits
/// @return 0 or a sum of `atraj_finding`, also the ones of a plan; else `ATRAJ_ERR_NULL`, `ATRAJ_ERR_LIMITS`, or `ATRAJ_ERR_NOT_FINITE` if a
/// number of the move is not finite or a limit is not a number
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_check(
    ctx: *const atraj_move,
    limits: *const atraj_limits,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { (ctx.cast::<Move<Number>>().as_ref(), limits_of(limits)) } {
        (Some(ctx), Some(limits)) => code(ctx.check(limits)),
        _ => ATRAJ_ERR_NULL as c_int,
    }
}

/// @brief When a move is at a position for the first time.
/// @param ctx points to a planned instance of a move
/// @param p position, unit
/// @return time since the start, s, not after the end; NaN if the axis never is at `p` until then, or if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_move_time_at(ctx: *const atraj_move, p: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let time = unsafe { ctx.cast::<Move<Number>>().as_ref() }.and_then(|ctx| ctx.time_at(p.into()));
    time.map_or(a_float::NAN, Into::into)
}

/// # Safety
/// `ctx` is NULL or valid.
unsafe fn moves<'a>(ctx: *mut atraj_move) -> Option<&'a mut Move<Number>> {
    // SAFETY: by the contract of this function; the layouts are the same.
    unsafe { ctx.cast::<Move<Number>>().as_mut() }
}

/// # Safety
/// `limits` is NULL or valid.
pub(super) unsafe fn limits_of<'a>(limits: *const atraj_limits) -> Option<&'a Limits<Number>> {
    // SAFETY: by the contract of this function; the layouts are the same.
    unsafe { limits.cast::<Limits<Number>>().as_ref() }
}

/// # Safety
/// `state` is NULL or valid.
pub(super) unsafe fn state(state: *const atraj_state) -> Option<State<Number>> {
    // SAFETY: by the contract of this function; the layouts are the same.
    unsafe { state.cast::<State<Number>>().as_ref().copied() }
}
