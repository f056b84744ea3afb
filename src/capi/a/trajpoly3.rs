//! `a/trajpoly3.h`: the cubic polynomial.

use super::poly::{self, polynomial};
use crate::capi::{Number, a_float};
use crate::liba::{Poly, Poly3, poly::target};

/// @brief Cubic polynomial trajectory.
///
/// Coefficients stand in ascending powers of time: `c[0] + c[1]*x + ...`. The struct of liba since 2025-03 (`A_TRAJPOLY_COMPACT`)
/// stores the coefficients of the position alone. The struct of liba 0.1.15 stores `A_TRAJPOLY3` of the arrays `p`, `v` and `a`.
#[repr(C)]
pub struct a_trajpoly3 {
    /// coefficients of position
    #[cfg(feature = "poly-compact")]
    pub c: [Number; 4],
    /// coefficients of position
    #[cfg(not(feature = "poly-compact"))]
    pub p: [Number; 4],
    /// coefficients of velocity
    #[cfg(all(not(feature = "poly-compact"), trajpoly3_v))]
    pub v: [Number; 3],
    /// coefficients of acceleration
    #[cfg(all(not(feature = "poly-compact"), trajpoly3_a))]
    pub a: [Number; 2],
}

polynomial! {
    a_trajpoly3, Poly3; 3 quantities: p: 4, v: 3 from p if trajpoly3_v, a: 2 from v if trajpoly3_a;
    ends: ; in registers: target::derives_in_registers::<Number>()
}

/// @brief Plan a cubic polynomial trajectory: all coefficients that the struct holds.
///
/// A duration of 0, an infinity or a NaN gives coefficients that are not finite.
/// @param ts duration, s, other than 0
/// @param p0 initial position, unit; `p1` final position
/// @param v0 initial velocity, unit/s; `v1` final velocity
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_gen(
    ctx: *mut a_trajpoly3, ts: a_float, p0: a_float, p1: a_float, v0: a_float, v1: a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { plan_all(ctx, ts, p0, p1, v0, v1) };
}

/// @brief Coefficients of position alone, from the arguments of `a_trajpoly3_gen`.
#[cfg(not(feature = "poly-compact"))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_gen0(
    ctx: *mut a_trajpoly3, ts: a_float, p0: a_float, p1: a_float, v0: a_float, v1: a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { plan(ctx, false, ts, p0, p1, v0, v1) };
}

/// @brief Coefficients of velocity, from those of position: `v[i] = p[i+1]*(i+1)`.
#[cfg(all(not(feature = "poly-compact"), trajpoly3_v))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_gen1(ctx: *mut a_trajpoly3) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::differentiate(ctx.cast(), const { poly::Place::new(4, 0) }) };
}

/// @brief Coefficients of acceleration, from those of velocity: `a[i] = v[i+1]*(i+1)`.
#[cfg(all(not(feature = "poly-compact"), trajpoly3_a))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_gen2(ctx: *mut a_trajpoly3) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::differentiate(ctx.cast(), const { poly::Place::new(4, 1) }) };
}

/// @brief Copy the 4 coefficients of position out; `c0` may lie inside `ctx`.
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_c0(ctx: *const a_trajpoly3, c0: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c0` is NULL or has room for 4, by the contract of this module.
    unsafe { poly::copy_out(ctx.cast(), c0, |c: &Poly3<Number>| *c) };
}

/// @brief Copy the 3 coefficients of velocity out; `c1` may lie inside `ctx`.
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_c1(ctx: *const a_trajpoly3, c1: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c1` is NULL or has room for 3, by the contract of this module.
    unsafe { poly::copy_out(ctx.cast(), c1, |c: &Poly3<Number>| c.derivative::<3>()) };
}

/// @brief Copy the 2 coefficients of acceleration out; `c2` may lie inside `ctx`.
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_c2(ctx: *const a_trajpoly3, c2: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c2` is NULL or has room for 2, by the contract of this module.
    unsafe { poly::copy_out(ctx.cast(), c2, |c: &Poly3<Number>| c.derivative::<3>().derivative::<2>()) };
}

/// @brief Position, unit, by Horner's rule.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_pos(ctx: *const a_trajpoly3, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<4, 0>(ctx.cast(), x) }
}

/// @brief Velocity, unit/s, by Horner's rule.
#[cfg(trajpoly3_v)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_vel(ctx: *const a_trajpoly3, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<4, 1>(ctx.cast(), x) }
}

/// @brief Acceleration, unit/s^2, by Horner's rule.
#[cfg(trajpoly3_a)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_acc(ctx: *const a_trajpoly3, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<4, 2>(ctx.cast(), x) }
}
