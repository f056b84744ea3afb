//! `atraj.h`: the double-S and the trapezoid that never fail, and what any profile does. A polynomial limits nothing between its ends.

use super::{answer, sample, write, write_extremes};
use crate::capi::a::{
    trajbell::a_trajbell, trajpoly3::a_trajpoly3, trajpoly5::a_trajpoly5, trajpoly7::a_trajpoly7, trajtrap::a_trajtrap,
};
use crate::capi::{Number, a_float, boundary, of, of_mut};
use crate::liba::{Bell, Trap};
use crate::sampling::Sweep;
use core::ffi::c_int;

/// @brief Plan the fastest bell-shaped velocity trajectory. It fails only for the arguments named below.
///
/// A jerk, or both accelerations, are finite. A target behind the axis, or nearer than it can stop, makes it turn back.
/// In a move that decelerates before it accelerates, `vm`, `jm`, `am` and `dm` of the struct have the opposite signs.
/// `a_trajbell_pos` and its siblings evaluate the struct.
/// @param jm maximum jerk, unit/s^3; `am` acceleration, unit/s^2; `vm` velocity, unit/s; signs are ignored; infinite:
/// no limit
/// @param p0 initial position, unit; `p1` final position
/// @param v0 initial velocity, unit/s; `v1` final velocity; both are limited to -vm .. vm
/// @return total duration, s; 0 if there is nothing to do. NaN, and `ctx` is untouched, if an argument is not a number,
/// a limit is 0, jerk and acceleration, a position or a velocity without a limit are infinite, or `ctx` is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_bell_gen(
    ctx: *mut a_trajbell, jm: a_float, am: a_float, vm: a_float, p0: a_float, p1: a_float, v0: a_float, v1: a_float,
) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let Some(ctx) = (unsafe { of_mut(ctx) }) else { return a_float::NAN };
    let Ok(fastest) = Bell::fastest(jm.into(), am.into(), vm.into(), boundary(p0, p1, v0, v1)) else {
        return a_float::NAN;
    };
    *ctx = fastest;
    fastest.t.into()
}

/// @brief Examine a bell-shaped velocity trajectory, whichever function planned it.
///
/// 64 ulps are allowed: of |p| + |v| T for positions, of |v| + |a| T for velocities, of the limits for the rest.
/// @param jm as for `atraj_bell_gen`, also `am` and `vm`
/// @return 0 for a clean move, else a sum of `atraj_finding`; `ATRAJ_ERR_NULL` or `ATRAJ_ERR_NOT_FINITE` without an
/// answer
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_bell_check(ctx: *const a_trajbell, jm: a_float, am: a_float, vm: a_float) -> c_int {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    answer(|| unsafe { Some(of(ctx)?.check(jm.into(), am.into(), vm.into())) })
}

/// @brief The lowest and the highest position, velocity and acceleration of a bell-shaped velocity trajectory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_bell_extremes(ctx: *const a_trajbell, lowest: *mut a_float, highest: *mut a_float) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write_extremes(of(ctx).map(Bell::extremes), lowest, highest) };
}

/// @brief Sample a bell-shaped velocity trajectory: positions, velocities, accelerations and jerks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_bell_sample(
    ctx: *const a_trajbell, start: a_float, dt: a_float, n: usize, pos: *mut a_float, vel: *mut a_float,
    acc: *mut a_float, jer: *mut a_float,
) -> usize {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { sample(of(ctx), [pos, vel, acc, jer], n, |bell, to| bell.sample_into(start.into(), dt.into(), to)) }
}

/// @brief State of a bell-shaped velocity trajectory: position, velocity, acceleration and jerk at one time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_bell_state(
    ctx: *const a_trajbell, time: a_float, pos: *mut a_float, vel: *mut a_float, acc: *mut a_float, jer: *mut a_float,
) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write([pos, vel, acc, jer], of(ctx).map(|bell| bell.state(time.into()))) };
}

