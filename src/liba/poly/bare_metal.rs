//! On a microcontroller a loop costs more than the work that it repeats. Where a unit or a call computes, all steps are therefore
//! written out once, from the highest degree down, and each degree enters at its own step.

use crate::real::{Operations, processor};

/// The polynomial with these coefficients, at most 8, at `x`, by Horner's rule; 0 without coefficients.
pub fn horner<R: Operations>(c: &[R], x: R) -> R {
    if !processor::HAS_BINARY32_UNIT {
        return match c.split_last() {
            Some((&highest, lower)) => lower.iter().rev().fold(highest, |y, c| y * x + *c),
            None => R::ZERO,
        };
    }
    let at = |k: usize| c.get(k).copied().unwrap_or(R::ZERO);
    // A sum that comes from a call comes in the same registers at every degree, so one load serves all degrees.
    let last = at(c.len().wrapping_sub(1));
    let highest = |k: usize| if R::HAS_UNIT { at(k) } else { last };
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

/// Writes the coefficients of the derivative, which has one coefficient fewer, of at most 8 coefficients. Where their number is
/// known, only the steps of this number are left.
#[inline(always)]
pub fn differentiate<R: Operations>(c: &[R], derivative: &mut [R]) {
    let mut term = |power: u8| {
        let k = usize::from(power);
        if let (Some(&c), Some(d)) = (c.get(k), derivative.get_mut(k - 1)) {
            // A factor of 1 changes no bit.
            *d = if power == 1 { c } else { c * R::from(power) };
        }
    };
    'one: {
        'two: {
            'three: {
                'four: {
                    'five: {
                        match c.len() {
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

/// Whether a plan still has its coefficients in registers, and so writes the coefficients of the derivatives too. Where calls compute,
/// one copy of the derivation serves all polynomials.
pub const fn derives_in_registers<R: Operations>() -> bool {
    R::HAS_UNIT
}
