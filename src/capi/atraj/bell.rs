//! `atraj.h`: the double-S that never fails, and what any other does.

use super::{ATRAJ_ERR_NULL, array, code, write, write_extremes};
use crate::capi::a::trajbell::a_trajbell;
use crate::capi::{Number, a_float, boundary};
use crate::liba::Bell;
use crate::sampling::MOST_SAMPLES;
use core::ffi::c_int;

/// @brief Plan the fastest bell-shaped velocity trajectory there is. It exists for all limits and ends that are numbers.
///
/// A jerk, or both accelerations, are finite. A target behind, or nearer than the way to stop, is reached by turning. In a move that
/// decelerates before it accelerates, `vm`, `jm`, `am` and `dm` of the struct have the opposite signs. `a_trajbell_pos` and its siblings
/// evaluate the struct.
/// @param ctx points to an instance of bell-shaped velocity trajectory, which need not be initialised
/// @param jm maximum jerk, unit/s^3; its sign is ignored; infinite: no limit
/// @param am maximum acceleration, unit/s^2; its sign is ignored; infinite: no limit
/// @param vm maximum velocity, unit/s; its sign is ignored; infinite: no limit
/// @param p0 initial position, unit
/// @param p1 final position, unit
/// @param v0 initial velocity, unit/s, limited to -vm .. vm
/// @param v1 final velocity, unit/s, limited to -vm .. vm
/// @return total duration, s; 0 if there is nothing to do. NaN, and `ctx` is untouched, if an argument is not a number, a limit is 0,
/// a position is infinite or `ctx` is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_bell_gen(
    ctx: *mut a_trajbell,
    jm: a_float,
    am: a_float,
    vm: a_float,
    p0: a_float,
    p1: a_float,
    v0: a_float,
    v1: a_float,
) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let Some(ctx) = (unsafe { ctx.cast::<Bell<Number>>().as_mut() }) else {
        return a_float::NAN;
    };
    match Bell::fastest(jm.into(), am.into(), vm.into(), boundary(p0, p1, v0, v1)) {
        Ok(fastest) => {
            *ctx = fastest;
            fastest.t.into()
        }
        Err(_) => a_float::NAN,
    }
}

/// @brief Examine a bell-shaped velocity trajectory, by whatever function it was planned.
///
/// 64 roundings are allowed: of |p| + |v| T for positions, of |v| + |a| T for velocities, of the limits for the rest.
/// @param ctx points to a planned instance of bell-shaped velocity trajectory
/// @param jm maximum jerk, unit/s^3; its sign is ignored; infinite: no limit
/// @param am maximum acceleration, unit/s^2; its sign is ignored; infinite: no limit
/// @param vm maximum velocity, unit/s; its sign is ignored; infinite: no limit
/// @return 0 for a clean move, else a sum of `atraj_finding`; `ATRAJ_ERR_NULL` or `ATRAJ_ERR_NOT_FINITE` without an answer
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_bell_check(
    ctx: *const a_trajbell,
    jm: a_float,
    am: a_float,
    vm: a_float,
) -> c_int {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Bell<Number>>().as_ref() } {
        Some(bell) => code(bell.check(jm.into(), am.into(), vm.into())),
        None => ATRAJ_ERR_NULL as c_int,
    }
}

/// @brief The lowest and the highest position, velocity and acceleration of a bell-shaped velocity trajectory.
/// @param ctx points to a planned instance of bell-shaped velocity trajectory; nothing happens if it is NULL
/// @param lowest the lowest position, velocity and acceleration: NULL or an array of 3
/// @param highest the highest position, velocity and acceleration: NULL or an array of 3
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_bell_extremes(
    ctx: *const a_trajbell,
    lowest: *mut a_float,
    highest: *mut a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    if let Some(bell) = unsafe { ctx.cast::<Bell<Number>>().as_ref() } {
        // SAFETY: the outputs are NULL or have room for three values by the contract of this module.
        unsafe { write_extremes(bell.extremes(), lowest, highest) };
    }
}

/// @brief Sample a bell-shaped velocity trajectory: positions, velocities, accelerations and jerks at evenly spaced times.
///
/// Sample `k` belongs to the time `x0 + k*dt`. It has the bits that the single functions give for this time.
/// @param ctx points to a planned instance of bell-shaped velocity trajectory
/// @param x0 time of sample 0 since the start, s
/// @param dt time from one sample to the next, s; it may be 0 or negative
/// @param n number of samples
/// @param pos position, unit: NULL or an array of `n`
/// @param vel velocity, unit/s: NULL or an array of `n`
/// @param acc acceleration, unit/s^2: NULL or an array of `n`
/// @param jer jerk, unit/s^3: NULL or an array of `n`
/// @return number of samples written: `n` or 2147483647, whichever is less; 0 if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_bell_sample(
    ctx: *const a_trajbell,
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
    let Some(bell) = (unsafe { ctx.cast::<Bell<Number>>().as_ref() }) else {
        return 0;
    };
    // SAFETY: each output is NULL or has room for `n` values by the contract of this module.
    let outputs = [pos, vel, acc, jer].map(|output| unsafe { array::<Number>(output.cast(), n) });
    bell.sample_into(x0.into(), dt.into(), outputs);
    n
}

/// @brief State of a bell-shaped velocity trajectory: position, velocity, acceleration and jerk at one time.
///
/// Each quantity has the bits that its single function gives.
/// @param ctx points to a planned instance of bell-shaped velocity trajectory; if it is NULL, all results are NaN
/// @param x time since the start, s
/// @param pos position, unit: NULL or the place for the result
/// @param vel velocity, unit/s: NULL or the place for the result
/// @param acc acceleration, unit/s^2: NULL or the place for the result
/// @param jer jerk, unit/s^3: NULL or the place for the result
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_bell_state(
    ctx: *const a_trajbell,
    x: a_float,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
    jer: *mut a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let state = match unsafe { ctx.cast::<Bell<Number>>().as_ref() } {
        Some(bell) => bell.state(x.into()).map(Into::into),
        None => [a_float::NAN; 4],
    };
    // SAFETY: each output is NULL or writable by the contract of this module.
    unsafe { write([pos, vel, acc, jer], state) };
}
