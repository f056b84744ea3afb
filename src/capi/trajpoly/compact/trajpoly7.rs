//! `a/trajpoly7.h`: the septic polynomial in the struct of liba since 2025-03, which stores the coefficients of position.

use super::copy_out;
use crate::capi::{Number, a_float, assert_same_layout, boundary, nan};
use crate::liba::{Poly, Poly7};

/// @brief Septic polynomial trajectory.
///
/// Coefficients stand in ascending powers of time: `c[0] + c[1]*x + ...`.
#[repr(C)]
pub struct a_trajpoly7 {
    /// coefficients of position
    pub c: [Number; 8],
}
assert_same_layout!(a_trajpoly7, Poly7<Number>, c);

impl a_trajpoly7 {
    /// The state at a time, from a copy of the coefficients that no output of a call can overlap.
    pub(in crate::capi) fn state(&self) -> impl Fn(Number) -> [Number; 4] + use<> {
        let poly = Poly { c: self.c };
        move |x| poly.state(x)
    }
}

/// @brief Plan a septic polynomial trajectory: all coefficients that the struct holds.
///
/// A duration of 0, an infinity or a NaN gives coefficients that are not finite. Nothing happens if `ctx` is NULL.
/// @param ctx points to an instance of septic polynomial trajectory, which need not be initialised
/// @param ts duration, s, other than 0
/// @param p0 initial position, unit
/// @param p1 final position, unit
/// @param v0 initial velocity, unit/s
/// @param v1 final velocity, unit/s
/// @param a0 initial acceleration, unit/s^2
/// @param a1 final acceleration, unit/s^2
/// @param j0 initial jerk, unit/s^3
/// @param j1 final jerk, unit/s^3
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen(
    ctx: *mut a_trajpoly7,
    ts: a_float,
    p0: a_float,
    p1: a_float,
    v0: a_float,
    v1: a_float,
    a0: a_float,
    a1: a_float,
    j0: a_float,
    j1: a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    if let Some(poly) = unsafe { ctx.cast::<Poly7<Number>>().as_mut() } {
        poly.plan(
            ts.into(),
            boundary(p0, p1, v0, v1),
            [a0.into(), a1.into()],
            [j0.into(), j1.into()],
        );
    }
}

/// @brief Copy the coefficients of position out.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param c0 array of 8, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c0(ctx: *const a_trajpoly7, c0: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let poly = unsafe { ctx.cast::<Poly7<Number>>().as_ref() };
    // SAFETY: `c0` is NULL or has room for 8 by the contract of this module.
    unsafe { copy_out::<8>(poly.copied(), c0) };
}

/// @brief Copy the coefficients of velocity out.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param c1 array of 7, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c1(ctx: *const a_trajpoly7, c1: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let poly = unsafe { ctx.cast::<Poly7<Number>>().as_ref() };
    // SAFETY: `c1` is NULL or has room for 7 by the contract of this module.
    unsafe { copy_out::<7>(poly.map(|poly| poly.derivative()), c1) };
}

/// @brief Copy the coefficients of acceleration out.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param c2 array of 6, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c2(ctx: *const a_trajpoly7, c2: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let poly = unsafe { ctx.cast::<Poly7<Number>>().as_ref() };
    // SAFETY: `c2` is NULL or has room for 6 by the contract of this module.
    unsafe { copy_out::<6>(poly.map(|poly| poly.derivative::<7>().derivative()), c2) };
}

/// @brief Copy the coefficients of jerk out.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param c3 array of 5, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c3(ctx: *const a_trajpoly7, c3: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let poly = unsafe { ctx.cast::<Poly7<Number>>().as_ref() };
    // SAFETY: `c3` is NULL or has room for 5 by the contract of this module.
    unsafe {
        copy_out::<5>(
            poly.map(|poly| poly.derivative::<7>().derivative::<6>().derivative()),
            c3,
        )
    };
}

/// @brief Position of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return position, unit; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_pos(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Poly7<Number>>().as_ref() } {
        Some(poly) => poly.position(x.into()).into(),
        None => nan(),
    }
}

/// @brief Velocity of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return velocity, unit/s; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_vel(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Poly7<Number>>().as_ref() } {
        Some(poly) => poly.velocity(x.into()).into(),
        None => nan(),
    }
}

/// @brief Acceleration of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return acceleration, unit/s^2; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_acc(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Poly7<Number>>().as_ref() } {
        Some(poly) => poly.acceleration(x.into()).into(),
        None => nan(),
    }
}

/// @brief Jerk of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return jerk, unit/s^3; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_jer(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Poly7<Number>>().as_ref() } {
        Some(poly) => poly.jerk(x.into()).into(),
        None => nan(),
    }
}
