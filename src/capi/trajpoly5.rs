//! `a/trajpoly5.h`: the quintic polynomial, in both generations of its struct.

#[cfg(all(not(feature = "poly-compact"), trajpoly5_v))]
use super::differentiate;
#[cfg(feature = "poly-compact")]
use super::evaluate_found;
use super::{Number, Place, a_float, boundary, evaluate};
use crate::Poly5;
#[cfg(not(feature = "poly-compact"))]
use crate::Real;
#[cfg(all(not(feature = "poly-compact"), trajpoly5_v))]
use crate::poly;
#[cfg(all(not(feature = "poly-compact"), trajpoly5_v))]
use core::mem::offset_of;

/// @brief Quintic polynomial trajectory.
///
/// Coefficients stand in ascending powers of time: `p[0] + p[1]*x + ...`. `A_TRAJPOLY5` arrays are stored.
#[cfg(not(feature = "poly-compact"))]
#[repr(C)]
pub struct a_trajpoly5 {
    /// coefficients of position
    pub p: [Number; 6],
    /// coefficients of velocity
    #[cfg(trajpoly5_v)]
    pub v: [Number; 5],
    /// coefficients of acceleration
    #[cfg(trajpoly5_a)]
    pub a: [Number; 4],
}

/// @brief Quintic polynomial trajectory.
///
/// Coefficients stand in ascending powers of time: `c[0] + c[1]*x + ...`.
#[cfg(feature = "poly-compact")]
#[repr(C)]
pub struct a_trajpoly5 {
    /// coefficients of position
    pub c: [Number; 6],
}

#[cfg(not(feature = "poly-compact"))]
impl a_trajpoly5 {
    pub(super) fn position_coefficients(&self) -> &[Number; 6] {
        &self.p
    }

    #[cfg(trajpoly5_v)]
    pub(super) fn velocity_coefficients(&self) -> &[Number; 5] {
        &self.v
    }

    #[cfg(not(trajpoly5_v))]
    pub(super) fn velocity_coefficients(&self) -> [Number; 5] {
        Poly5 { c: self.p }.velocity_coefficients()
    }

    #[cfg(trajpoly5_a)]
    pub(super) fn acceleration_coefficients(&self) -> &[Number; 4] {
        &self.a
    }

    #[cfg(not(trajpoly5_a))]
    pub(super) fn acceleration_coefficients(&self) -> [Number; 4] {
        Poly5 { c: self.p }.acceleration_coefficients()
    }
}

#[cfg(feature = "poly-compact")]
impl a_trajpoly5 {
    pub(super) fn position_coefficients(&self) -> &[Number; 6] {
        &self.c
    }

    pub(super) fn velocity_coefficients(&self) -> [Number; 5] {
        Poly5 { c: self.c }.velocity_coefficients()
    }

    pub(super) fn acceleration_coefficients(&self) -> [Number; 4] {
        Poly5 { c: self.c }.acceleration_coefficients()
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
    #[cfg(not(feature = "poly-compact"))]
    // SAFETY: the contract of this function is that of each of these.
    unsafe {
        if Number::CHEAP_ROOT {
            plan(ctx, true, ts, p0, p1, v0, v1, a0, a1);
        } else {
            a_trajpoly5_gen0(ctx, ts, p0, p1, v0, v1, a0, a1);
            #[cfg(trajpoly5_v)]
            a_trajpoly5_gen1(ctx);
            #[cfg(trajpoly5_a)]
            a_trajpoly5_gen2(ctx);
        }
    }
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    #[cfg(feature = "poly-compact")]
    if let Some(ctx) = unsafe { ctx.as_mut() } {
        Poly5::write(
            &mut ctx.c,
            ts.into(),
            boundary(p0, p1, v0, v1),
            [a0.into(), a1.into()],
        );
    }
}

/// @brief Coefficients of position of a quintic polynomial trajectory.
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
#[cfg(not(feature = "poly-compact"))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_gen0(
    ctx: *mut a_trajpoly5,
    ts: a_float,
    p0: a_float,
    p1: a_float,
    v0: a_float,
    v1: a_float,
    a0: a_float,
    a1: a_float,
) {
    // SAFETY: the contract is the same.
    unsafe { plan(ctx, false, ts, p0, p1, v0, v1, a0, a1) }
}

