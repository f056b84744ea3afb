//! The two real types a profile is computed in, and the few operations it needs.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// IEEE-754 binary32 (`f32`) or binary64 (`f64`).
///
/// Sealed: the bit-for-bit guarantee holds for these two types and no other.
pub trait Real:
    Copy
    + PartialOrd
    + From<u8>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + sealed::Sealed
{
    /// 1/2, exact.
    const HALF: Self;
    /// 1/16, exact.
    const SIXTEENTH: Self;
    /// 1/6, rounded once.
    const SIXTH: Self;
    /// Distance from 1 to the next larger number: `2^-23` or `2^-52`.
    const EPSILON: Self;
    /// `64 EPSILON`, exact.
    const DOUBT: Self;
    /// `EPSILON^-4`, exact.
    const HUGE: Self;
    /// Positive infinity.
    const INFINITY: Self;
    /// The processor takes a root or a division in one instruction, and has little room for code that avoids them.
    const CHEAP_ROOT: bool;

    /// Square root, correctly rounded; NaN below zero.
    fn sqrt(self) -> Self;

    /// The number of a sample, rounded once.
    fn from_index(k: i32) -> Self;

    /// Rounded towards zero, limited to what an index can be; 0 for a NaN.
    fn to_index(self) -> i32;

    /// The absolute value.
    fn abs(self) -> Self;

    /// The opposite, if it is wanted, by its sign bit.
    fn flipped_if(self, wanted: bool) -> Self;

    /// The opposites, if they are wanted: on hosts without a branch, which moves to and fro would mispredict.
    fn negated_if(wanted: bool, values: [Self; 3]) -> [Self; 3] {
        if !cfg!(target_os = "none") {
            return values.map(|value| value.flipped_if(wanted));
        }
        let [a, b, c] = values;
        if wanted {
            keep_branch();
            [-a, -b, -c]
        } else {
            values
        }
    }

    /// The absolute value, but `-0.0` stays `-0.0` and a NaN keeps its sign.
    fn magnitude(self) -> Self {
        if self < Self::from(0) {
            keep_branch();
            -self
        } else {
            self
        }
    }

    /// `self` limited to `±most`, which is not below zero; NaN becomes `-most`.
    fn limit(self, most: Self) -> Self {
        if self.abs() < most {
            keep_branch();
            self
        } else if self > -most {
            most
        } else {
            -most
        }
    }

    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool {
        self.abs() < Self::INFINITY
    }
}

/// Keeps the branch it stands in, where the compiler would compute both sides and select. A microcontroller has nothing
/// to predict, and a value that is not computed costs nothing.
#[inline(always)]
pub(crate) fn keep_branch() {
    #[cfg(target_os = "none")]
    core::sync::atomic::compiler_fence(core::sync::atomic::Ordering::SeqCst);
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
    #[cfg(soft_binary64)]
    impl Sealed for crate::soft::Soft64 {}
}

// Stable `core` has no square root yet. The C library's is correctly rounded, and where the processor has an instruction
// for it the compiler emits that, with a call for what is below zero. An unstable `core` spares this call.
#[cfg(not(atraj_unstable_core))]
#[allow(unsafe_code)]
unsafe extern "C" {
    safe fn sqrt(x: f64) -> f64;
    safe fn sqrtf(x: f32) -> f32;
}
#[cfg(atraj_unstable_core)]
use core::{f32::math::sqrt as sqrtf, f64::math::sqrt};

impl Real for f32 {
    const HALF: Self = 0.5;
    const SIXTEENTH: Self = 0.0625;
    const SIXTH: Self = 1.0 / 6.0;
    const EPSILON: Self = f32::EPSILON;
    const DOUBT: Self = 64.0 * f32::EPSILON;
    const HUGE: Self = 1.0 / (f32::EPSILON * f32::EPSILON * f32::EPSILON * f32::EPSILON);
    const INFINITY: Self = f32::INFINITY;
    const CHEAP_ROOT: bool = cfg!(all(target_arch = "arm", target_abi = "eabihf"));

    fn sqrt(self) -> Self {
        sqrtf(self)
    }

    fn abs(self) -> Self {
        f32::abs(self)
    }

    fn flipped_if(self, wanted: bool) -> Self {
        Self::from_bits(self.to_bits() ^ (u32::from(wanted) << 31))
    }

    fn from_index(k: i32) -> Self {
        k as Self
    }

    fn to_index(self) -> i32 {
        self as i32
    }
}

impl Real for f64 {
    const HALF: Self = 0.5;
    const SIXTEENTH: Self = 0.0625;
    const SIXTH: Self = 1.0 / 6.0;
    const EPSILON: Self = f64::EPSILON;
    const DOUBT: Self = 64.0 * f64::EPSILON;
    const HUGE: Self = 1.0 / (f64::EPSILON * f64::EPSILON * f64::EPSILON * f64::EPSILON);
    const INFINITY: Self = f64::INFINITY;
    const CHEAP_ROOT: bool = false;

    fn sqrt(self) -> Self {
        sqrt(self)
    }

    fn abs(self) -> Self {
        f64::abs(self)
    }

    fn flipped_if(self, wanted: bool) -> Self {
        Self::from_bits(self.to_bits() ^ (u64::from(wanted) << 63))
    }

    fn from_index(k: i32) -> Self {
        k as Self
    }

    fn to_index(self) -> i32 {
        self as i32
    }
}
