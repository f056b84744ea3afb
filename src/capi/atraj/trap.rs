//! `atraj.h`: the trapezoid that never fails, and what any other does.

use super::{answer, sample, write, write_extremes};
use crate::capi::{a::trajtrap::a_trajtrap, a_float, boundary, of, of_mut};
use crate::liba::Trap;
use core::ffi::c_int;

/// @brief Plan the fastest trapezoidal velocity trajectory. It fails only for the arguments named below.
///
/// A target behind the axis, or nearer than it can stop, makes it turn back. `a_trajtrap_pos` and its siblings evaluate the struct.
/// @param vm maximum velocity, unit/s; its sign is ignored; infinite: no limit
/// @param ac acceleration before constant velocity, unit/s^2, `de` after it: the positive one limits the acceleration
/// towards larger positions, the negative one the acceleration towards smaller positions
/// @param p0 initial position, unit; `p1` final position
/// @param v0 initial velocity, unit/s; `v1` final velocity; both are limited to -vm .. vm
/// @return total duration, s; 0 if there is nothing to do. NaN, and `ctx` is untouched, if an argument is not a number,
/// a limit is 0, `ac` and `de` have one sign, an acceleration or a position is infinite, or `ctx` is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_trap_gen(
    ctx: *mut a_trajtrap, vm: a_float, ac: a_float, de: a_float, p0: a_float, p1: a_float, v0: a_float, v1: a_float,
) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let Some(ctx) = (unsafe { of_mut(ctx) }) else { return a_float::NAN };
    let Ok(fastest) = Trap::fastest(vm.into(), ac.into(), de.into(), boundary(p0, p1, v0, v1)) else {
        return a_float::NAN;
    };
    *ctx = fastest;
    fastest.t.into()
}

/// @brief Examine a trapezoidal velocity trajectory, whichever function planned it.
///
/// 64 ulps are allowed: of |p| + |v| T for positions, of |v| + |a| T for velocities, of the limits for the rest.
/// @param vm as for `atraj_trap_gen`
/// @param ac acceleration, unit/s^2; `de` one of the other sign; infinite: no limit
/// @return 0 for a clean move, else a sum of `atraj_finding`; `ATRAJ_ERR_NULL`, `ATRAJ_ERR_NOT_FINITE` or, if `ac` and
/// `de` have one sign, `ATRAJ_ERR_LIMITS` without an answer
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_trap_check(ctx: *const a_trajtrap, vm: a_float, ac: a_float, de: a_float) -> c_int {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    answer(|| unsafe { Some(of(ctx)?.check(vm.into(), ac.into(), de.into())) })
}

/// @brief The lowest and the highest position, velocity and acceleration of a trapezoidal velocity trajectory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_trap_extremes(ctx: *const a_trajtrap, lowest: *mut a_float, highest: *mut a_float) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write_extremes(of(ctx).map(Trap::extremes), lowest, highest) };
}

/// @brief Sample a trapezoidal velocity trajectory: positions, velocities and accelerations.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_trap_sample(
    ctx: *const a_trajtrap, start: a_float, dt: a_float, n: usize, pos: *mut a_float, vel: *mut a_float,
    acc: *mut a_float,
) -> usize {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { sample(of(ctx), [pos, vel, acc], n, |trap, to| trap.sample_into(start.into(), dt.into(), to)) }
}

/// @brief State of a trapezoidal velocity trajectory: position, velocity and acceleration at one time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_trap_state(
    ctx: *const a_trajtrap, time: a_float, pos: *mut a_float, vel: *mut a_float, acc: *mut a_float,
) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write([pos, vel, acc], of(ctx).map(|trap| trap.state(time.into()))) };
}
