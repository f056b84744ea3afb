//! The polynomials of the structs with levels: on a host a loop for each degree, on small flash one copy for all degrees.
//!
//! On a microcontroller a loop costs more than the work that it repeats. Where a unit or a call computes, all steps are therefore
//! written out once, from the highest degree down, and each degree enters at its own step.
#![allow(dead_code, reason = "low levels have no derivatives")]

use super::{Number, a_float, nan};
use crate::liba::Poly;
use crate::real::{Operations, processor};
use core::slice;

/// Which of a struct's reals are the coefficients of a polynomial: the first of them and the degree, packed into what one short
/// instruction can load.
#[derive(Clone, Copy)]
struct Place(usize);

impl Place {
    /// The `count` coefficients, at most 8, that stand `offset` bytes into the struct.
    const fn new(offset: usize, count: usize) -> Self {
        Self(offset / size_of::<a_float>() * 8 + count - 1)
    }

    /// The coefficients.
    ///
    /// # Safety
    /// `ctx` points to a struct that holds these coefficients.
    unsafe fn of(self, ctx: *const Number) -> *const [Number] {
        // SAFETY: by the contract of this function.
        let first = unsafe { ctx.add(self.0 / 8) };
        core::ptr::slice_from_raw_parts(first, self.0 % 8 + 1)
    }
}

/// The polynomial whose `N` coefficients stand `offset` bytes into a struct, at `x`; NaN for a NULL context.
///
/// # Safety
/// `ctx` is NULL or points to a struct that holds these coefficients.
pub unsafe fn evaluate<const N: usize>(ctx: *const Number, offset: usize, x: a_float) -> a_float {
    if processor::IS_BARE_METAL {
        // SAFETY: the contract of this function is the contract of that one.
        return unsafe { evaluate_at(ctx, Place::new(offset, N), x) };
    }
    if ctx.is_null() {
        return nan();
    }
    // SAFETY: not NULL, so the coefficients are there by the contract of this function.
    let c = unsafe { *ctx.byte_add(offset).cast::<[Number; N]>() };
    Poly { c }.position(x.into()).into()
}

/// # Safety
/// `ctx` is NULL or points to a struct that holds these coefficients.
#[inline(never)]
unsafe fn evaluate_at(ctx: *const Number, place: Place, x: a_float) -> a_float {
    if ctx.is_null() {
        return a_float::NAN;
    }
    // SAFETY: by the contract of this function.
    let coefficients = unsafe { &*place.of(ctx) };
    horner(coefficients, x.into()).into()
}

/// Horner's rule for up to eight coefficients; 0 for none.
fn horner(c: &[Number], x: Number) -> Number {
    if !processor::HAS_BINARY32_UNIT {
        return match c.split_last() {
            Some((&highest, lower)) => lower.iter().rev().fold(highest, |y, c| y * x + *c),
            None => Number::ZERO,
        };
    }
    let at = |k: usize| c.get(k).copied().unwrap_or(Number::ZERO);
    // A sum that comes from a call comes in the same registers at every degree, so one load serves all degrees.
    let last = at(c.len().wrapping_sub(1));
    let highest = |k: usize| if Number::HAS_UNIT { at(k) } else { last };
    let c1 = 'one: {
        let c2 = 'two: {
            let c3 = 'three: {
                let c4 = 'four: {
                    let c5 = 'five: {
                        let c6 = 'six: {
                            let c7 = match c.len() {
                                8 => highest(7),
                                7 => break 'six highest(6),
                                6 => break 'five highest(5),
                                5 => break 'four highest(4),
                                4 => break 'three highest(3),
                                3 => break 'two highest(2),
                                2 => break 'one highest(1),
                                _ => return highest(0),
                            };
                            c7 * x + at(6)
                        };
                        c6 * x + at(5)
                    };
                    c5 * x + at(4)
                };
                c4 * x + at(3)
            };
            c3 * x + at(2)
        };
        c2 * x + at(1)
    };
    c1 * x + at(0)
}

/// Writes the `M` coefficients of the derivative behind `N` coefficients, which stand `offset` bytes into a struct; nothing for a
/// NULL context.
///
/// # Safety
/// `ctx` is NULL or points to a struct that holds both arrays.
pub unsafe fn differentiate<const N: usize, const M: usize>(ctx: *mut Number, offset: usize) {
    if processor::IS_BARE_METAL {
        // SAFETY: the contract of this function is the contract of that one.
        return unsafe { differentiate_at(ctx, Place::new(offset, N)) };
    }
    if ctx.is_null() {
        return;
    }
    // SAFETY: not NULL, so both arrays are there by the contract of this function, and they do not overlap.
    unsafe {
        let coefficients = ctx.byte_add(offset).cast::<[Number; N]>();
        derive(
            &*coefficients,
            &mut *coefficients.add(1).cast::<[Number; M]>(),
        );
    }
}

/// # Safety
/// `ctx` is NULL or points to a struct that holds these coefficients and, behind them, the coefficients of the derivative.
#[inline(never)]
unsafe fn differentiate_at(ctx: *mut Number, place: Place) {
    if ctx.is_null() {
        return;
    }
    // SAFETY: by the contract of this function; the arrays do not overlap.
    let (coefficients, derivative) = unsafe {
        let coefficients = place.of(ctx).cast_mut();
        let count = coefficients.len();
        let derivative = coefficients.cast::<Number>().add(count);
        (
            &*coefficients,
            slice::from_raw_parts_mut(derivative, count - 1),
        )
    };
    write_terms(coefficients, derivative);
}

/// Writes the coefficients of the derivative.
pub fn derive<const N: usize, const M: usize>(c: &[Number; N], derivative: &mut [Number; M]) {
    if processor::IS_BARE_METAL {
        write_terms(c, derivative);
    } else {
        *derivative = Poly { c: *c }.derivative().c;
    }
}

/// Writes the coefficients of the derivative of a polynomial with up to eight coefficients. Where their number is known, only the
/// steps of this number are left.
#[inline(always)]
fn write_terms(coefficients: &[Number], derivative: &mut [Number]) {
    let mut term = |power: u8| {
        let k = usize::from(power);
        if let (Some(&c), Some(d)) = (coefficients.get(k), derivative.get_mut(k - 1)) {
            // A factor of 1 changes no bit.
            *d = if power == 1 {
                c
            } else {
                c * Number::from(power)
            };
        }
    };
    'one: {
        'two: {
            'three: {
                'four: {
                    'five: {
                        match coefficients.len() {
                            8 => term(7),
                            7 => {}
                            6 => break 'five,
                            5 => break 'four,
                            4 => break 'three,
                            3 => break 'two,
                            2 => break 'one,
                            _ => return,
                        }
                        term(6);
                    }
                    term(5);
                }
                term(4);
            }
            term(3);
        }
        term(2);
    }
    term(1);
}
