//! The structs of liba since 2025-03: the coefficients of position alone.

pub mod trajpoly3;
pub mod trajpoly5;
pub mod trajpoly7;

use super::super::{Number, a_float};
use crate::liba::Poly;

/// Writes the coefficients of a polynomial to `output`; nothing for `None` or NULL.
///
/// # Safety
/// `output` is NULL or has room for `N` reals.
unsafe fn copy_out<const N: usize>(poly: Option<Poly<Number, N>>, output: *mut a_float) {
    if let (Some(poly), false) = (poly, output.is_null()) {
        // SAFETY: by the contract of this function. No reference into the caller's struct is left.
        unsafe { output.cast::<[Number; N]>().write(poly.c) };
    }
}
