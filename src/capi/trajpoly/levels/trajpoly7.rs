//! `a/trajpoly7.h`: the septic polynomial in the struct of liba 0.1.15, which stores its derivatives up to a level.

#[cfg(trajpoly7_v)]
use crate::capi::firmware::differentiate;
use crate::capi::firmware::evaluate;
use crate::capi::{Number, a_float, boundary};
use crate::liba::{Poly, Poly7};
use core::mem::offset_of;

/// @brief Septic polynomial trajectory.
///
/// Coefficients stand in ascending powers of time: `p[0] + p[1]*x + ...`. `A_TRAJPOLY7` arrays are stored.
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
// A pointer to the struct is a pointer to the polynomial of position.
const _: () = assert!(offset_of!(a_trajpoly7, p) == 0);

impl a_trajpoly7 {
    /// The state at a time, from a copy of the coefficients that no output of a call can overlap. Derivatives above the struct's
    /// level are computed from the position coefficients.
    pub(in crate::capi) fn state(&self) -> impl Fn(Number) -> [Number; 4] + use<> {
        let p = Poly { c: self.p };
        #[cfg(trajpoly7_v)]
        let v = Poly { c: self.v };
        #[cfg(not(trajpoly7_v))]
        let v: Poly<_, 7> = p.derivative();
        #[cfg(trajpoly7_a)]
        let a = Poly { c: self.a };
        #[cfg(not(trajpoly7_a))]
        let a: Poly<_, 6> = v.derivative();
        #[cfg(trajpoly7_j)]
        let j = Poly { c: self.j };
        #[cfg(not(trajpoly7_j))]
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
        a_trajpoly7_gen0(ctx, ts, p0, p1, v0, v1, a0, a1, j0, j1);
        #[cfg(trajpoly7_v)]
        a_trajpoly7_gen1(ctx);
        #[cfg(trajpoly7_a)]
        a_trajpoly7_gen2(ctx);
        #[cfg(trajpoly7_j)]
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
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the coefficients of position come first.
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
#[cfg(trajpoly7_v)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen1(ctx: *mut a_trajpoly7) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and `v` follows `p`.
    unsafe { differentiate::<8, 7>(ctx.cast(), offset_of!(a_trajpoly7, p)) };
}

/// @brief Coefficients of acceleration, from the coefficients of velocity: `a[i] = v[i+1]*(i+1)`.
/// @param ctx points to an instance of septic polynomial trajectory; nothing happens if it is NULL
#[cfg(trajpoly7_a)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen2(ctx: *mut a_trajpoly7) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and `a` follows `v`.
    unsafe { differentiate::<7, 6>(ctx.cast(), offset_of!(a_trajpoly7, v)) };
}

/// @brief Coefficients of jerk, from the coefficients of acceleration: `j[i] = a[i+1]*(i+1)`.
/// @param ctx points to an instance of septic polynomial trajectory; nothing happens if it is NULL
#[cfg(trajpoly7_j)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_gen3(ctx: *mut a_trajpoly7) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and `j` follows `a`.
    unsafe { differentiate::<6, 5>(ctx.cast(), offset_of!(a_trajpoly7, a)) };
}

/// @brief Position of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return position, unit; NaN if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_pos(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { evaluate::<8>(ctx.cast(), offset_of!(a_trajpoly7, p), x) }
}

/// @brief Velocity of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return velocity, unit/s; NaN if `ctx` is NULL
#[cfg(trajpoly7_v)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_vel(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { evaluate::<7>(ctx.cast(), offset_of!(a_trajpoly7, v), x) }
}

/// @brief Acceleration of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return acceleration, unit/s^2; NaN if `ctx` is NULL
#[cfg(trajpoly7_a)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_acc(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { evaluate::<6>(ctx.cast(), offset_of!(a_trajpoly7, a), x) }
}

/// @brief Jerk of a septic polynomial trajectory, by Horner's rule.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x time since the start, s; the polynomial goes on outside the move
/// @return jerk, unit/s^3; NaN if `ctx` is NULL
#[cfg(trajpoly7_j)]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajpoly7_jer(ctx: *const a_trajpoly7, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { evaluate::<5>(ctx.cast(), offset_of!(a_trajpoly7, j), x) }
}
