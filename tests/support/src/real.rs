//! The two real types, with what tests need of them: arithmetic, bits, range and peculiar values.

use std::fmt::{Debug, LowerExp};
use std::ops::{Add, Div, Mul, Neg, Sub};

pub trait Real:
    atraj::Real
    + Copy
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Default
    + Debug
    + LowerExp
    + Send
    + 'static
{
    const NAME: &'static str; // How the type is called. The names of golden files end with it.
    const EXPONENTS: (i32, i32); // exponents of the smallest normal and of the largest power of two
    const SIGNIFICAND_BITS: u32; // bits of the significand that are stored
    const MACHINE_EPSILON: Self; // distance from 1 to the next larger number
    /// The most rounds that the search without cruise can take. The step halves from the largest number down to epsilon.
    const MOST_ROUNDS: u32;
    const SPECIAL: [Self; 24]; // values at which arithmetic is peculiar

    fn of(number: f64) -> Self; // the number, rounded to this type
    fn widen(self) -> f64;
    fn from_low_bits(bits: u64) -> Self; // the value with these low bits
    fn low_bits(self) -> u64;
    fn square_root(self) -> Self; // the root, correctly rounded
    fn fused(self, factor: Self, term: Self) -> Self; // `self*factor + term`, rounded once
    /// The number `steps` representable numbers further away from zero, or nearer to it if negative. It stops at zero and at the largest NaN.
    fn neighbour(self, steps: i8) -> Self;

    fn is_nan(self) -> bool {
        self.partial_cmp(&self).is_none()
    }

    fn same(self, other: Self) -> bool {
        self.low_bits() == other.low_bits() || (self.is_nan() && other.is_nan())
    }

    fn parse(text: &str) -> Option<Self> {
        if text == "nan" {
            return Some(Self::of(f64::NAN));
        }
        let bits = u64::from_str_radix(text, 16).ok()?;
        (text.len() == 2 * size_of::<Self>()).then(|| Self::from_low_bits(bits))
    }

    fn show(self) -> String {
        let digits = 2 * size_of::<Self>();
        format!("{self:e} ({:0digits$x})", self.low_bits())
    }
}

macro_rules! real {
    ($real:ident, $bits:ident) => {
        impl Real for $real {
            const NAME: &'static str = stringify!($real);
            const EXPONENTS: (i32, i32) = ($real::MIN_EXP - 1, $real::MAX_EXP - 1);
            const SIGNIFICAND_BITS: u32 = $real::MANTISSA_DIGITS - 1;
            const MACHINE_EPSILON: Self = $real::EPSILON;
            const MOST_ROUNDS: u32 = $real::MAX_EXP as u32 + Self::SIGNIFICAND_BITS;
            #[rustfmt::skip]
            const SPECIAL: [Self; 24] = {
                let (denormal, below_normal) = ($real::from_bits(1), $real::from_bits($real::MIN_POSITIVE.to_bits() - 1));
                [
                    0.0, -0.0, 1.0, -1.0, 0.5, 2.0, -2.0, 6.0, 1.0 / 6.0,
                    $real::EPSILON, 1.0 + $real::EPSILON, 1.0 - $real::EPSILON / 2.0,
                    $real::MIN_POSITIVE, -$real::MIN_POSITIVE, denormal, -denormal, below_normal,
                    $real::MAX, -$real::MAX, $real::MAX / 2.0, $real::INFINITY, $real::NEG_INFINITY, $real::NAN, -$real::NAN,
                ]
            };
            fn of(number: f64) -> Self {
                number as $real
            }
            fn widen(self) -> f64 {
                self as f64
            }
            fn from_low_bits(bits: u64) -> Self {
                $real::from_bits(bits as $bits)
            }
            fn low_bits(self) -> u64 {
                self.to_bits().into()
            }
            fn square_root(self) -> Self {
                $real::sqrt(self)
            }
            fn fused(self, factor: Self, term: Self) -> Self {
                self.mul_add(factor, term)
            }
            fn neighbour(self, steps: i8) -> Self {
                let sign = self.to_bits() & (1 << ($bits::BITS - 1));
                let magnitude = self.to_bits() ^ sign;
                let magnitude = magnitude.saturating_add_signed(steps.into());
                $real::from_bits(sign | magnitude.min($bits::MAX >> 1))
            }
        }
    };
}
real!(f32, u32);
real!(f64, u64);

pub fn just_after(t: f64) -> f64 {
    let t = if t > 0.0 { t } else { 0.0 };
    f64::from_bits(t.to_bits() + 1)
}
