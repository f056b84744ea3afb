//! `a/trajpoly3.h`: the cubic polynomial, in both generations of its struct.

#[cfg(all(not(feature = "poly-compact"), trajpoly3_v))]
use super::differentiate;
#[cfg(feature = "poly-compact")]
use super::evaluate_found;
use super::{Number, Place, a_float, boundary, evaluate};
use crate::Poly3;
#[cfg(not(feature = "poly-compact"))]
use crate::Real;
#[cfg(all(not(feature = "poly-compact"), trajpoly3_v))]
use crate::poly;
#[cfg(all(not(feature = "poly-compact"), trajpoly3_v))]
use core::mem::offset_of;

/// @brief Cubic polynomial trajectory.
///
/// Coefficients stand in ascending powers of time: `p[0] + p[1]*x + ...`. `A_TRAJPOLY3` arrays are stored.
#[cfg(not(feature = "poly-compact"))]
#[repr(C)]
pub struct a_trajpoly3 {
    /// coefficients of position
    pub p: [Number; 4],
    /// coefficients of velocity
    #[cfg(trajpoly3_v)]
    pub v: [Number; 3],
    /// coefficients of acceleration
    #[cfg(trajpoly3_a)]
    pub a: [Number; 2],
}

/// @brief Cubic polynomial trajectory.
///
/// Coefficients stand in ascending powers of time: `c[0] + c[1]*x + ...`.
#[cfg(feature = "poly-compact")]
#[repr(C)]
pub struct a_trajpoly3 {
    /// coefficients of position
    pub c: [Number; 4],
}

#[cfg(not(feature = "poly-compact"))]
impl a_trajpoly3 {
    pub(super) fn position_coefficients(&self) -> &[Number; 4] {
        &self.p
    }

    #[cfg(trajpoly3_v)]
    pub(super) fn velocity_coefficients(&self) -> &[Number; 3] {
        &self.v
    }

    #[cfg(not(trajpoly3_v))]
    pub(super) fn velocity_coefficients(&self) -> [Number; 3] {
        Poly3 { c: self.p }.velocity_coefficients()
    }

    #[cfg(trajpoly3_a)]
    pub(super) fn acceleration_coefficients(&self) -> &[Number; 2] {
        &self.a
    }

    #[cfg(not(trajpoly3_a))]
    pub(super) fn acceleration_coefficients(&self) -> [Number; 2] {
        Poly3 { c: self.p }.acceleration_coefficients()
    }
}

#[cfg(feature = "poly-compact")]
impl a_trajpoly3 {
    pub(super) fn position_coefficients(&self) -> &[Number; 4] {
        &self.c
    }

    pub(super) fn velocity_coefficients(&self) -> [Number; 3] {
        Poly3 { c: self.c }.velocity_coefficients()
    }

    pub(super) fn acceleration_coefficients(&self) -> [Number; 2] {
        Poly3 { c: self.c }.acceleration_coefficients()
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
    #[cfg(not(feature = "poly-compact"))]
    // SAFETY: the contract of this function is that of each of these.
    unsafe {
        if Number::CHEAP_ROOT {
            plan(ctx, true, ts, p0, p1, v0, v1);
        } else {
            a_trajpoly3_gen0(ctx, ts, p0, p1, v0, v1);
            #[cfg(trajpoly3_v)]
            a_trajpoly3_gen1(ctx);
            #[cfg(trajpoly3_a)]
            a_trajpoly3_gen2(ctx);
        }
    }
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    #[cfg(feature = "poly-compact")]
    if let Some(ctx) = unsafe { ctx.as_mut() } {
        Poly3::write(&mut ctx.c, ts.into(), boundary(p0, p1, v0, v1));
    }
}

/// @brief Coefficients of position of a cubic polynomial trajectory.
///
/// A duration of 0, an infinity or a NaN gives coefficients that are not finite. Nothing happens if `ctx` is NULL.
/// @param ctx points to an instance of cubic polynomial trajectory, which need not be initialised
/// @param ts duration, s, other than 0
/// @param p0 initial position, unit
/// @param p1 final position, unit
/// @param v0 initial velocity, unit/s
/// @param v1 final velocity, unit/s
#[cfg(not(feature = "poly-compact"))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_gen0(
    ctx: *mut a_trajpoly3,
    ts: a_float,
    p0: a_float,
    p1: a_float,
    v0: a_float,
    v1: a_float,
) {
    // SAFETY: the contract is the same.
    unsafe { plan(ctx, false, ts, p0, p1, v0, v1) }
}

