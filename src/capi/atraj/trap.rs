//! `atraj.h`: the trapezoid that never fails, and what any other does.

use super::{ATRAJ_ERR_NULL, array, code, write, write_extremes};
use crate::capi::a::trajtrap::a_trajtrap;
use crate::capi::{Number, a_float, boundary};
use crate::liba::Trap;
use crate::sampling::MOST_SAMPLES;
use core::ffi::c_int;

/// @brief Plan the fastest trapezoidal velocity trajectory there is. It exists for all limits and ends that are numbers.
///
/// A target behind, or nearer than the way to stop, is reached by turning. `a_trajtrap_pos` and its siblings evaluate the struct.
/// @param ctx points to an instance of trapezoidal velocity trajectory, which need not be initialised
/// @param vm maximum velocity, unit/s; its sign is ignored; infinite: no limit
/// @param ac acceleration before constant velocity, unit/s^2
/// @param de acceleration after constant velocity, unit/s^2. Of `ac` and `de`, the positive one limits the acceleration towards
/// larger positions, the negative one the acceleration towards smaller positions.
/// @param p0 initial position, unit
/// @param p1 final position, unit
/// @param v0 initial velocity, unit/s, limited to -vm .. vm
/// @param v1 final velocity, unit/s, limited to -vm .. vm
/// @return total duration, s; 0 if there is nothing to do. NaN, and `ctx` is untouched, if an argument is not a number, a limit is 0,
/// `ac` and `de` have one sign, an acceleration or a position is infinite, or `ctx` is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_trap_gen(
    ctx: *mut a_trajtrap,
    vm: a_float,
    ac: a_float,
    de: a_float,
    p0: a_float,
    p1: a_float,
    v0: a_float,
    v1: a_float,
) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let Some(ctx) = (unsafe { ctx.cast::<Trap<Number>>().as_mut() }) else {
        return a_float::NAN;
    };
    match Trap::fastest(vm.into(), ac.into(), de.into(), boundary(p0, p1, v0, v1)) {
        Ok(fastest) => {
            *ctx = fastest;
            fastest.t.into()
        }
        Err(_) => a_float::NAN,
    }
}

/// @brief Examine a trapezoidal velocity trajectory, by whatever function it was planned.
///
/// 64 roundings are allowed: of |p| + |v| T for positions, of |v| + |a| T for velocities, of the limits for the rest.
/// @param ctx points to a planned instance of trapezoidal velocity trajectory
/// @param vm maximum velocity, unit/s; its sign is ignored; infinite: no limit
/// @param ac acceleration of one sign, unit/s^2; infinite: no limit
/// @param de acceleration of the other sign, unit/s^2; infinite: no limit
/// @return 0 for a clean move, else a sum of `atraj_finding`; `ATRAJ_ERR_NULL`, `ATRAJ_ERR_NOT_FINITE` or, if `ac` and `de` have one sign,
/// `ATRAJ_ERR_LIMITS` without an answer
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_trap_check(
    ctx: *const a_trajtrap,
    vm: a_float,
    ac: a_float,
    de: a_float,
) -> c_int {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Trap<Number>>().as_ref() } {
        Some(trap) => code(trap.check(vm.into(), ac.into(), de.into())),
        None => ATRAJ_ERR_NULL as c_int,
    }
}

/// @brief The lowest and the highest position, velocity and acceleration of a trapezoidal velocity trajectory.
/// @param ctx points to a planned instance of trapezoidal velocity trajectory; nothing happens if it is NULL
/// @param lowest the lowest position, velocity and acceleration: NULL or an array of 3
/// @param highest the highest position, velocity and acceleration: NULL or an array of 3
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_trap_extremes(
    ctx: *const a_trajtrap,
    lowest: *mut a_float,
    highest: *mut a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    if let Some(trap) = unsafe { ctx.cast::<Trap<Number>>().as_ref() } {
        // SAFETY: the outputs are NULL or have room for three values by the contract of this module.
        unsafe { write_extremes(trap.extremes(), lowest, highest) };
    }
}

/// @brief Sample a trapezoidal velocity trajectory: positions, velocities and accelerations at evenly spaced times.
///
/// Sample `k` belongs to the time `x0 + k*dt`. It has the bits that the single functions give for this time.
/// @param ctx points to a planned instance of trapezoidal velocity trajectory
/// @param x0 time of sample 0 since the start, s
/// @param dt time from one sample to the next, s; it may be 0 or negative
/// @param n number of samples
/// @param pos position, unit: NULL or an array of `n`
/// @param vel velocity, unit/s: NULL or an array of `n`
/// @param acc acceleration, unit/s^2: NULL or an array of `n`
/// @return number of samples written: `n` or 2147483647, whichever is less; 0 if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_trap_sample(
    ctx: *const a_trajtrap,
    x0: a_float,
    dt: a_float,
    n: usize,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
) -> usize {
    let n = n.min(MOST_SAMPLES);
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let Some(trap) = (unsafe { ctx.cast::<Trap<Number>>().as_ref() }) else {
        return 0;
    };
    // SAFETY: each output is NULL or has room for `n` values by the contract of this module.
    let outputs = [pos, vel, acc].map(|output| unsafe { array::<Number>(output.cast(), n) });
    trap.sample_into(x0.into(), dt.into(), outputs);
    n
}

/// @brief State of a trapezoidal velocity trajectory: position, velocity and acceleration at one time.
///
/// Each quantity has the bits that its single function gives.
/// @param ctx points to a planned instance of trapezoidal velocity trajectory; if it is NULL, all results are NaN
/// @param x time since the start, s
/// @param pos position, unit: NULL or the place for the result
/// @param vel velocity, unit/s: NULL or the place for the result
/// @param acc acceleration, unit/s^2: NULL or the place for the result
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_trap_state(
    ctx: *const a_trajtrap,
    x: a_float,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let state = match unsafe { ctx.cast::<Trap<Number>>().as_ref() } {
        Some(trap) => trap.state(x.into()).map(Into::into),
        None => [a_float::NAN; 3],
    };
    // SAFETY: each output is NULL or writable by the contract of this module.
    unsafe { write([pos, vel, acc], state) };
}
