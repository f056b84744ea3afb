//! What the shims of all polynomials have in common.
//!
//! The struct of liba 0.1.15 stores the coefficients of position and, up to the level of the build, the coefficients of its derivatives, one
//! array after the other. The struct of liba since 2025-03 stores the coefficients of position alone.

use crate::capi::{Number, a_float};
#[cfg(not(feature = "poly-compact"))]
use crate::liba::poly::target;
#[cfg(feature = "poly-compact")]
use crate::{capi::value, liba::Poly};
#[cfg(not(feature = "poly-compact"))]
use core::slice;

/// Where a struct stores the coefficients of a derivative: the place of the first and their number, packed into what one short
/// instruction can load.
#[cfg(not(feature = "poly-compact"))]
#[derive(Clone, Copy)]
pub struct Place(usize);

#[cfg(not(feature = "poly-compact"))]
impl Place {
    /// The derivative of this order of a polynomial with `n` coefficients, at most 8.
    pub const fn new(n: usize, order: usize) -> Self {
        // `order` arrays stand before it, each one shorter than the array before: n + (n-1) + ….
        let first = order * n - order * order.saturating_sub(1) / 2;
        Self(first * 8 + n - order - 1)
    }

    fn first(self) -> usize {
        self.0 / 8
    }

    fn count(self) -> usize {
        self.0 % 8 + 1
    }
}

/// The derivative of order `ORDER` of a polynomial with `N` coefficients, at `x`; NaN for a NULL context.
///
/// # Safety
/// `ctx` is NULL or points to a struct that stores the polynomial and, if structs have levels, its derivatives up to this one.
pub unsafe fn evaluate<const N: usize, const ORDER: usize>(ctx: *const Number, x: a_float) -> a_float {
    // SAFETY: by the contract of this function.
    #[cfg(feature = "poly-compact")]
    let y = value(unsafe { ctx.cast::<Poly<Number, N>>().as_ref() }, |poly| poly.derivative_at(ORDER, x.into()));
    // SAFETY: both functions have the same contract.
    #[cfg(not(feature = "poly-compact"))]
    let y = unsafe { evaluate_at(ctx, const { Place::new(N, ORDER) }, x) };
    y
}

/// # Safety
/// `ctx` is NULL or points to a struct that stores these coefficients.
#[cfg(not(feature = "poly-compact"))]
#[cfg_attr(target_os = "none", inline(never))] // one copy for all polynomials
unsafe fn evaluate_at(ctx: *const Number, place: Place, x: a_float) -> a_float {
    if ctx.is_null() {
        return a_float::NAN;
    }
    // SAFETY: not NULL, so the coefficients are there by the contract of this function.
    let c = unsafe { slice::from_raw_parts(ctx.add(place.first()), place.count()) };
    target::horner(c, x.into()).into()
}

/// Writes the coefficients of the next derivative from those at this place; nothing for a NULL context.
///
/// # Safety
/// `ctx` is NULL or points to a struct that stores these coefficients and, after them, the coefficients of the derivative.
#[cfg(not(feature = "poly-compact"))]
#[cfg_attr(target_os = "none", inline(never))] // one copy for all polynomials
#[allow(dead_code, reason = "the lowest level has no derivatives")]
pub unsafe fn differentiate(ctx: *mut Number, place: Place) {
    if ctx.is_null() {
        return;
    }
    let count = place.count();
    // SAFETY: not NULL, so both arrays are there by the contract of this function, and they do not overlap.
    let (c, derivative) = unsafe {
        let c = ctx.add(place.first());
        (slice::from_raw_parts(c, count), slice::from_raw_parts_mut(c.add(count), count - 1))
    };
    target::differentiate(c, derivative);
}