/// The coefficients of position, and on demand those derived from them, for which they are still in registers.
///
/// # Safety
/// As for all functions of this module.
#[cfg(not(feature = "poly-compact"))]
#[cfg_attr(all(target_abi = "eabihf", feature = "float"), inline(never))]
unsafe fn plan(
    ctx: *mut a_trajpoly5,
    all: bool,
    ts: a_float,
    p0: a_float,
    p1: a_float,
    v0: a_float,
    v1: a_float,
    a0: a_float,
    a1: a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    if let Some(ctx) = unsafe { ctx.as_mut() } {
        Poly5::write(
            &mut ctx.p,
            ts.into(),
            boundary(p0, p1, v0, v1),
            [a0.into(), a1.into()],
        );
        if all {
            #[cfg(trajpoly5_v)]
            {
                ctx.v = poly::derivative(&ctx.p);
            }
            #[cfg(trajpoly5_a)]
            {
                ctx.a = poly::derivative(&ctx.v);
            }
        }
    }
}

/// @brief Coefficients of velocity, from those of position: `v[i] = p[i+1]*(i+1)`.
/// @param ctx points to an instance of quintic polynomial trajectory; nothing happens if it is NULL
#[cfg(all(not(feature = "poly-compact"), trajpoly5_v))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_gen1(ctx: *mut a_trajpoly5) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and `v` follows `p`.
    unsafe { differentiate(ctx.cast(), Place::new(offset_of!(a_trajpoly5, p), 5)) };
}

/// @brief Coefficients of acceleration, from those of velocity: `a[i] = v[i+1]*(i+1)`.
/// @param ctx points to an instance of quintic polynomial trajectory; nothing happens if it is NULL
#[cfg(all(not(feature = "poly-compact"), trajpoly5_a))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_gen2(ctx: *mut a_trajpoly5) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and `a` follows `v`.
    unsafe { differentiate(ctx.cast(), Place::new(offset_of!(a_trajpoly5, v), 4)) };
}

/// @brief Copy the coefficients of position out.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param c0 array of 6, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_c0(ctx: *const a_trajpoly5, c0: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let coefficients = unsafe { ctx.as_ref() }.map(a_trajpoly5::position_coefficients);
    if let (Some(coefficients), false) = (coefficients, c0.is_null()) {
        // SAFETY: `c0` has room for them by the contract of this module, and no reference into `ctx` is left.
        unsafe { c0.cast::<[Number; 6]>().write(*coefficients) };
    }
}

/// @brief Copy the coefficients of velocity out.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param c1 array of 5, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_c1(ctx: *const a_trajpoly5, c1: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let coefficients = unsafe { ctx.as_ref() }.map(a_trajpoly5::velocity_coefficients);
    if let (Some(coefficients), false) = (coefficients, c1.is_null()) {
        // SAFETY: `c1` has room for them by the contract of this module, and no reference into `ctx` is left.
        unsafe { c1.cast::<[Number; 5]>().write(coefficients) };
    }
}

/// @brief Copy the coefficients of acceleration out.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param c2 array of 4, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_c2(ctx: *const a_trajpoly5, c2: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let coefficients = unsafe { ctx.as_ref() }.map(a_trajpoly5::acceleration_coefficients);
    if let (Some(coefficients), false) = (coefficients, c2.is_null()) {
        // SAFETY: `c2` has room for them by the contract of this module, and no reference into `ctx` is left.
        unsafe { c2.cast::<[Number; 4]>().write(coefficients) };
    }
}

/// @brief Position of a quintic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return position, unit; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_pos(ctx: *const a_trajpoly5, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the coefficients come first.
    unsafe { evaluate(ctx.cast(), Place::new(0, 5), x) }
}

/// @brief Velocity of a quintic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return velocity, unit/s; NaN if `ctx` is NULL
#[cfg(trajpoly5_v)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_vel(ctx: *const a_trajpoly5, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    #[cfg(not(feature = "poly-compact"))]
    unsafe {
        evaluate(ctx.cast(), Place::new(offset_of!(a_trajpoly5, v), 4), x)
    }
    // SAFETY: likewise.
    #[cfg(feature = "poly-compact")]
    evaluate_found(
        unsafe { ctx.as_ref() }.map(a_trajpoly5::velocity_coefficients),
        x,
    )
}

/// @brief Acceleration of a quintic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return acceleration, unit/s^2; NaN if `ctx` is NULL
#[cfg(trajpoly5_a)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_acc(ctx: *const a_trajpoly5, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    #[cfg(not(feature = "poly-compact"))]
    unsafe {
        evaluate(ctx.cast(), Place::new(offset_of!(a_trajpoly5, a), 3), x)
    }
    // SAFETY: likewise.
    #[cfg(feature = "poly-compact")]
    evaluate_found(
        unsafe { ctx.as_ref() }.map(a_trajpoly5::acceleration_coefficients),
        x,
    )
}
