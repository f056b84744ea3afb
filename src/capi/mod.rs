//! The C ABI: structs and functions of liba and the handle of CLARAty's trapezoid, one file for each header.
//!
//! The contract, stated once:
//!
//! - **Pointers.** A context is NULL or points to a struct of the type named, aligned, and not in use by another thread
//!   for the time of the call. An output array is NULL or has room for what the function writes. Nothing is kept, but
//!   by a `claraty_trapezoid` its clock, and its waypoints until the next set.
//! - **NULL** context: `gen` returns 0, a function without a result does nothing, an evaluation returns NaN, one with
//!   an error code `CLARATY_ERR_NULL`. The originals dereference it, which is undefined, so any answer is compatible.
//! - **Uninitialised** contexts may be passed to `gen`; what a failing `gen` does not reach keeps its old value.
//! - **NaN and infinities** in arguments and fields go through the arithmetic as in the original; `claraty_trapezoid`
//!   refuses them.
//! - **No** function panics, allocates, keeps state or loops without bound; all are reentrant.
#![allow(non_camel_case_types)] // C names
#![allow(clippy::missing_safety_doc)] // the contract above is the safety section of every function
#![allow(clippy::too_many_arguments)] // the signatures are the original's
#![allow(clippy::useless_conversion)] // not where `Number` is a type of its own

pub mod atraj;
pub mod claraty;
#[cfg(atraj_archive)]
mod panic;
pub mod trajbell;
pub mod trajpoly3;
pub mod trajpoly5;
pub mod trajpoly7;
pub mod trajtrap;

use crate::{Boundary, poly};
use core::slice;

/// The real type of this build: `float` with the feature `float`, else `double`.
#[cfg(feature = "float")]
pub type a_float = f32;
/// The real type of this build: `float` with the feature `float`, else `double`.
#[cfg(not(feature = "float"))]
pub type a_float = f64;

/// What the profiles compute in: the same bits.
#[cfg(any(feature = "float", not(soft_binary64)))]
type Number = a_float;
#[cfg(all(not(feature = "float"), soft_binary64))]
type Number = crate::soft::Soft64;

fn boundary(p0: a_float, p1: a_float, v0: a_float, v1: a_float) -> Boundary<Number> {
    Boundary {
        p0: p0.into(),
        p1: p1.into(),
        v0: v0.into(),
        v1: v1.into(),
    }
}

/// Fails the build unless every named field stands at the same offset in the C struct and in the core's, and both have
/// the same size: what makes a pointer to one a pointer to the other.
macro_rules! assert_same_layout {
    ($c:ty, $core:ty, $($field:ident)*) => {
        const _: () = {
            assert!(size_of::<$c>() == size_of::<$core>());
            assert!(align_of::<$c>() == align_of::<$core>());
            $(assert!(core::mem::offset_of!($c, $field) == core::mem::offset_of!($core, $field));)*
        };
    };
}
use assert_same_layout;

/// What an evaluation of a NULL context returns. Out of line, and hidden from constant propagation: what is left of the
/// check is one branch in each evaluation.
#[cold]
#[inline(never)]
fn nan() -> a_float {
    core::hint::black_box(a_float::NAN)
}

/// Which of a struct's numbers are the coefficients of a polynomial: the first of them and the degree, packed into what one
/// short instruction can load, for each function hands over its own.
#[derive(Clone, Copy)]
struct Place(usize);

impl Place {
    /// The coefficients of a polynomial of this degree, at most 7, which stand `offset` bytes into the struct.
    const fn new(offset: usize, degree: usize) -> Self {
        Self(offset / size_of::<a_float>() * 8 + degree)
    }

    /// How many bytes into the struct they start.
    fn offset(self) -> usize {
        self.0 / 8 * size_of::<a_float>()
    }

    fn degree(self) -> usize {
        self.0 % 8
    }
}

/// The polynomial with these coefficients at `x`; NaN for a NULL context. Shared by the functions of all polynomials, of which
/// a tail call is left.
///
/// # Safety
/// `ctx` is NULL or points to a struct of reals that has these.
#[inline(never)]
unsafe fn evaluate(ctx: *const a_float, place: Place, x: a_float) -> a_float {
    if ctx.is_null() {
        return a_float::NAN;
    }
    // SAFETY: by the contract of this function.
    let coefficients = unsafe {
        let first = ctx.cast::<Number>().byte_add(place.offset());
        slice::from_raw_parts(first, place.degree() + 1)
    };
    poly::horner(coefficients, x.into()).into()
}

/// Likewise of coefficients that the struct does not hold.
#[cfg(feature = "poly-compact")]
fn evaluate_found<const N: usize>(coefficients: Option<[Number; N]>, x: a_float) -> a_float {
    let coefficients = coefficients
        .as_ref()
        .map_or(core::ptr::null(), |c| c.as_ptr().cast());
    // SAFETY: NULL or an array of this length.
    unsafe { evaluate(coefficients, Place::new(0, N - 1), x) }
}

/// From these coefficients those of the derivative, which are next in the struct; nothing for a NULL context. One for all
/// polynomials on bare metal, where size comes first.
///
/// # Safety
/// `ctx` is NULL or points to a struct of reals that has both.
#[cfg(all(
    not(feature = "poly-compact"),
    any(trajpoly3_v, trajpoly5_v, trajpoly7_v)
))]
#[cfg_attr(target_os = "none", inline(never))]
#[cfg_attr(not(target_os = "none"), inline(always))]
unsafe fn differentiate(ctx: *mut a_float, place: Place) {
    if ctx.is_null() {
        return;
    }
    let degree = place.degree();
    // SAFETY: by the contract of this function.
    let (coefficients, derivative) = unsafe {
        let first = ctx.cast::<Number>().byte_add(place.offset());
        (
            slice::from_raw_parts(first, degree + 1),
            slice::from_raw_parts_mut(first.add(degree + 1), degree),
        )
    };
    poly::differentiate(coefficients, derivative);
}
