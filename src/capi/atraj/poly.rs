//! `atraj.h`: what a polynomial does, which limits nothing between its ends.

use super::{array, write, write_extremes};
use crate::capi::a::{trajpoly3::a_trajpoly3, trajpoly5::a_trajpoly5, trajpoly7::a_trajpoly7};
use crate::capi::{Number, a_float};
use crate::liba::{Poly3, Poly5, Poly7};
use crate::sampling::{MOST_SAMPLES, Sweep};

/// @brief The lowest and the highest position, velocity and acceleration of a cubic polynomial trajectory.
///
/// They are found from the coefficients of position.
/// @param ctx points to a planned instance of cubic polynomial trajectory; nothing happens if it is NULL
/// @param ts duration, s, with which it was planned: the struct does not hold it
/// @param lowest the lowest position, velocity and acceleration: NULL or an array of 3
/// @param highest the highest position, velocity and acceleration: NULL or an array of 3
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly3_extremes(
    ctx: *const a_trajpoly3,
    ts: a_float,
    lowest: *mut a_float,
    highest: *mut a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the coefficients of position come first.
    if let Some(poly) = unsafe { ctx.cast::<Poly3<Number>>().as_ref() } {
        // SAFETY: the outputs are NULL or have room for three values by the contract of this module.
        unsafe { write_extremes(poly.extremes(ts.into()), lowest, highest) };
    }
}

/// @brief Sample a cubic polynomial trajectory: positions, velocities and accelerations at evenly spaced times.
///
/// Sample `k` belongs to the time `x0 + k*dt`. It has the bits that the single functions give for this time.
///
/// Derivatives above the struct's level are computed from the position coefficients.
/// @param ctx points to a planned instance of cubic polynomial trajectory
/// @param x0 time of sample 0 since the start, s
/// @param dt time from one sample to the next, s; it may be 0 or negative
/// @param n number of samples
/// @param pos position, unit: NULL or an array of `n`
/// @param vel velocity, unit/s: NULL or an array of `n`
/// @param acc acceleration, unit/s^2: NULL or an array of `n`
/// @return number of samples written: `n` or 2147483647, whichever is less; 0 if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly3_sample(
    ctx: *const a_trajpoly3,
    x0: a_float,
    dt: a_float,
    n: usize,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
) -> usize {
    let n = n.min(MOST_SAMPLES);
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let Some(poly) = (unsafe { ctx.as_ref() }) else {
        return 0;
    };
    // SAFETY: each output is NULL or has room for `n` values by the contract of this module.
    let outputs = [pos, vel, acc].map(|output| unsafe { array(output.cast(), n) });
    let state = poly.state();
    Sweep {
        x0: x0.into(),
        dt: dt.into(),
    }
    .fill(outputs, state);
    n
}

/// @brief State of a cubic polynomial trajectory: position, velocity and acceleration at one time.
///
/// Each quantity has the bits that its single function gives.
///
/// Derivatives above the struct's level are computed from the position coefficients.
/// @param ctx points to a planned instance of cubic polynomial trajectory; if it is NULL, all results are NaN
/// @param x time since the start, s
/// @param pos position, unit: NULL or the place for the result
/// @param vel velocity, unit/s: NULL or the place for the result
/// @param acc acceleration, unit/s^2: NULL or the place for the result
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly3_state(
    ctx: *const a_trajpoly3,
    x: a_float,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let state = match unsafe { ctx.as_ref() } {
        Some(poly) => poly.state()(x.into()).map(Into::into),
        None => [a_float::NAN; 3],
    };
    // SAFETY: each output is NULL or writable by the contract of this module.
    unsafe { write([pos, vel, acc], state) };
}

/// @brief The lowest and the highest position, velocity and acceleration of a quintic polynomial trajectory.
///
/// They are found from the coefficients of position.
/// @param ctx points to a planned instance of quintic polynomial trajectory; nothing happens if it is NULL
/// @param ts duration, s, with which it was planned: the struct does not hold it
/// @param lowest the lowest position, velocity and acceleration: NULL or an array of 3
/// @param highest the highest position, velocity and acceleration: NULL or an array of 3
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly5_extremes(
    ctx: *const a_trajpoly5,
    ts: a_float,
    lowest: *mut a_float,
    highest: *mut a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the coefficients of position come first.
    if let Some(poly) = unsafe { ctx.cast::<Poly5<Number>>().as_ref() } {
        // SAFETY: the outputs are NULL or have room for three values by the contract of this module.
        unsafe { write_extremes(poly.extremes(ts.into()), lowest, highest) };
    }
}

