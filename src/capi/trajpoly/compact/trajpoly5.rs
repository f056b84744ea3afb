//! `a/trajpoly5.h`: the quintic polynomial in the struct of liba since 2025-03, which stores the coefficients of position.

use super::copy_out;
use crate::capi::{Number, a_float, assert_same_layout, boundary, nan};
use crate::liba::{Poly, Poly5};

/// @brief Quintic polynomial trajectory.
///
/// Coefficients stand in ascending powers of time: `c[0] + c[1]*x + ...`.
#[repr(C)]
pub struct a_trajpoly5 {
    /// coefficients of position
    pub c: [Number; 6],
}
assert_same_layout!(a_trajpoly5, Poly5<Number>, c);

impl a_trajpoly5 {
    /// The state at a time, from a copy of the coefficients that no output of a call can overlap.
    pub(in crate::capi) fn state(&self) -> impl Fn(Number) -> [Number; 3] + use<> {
        let poly = Poly { c: self.c };
        move |x| {
            let [p, v, a, _] = poly.state(x);
            [p, v, a]
        }
    }
}

/// @brief Plan a quintic polynomial trajectory: all coefficients that the struct holds.
///
/// A duration of 0, an infinity or a NaN gives coefficients that are not finite. Nothing happens if `ctx` is NULL.
/// @param ctx points to an instance of quintic polynomial trajectory, which need not be initialised
/// @param ts duration, s, other than 0
/// @param p0 initial position, unit
/// @param p1 final position, unit
/// @param v0 initial velocity, unit/s
/// @param v1 final velocity, unit/s
/// @param a0 initial acceleration, unit/s^2
/// @param a1 final acceleration, unit/s^2
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_gen(
    ctx: *mut a_trajpoly5,
    ts: a_float,
    p0: a_float,
    p1: a_float,
    v0: a_float,
    v1: a_float,
    a0: a_float,
    a1: a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    if let Some(poly) = unsafe { ctx.cast::<Poly5<Number>>().as_mut() } {
        poly.plan(ts.into(), boundary(p0, p1, v0, v1), [a0.into(), a1.into()]);
    }
}

/// @brief Copy the coefficients of position out.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param c0 array of 6, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_c0(ctx: *const a_trajpoly5, c0: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let poly = unsafe { ctx.cast::<Poly5<Number>>().as_ref() };
    // SAFETY: `c0` is NULL or has room for 6 by the contract of this module.
    unsafe { copy_out::<6>(poly.copied(), c0) };
}

/// @brief Copy the coefficients of velocity out.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param c1 array of 5, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_c1(ctx: *const a_trajpoly5, c1: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let poly = unsafe { ctx.cast::<Poly5<Number>>().as_ref() };
    // SAFETY: `c1` is NULL or has room for 5 by the contract of this module.
    unsafe { copy_out::<5>(poly.map(|poly| poly.derivative()), c1) };
}

/// @brief Copy the coefficients of acceleration out.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param c2 array of 4, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_c2(ctx: *const a_trajpoly5, c2: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let poly = unsafe { ctx.cast::<Poly5<Number>>().as_ref() };
    // SAFETY: `c2` is NULL or has room for 4 by the contract of this module.
    unsafe { copy_out::<4>(poly.map(|poly| poly.derivative::<5>().derivative()), c2) };
}

/// @brief Position of a quintic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return position, unit; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_pos(ctx: *const a_trajpoly5, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Poly5<Number>>().as_ref() } {
        Some(poly) => poly.position(x.into()).into(),
        None => nan(),
    }
}

/// @brief Velocity of a quintic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return velocity, unit/s; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_vel(ctx: *const a_trajpoly5, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Poly5<Number>>().as_ref() } {
        Some(poly) => poly.velocity(x.into()).into(),
        None => nan(),
    }
}

/// @brief Acceleration of a quintic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return acceleration, unit/s^2; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_acc(ctx: *const a_trajpoly5, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    match unsafe { ctx.cast::<Poly5<Number>>().as_ref() } {
        Some(poly) => poly.acceleration(x.into()).into(),
        None => nan(),
    }
}
