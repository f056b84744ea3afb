//! `a/trajpoly3.h`: the cubic polynomial in the struct of liba since 2025-03, which stores the coefficients of position.

use super::copy_out;
use crate::capi::{Number, a_float, assert_same_layout, boundary, nan};
use crate::liba::{Poly, Poly3};

/// @brief Cubic polynomial trajectory.
///
/// Coefficients stand in ascending powers of time: `c[0] + c[1]*x + ...`.
#[repr(C)]
pub struct a_trajpoly3 {
    /// coefficients of position
    pub c: [Number; 4],
}
assert_same_layout!(a_trajpoly3, Poly3<Number>, c);

impl a_trajpoly3 {
    /// The state at a time, from a copy of the coefficients that no output of a call can overlap.
    pub(in crate::capi) fn state(&self) -> impl Fn(Number) -> [Number; 3] + use<> {
        let poly = Poly { c: self.c };
        move |x| {
            let [p, v, a, _] = poly.state(x);
            [p, v, a]
        }
    }
}

/// @brief Plan a cubic polynomial trajectory: all coefficients that the struct holds.
///
/// A duration of 0, an infinity or a NaN gives coefficients that are not finite. Nothing happens if `ctx` is NULL.
/// @param ctx points to an instance of cubic polynomial trajectory, which need not be initialised
/// @param ts duration, s, other than 0
/// @param p0 initial position, unit
/// @param p1 final position, unit
/// @param v0 initial velocity, unit/s
/// @param v1 final velocity, unit/s
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_gen(
    ctx: *mut a_trajpoly3,
    ts: a_float,
    p0: a_float,
    p1: a_float,
    v0: a_float,
    v1: a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    if let Some(poly) = unsafe { ctx.cast::<Poly3<Number>>().as_mut() } {
        poly.plan(ts.into(), boundary(p0, p1, v0, v1));
    }
}

/// @brief Copy the coefficients of position out.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param c0 array of 4, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_c0(ctx: *const a_trajpoly3, c0: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let poly = unsafe { ctx.cast::<Poly3<Number>>().as_ref() };
    // SAFETY: `c0` is NULL or has room for 4 by the contract of this module.
    unsafe { copy_out::<4>(poly.copied(), c0) };
}

/// @brief Copy the coefficients of velocity out.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param c1 array of 3, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_c1(ctx: *const a_trajpoly3, c1: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let poly = unsafe { ctx.cast::<Poly3<Number>>().as_ref() };
    // SAFETY: `c1` is NULL or has room for 3 by the contract of this module.
    unsafe { copy_out::<3>(poly.map(|poly| poly.derivative()), c1) };
}

/// @brief Copy the coefficients of acceleration out.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param c2 array of 2, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_c2(ctx: *const a_trajpoly3, c2: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let poly = unsafe { ctx.cast::<Poly3<Number>>().as_ref() };
    // SAFETY: `c2` is NULL or has room for 2 by the contract of this module.
    unsafe { copy_out::<2>(poly.map(|poly| poly.derivative::<3>().derivative()), c2) };
}

/// @brief Position of a cubic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return position, unit; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_pos(ctx: *const a_trajpoly3, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Poly3<Number>>().as_ref() } {
        Some(poly) => poly.position(x.into()).into(),
        None => nan(),
    }
}

/// @brief Velocity of a cubic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return velocity, unit/s; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_vel(ctx: *const a_trajpoly3, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Poly3<Number>>().as_ref() } {
        Some(poly) => poly.velocity(x.into()).into(),
        None => nan(),
    }
}

/// @brief Acceleration of a cubic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return acceleration, unit/s^2; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_acc(ctx: *const a_trajpoly3, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Poly3<Number>>().as_ref() } {
        Some(poly) => poly.acceleration(x.into()).into(),
        None => nan(),
    }
}
