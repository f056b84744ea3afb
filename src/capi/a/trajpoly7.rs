//! `a/trajpoly7.h`: the septic polynomial.

use super::poly;
#[cfg(feature = "poly-compact")]
use crate::capi::assert_same_layout;
use crate::capi::{Number, a_float, boundary};
use crate::liba::{Poly, Poly7};

/// @brief Septic polynomial trajectory.
///
/// Coefficients stand in ascending powers of time: `c[0] + c[1]*x + ...`. The struct of liba since 2025-03 (`A_TRAJPOLY_COMPACT`)
/// stores the coefficients of the position alone. The struct of liba 0.1.15 stores `A_TRAJPOLY7` of the arrays `p`, `v`, `a` and `j`.
#[repr(C)]
pub struct a_trajpoly7 {
    /// coefficients of position
    #[cfg(feature = "poly-compact")]
    pub c: [Number; 8],
    /// coefficients of position
    #[cfg(not(feature = "poly-compact"))]
    pub p: [Number; 8],
    /// coefficients of velocity
    #[cfg(all(not(feature = "poly-compact"), trajpoly7_v))]
    pub v: [Number; 7],
    /// coefficients of acceleration
    #[cfg(all(not(feature = "poly-compact"), trajpoly7_a))]
    pub a: [Number; 6],
    /// coefficients of jerk
    #[cfg(all(not(feature = "poly-compact"), trajpoly7_j))]
    pub j: [Number; 5],
}

// A pointer to the struct is a pointer to the polynomial of position.
#[cfg(feature = "poly-compact")]
assert_same_layout!(a_trajpoly7, Poly7<Number>, c);
#[cfg(not(feature = "poly-compact"))]
const _: () = assert!(core::mem::offset_of!(a_trajpoly7, p) == 0);

impl a_trajpoly7 {
    /// The state at a time, from a copy of the coefficients that no output of a call can overlap. Derivatives that the struct does
    /// not store are computed from the position coefficients.
    pub(in crate::capi) fn state(&self) -> impl Fn(Number) -> [Number; 4] + use<> {
        #[cfg(feature = "poly-compact")]
        let p = Poly { c: self.c };
        #[cfg(not(feature = "poly-compact"))]
        let p = Poly { c: self.p };
        #[cfg(all(not(feature = "poly-compact"), trajpoly7_v))]
        let v = Poly { c: self.v };
        #[cfg(any(feature = "poly-compact", not(trajpoly7_v)))]
        let v: Poly<_, 7> = p.derivative();
        #[cfg(all(not(feature = "poly-compact"), trajpoly7_a))]
        let a = Poly { c: self.a };
        #[cfg(any(feature = "poly-compact", not(trajpoly7_a)))]
        let a: Poly<_, 6> = v.derivative();
        #[cfg(all(not(feature = "poly-compact"), trajpoly7_j))]
        let j = Poly { c: self.j };
        #[cfg(any(feature = "poly-compact", not(trajpoly7_j)))]
        let j: Poly<_, 5> = a.derivative();
        move |x| [p.position(x), v.position(x), a.position(x), j.position(x)]
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
    // SAFETY: the contract of this function is the contract of each of these.
    unsafe {
        #[cfg(feature = "poly-compact")]
        plan(ctx, ts, p0, p1, v0, v1, a0, a1, j0, j1);
        #[cfg(not(feature = "poly-compact"))]
        a_trajpoly7_gen0(ctx, ts, p0, p1, v0, v1, a0, a1, j0, j1);
        #[cfg(all(not(feature = "poly-compact"), trajpoly7_v))]
        a_trajpoly7_gen1(ctx);
        #[cfg(all(not(feature = "poly-compact"), trajpoly7_a))]
        a_trajpoly7_gen2(ctx);
        #[cfg(all(not(feature = "poly-compact"), trajpoly7_j))]
        a_trajpoly7_gen3(ctx);
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
    // SAFETY: both functions have the same contract.
    unsafe { plan(ctx, ts, p0, p1, v0, v1, a0, a1, j0, j1) };
}

/// The coefficients of position.
///
/// # Safety
/// `ctx` is NULL or valid by the contract of this module.
unsafe fn plan(
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
    // SAFETY: by the contract of this function, and the coefficients of position come first.
    if let Some(poly) = unsafe { ctx.cast::<Poly7<Number>>().as_mut() } {
        poly.plan(
            ts.into(),
            boundary(p0, p1, v0, v1),
            [a0.into(), a1.into()],
            [j0.into(), j1.into()],
        );
    }
}

/// @brief Coefficients of velocity, from the coefficients of position: `v[i] = p[i+1]*(i+1)`.
/// @param ctx points to an instance of septic polynomial trajectory; nothing happens if it is NULL
#[cfg(all(not(feature = "poly-compact"), trajpoly7_v))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen1(ctx: *mut a_trajpoly7) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::differentiate::<8, 0>(ctx.cast()) };
}

/// @brief Coefficients of acceleration, from the coefficients of velocity: `a[i] = v[i+1]*(i+1)`.
/// @param ctx points to an instance of septic polynomial trajectory; nothing happens if it is NULL
#[cfg(all(not(feature = "poly-compact"), trajpoly7_a))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen2(ctx: *mut a_trajpoly7) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::differentiate::<8, 1>(ctx.cast()) };
}