/// The coefficients of position, and on demand those derived from them, for which they are still in registers.
///
/// # Safety
/// As for all functions of this module.
#[cfg(not(feature = "poly-compact"))]
#[cfg_attr(all(target_abi = "eabihf", feature = "float"), inline(never))]
unsafe fn plan(
    ctx: *mut a_trajpoly3,
    all: bool,
    ts: a_float,
    p0: a_float,
    p1: a_float,
    v0: a_float,
    v1: a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    if let Some(ctx) = unsafe { ctx.as_mut() } {
        Poly3::write(&mut ctx.p, ts.into(), boundary(p0, p1, v0, v1));
        if all {
            #[cfg(trajpoly3_v)]
            {
                ctx.v = poly::derivative(&ctx.p);
            }
            #[cfg(trajpoly3_a)]
            {
                ctx.a = poly::derivative(&ctx.v);
            }
        }
    }
}

/// @brief Coefficients of velocity, from those of position: `v[i] = p[i+1]*(i+1)`.
/// @param ctx points to an instance of cubic polynomial trajectory; nothing happens if it is NULL
#[cfg(all(not(feature = "poly-compact"), trajpoly3_v))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_gen1(ctx: *mut a_trajpoly3) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and `v` follows `p`.
    unsafe { differentiate(ctx.cast(), Place::new(offset_of!(a_trajpoly3, p), 3)) };
}

/// @brief Coefficients of acceleration, from those of velocity: `a[i] = v[i+1]*(i+1)`.
/// @param ctx points to an instance of cubic polynomial trajectory; nothing happens if it is NULL
#[cfg(all(not(feature = "poly-compact"), trajpoly3_a))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_gen2(ctx: *mut a_trajpoly3) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and `a` follows `v`.
    unsafe { differentiate(ctx.cast(), Place::new(offset_of!(a_trajpoly3, v), 2)) };
}

/// @brief Copy the coefficients of position out.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param c0 array of 4, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_c0(ctx: *const a_trajpoly3, c0: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let coefficients = unsafe { ctx.as_ref() }.map(a_trajpoly3::position_coefficients);
    if let (Some(coefficients), false) = (coefficients, c0.is_null()) {
        // SAFETY: `c0` has room for them by the contract of this module, and no reference into `ctx` is left.
        unsafe { c0.cast::<[Number; 4]>().write(*coefficients) };
    }
}

/// @brief Copy the coefficients of velocity out.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param c1 array of 3, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_c1(ctx: *const a_trajpoly3, c1: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let coefficients = unsafe { ctx.as_ref() }.map(a_trajpoly3::velocity_coefficients);
    if let (Some(coefficients), false) = (coefficients, c1.is_null()) {
        // SAFETY: `c1` has room for them by the contract of this module, and no reference into `ctx` is left.
        unsafe { c1.cast::<[Number; 3]>().write(coefficients) };
    }
}

/// @brief Copy the coefficients of acceleration out.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param c2 array of 2, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_c2(ctx: *const a_trajpoly3, c2: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let coefficients = unsafe { ctx.as_ref() }.map(a_trajpoly3::acceleration_coefficients);
    if let (Some(coefficients), false) = (coefficients, c2.is_null()) {
        // SAFETY: `c2` has room for them by the contract of this module, and no reference into `ctx` is left.
        unsafe { c2.cast::<[Number; 2]>().write(coefficients) };
    }
}

/// @brief Position of a cubic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return position, unit; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_pos(ctx: *const a_trajpoly3, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the coefficients come first.
    unsafe { evaluate(ctx.cast(), Place::new(0, 3), x) }
}

/// @brief Velocity of a cubic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return velocity, unit/s; NaN if `ctx` is NULL
#[cfg(trajpoly3_v)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_vel(ctx: *const a_trajpoly3, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    #[cfg(not(feature = "poly-compact"))]
    unsafe {
        evaluate(ctx.cast(), Place::new(offset_of!(a_trajpoly3, v), 2), x)
    }
    // SAFETY: likewise.
    #[cfg(feature = "poly-compact")]
    evaluate_found(
        unsafe { ctx.as_ref() }.map(a_trajpoly3::velocity_coefficients),
        x,
    )
}

/// @brief Acceleration of a cubic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return acceleration, unit/s^2; NaN if `ctx` is NULL
#[cfg(trajpoly3_a)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_acc(ctx: *const a_trajpoly3, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    #[cfg(not(feature = "poly-compact"))]
    unsafe {
        evaluate(ctx.cast(), Place::new(offset_of!(a_trajpoly3, a), 1), x)
    }
    // SAFETY: likewise.
    #[cfg(feature = "poly-compact")]
    evaluate_found(
        unsafe { ctx.as_ref() }.map(a_trajpoly3::acceleration_coefficients),
        x,
    )
}
