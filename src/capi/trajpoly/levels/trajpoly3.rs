//! `a/trajpoly3.h`: the cubic polynomial in the struct of liba 0.1.15, which stores its derivatives up to a level.

use crate::capi::firmware::evaluate;
#[cfg(trajpoly3_v)]
use crate::capi::firmware::{derive, differentiate};
use crate::capi::{Number, a_float, boundary};
use crate::liba::{Poly, Poly3};
use crate::real::Operations;
use core::mem::offset_of;

/// @brief Cubic polynomial trajectory.
///
/// Coefficients stand in ascending powers of time: `p[0] + p[1]*x + ...`. `A_TRAJPOLY3` arrays are stored.
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
// A pointer to the struct is a pointer to the polynomial of position.
const _: () = assert!(offset_of!(a_trajpoly3, p) == 0);

impl a_trajpoly3 {
    /// The state at a time, from a copy of the coefficients that no output of a call can overlap. Derivatives above the struct's
    /// level are computed from the position coefficients.
    pub(in crate::capi) fn state(&self) -> impl Fn(Number) -> [Number; 3] + use<> {
        let p = Poly { c: self.p };
        #[cfg(trajpoly3_v)]
        let v = Poly { c: self.v };
        #[cfg(not(trajpoly3_v))]
        let v: Poly<_, 3> = p.derivative();
        #[cfg(trajpoly3_a)]
        let a = Poly { c: self.a };
        #[cfg(not(trajpoly3_a))]
        let a: Poly<_, 2> = v.derivative();
        move |x| [p.position(x), v.position(x), a.position(x)]
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
    // SAFETY: the contract of this function is the contract of each of these.
    unsafe {
        if Number::HAS_UNIT {
            plan(ctx, true, ts, p0, p1, v0, v1);
            return;
        }
        a_trajpoly3_gen0(ctx, ts, p0, p1, v0, v1);
        #[cfg(trajpoly3_v)]
        a_trajpoly3_gen1(ctx);
        #[cfg(trajpoly3_a)]
        a_trajpoly3_gen2(ctx);
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
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_gen0(
    ctx: *mut a_trajpoly3,
    ts: a_float,
    p0: a_float,
    p1: a_float,
    v0: a_float,
    v1: a_float,
) {
    // SAFETY: the contract of this function is the contract of that one.
    unsafe { plan(ctx, false, ts, p0, p1, v0, v1) };
}

/// The coefficients of position and, for `all`, the coefficients that derive from them. A unit still has these in its registers.
///
/// # Safety
/// `ctx` is NULL or valid by the contract of this module.
unsafe fn plan(
    ctx: *mut a_trajpoly3,
    all: bool,
    ts: a_float,
    p0: a_float,
    p1: a_float,
    v0: a_float,
    v1: a_float,
) {
    // SAFETY: by the contract of this function, and the coefficients of position come first.
    let Some(position) = (unsafe { ctx.cast::<Poly3<Number>>().as_mut() }) else {
        return;
    };
    position.plan(ts.into(), boundary(p0, p1, v0, v1));
    if all {
        #[cfg(trajpoly3_v)]
        // SAFETY: not NULL, so valid by the contract of this function; `position` is not used any more.
        unsafe {
            let poly = &mut *ctx;
            derive(&poly.p, &mut poly.v);
            #[cfg(trajpoly3_a)]
            derive(&poly.v, &mut poly.a);
        }
    }
}

/// @brief Coefficients of velocity, from the coefficients of position: `v[i] = p[i+1]*(i+1)`.
/// @param ctx points to an instance of cubic polynomial trajectory; nothing happens if it is NULL
#[cfg(trajpoly3_v)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_gen1(ctx: *mut a_trajpoly3) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and `v` follows `p`.
    unsafe { differentiate::<4, 3>(ctx.cast(), offset_of!(a_trajpoly3, p)) };
}

/// @brief Coefficients of acceleration, from the coefficients of velocity: `a[i] = v[i+1]*(i+1)`.
/// @param ctx points to an instance of cubic polynomial trajectory; nothing happens if it is NULL
#[cfg(trajpoly3_a)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_gen2(ctx: *mut a_trajpoly3) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and `a` follows `v`.
    unsafe { differentiate::<3, 2>(ctx.cast(), offset_of!(a_trajpoly3, v)) };
}

/// @brief Position of a cubic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return position, unit; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_pos(ctx: *const a_trajpoly3, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { evaluate::<4>(ctx.cast(), offset_of!(a_trajpoly3, p), x) }
}

/// @brief Velocity of a cubic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return velocity, unit/s; NaN if `ctx` is NULL
#[cfg(trajpoly3_v)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_vel(ctx: *const a_trajpoly3, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { evaluate::<3>(ctx.cast(), offset_of!(a_trajpoly3, v), x) }
}

/// @brief Acceleration of a cubic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return acceleration, unit/s^2; NaN if `ctx` is NULL
#[cfg(trajpoly3_a)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly3_acc(ctx: *const a_trajpoly3, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { evaluate::<2>(ctx.cast(), offset_of!(a_trajpoly3, a), x) }
}
