//! `a/trajpoly5.h`: the quintic polynomial.

use super::poly;
#[cfg(feature = "poly-compact")]
use crate::capi::assert_same_layout;
use crate::capi::{Number, a_float, boundary};
#[cfg(not(feature = "poly-compact"))]
use crate::liba::poly::target;
use crate::liba::{Poly, Poly5};

/// @brief Quintic polynomial trajectory.
///
/// Coefficients stand in ascending powers of time: `c[0] + c[1]*x + ...`. The struct of liba since 2025-03 (`A_TRAJPOLY_COMPACT`)
/// stores the coefficients of the position alone. The struct of liba 0.1.15 stores `A_TRAJPOLY5` of the arrays `p`, `v` and `a`.
#[repr(C)]
pub struct a_trajpoly5 {
    /// coefficients of position
    #[cfg(feature = "poly-compact")]
    pub c: [Number; 6],
    /// coefficients of position
    #[cfg(not(feature = "poly-compact"))]
    pub p: [Number; 6],
    /// coefficients of velocity
    #[cfg(all(not(feature = "poly-compact"), trajpoly5_v))]
    pub v: [Number; 5],
    /// coefficients of acceleration
    #[cfg(all(not(feature = "poly-compact"), trajpoly5_a))]
    pub a: [Number; 4],
}

// A pointer to the struct is a pointer to the polynomial of position.
#[cfg(feature = "poly-compact")]
assert_same_layout!(a_trajpoly5, Poly5<Number>, c);
#[cfg(not(feature = "poly-compact"))]
const _: () = assert!(core::mem::offset_of!(a_trajpoly5, p) == 0);

impl a_trajpoly5 {
    /// The state at a time, from a copy of the coefficients that no output of a call can overlap. Derivatives that the struct does
    /// not store are computed from the position coefficients.
    pub(in crate::capi) fn state(&self) -> impl Fn(Number) -> [Number; 3] + use<> {
        #[cfg(feature = "poly-compact")]
        let p = Poly { c: self.c };
        #[cfg(not(feature = "poly-compact"))]
        let p = Poly { c: self.p };
        #[cfg(all(not(feature = "poly-compact"), trajpoly5_v))]
        let v = Poly { c: self.v };
        #[cfg(any(feature = "poly-compact", not(trajpoly5_v)))]
        let v: Poly<_, 5> = p.derivative();
        #[cfg(all(not(feature = "poly-compact"), trajpoly5_a))]
        let a = Poly { c: self.a };
        #[cfg(any(feature = "poly-compact", not(trajpoly5_a)))]
        let a: Poly<_, 4> = v.derivative();
        move |x| [p.position(x), v.position(x), a.position(x)]
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
    // SAFETY: the contract of this function is the contract of each of these.
    unsafe {
        #[cfg(not(feature = "poly-compact"))]
        if !target::derives_in_registers::<Number>() {
            a_trajpoly5_gen0(ctx, ts, p0, p1, v0, v1, a0, a1);
            #[cfg(trajpoly5_v)]
            a_trajpoly5_gen1(ctx);
            #[cfg(trajpoly5_a)]
            a_trajpoly5_gen2(ctx);
            return;
        }
        plan(ctx, true, ts, p0, p1, v0, v1, a0, a1);
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
    // SAFETY: both functions have the same contract.
    unsafe { plan(ctx, false, ts, p0, p1, v0, v1, a0, a1) };
}

/// The coefficients of position and, for `all`, the stored ones that derive from them.
///
/// # Safety
/// `ctx` is NULL or valid by the contract of this module.
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
    // SAFETY: by the contract of this function, and the coefficients of position come first.
    let Some(position) = (unsafe { ctx.cast::<Poly5<Number>>().as_mut() }) else {
        return;
    };
    position.plan(ts.into(), boundary(p0, p1, v0, v1), [a0.into(), a1.into()]);
    if all {
        #[cfg(all(not(feature = "poly-compact"), trajpoly5_v))]
        // SAFETY: not NULL, so valid by the contract of this function; `position` is not used any more.
        unsafe {
            let poly = &mut *ctx;
            target::differentiate(&poly.p, &mut poly.v);
            #[cfg(trajpoly5_a)]
            target::differentiate(&poly.v, &mut poly.a);
        }
    }
}

/// @brief Coefficients of velocity, from the coefficients of position: `v[i] = p[i+1]*(i+1)`.
/// @param ctx points to an instance of quintic polynomial trajectory; nothing happens if it is NULL
#[cfg(all(not(feature = "poly-compact"), trajpoly5_v))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_gen1(ctx: *mut a_trajpoly5) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::differentiate::<6, 0>(ctx.cast()) };
}

/// @brief Coefficients of acceleration, from the coefficients of velocity: `a[i] = v[i+1]*(i+1)`.
/// @param ctx points to an instance of quintic polynomial trajectory; nothing happens if it is NULL
#[cfg(all(not(feature = "poly-compact"), trajpoly5_a))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_gen2(ctx: *mut a_trajpoly5) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::differentiate::<6, 1>(ctx.cast()) };
}

/// @brief Copy the coefficients of position out.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param c0 array of 6, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_c0(ctx: *const a_trajpoly5, c0: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c0` is NULL or has room for 6, by the contract of this module.
    unsafe { poly::copy_out(ctx.cast(), c0, |c: &Poly5<Number>| *c) };
}

/// @brief Copy the coefficients of velocity out.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param c1 array of 5, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_c1(ctx: *const a_trajpoly5, c1: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c1` is NULL or has room for 5, by the contract of this module.
    unsafe { poly::copy_out(ctx.cast(), c1, |c: &Poly5<Number>| c.derivative::<5>()) };
}

/// @brief Copy the coefficients of acceleration out.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param c2 array of 4, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_c2(ctx: *const a_trajpoly5, c2: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c2` is NULL or has room for 4, by the contract of this module.
    unsafe {
        poly::copy_out(ctx.cast(), c2, |c: &Poly5<Number>| {
            c.derivative::<5>().derivative::<4>()
        })
    };
}

/// @brief Position of a quintic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return position, unit; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_pos(ctx: *const a_trajpoly5, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<6, 0>(ctx.cast(), x) }
}

/// @brief Velocity of a quintic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return velocity, unit/s; NaN if `ctx` is NULL
#[cfg(trajpoly5_v)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_vel(ctx: *const a_trajpoly5, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<6, 1>(ctx.cast(), x) }
}

/// @brief Acceleration of a quintic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return acceleration, unit/s^2; NaN if `ctx` is NULL
#[cfg(trajpoly5_a)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_acc(ctx: *const a_trajpoly5, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<6, 2>(ctx.cast(), x) }
}
