//! The structs of liba 0.1.15: the coefficients of position and, up to the level of the build, the coefficients of its derivatives.

pub mod trajpoly3;
pub mod trajpoly5;
pub mod trajpoly7;

#[cfg(target_os = "none")]
use crate::capi::firmware::evaluate;
#[cfg(all(target_os = "none", any(trajpoly3_v, trajpoly5_v, trajpoly7_v)))]
use crate::capi::firmware::{derive, differentiate};

#[cfg(not(target_os = "none"))]
use crate::capi::{Number, a_float, nan};
#[cfg(not(target_os = "none"))]
use crate::poly::Poly;

/// The polynomial whose `N` coefficients stand `offset` bytes into a struct, at `x`; NaN for a NULL context.
///
/// # Safety
/// `ctx` is NULL or points to a struct that holds these coefficients.
#[cfg(not(target_os = "none"))]
unsafe fn evaluate<const N: usize>(ctx: *const Number, offset: usize, x: a_float) -> a_float {
    if ctx.is_null() {
        return nan();
    }
    // SAFETY: by the contract of this function.
    let c = unsafe { *ctx.byte_add(offset).cast::<[Number; N]>() };
    Poly { c }.position(x).into()
}

/// Writes the `M` coefficients of the derivative behind `N` coefficients, which stand `offset` bytes into a struct; nothing for a
/// NULL context.
///
/// # Safety
/// `ctx` is NULL or points to a struct that holds both arrays.
#[cfg(all(not(target_os = "none"), any(trajpoly3_v, trajpoly5_v, trajpoly7_v)))]
unsafe fn differentiate<const N: usize, const M: usize>(ctx: *mut Number, offset: usize) {
    if ctx.is_null() {
        return;
    }
    // SAFETY: by the contract of this function; the arrays do not overlap.
    unsafe {
        let coefficients = ctx.byte_add(offset).cast::<[Number; N]>();
        derive(
            &*coefficients,
            &mut *coefficients.add(1).cast::<[Number; M]>(),
        );
    }
}

/// Writes the coefficients of the derivative.
#[cfg(all(not(target_os = "none"), any(trajpoly3_v, trajpoly5_v, trajpoly7_v)))]
fn derive<const N: usize, const M: usize>(&c: &[Number; N], derivative: &mut [Number; M]) {
    *derivative = Poly { c }.derivative().c;
}