/// @brief Plan the fastest trapezoidal velocity trajectory. It fails only for the arguments named below.
///
/// A target behind the axis, or nearer than it can stop, makes it turn back. `a_trajtrap_pos` and its siblings evaluate the struct.
/// @param vm maximum velocity, unit/s; its sign is ignored; infinite: no limit
/// @param ac acceleration before constant velocity, unit/s^2, `de` after it: the positive one limits the acceleration
/// towards larger positions, the negative one the acceleration towards smaller positions
/// @param p0 initial position, unit; `p1` final position
/// @param v0 initial velocity, unit/s; `v1` final velocity; both are limited to -vm .. vm
/// @return total duration, s; 0 if there is nothing to do. NaN, and `ctx` is untouched, if an argument is not a number,
/// a limit is 0, `ac` and `de` have one sign, an acceleration, a position or a velocity without a limit is infinite, or
/// `ctx` is NULL.
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

/// @brief The lowest and the highest position, velocity and acceleration of a cubic polynomial trajectory.
/// @param ts duration, s, with which it was planned: the struct does not hold it
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly3_extremes(
    ctx: *const a_trajpoly3, ts: a_float, lowest: *mut a_float, highest: *mut a_float,
) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write_extremes(of(ctx).map(|poly| poly.extremes(ts.into())), lowest, highest) };
}

/// @brief Sample a cubic polynomial trajectory: positions, velocities and accelerations.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly3_sample(
    ctx: *const a_trajpoly3, start: a_float, dt: a_float, n: usize, pos: *mut a_float, vel: *mut a_float,
    acc: *mut a_float,
) -> usize {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { sample(ctx.as_ref(), [pos, vel, acc], n, |poly, to| sweep(start, dt).fill(to, poly.state())) }
}

/// @brief State of a cubic polynomial trajectory: position, velocity and acceleration at one time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly3_state(
    ctx: *const a_trajpoly3, time: a_float, pos: *mut a_float, vel: *mut a_float, acc: *mut a_float,
) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write([pos, vel, acc], ctx.as_ref().map(|poly| poly.state()(time.into()))) };
}

/// @brief The lowest and the highest position, velocity and acceleration of a quintic polynomial trajectory.
/// @param ts duration, s, with which it was planned: the struct does not hold it
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly5_extremes(
    ctx: *const a_trajpoly5, ts: a_float, lowest: *mut a_float, highest: *mut a_float,
) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write_extremes(of(ctx).map(|poly| poly.extremes(ts.into())), lowest, highest) };
}

/// @brief Sample a quintic polynomial trajectory: positions, velocities and accelerations.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly5_sample(
    ctx: *const a_trajpoly5, start: a_float, dt: a_float, n: usize, pos: *mut a_float, vel: *mut a_float,
    acc: *mut a_float,
) -> usize {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { sample(ctx.as_ref(), [pos, vel, acc], n, |poly, to| sweep(start, dt).fill(to, poly.state())) }
}

/// @brief State of a quintic polynomial trajectory: position, velocity and acceleration at one time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly5_state(
    ctx: *const a_trajpoly5, time: a_float, pos: *mut a_float, vel: *mut a_float, acc: *mut a_float,
) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write([pos, vel, acc], ctx.as_ref().map(|poly| poly.state()(time.into()))) };
}

/// @brief The lowest and the highest position, velocity and acceleration of a septic polynomial trajectory.
/// @param ts duration, s, with which it was planned: the struct does not hold it
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly7_extremes(
    ctx: *const a_trajpoly7, ts: a_float, lowest: *mut a_float, highest: *mut a_float,
) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write_extremes(of(ctx).map(|poly| poly.extremes(ts.into())), lowest, highest) };
}

/// @brief Sample a septic polynomial trajectory: positions, velocities, accelerations and jerks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly7_sample(
    ctx: *const a_trajpoly7, start: a_float, dt: a_float, n: usize, pos: *mut a_float, vel: *mut a_float,
    acc: *mut a_float, jer: *mut a_float,
) -> usize {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { sample(ctx.as_ref(), [pos, vel, acc, jer], n, |poly, to| sweep(start, dt).fill(to, poly.state())) }
}

/// @brief State of a septic polynomial trajectory: position, velocity, acceleration and jerk at one time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly7_state(
    ctx: *const a_trajpoly7, time: a_float, pos: *mut a_float, vel: *mut a_float, acc: *mut a_float, jer: *mut a_float,
) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write([pos, vel, acc, jer], ctx.as_ref().map(|poly| poly.state()(time.into()))) };
}

fn sweep(start: a_float, dt: a_float) -> Sweep<Number> {
    Sweep { x0: start.into(), dt: dt.into() }
}
