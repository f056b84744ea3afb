//! `atraj.h`: what a polynomial reaches, which limits nothing between its ends.

use super::write_extremes;
use crate::capi::trajpoly::{
    trajpoly3::a_trajpoly3, trajpoly5::a_trajpoly5, trajpoly7::a_trajpoly7,
};
use crate::capi::{Number, a_float};
use crate::liba::{Poly3, Poly5, Poly7};

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
