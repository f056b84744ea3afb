//! `a/trajpoly7.h`: the septic polynomial, in both generations of its struct.

#[cfg(all(not(feature = "poly-compact"), trajpoly7_v))]
use super::differentiate;
#[cfg(feature = "poly-compact")]
use super::evaluate_found;
use super::{Number, Place, a_float, boundary, evaluate};
use crate::Poly7;
#[cfg(all(not(feature = "poly-compact"), trajpoly7_v))]
use core::mem::offset_of;

/// @brief Septic polynomial trajectory.
///
/// Coefficients stand in ascending powers of time: `p[0] + p[1]*x + ...`. `A_TRAJPOLY7` arrays are stored.
#[cfg(not(feature = "poly-compact"))]
#[repr(C)]
pub struct a_trajpoly7 {
    /// coefficients of position
    pub p: [Number; 8],
    /// coefficients of velocity
    #[cfg(trajpoly7_v)]
    pub v: [Number; 7],
    /// coefficients of acceleration
    #[cfg(trajpoly7_a)]
    pub a: [Number; 6],
    /// coefficients of jerk
    #[cfg(trajpoly7_j)]
    pub j: [Number; 5],
}

/// @brief Septic polynomial trajectory.
///
/// Coefficients stand in ascending powers of time: `c[0] + c[1]*x + ...`.
#[cfg(feature = "poly-compact")]
#[repr(C)]
pub struct a_trajpoly7 {
    /// coefficients of position
    pub c: [Number; 8],
}

#[cfg(not(feature = "poly-compact"))]
impl a_trajpoly7 {
    pub(super) fn position_coefficients(&self) -> &[Number; 8] {
        &self.p
    }

    #[cfg(trajpoly7_v)]
    pub(super) fn velocity_coefficients(&self) -> &[Number; 7] {
        &self.v
    }

    #[cfg(not(trajpoly7_v))]
    pub(super) fn velocity_coefficients(&self) -> [Number; 7] {
        Poly7 { c: self.p }.velocity_coefficients()
    }

    #[cfg(trajpoly7_a)]
    pub(super) fn acceleration_coefficients(&self) -> &[Number; 6] {
        &self.a
    }

    #[cfg(not(trajpoly7_a))]
    pub(super) fn acceleration_coefficients(&self) -> [Number; 6] {
        Poly7 { c: self.p }.acceleration_coefficients()
    }

    #[cfg(trajpoly7_j)]
    pub(super) fn jerk_coefficients(&self) -> &[Number; 5] {
        &self.j
    }

    #[cfg(not(trajpoly7_j))]
    pub(super) fn jerk_coefficients(&self) -> [Number; 5] {
        Poly7 { c: self.p }.jerk_coefficients()
    }
}

#[cfg(feature = "poly-compact")]
impl a_trajpoly7 {
    pub(super) fn position_coefficients(&self) -> &[Number; 8] {
        &self.c
    }

    pub(super) fn velocity_coefficients(&self) -> [Number; 7] {
        Poly7 { c: self.c }.velocity_coefficients()
    }

    pub(super) fn acceleration_coefficients(&self) -> [Number; 6] {
        Poly7 { c: self.c }.acceleration_coefficients()
    }

    pub(super) fn jerk_coefficients(&self) -> [Number; 5] {
        Poly7 { c: self.c }.jerk_coefficients()
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
    #[cfg(not(feature = "poly-compact"))]
    // SAFETY: the contract of this function is that of each of these.
    unsafe {
        a_trajpoly7_gen0(ctx, ts, p0, p1, v0, v1, a0, a1, j0, j1);
        #[cfg(trajpoly7_v)]
        a_trajpoly7_gen1(ctx);
        #[cfg(trajpoly7_a)]
        a_trajpoly7_gen2(ctx);
        #[cfg(trajpoly7_j)]
        a_trajpoly7_gen3(ctx);
    }
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    #[cfg(feature = "poly-compact")]
    if let Some(ctx) = unsafe { ctx.as_mut() } {
        Poly7::write(
            &mut ctx.c,
            ts.into(),
            boundary(p0, p1, v0, v1),
            [a0.into(), a1.into()],
            [j0.into(), j1.into()],
        );
    }
}

/// @brief Coefficients of position of a septic polynomial trajectory.
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
#[cfg(not(feature = "poly-compact"))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen0(
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
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    if let Some(ctx) = unsafe { ctx.as_mut() } {
        Poly7::write(
            &mut ctx.p,
            ts.into(),
            boundary(p0, p1, v0, v1),
            [a0.into(), a1.into()],
            [j0.into(), j1.into()],
        );
    }
}

/// @brief Coefficients of velocity, from those of position: `v[i] = p[i+1]*(i+1)`.
/// @param ctx points to an instance of septic polynomial trajectory; nothing happens if it is NULL
#[cfg(all(not(feature = "poly-compact"), trajpoly7_v))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen1(ctx: *mut a_trajpoly7) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and `v` follows `p`.
    unsafe { differentiate(ctx.cast(), Place::new(offset_of!(a_trajpoly7, p), 7)) };
}

