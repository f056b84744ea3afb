//! `a/trajpoly7.h`: the septic polynomial.

use super::poly::{self, polynomial};
use crate::capi::{Number, a_float};
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

// 26 coefficients are more than the registers hold.
polynomial! {
    a_trajpoly7, Poly7; 4 quantities: p: 8, v: 7 from p if trajpoly7_v, a: 6 from v if trajpoly7_a, j: 5 from a if trajpoly7_j;
    ends: a0 a1, j0 j1; in registers: false
}

/// @brief Plan a septic polynomial trajectory: all coefficients that the struct holds.
///
/// A duration of 0, an infinity or a NaN gives coefficients that are not finite.
/// @param ts duration, s, other than 0
/// @param p0 initial position, unit; `p1` final position
/// @param v0 initial velocity, unit/s; `v1` final velocity
/// @param a0 initial acceleration, unit/s^2; `a1` final acceleration
/// @param j0 initial jerk, unit/s^3; `j1` final jerk
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen(
    ctx: *mut a_trajpoly7, ts: a_float, p0: a_float, p1: a_float, v0: a_float, v1: a_float, a0: a_float, a1: a_float,
    j0: a_float, j1: a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { plan_all(ctx, ts, p0, p1, v0, v1, a0, a1, j0, j1) };
}

/// @brief Coefficients of position alone, from the arguments of `a_trajpoly7_gen`.
#[cfg(not(feature = "poly-compact"))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen0(
    ctx: *mut a_trajpoly7, ts: a_float, p0: a_float, p1: a_float, v0: a_float, v1: a_float, a0: a_float, a1: a_float,
    j0: a_float, j1: a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { plan(ctx, false, ts, p0, p1, v0, v1, a0, a1, j0, j1) };
}

/// @brief Coefficients of velocity, from those of position: `v[i] = p[i+1]*(i+1)`.
#[cfg(all(not(feature = "poly-compact"), trajpoly7_v))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen1(ctx: *mut a_trajpoly7) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::differentiate(ctx.cast(), const { poly::Place::new(8, 0) }) };
}

/// @brief Coefficients of acceleration, from those of velocity: `a[i] = v[i+1]*(i+1)`.
#[cfg(all(not(feature = "poly-compact"), trajpoly7_a))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen2(ctx: *mut a_trajpoly7) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::differentiate(ctx.cast(), const { poly::Place::new(8, 1) }) };
}

/// @brief Coefficients of jerk, from those of acceleration: `j[i] = a[i+1]*(i+1)`.
#[cfg(all(not(feature = "poly-compact"), trajpoly7_j))]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen3(ctx: *mut a_trajpoly7) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::differentiate(ctx.cast(), const { poly::Place::new(8, 2) }) };
}

/// @brief Copy the 8 coefficients of position out; `c0` may lie inside `ctx`.
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c0(ctx: *const a_trajpoly7, c0: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c0` is NULL or has room for 8, by the contract of this module.
    unsafe { poly::copy_out(ctx.cast(), c0, |c: &Poly7<Number>| *c) };
}

/// @brief Copy the 7 coefficients of velocity out; `c1` may lie inside `ctx`.
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c1(ctx: *const a_trajpoly7, c1: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c1` is NULL or has room for 7, by the contract of this module.
    unsafe { poly::copy_out(ctx.cast(), c1, |c: &Poly7<Number>| c.derivative::<7>()) };
}

/// @brief Copy the 6 coefficients of acceleration out; `c2` may lie inside `ctx`.
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c2(ctx: *const a_trajpoly7, c2: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c2` is NULL or has room for 6, by the contract of this module.
    unsafe { poly::copy_out(ctx.cast(), c2, |c: &Poly7<Number>| c.derivative::<7>().derivative::<6>()) };
}

/// @brief Copy the 5 coefficients of jerk out; `c3` may lie inside `ctx`.
#[cfg(feature = "poly-compact")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_c3(ctx: *const a_trajpoly7, c3: *mut a_float) {
    // SAFETY: `ctx` is NULL or valid, and `c3` is NULL or has room for 5, by the contract of this module.
    unsafe {
        poly::copy_out(ctx.cast(), c3, |c: &Poly7<Number>| c.derivative::<7>().derivative::<6>().derivative::<5>())
    };
}

/// @brief Position, unit, by Horner's rule.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_pos(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<8, 0>(ctx.cast(), x) }
}

/// @brief Velocity, unit/s, by Horner's rule.
#[cfg(trajpoly7_v)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_vel(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<8, 1>(ctx.cast(), x) }
}

/// @brief Acceleration, unit/s^2, by Horner's rule.
#[cfg(trajpoly7_a)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_acc(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<8, 2>(ctx.cast(), x) }
}

/// @brief Jerk, unit/s^3, by Horner's rule.
#[cfg(trajpoly7_j)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_jer(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { poly::evaluate::<8, 3>(ctx.cast(), x) }
}
