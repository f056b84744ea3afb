//! `a/trajpoly5.h`: the quintic polynomial.

use super::poly::{self, polynomial};
use crate::capi::{Number, a_float};
use crate::liba::{Poly, Poly5, poly::target};

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

polynomial! {
    a_trajpoly5, Poly5; 3 quantities: p: 6, v: 5 from p if trajpoly5_v, a: 4 from v if trajpoly5_a;
    ends: a0 a1; in registers: target::derives_in_registers::<Number>()
}

/// @brief Plan a quintic polynomial trajectory: all coefficients that the struct holds.
///
/// A duration of 0, an infinity or a NaN gives coefficients that are not finite.
/// @param ts duration, s, other than 0
/// @param p0 initial position, unit; `p1` final position
/// @param v0 initial velocity, unit/s; `v1` final velocity
/// @param a0 initial acceleration, unit/s^2; `a1` final acceleration
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_gen(
    ctx: *mut a_trajpoly5, ts: a_float, p0: a_float, p1: a_float, v0: a_float, v1: a_float, a0: a_float, a1: a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { plan_all(ctx, ts, p0, p1, v0, v1, a0, a1) };
}

/// @brief Coefficients of position alone, from the arguments of `a_trajpoly5_gen`.
#[cfg(not(feature = "poly-compact"))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_gen0(
    ctx: *mut a_trajpoly5, ts: a_float, p0: a_float, p1: a_float, v0: a_float, v1: a_float, a0: a_float, a1: a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { plan(ctx, false, ts, p0, p1, v0, v1, a0, a1) };
}

/// @brief Coefficients of velocity, from those of position: `v[i] = p[i+1]*(i+1)`.
#[cfg(all(not(feature = "poly-compact"), trajpoly5_v))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_gen1(ctx: *mut a_trajpoly5) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::differentiate(ctx.cast(), const { poly::Place::new(6, 0) }) };
}

/// @brief Coefficients of acceleration, from those of velocity: `a[i] = v[i+1]*(i+1)`.
#[cfg(all(not(feature = "poly-compact"), trajpoly5_a))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_gen2(ctx: *mut a_trajpoly5) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::differentiate(ctx.cast(), const { poly::Place::new(6, 1) }) };
}

/// @brief Copy the 6 coefficients of position out; `c0` may lie inside `ctx`.
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_c0(ctx: *const a_trajpoly5, c0: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c0` is NULL or has room for 6, by the contract of this module.
    unsafe { poly::copy_out(ctx.cast(), c0, |c: &Poly5<Number>| *c) };
}

/// @brief Copy the 5 coefficients of velocity out; `c1` may lie inside `ctx`.
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_c1(ctx: *const a_trajpoly5, c1: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c1` is NULL or has room for 5, by the contract of this module.
    unsafe { poly::copy_out(ctx.cast(), c1, |c: &Poly5<Number>| c.derivative::<5>()) };
}

/// @brief Copy the 4 coefficients of acceleration out; `c2` may lie inside `ctx`.
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_c2(ctx: *const a_trajpoly5, c2: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c2` is NULL or has room for 4, by the contract of this module.
    unsafe { poly::copy_out(ctx.cast(), c2, |c: &Poly5<Number>| c.derivative::<5>().derivative::<4>()) };
}

/// @brief Position, unit, by Horner's rule.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_pos(ctx: *const a_trajpoly5, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<6, 0>(ctx.cast(), x) }
}

/// @brief Velocity, unit/s, by Horner's rule.
#[cfg(trajpoly5_v)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_vel(ctx: *const a_trajpoly5, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<6, 1>(ctx.cast(), x) }
}

/// @brief Acceleration, unit/s^2, by Horner's rule.
#[cfg(trajpoly5_a)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_acc(ctx: *const a_trajpoly5, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<6, 2>(ctx.cast(), x) }
}
