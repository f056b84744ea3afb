//! Binary64 for the Cortex-M cores whose unit computes in binary32 only.
//!
//! On such a core each operation on an `f64` is a call that takes and returns core registers. The compiler nevertheless carries an `f64` in the unit's
//! registers and moves it out and in around every call: a third more code. A [`Soft64`] stays in core registers, as a `double` of gcc does.
//!
//! The compiler does not know that these calls have no effect but their result, so it neither drops nor moves one. A formula
//! ends with the operand that is computed last, and a call returns its result where the next call takes its first argument.
//! Sums, differences and products therefore swap their operands here. The swap changes no bit.

use super::primitives::Primitives;
use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// The bits of an `f64`.
#[derive(Clone, Copy, Default)]
#[repr(transparent)]
pub struct Soft64(u64);

const SIGN: u64 = 1 << 63;

// From the run-time ABI for the Arm architecture: every toolchain has these functions, and the compiler itself calls them for an `f64`.
#[allow(unsafe_code)]
unsafe extern "C" {
    safe fn __aeabi_dadd(a: u64, b: u64) -> u64;
    /// `b - a`
    safe fn __aeabi_drsub(a: u64, b: u64) -> u64;
    safe fn __aeabi_dmul(a: u64, b: u64) -> u64;
    safe fn __aeabi_ddiv(a: u64, b: u64) -> u64;
    safe fn __aeabi_dcmpeq(a: u64, b: u64) -> i32;
    safe fn __aeabi_dcmplt(a: u64, b: u64) -> i32;
    safe fn __aeabi_dcmple(a: u64, b: u64) -> i32;
    safe fn __aeabi_dcmpgt(a: u64, b: u64) -> i32;
    safe fn __aeabi_dcmpge(a: u64, b: u64) -> i32;
}

impl From<f64> for Soft64 {
    fn from(x: f64) -> Self {
        Self(x.to_bits())
    }
}

impl From<Soft64> for f64 {
    fn from(x: Soft64) -> Self {
        f64::from_bits(x.0)
    }
}

impl From<u8> for Soft64 {
    fn from(n: u8) -> Self {
        f64::from(n).into()
    }
}

macro_rules! calls {
    ($($Operator:ident $method:ident: $a:ident $b:ident => $call:expr;)+) => {
        $(impl $Operator for Soft64 {
            type Output = Self;
            fn $method(self, Self($b): Self) -> Self {
                let Self($a) = self;
                Self($call)
            }
        })+
    };
}
calls! {
    Add add: a b => __aeabi_dadd(b, a);
    Sub sub: a b => __aeabi_drsub(b, a);
    Mul mul: a b => __aeabi_dmul(b, a);
    Div div: a b => __aeabi_ddiv(a, b);
}

impl Neg for Soft64 {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0 ^ SIGN)
    }
}

impl PartialEq for Soft64 {
    fn eq(&self, other: &Self) -> bool {
        __aeabi_dcmpeq(self.0, other.0) != 0
    }
}

impl PartialOrd for Soft64 {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        f64::from(*self).partial_cmp(&f64::from(*other))
    }
    fn lt(&self, other: &Self) -> bool {
        __aeabi_dcmplt(self.0, other.0) != 0
    }
    fn le(&self, other: &Self) -> bool {
        __aeabi_dcmple(self.0, other.0) != 0
    }
    fn gt(&self, other: &Self) -> bool {
        __aeabi_dcmpgt(self.0, other.0) != 0
    }
    fn ge(&self, other: &Self) -> bool {
        __aeabi_dcmpge(self.0, other.0) != 0
    }
}

/// The constants of an `f64`.
macro_rules! constants {
    ($($NAME:ident)+) => {
        $(const $NAME: Self = Self(<f64 as Primitives>::$NAME.to_bits());)+
    };
}

impl Primitives for Soft64 {
    constants! { ZERO SIXTEENTH SIXTH HALF ONE EPSILON DOUBT HUGE INFINITY NAN LN_2 PI }
    const HAS_UNIT: bool = false;

    fn abs(self) -> Self {
        Self(self.0 & !SIGN)
    }

    fn copysign(self, sign: Self) -> Self {
        Self(self.0 & !SIGN | sign.0 & SIGN)
    }

    // The C function returns its result in the unit's registers. Inlined, the compiler leaves the result there.
    #[inline(never)]
    fn plain_sqrt(self) -> Self {
        f64::from(self).plain_sqrt().into()
    }

    fn rough_cube_root(self) -> Self {
        f64::from(self).rough_cube_root().into()
    }

    fn split(self) -> (Self, i32) {
        let (significand, exponent) = f64::from(self).split();
        (significand.into(), exponent)
    }

    fn from_index(k: i32) -> Self {
        f64::from(k).into()
    }

    fn to_index(self) -> i32 {
        f64::from(self) as i32
    }
}
