//! The C ABI: structs and functions of liba and the handle of CLARAty's trapezoid, one file for each header.
//!
//! The contract, stated once. What all arguments of one header have in common stands at its head, in `include`.
//!
//! - **Pointers.** A context is NULL or points to a struct of the type named, aligned, and not in use by another thread
//!   for the time of the call. One interrupt and one main loop share an `atraj_axis` or an `atraj_group`. An output array
//!   is NULL or has room for what the function writes. Nothing is kept, but by an `atraj_group` its memory, path and
//!   positions, by an `atraj_shaper_stream` its line, and by a `claraty_trapezoid` its clock, and its waypoints until
//!   the next set.
//! - **NULL** context: `gen` returns 0, a function without a result does nothing, an evaluation returns NaN, one with
//!   an error code `CLARATY_ERR_NULL`. The originals dereference it, which is undefined, so any answer is compatible.
//! - **Uninitialised** contexts may be passed to `gen`; what a failing `gen` does not reach keeps its old value.
//! - **NaN and infinities** in arguments and fields go through the arithmetic as in the original; `claraty_trapezoid`
//!   refuses them.
//! - **No** function panics, allocates, keeps state or loops without bound; all are reentrant.
//!
//! By design, this module clashes with the crate `liba` in one program, because both define the same C functions.
#![allow(non_camel_case_types)] // C names
#![allow(clippy::missing_safety_doc)] // the contract above is the safety section of every function
#![allow(clippy::too_many_arguments)] // the signatures are the original's
#![allow(clippy::useless_conversion)] // not where `Number` is a type of its own

pub mod a;
pub mod atraj;
pub mod claraty;
#[cfg(all(atraj_archive, any(target_os = "linux", target_os = "none")))]
mod identity;
#[cfg(atraj_archive)]
mod panic;

pub use a::{trajbell, trajtrap};
pub mod trajpoly {
    //! The polynomials.
    pub use crate::capi::a::{trajpoly3, trajpoly5, trajpoly7};
}

use crate::state::{Boundary, Saturation};

/// The real type of this build: `float` with the feature `float`, else `double`.
#[cfg(feature = "float")]
pub type a_float = f32;
/// The real type of this build: `float` with the feature `float`, else `double`.
#[cfg(not(feature = "float"))]
pub type a_float = f64;

/// The type that the profiles compute in: the same bits.
#[cfg(feature = "float")]
type Number = f32;
/// The type that the profiles compute in: the same bits.
#[cfg(not(feature = "float"))]
type Number = crate::real::Double;

/// The saturation of the generation of liba that this build stands for.
const SATURATION: Saturation =
    if cfg!(feature = "poly-compact") { Saturation::Numbers } else { Saturation::Everything };

fn boundary(p0: a_float, p1: a_float, v0: a_float, v1: a_float) -> Boundary<Number> {
    Boundary { p0: p0.into(), p1: p1.into(), v0: v0.into(), v1: v1.into() }
}

/// A type of C: a pointer to it is a pointer to its type of the core, too.
///
/// # Safety
/// The type begins with a value of `Core`, with the same alignment.
unsafe trait Face {
    type Core;
}
// SAFETY: both are the same bits.
unsafe impl Face for a_float {
    type Core = Number;
}
// SAFETY: one type.
unsafe impl Face for usize {
    type Core = Self;
}

/// # Safety
/// `c` is NULL or points to a value that nobody changes as long as the result lives.
unsafe fn of<'a, C: Face>(c: *const C) -> Option<&'a C::Core> {
    // SAFETY: by the contracts of this function and of the trait.
    unsafe { c.cast::<C::Core>().as_ref() }
}

/// # Safety
/// `c` is NULL or points to a value that nobody else uses as long as the result lives.
unsafe fn of_mut<'a, C: Face>(c: *mut C) -> Option<&'a mut C::Core> {
    // SAFETY: by the contracts of this function and of the trait.
    unsafe { c.cast::<C::Core>().as_mut() }
}

/// Fails the build unless every named field stands at the same offset in the C struct and in the core's, there perhaps
/// under another name, and both have the same size: what makes a pointer to one a pointer to the other.
macro_rules! assert_same_layout {
    ($c:ty, $core:ty, $($field:ident $(= $name:ident)?)*) => {
        const _: () = {
            use core::mem::offset_of;
            assert!(size_of::<$c>() == size_of::<$core>());
            assert!(align_of::<$c>() == align_of::<$core>());
            $(assert!(offset_of!($c, $field) == $crate::capi::core_offset!($core, $field $($name)?));)*
        };
        // SAFETY: see above.
        unsafe impl $crate::capi::Face for $c {
            type Core = $core;
        }
    };
}
macro_rules! core_offset {
    ($core:ty, $field:ident) => {
        offset_of!($core, $field)
    };
    ($core:ty, $field:ident $name:ident) => {
        offset_of!($core, $name)
    };
}
use assert_same_layout;
use core_offset;

/// Fails the build unless each row of a table has its constant of C.
macro_rules! assert_named {
    ($rows:expr; $($row:expr => $NAME:ident,)+) => {
        const _: () = {
            $(assert!($row as i16 == $NAME as i16);)+
            assert!($rows.len() == [$($NAME as i16),+].len(), "a row has no constant of C");
        };
    };
}
use assert_named;

/// What an evaluation returns.
#[inline(always)]
fn value<T>(ctx: Option<&T>, at: impl FnOnce(&T) -> Number) -> a_float {
    match ctx {
        Some(ctx) => at(ctx).into(),
        None => nan(),
    }
}

/// The value of a NULL context. Out of line, and hidden from constant propagation: one branch is left of the check in each
/// evaluation.
#[cold]
#[inline(never)]
fn nan() -> a_float {
    core::hint::black_box(a_float::NAN)
}
