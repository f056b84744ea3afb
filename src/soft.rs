//! Binary64 for the Cortex-M cores whose floating-point unit has binary32 only.
//!
//! There each operation on an `f64` is a call that takes and returns core registers. The compiler carries an `f64` in the
//! unit's registers all the same and moves it out and in for every call: a third more code. A [`Soft64`] stays in core
//! registers, as what gcc makes of a `double` does.
//!
//! The compiler does not know that these calls have no effect but their result, so it neither leaves out nor moves any.
//! Code for every [`Real`] is therefore written as it should run: nothing is computed twice or before it is needed, a
//! field is read where it is used, and of the operands of a sum or a product the one computed last stands first, as it
//! already is where the call wants its first argument. No order of two operands changes a bit.

use crate::Real;
use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// The bits of an `f64`.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct Soft64(u64);

const SIGN: u64 = 1 << 63;

// From the run-time ABI for the Arm architecture: what the compiler itself calls for an `f64`, in every toolchain.
#[allow(unsafe_code)]
unsafe extern "C" {
    safe fn __aeabi_dadd(a: u64, b: u64) -> u64;
    safe fn __aeabi_dsub(a: u64, b: u64) -> u64;
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

impl Add for Soft64 {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(__aeabi_dadd(self.0, other.0))
    }
}

impl Sub for Soft64 {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(__aeabi_dsub(self.0, other.0))
    }
}

impl Mul for Soft64 {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(__aeabi_dmul(self.0, other.0))
    }
}

impl Div for Soft64 {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self(__aeabi_ddiv(self.0, other.0))
    }
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

impl Real for Soft64 {
    const HALF: Self = Self(0.5f64.to_bits());
    const SIXTEENTH: Self = Self(0.0625f64.to_bits());
    const SIXTH: Self = Self((1.0f64 / 6.0).to_bits());
    const EPSILON: Self = Self(f64::EPSILON.to_bits());
    const DOUBT: Self = Self(<f64 as Real>::DOUBT.to_bits());
    const HUGE: Self = Self(<f64 as Real>::HUGE.to_bits());
    const INFINITY: Self = Self(f64::INFINITY.to_bits());
    const CHEAP_ROOT: bool = false;

    // Apart, as the C function returns its result in the unit's registers, and the compiler would leave it there.
    #[inline(never)]
    fn plain_sqrt(self) -> Self {
        f64::from(self).plain_sqrt().into()
    }

    fn abs(self) -> Self {
        Self(self.0 & !SIGN)
    }

    fn copysign(self, sign: Self) -> Self {
        Self(self.0 & !SIGN | sign.0 & SIGN)
    }

    fn from_index(k: i32) -> Self {
        f64::from(k).into()
    }

    fn to_index(self) -> i32 {
        f64::from(self) as i32
    }
}