/// @brief Coefficients of acceleration, from those of velocity: `a[i] = v[i+1]*(i+1)`.
/// @param ctx points to an instance of septic polynomial trajectory; nothing happens if it is NULL
#[cfg(all(not(feature = "poly-compact"), trajpoly7_a))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen2(ctx: *mut a_trajpoly7) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and `a` follows `v`.
    unsafe { differentiate(ctx.cast(), Place::new(offset_of!(a_trajpoly7, v), 6)) };
}

/// @brief Coefficients of jerk, from those of acceleration: `j[i] = a[i+1]*(i+1)`.
/// @param ctx points to an instance of septic polynomial trajectory; nothing happens if it is NULL
#[cfg(all(not(feature = "poly-compact"), trajpoly7_j))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen3(ctx: *mut a_trajpoly7) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and `j` follows `a`.
    unsafe { differentiate(ctx.cast(), Place::new(offset_of!(a_trajpoly7, a), 5)) };
}

/// @brief Copy the coefficients of position out.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param c0 array of 8, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c0(ctx: *const a_trajpoly7, c0: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let coefficients = unsafe { ctx.as_ref() }.map(a_trajpoly7::position_coefficients);
    if let (Some(coefficients), false) = (coefficients, c0.is_null()) {
        // SAFETY: `c0` has room for them by the contract of this module, and no reference into `ctx` is left.
        unsafe { c0.cast::<[Number; 8]>().write(*coefficients) };
    }
}

/// @brief Copy the coefficients of velocity out.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param c1 array of 7, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c1(ctx: *const a_trajpoly7, c1: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let coefficients = unsafe { ctx.as_ref() }.map(a_trajpoly7::velocity_coefficients);
    if let (Some(coefficients), false) = (coefficients, c1.is_null()) {
        // SAFETY: `c1` has room for them by the contract of this module, and no reference into `ctx` is left.
        unsafe { c1.cast::<[Number; 7]>().write(coefficients) };
    }
}

/// @brief Copy the coefficients of acceleration out.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param c2 array of 6, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c2(ctx: *const a_trajpoly7, c2: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let coefficients = unsafe { ctx.as_ref() }.map(a_trajpoly7::acceleration_coefficients);
    if let (Some(coefficients), false) = (coefficients, c2.is_null()) {
        // SAFETY: `c2` has room for them by the contract of this module, and no reference into `ctx` is left.
        unsafe { c2.cast::<[Number; 6]>().write(coefficients) };
    }
}

/// @brief Copy the coefficients of jerk out.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param c3 array of 5, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c3(ctx: *const a_trajpoly7, c3: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let coefficients = unsafe { ctx.as_ref() }.map(a_trajpoly7::jerk_coefficients);
    if let (Some(coefficients), false) = (coefficients, c3.is_null()) {
        // SAFETY: `c3` has room for them by the contract of this module, and no reference into `ctx` is left.
        unsafe { c3.cast::<[Number; 5]>().write(coefficients) };
    }
}

/// @brief Position of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return position, unit; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_pos(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the coefficients come first.
    unsafe { evaluate(ctx.cast(), Place::new(0, 7), x) }
}

/// @brief Velocity of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return velocity, unit/s; NaN if `ctx` is NULL
#[cfg(trajpoly7_v)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_vel(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    #[cfg(not(feature = "poly-compact"))]
    unsafe {
        evaluate(ctx.cast(), Place::new(offset_of!(a_trajpoly7, v), 6), x)
    }
    // SAFETY: likewise.
    #[cfg(feature = "poly-compact")]
    evaluate_found(
        unsafe { ctx.as_ref() }.map(a_trajpoly7::velocity_coefficients),
        x,
    )
}

/// @brief Acceleration of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return acceleration, unit/s^2; NaN if `ctx` is NULL
#[cfg(trajpoly7_a)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_acc(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    #[cfg(not(feature = "poly-compact"))]
    unsafe {
        evaluate(ctx.cast(), Place::new(offset_of!(a_trajpoly7, a), 5), x)
    }
    // SAFETY: likewise.
    #[cfg(feature = "poly-compact")]
    evaluate_found(
        unsafe { ctx.as_ref() }.map(a_trajpoly7::acceleration_coefficients),
        x,
    )
}

/// @brief Jerk of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return jerk, unit/s^3; NaN if `ctx` is NULL
#[cfg(trajpoly7_j)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_jer(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    #[cfg(not(feature = "poly-compact"))]
    unsafe {
        evaluate(ctx.cast(), Place::new(offset_of!(a_trajpoly7, j), 4), x)
    }
    // SAFETY: likewise.
    #[cfg(feature = "poly-compact")]
    evaluate_found(
        unsafe { ctx.as_ref() }.map(a_trajpoly7::jerk_coefficients),
        x,
    )
}