/// @brief Sample a quintic polynomial trajectory: positions, velocities and accelerations at evenly spaced times.
///
/// Sample `k` belongs to the time `x0 + k*dt`. It has the bits that the single functions give for this time.
///
/// Derivatives above the struct's level are computed from the position coefficients.
/// @param ctx points to a planned instance of quintic polynomial trajectory
/// @param x0 time of sample 0 since the start, s
/// @param dt time from one sample to the next, s; it may be 0 or negative
/// @param n number of samples
/// @param pos position, unit: NULL or an array of `n`
/// @param vel velocity, unit/s: NULL or an array of `n`
/// @param acc acceleration, unit/s^2: NULL or an array of `n`
/// @return number of samples written: `n` or 2147483647, whichever is less; 0 if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly5_sample(
    ctx: *const a_trajpoly5,
    x0: a_float,
    dt: a_float,
    n: usize,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
) -> usize {
    let n = n.min(MOST_SAMPLES);
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let Some(poly) = (unsafe { ctx.as_ref() }) else {
        return 0;
    };
    // SAFETY: each output is NULL or has room for `n` values by the contract of this module.
    let outputs = [pos, vel, acc].map(|output| unsafe { array(output.cast(), n) });
    let state = poly.state();
    Sweep {
        x0: x0.into(),
        dt: dt.into(),
    }
    .fill(outputs, state);
    n
}

/// @brief State of a quintic polynomial trajectory: position, velocity and acceleration at one time.
///
/// Each quantity has the bits that its single function gives.
///
/// Derivatives above the struct's level are computed from the position coefficients.
/// @param ctx points to a planned instance of quintic polynomial trajectory; if it is NULL, all results are NaN
/// @param x time since the start, s
/// @param pos position, unit: NULL or the place for the result
/// @param vel velocity, unit/s: NULL or the place for the result
/// @param acc acceleration, unit/s^2: NULL or the place for the result
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly5_state(
    ctx: *const a_trajpoly5,
    x: a_float,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let state = match unsafe { ctx.as_ref() } {
        Some(poly) => poly.state()(x.into()).map(Into::into),
        None => [a_float::NAN; 3],
    };
    // SAFETY: each output is NULL or writable by the contract of this module.
    unsafe { write([pos, vel, acc], state) };
}

/// @brief The lowest and the highest position, velocity and acceleration of a septic polynomial trajectory.
///
/// They are found from the coefficients of position.
/// @param ctx points to a planned instance of septic polynomial trajectory; nothing happens if it is NULL
/// @param ts duration, s, with which it was planned: the struct does not hold it
/// @param lowest the lowest position, velocity and acceleration: NULL or an array of 3
/// @param highest the highest position, velocity and acceleration: NULL or an array of 3
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly7_extremes(
    ctx: *const a_trajpoly7,
    ts: a_float,
    lowest: *mut a_float,
    highest: *mut a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the coefficients of position come first.
    if let Some(poly) = unsafe { ctx.cast::<Poly7<Number>>().as_ref() } {
        // SAFETY: the outputs are NULL or have room for three values by the contract of this module.
        unsafe { write_extremes(poly.extremes(ts.into()), lowest, highest) };
    }
}

/// @brief Sample a septic polynomial trajectory: positions, velocities, accelerations and jerks at evenly spaced times.
///
/// Sample `k` belongs to the time `x0 + k*dt`. It has the bits that the single functions give for this time.
///
/// Derivatives above the struct's level are computed from the position coefficients.
/// @param ctx points to a planned instance of septic polynomial trajectory
/// @param x0 time of sample 0 since the start, s
/// @param dt time from one sample to the next, s; it may be 0 or negative
/// @param n number of samples
/// @param pos position, unit: NULL or an array of `n`
/// @param vel velocity, unit/s: NULL or an array of `n`
/// @param acc acceleration, unit/s^2: NULL or an array of `n`
/// @param jer jerk, unit/s^3: NULL or an array of `n`
/// @return number of samples written: `n` or 2147483647, whichever is less; 0 if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly7_sample(
    ctx: *const a_trajpoly7,
    x0: a_float,
    dt: a_float,
    n: usize,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
    jer: *mut a_float,
) -> usize {
    let n = n.min(MOST_SAMPLES);
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let Some(poly) = (unsafe { ctx.as_ref() }) else {
        return 0;
    };
    // SAFETY: each output is NULL or has room for `n` values by the contract of this module.
    let outputs = [pos, vel, acc, jer].map(|output| unsafe { array(output.cast(), n) });
    let state = poly.state();
    Sweep {
        x0: x0.into(),
        dt: dt.into(),
    }
    .fill(outputs, state);
    n
}

/// @brief State of a septic polynomial trajectory: position, velocity, acceleration and jerk at one time.
///
/// Each quantity has the bits that its single function gives.
///
/// Derivatives above the struct's level are computed from the position coefficients.
/// @param ctx points to a planned instance of septic polynomial trajectory; if it is NULL, all results are NaN
/// @param x time since the start, s
/// @param pos position, unit: NULL or the place for the result
/// @param vel velocity, unit/s: NULL or the place for the result
/// @param acc acceleration, unit/s^2: NULL or the place for the result
/// @param jer jerk, unit/s^3: NULL or the place for the result
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_poly7_state(
    ctx: *const a_trajpoly7,
    x: a_float,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
    jer: *mut a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let state = match unsafe { ctx.as_ref() } {
        Some(poly) => poly.state()(x.into()).map(Into::into),
        None => [a_float::NAN; 4],
    };
    // SAFETY: each output is NULL or writable by the contract of this module.
    unsafe { write([pos, vel, acc, jer], state) };
}
