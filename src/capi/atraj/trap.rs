//! `atraj.h`: the trapezoid that never fails, and what is wrong with any other.

use super::{ATRAJ_ERR_NULL, code, write_extremes};
use crate::capi::trajtrap::a_trajtrap;
use crate::capi::{Number, a_float, boundary};
use crate::liba::Trap;
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
/// @return 0 for a clean move, else a sum of `atraj_finding`; `ATRAJ_ERR_NULL` or `ATRAJ_ERR_NOT_FINITE` without an answer
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
