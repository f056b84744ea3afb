//! `atraj.h`: one call evaluates a move at many times, or all quantities of a move at one time.

use crate::capi::trajbell::a_trajbell;
use crate::capi::trajpoly::{
    trajpoly3::a_trajpoly3, trajpoly5::a_trajpoly5, trajpoly7::a_trajpoly7,
};
use crate::capi::trajtrap::a_trajtrap;
use crate::capi::{Number, a_float};
use crate::liba::Bell;
use crate::liba::Trap;
use crate::sampling::{MOST_SAMPLES, Sweep};

/// @brief Sample a bell-shaped velocity trajectory: positions, velocities, accelerations and jerks at evenly spaced times.
///
/// Sample `k` belongs to the time `x0 + k*dt`. It has the bits that the single functions give for this time.
/// @param ctx points to a planned instance of bell-shaped velocity trajectory
/// @param x0 time of sample 0 since the start, s
/// @param dt time from one sample to the next, s; it may be 0 or negative
/// @param n number of samples
/// @param pos position, unit: NULL or an array of `n`
/// @param vel velocity, unit/s: NULL or an array of `n`
/// @param acc acceleration, unit/s^2: NULL or an array of `n`
/// @param jer jerk, unit/s^3: NULL or an array of `n`
/// @return number of samples written: `n` or 2147483647, whichever is less; 0 if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_bell_sample(
    ctx: *const a_trajbell,
    x0: a_float,
    dt: a_float,
    n: usize,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
    jer: *mut a_float,
) -> usize {
    let n = n.min(MOST_SAMPLES);
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let Some(bell) = (unsafe { ctx.cast::<Bell<Number>>().as_ref() }) else {
        return 0;
    };
    // SAFETY: each output is NULL or has room for `n` values by the contract of this module.
    let outputs = [pos, vel, acc, jer].map(|output| unsafe { array::<Number>(output.cast(), n) });
    bell.sample_into(x0.into(), dt.into(), outputs);
    n
}

/// @brief State of a bell-shaped velocity trajectory: position, velocity, acceleration and jerk at one time.
///
/// Each quantity has the bits that its single function gives.
/// @param ctx points to a planned instance of bell-shaped velocity trajectory; if it is NULL, all results are NaN
/// @param x time since the start, s
/// @param pos position, unit: NULL or the place for the result
/// @param vel velocity, unit/s: NULL or the place for the result
/// @param acc acceleration, unit/s^2: NULL or the place for the result
/// @param jer jerk, unit/s^3: NULL or the place for the result
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_bell_state(
    ctx: *const a_trajbell,
    x: a_float,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
    jer: *mut a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let state = match unsafe { ctx.cast::<Bell<Number>>().as_ref() } {
        Some(bell) => bell.state(x.into()).map(Into::into),
        None => [a_float::NAN; 4],
    };
    // SAFETY: each output is NULL or writable by the contract of this module.
    unsafe { write([pos, vel, acc, jer], state) };
}

/// @brief Sample a trapezoidal velocity trajectory: positions, velocities and accelerations at evenly spaced times.
///
/// Sample `k` belongs to the time `x0 + k*dt`. It has the bits that the single functions give for this time.
/// @param ctx points to a planned instance of trapezoidal velocity trajectory
/// @param x0 time of sample 0 since the start, s
/// @param dt time from one sample to the next, s; it may be 0 or negative
/// @param n number of samples
/// @param pos position, unit: NULL or an array of `n`
/// @param vel velocity, unit/s: NULL or an array of `n`
/// @param acc acceleration, unit/s^2: NULL or an array of `n`
/// @return number of samples written: `n` or 2147483647, whichever is less; 0 if `ctx` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_trap_sample(
    ctx: *const a_trajtrap,
    x0: a_float,
    dt: a_float,
    n: usize,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
) -> usize {
    let n = n.min(MOST_SAMPLES);
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let Some(trap) = (unsafe { ctx.cast::<Trap<Number>>().as_ref() }) else {
        return 0;
    };
    // SAFETY: each output is NULL or has room for `n` values by the contract of this module.
    let outputs = [pos, vel, acc].map(|output| unsafe { array::<Number>(output.cast(), n) });
    trap.sample_into(x0.into(), dt.into(), outputs);
    n
}

/// @brief State of a trapezoidal velocity trajectory: position, velocity and acceleration at one time.
///
/// Each quantity has the bits that its single function gives.
/// @param ctx points to a planned instance of trapezoidal velocity trajectory; if it is NULL, all results are NaN
/// @param x time since the start, s
/// @param pos position, unit: NULL or the place for the result
/// @param vel velocity, unit/s: NULL or the place for the result
/// @param acc acceleration, unit/s^2: NULL or the place for the result
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_trap_state(
    ctx: *const a_trajtrap,
    x: a_float,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let state = match unsafe { ctx.cast::<Trap<Number>>().as_ref() } {
        Some(trap) => trap.state(x.into()).map(Into::into),
        None => [a_float::NAN; 3],
    };
    // SAFETY: each output is NULL or writable by the contract of this module.
    unsafe { write([pos, vel, acc], state) };
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

/// The `n` values at `output`. A NULL output has no values.
///
/// # Safety
/// `output` is NULL, or has room for `n` values that nobody else uses.
pub(super) unsafe fn array<'a, T>(output: *mut T, n: usize) -> &'a mut [T] {
    if output.is_null() {
        return &mut [];
    }
    // SAFETY: by the contract of this function.
    unsafe { core::slice::from_raw_parts_mut(output, n) }
}

/// Writes each value to its output. A NULL output gets nothing.
///
/// # Safety
/// Each output is NULL or writable.
pub(super) unsafe fn write<const N: usize>(outputs: [*mut a_float; N], values: [a_float; N]) {
    for (output, value) in outputs.into_iter().zip(values) {
        if !output.is_null() {
            // SAFETY: by the contract of this function.
            unsafe { output.write(value) };
        }
    }
}
