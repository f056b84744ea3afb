//! What each real type does in its own way.

use super::processor;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// The constants of a real type, and the operations that have a body for each type.
pub trait Primitives:
    Copy
    + Default
    + PartialOrd
    + From<u8>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    const ZERO: Self;
    /// 1/16, exact.
    const SIXTEENTH: Self;
    /// 1/6, rounded once.
    const SIXTH: Self;
    /// 1/2, exact.
    const HALF: Self;
    const ONE: Self;
    /// Distance from 1 to the next larger number: `2^-23` or `2^-52`.
    const EPSILON: Self;
    /// `64 EPSILON`, exact.
    const DOUBT: Self;
    /// `EPSILON^-4`, exact.
    const HUGE: Self;
    const INFINITY: Self;
    const NAN: Self;
    /// The natural logarithm of 2, rounded once.
    const LN_2: Self;
    /// Half of the circumference of a circle of radius 1, rounded once.
    const PI: Self;
    /// The processor divides, and takes a root, in one instruction.
    const HAS_UNIT: bool;

    fn abs(self) -> Self;

    fn copysign(self, sign: Self) -> Self;

    /// The square root as the processor or the C library takes it, correctly rounded; NaN below zero.
    fn plain_sqrt(self) -> Self;

    /// The cube root of `self`, which is not below 0, up to 3.5 %. A factor of 8 in `self` is a factor of 2 in the result, exactly.
    fn rough_cube_root(self) -> Self;

    /// `self`, which is normal and above 0, as `(m, e)`: `m` times the `e`-th power of two, with `1 <= m < 2`.
    fn split(self) -> (Self, i32);

    /// `k` rounded once.
    fn from_index(k: i32) -> Self;

    /// `self` rounded towards zero and limited to the range of an `i32`; 0 for a NaN.
    fn to_index(self) -> i32;
}

// Stable `core` has no square root yet. The root of the C library is correctly rounded, and the compiler knows the name: it emits
// an instruction where the processor has one. An unstable `core` brings a root of its own.
#[cfg(not(atraj_unstable_core))]
#[allow(unsafe_code)]
unsafe extern "C" {
    safe fn sqrt(x: f64) -> f64;
    safe fn sqrtf(x: f32) -> f32;
}
#[cfg(atraj_unstable_core)]
use core::{f32::math::sqrt as sqrtf, f64::math::sqrt};

/// A third of the exponent, exactly, and of the significand for want of anything better, up to 0.01 %. The exponent begins at the bit
/// `EXPONENT`. A Cortex-M0 would need a routine for a division of integers.
fn third<const EXPONENT: u32>(bits: u32) -> u32 {
    let exponent = ((bits >> EXPONENT) * 683) >> 11;
    let rest = bits - ((3 * exponent) << EXPONENT);
    (exponent << EXPONENT) + (((rest >> (EXPONENT - 14)) * 0x5555) >> (30 - EXPONENT))
}

/// What `f32` and `f64` have in the same way: constants, and operations of the processor.
macro_rules! same_way {
    ($R:ident, $sqrt:ident, $HAS_UNIT:ident) => {
        const ZERO: Self = 0.0;
        const SIXTEENTH: Self = 0.0625;
        const SIXTH: Self = 1.0 / 6.0;
        const HALF: Self = 0.5;
        const ONE: Self = 1.0;
        const EPSILON: Self = $R::EPSILON;
        const DOUBT: Self = 64.0 * $R::EPSILON;
        const HUGE: Self = 1.0 / ($R::EPSILON * $R::EPSILON * $R::EPSILON * $R::EPSILON);
        const INFINITY: Self = $R::INFINITY;
        const NAN: Self = $R::NAN;
        const LN_2: Self = core::$R::consts::LN_2;
        const PI: Self = core::$R::consts::PI;
        const HAS_UNIT: bool = processor::$HAS_UNIT;

        fn abs(self) -> Self {
            $R::abs(self)
        }

        fn copysign(self, sign: Self) -> Self {
            $R::copysign(self, sign)
        }

        fn plain_sqrt(self) -> Self {
            $sqrt(self)
        }

        fn from_index(k: i32) -> Self {
            k as Self
        }

        fn to_index(self) -> i32 {
            self as i32
        }
    };
}

impl Primitives for f32 {
    same_way!(f32, sqrtf, HAS_BINARY32_UNIT);

    fn rough_cube_root(self) -> Self {
        f32::from_bits(third::<23>(self.to_bits()) + 0x2a51_4067)
    }

    fn split(self) -> (Self, i32) {
        let bits = self.to_bits();
        let significand = Self::from_bits(bits & 0x007f_ffff | 0x3f80_0000);
        (significand, (bits >> 23) as i32 - 127)
    }
}

impl Primitives for f64 {
    same_way!(f64, sqrt, HAS_BINARY64_UNIT);

    fn rough_cube_root(self) -> Self {
        let upper_half = third::<20>((self.to_bits() >> 32) as u32) + 0x2a9f_7893;
        f64::from_bits(u64::from(upper_half) << 32)
    }

    fn split(self) -> (Self, i32) {
        let bits = self.to_bits();
        let significand = Self::from_bits(bits & 0x000f_ffff_ffff_ffff | 0x3ff0_0000_0000_0000);
        (significand, (bits >> 52) as i32 - 1023)
    }
}
