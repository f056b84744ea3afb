//! `atraj.h`: what a polynomial does, which limits nothing between its ends.

use super::{sample, write, write_extremes};
use crate::capi::a::{trajpoly3::a_trajpoly3, trajpoly5::a_trajpoly5, trajpoly7::a_trajpoly7};
use crate::capi::{Number, a_float, of};
use crate::sampling::Sweep;

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