/// @brief Coefficients of jerk, from the coefficients of acceleration: `j[i] = a[i+1]*(i+1)`.
/// @param ctx points to an instance of septic polynomial trajectory; nothing happens if it is NULL
#[cfg(all(not(feature = "poly-compact"), trajpoly7_j))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen3(ctx: *mut a_trajpoly7) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::differentiate::<8, 2>(ctx.cast()) };
}

/// @brief Copy the coefficients of position out.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param c0 array of 8, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c0(ctx: *const a_trajpoly7, c0: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c0` is NULL or has room for 8, by the contract of this module.
    unsafe { poly::copy_out(ctx.cast(), c0, |c: &Poly7<Number>| *c) };
}

/// @brief Copy the coefficients of velocity out.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param c1 array of 7, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c1(ctx: *const a_trajpoly7, c1: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c1` is NULL or has room for 7, by the contract of this module.
    unsafe { poly::copy_out(ctx.cast(), c1, |c: &Poly7<Number>| c.derivative::<7>()) };
}

/// @brief Copy the coefficients of acceleration out.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param c2 array of 6, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c2(ctx: *const a_trajpoly7, c2: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c2` is NULL or has room for 6, by the contract of this module.
    unsafe {
        poly::copy_out(ctx.cast(), c2, |c: &Poly7<Number>| {
            c.derivative::<7>().derivative::<6>()
        })
    };
}

/// @brief Copy the coefficients of jerk out.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param c3 array of 5, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c3(ctx: *const a_trajpoly7, c3: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c3` is NULL or has room for 5, by the contract of this module.
    unsafe {
        poly::copy_out(ctx.cast(), c3, |c: &Poly7<Number>| {
            c.derivative::<7>().derivative::<6>().derivative::<5>()
        })
    };
}

/// @brief Position of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return position, unit; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_pos(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<8, 0>(ctx.cast(), x) }
}

/// @brief Velocity of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return velocity, unit/s; NaN if `ctx` is NULL
#[cfg(trajpoly7_v)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_vel(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<8, 1>(ctx.cast(), x) }
}

/// @brief Acceleration of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return acceleration, unit/s^2; NaN if `ctx` is NULL
#[cfg(trajpoly7_a)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_acc(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<8, 2>(ctx.cast(), x) }
}

/// @brief Jerk of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return jerk, unit/s^3; NaN if `ctx` is NULL
#[cfg(trajpoly7_j)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_jer(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<8, 3>(ctx.cast(), x) }
}
