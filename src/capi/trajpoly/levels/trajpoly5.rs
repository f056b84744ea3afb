//! `a/trajpoly5.h`: the quintic polynomial in the struct of liba 0.1.15, which stores its derivatives up to a level.

use crate::capi::firmware::evaluate;
#[cfg(trajpoly5_v)]
use crate::capi::firmware::{derive, differentiate};
use crate::capi::{Number, a_float, boundary};
use crate::liba::{Poly, Poly5};
use crate::real::Operations;
use core::mem::offset_of;

/// @brief Quintic polynomial trajectory.
///
/// Coefficients stand in ascending powers of time: `p[0] + p[1]*x + ...`. `A_TRAJPOLY5` arrays are stored.
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
// A pointer to the struct is a pointer to the polynomial of position.
const _: () = assert!(offset_of!(a_trajpoly5, p) == 0);

impl a_trajpoly5 {
    /// The state at a time, from a copy of the coefficients that no output of a call can overlap. Derivatives above the struct's
    /// level are computed from the position coefficients.
    pub(in crate::capi) fn state(&self) -> impl Fn(Number) -> [Number; 3] + use<> {
        let p = Poly { c: self.p };
        #[cfg(trajpoly5_v)]
        let v = Poly { c: self.v };
        #[cfg(not(trajpoly5_v))]
        let v: Poly<_, 5> = p.derivative();
        #[cfg(trajpoly5_a)]
        let a = Poly { c: self.a };
        #[cfg(not(trajpoly5_a))]
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
        if Number::HAS_UNIT {
            plan(ctx, true, ts, p0, p1, v0, v1, a0, a1);
            return;
        }
        a_trajpoly5_gen0(ctx, ts, p0, p1, v0, v1, a0, a1);
        #[cfg(trajpoly5_v)]
        a_trajpoly5_gen1(ctx);
        #[cfg(trajpoly5_a)]
        a_trajpoly5_gen2(ctx);
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
    // SAFETY: the contract of this function is the contract of that one.
    unsafe { plan(ctx, false, ts, p0, p1, v0, v1, a0, a1) };
}

/// The coefficients of position and, for `all`, the coefficients that derive from them. A unit still has these in its registers.
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
        #[cfg(trajpoly5_v)]
        // SAFETY: not NULL, so valid by the contract of this function; `position` is not used any more.
        unsafe {
            let poly = &mut *ctx;
            derive(&poly.p, &mut poly.v);
            #[cfg(trajpoly5_a)]
            derive(&poly.v, &mut poly.a);
        }
    }
}

/// @brief Coefficients of velocity, from the coefficients of position: `v[i] = p[i+1]*(i+1)`.
/// @param ctx points to an instance of quintic polynomial trajectory; nothing happens if it is NULL
#[cfg(trajpoly5_v)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_gen1(ctx: *mut a_trajpoly5) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and `v` follows `p`.
    unsafe { differentiate::<6, 5>(ctx.cast(), offset_of!(a_trajpoly5, p)) };
}

/// @brief Coefficients of acceleration, from the coefficients of velocity: `a[i] = v[i+1]*(i+1)`.
/// @param ctx points to an instance of quintic polynomial trajectory; nothing happens if it is NULL
#[cfg(trajpoly5_a)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_gen2(ctx: *mut a_trajpoly5) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and `a` follows `v`.
    unsafe { differentiate::<5, 4>(ctx.cast(), offset_of!(a_trajpoly5, v)) };
}

/// @brief Position of a quintic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return position, unit; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_pos(ctx: *const a_trajpoly5, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { evaluate::<6>(ctx.cast(), offset_of!(a_trajpoly5, p), x) }
}

/// @brief Velocity of a quintic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return velocity, unit/s; NaN if `ctx` is NULL
#[cfg(trajpoly5_v)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_vel(ctx: *const a_trajpoly5, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { evaluate::<5>(ctx.cast(), offset_of!(a_trajpoly5, v), x) }
}

/// @brief Acceleration of a quintic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return acceleration, unit/s^2; NaN if `ctx` is NULL
#[cfg(trajpoly5_a)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly5_acc(ctx: *const a_trajpoly5, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { evaluate::<4>(ctx.cast(), offset_of!(a_trajpoly5, a), x) }
}
