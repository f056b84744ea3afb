//! On a host a loop serves every degree: the compiler unrolls it where the degree is known.

use crate::real::Operations;

/// The polynomial with these coefficients at `x`, by Horner's rule; 0 without coefficients.
pub fn horner<R: Operations>(c: &[R], x: R) -> R {
    let mut terms = c.iter().rev();
    let highest = terms.next().copied().unwrap_or_default();
    terms.fold(highest, |y, &c| y * x + c)
}

/// Writes the coefficients of the derivative, which has one coefficient fewer.
#[inline(always)]
pub fn differentiate<R: Operations>(c: &[R], derivative: &mut [R]) {
    let terms = derivative.iter_mut().zip(c.iter().skip(1));
    for (k, (d, &c)) in terms.enumerate() {
        *d = c * R::from(k as u8 + 1);
    }
}

/// A plan still has its coefficients in registers, so it writes the coefficients of the derivatives too.
pub const fn derives_in_registers<R: Operations>() -> bool {
    true
}
