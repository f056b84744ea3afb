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

use crate::Boundary;

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

/// The polynomial with these coefficients at `x`; NaN for those of a NULL context.
fn evaluate<C: AsRef<[a_float]>>(coefficients: Option<C>, x: a_float) -> a_float {
    horner(coefficients.as_ref().map(C::as_ref), x)
}

/// Shared by the functions of all polynomials, of which a tail call is left.
#[inline(never)]
fn horner(coefficients: Option<&[a_float]>, x: a_float) -> a_float {
    match coefficients {
        Some(coefficients) => crate::poly::horner(coefficients, x),
        None => nan(),
    }
}