/// Writes the coefficients that derive from a polynomial; nothing for NULL.
///
/// # Safety
/// `ctx` is NULL or points to a struct that stores the polynomial, and `output` is NULL or has room for `M` reals.
#[cfg(feature = "poly-compact")]
pub unsafe fn copy_out<const N: usize, const M: usize>(
    ctx: *const Poly<Number, N>, output: *mut a_float, derive: impl Fn(&Poly<Number, N>) -> Poly<Number, M>,
) {
    // SAFETY: by the contract of this function.
    let derivative = unsafe { ctx.as_ref() }.map(derive);
    if let (Some(Poly { c }), false) = (derivative, output.is_null()) {
        // SAFETY: by the contract of this function. No reference into the caller's struct is left.
        unsafe { output.cast::<[Number; M]>().write(c) };
    }
}

/// What C does not see of a polynomial: the layout of its struct, its state at a time, and the plan of the coefficients that the struct
/// stores. A quantity is named with its number of coefficients; `$end` are the derivatives at both ends that liba's plan takes after the
/// velocities, and `$in_registers` says whether a plan still has its coefficients in registers and so derives the others at once.
macro_rules! polynomial {
    ($Struct:ident, $Poly:ident; $quantities:literal quantities: $p:ident: $N:literal,
     $($q:ident: $n:literal from $before:ident if $level:ident),+; ends: $($($end:ident)+),*; in registers: $in_registers:expr) => {
        #[cfg(feature = "poly-compact")]
        $crate::capi::assert_same_layout!($Struct, $Poly<Number>, c);
        #[cfg(not(feature = "poly-compact"))]
        const _: () = assert!(core::mem::offset_of!($Struct, $p) == 0);
        // SAFETY: the struct begins with the polynomial of position.
        #[cfg(not(feature = "poly-compact"))]
        unsafe impl $crate::capi::Face for $Struct {
            type Core = $Poly<Number>;
        }

        impl $Struct {
            /// The state at a time, from a copy of the coefficients that no output of a call can overlap. Derivatives that the struct
            /// does not store are computed from the position coefficients.
            pub(in crate::capi) fn state(&self) -> impl Fn(Number) -> [Number; $quantities] + use<> {
                #[cfg(feature = "poly-compact")]
                let $p = Poly { c: self.c };
                #[cfg(not(feature = "poly-compact"))]
                let $p = Poly { c: self.$p };
                $(
                    #[cfg(all(not(feature = "poly-compact"), $level))]
                    let $q = Poly { c: self.$q };
                    #[cfg(any(feature = "poly-compact", not($level)))]
                    let $q: Poly<_, $n> = $before.derivative();
                )+
                move |x| [$p.position(x), $($q.position(x)),+]
            }
        }

        /// The coefficients of position and, for `all`, the stored ones that derive from them.
        ///
        /// # Safety
        /// `ctx` is NULL or valid by the contract of this module.
        unsafe fn plan(
            ctx: *mut $Struct, all: bool, ts: a_float, p0: a_float, p1: a_float, v0: a_float, v1: a_float, $($($end: a_float),+),*
        ) {
            // SAFETY: by the contract of this function.
            let Some(position) = (unsafe { $crate::capi::of_mut(ctx) }) else { return };
            position.plan(ts.into(), $crate::capi::boundary(p0, p1, v0, v1), $([$($end.into()),+]),*);
            if all {
                $(
                    #[cfg(all(not(feature = "poly-compact"), $level))]
                    // SAFETY: not NULL, so valid by the contract of this function; `position` is not used any more.
                    unsafe { $crate::liba::poly::target::differentiate(&(*ctx).$before, &mut (*ctx).$q) };
                )+
            }
        }

        /// All coefficients that the struct stores.
        ///
        /// # Safety
        /// `ctx` is NULL or valid by the contract of this module.
        unsafe fn plan_all(
            ctx: *mut $Struct, ts: a_float, p0: a_float, p1: a_float, v0: a_float, v1: a_float, $($($end: a_float),+),*
        ) {
            let in_registers = $in_registers;
            // SAFETY: the contract of this function is the contract of each of these.
            unsafe {
                plan(ctx, in_registers, ts, p0, p1, v0, v1, $($($end),+),*);
                if !in_registers {
                    $(
                        #[cfg(all(not(feature = "poly-compact"), $level))]
                        poly::differentiate(ctx.cast(), const { poly::Place::new($N, $N - $n - 1) });
                    )+
                }
            }
        }
    };
}
pub(super) use polynomial;
