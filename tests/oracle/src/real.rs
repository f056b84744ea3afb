//! What random tests need to know of the two real types.

use crate::common::GoldenReal;

/// `f32` or `f64`, with its bits, its range and its peculiar values.
pub trait OracleReal: GoldenReal + Send + 'static {
    /// How the type is called.
    const NAME: &'static str;
    /// Exponents of the smallest normal and of the largest power of two.
    const EXPONENTS: (i32, i32);
    /// Bits of the significand that are stored.
    const SIGNIFICAND_BITS: u32;
    /// The most rounds that the search without cruise can take: the exponents from the largest number down to epsilon.
    const MOST_ROUNDS: u32;
    /// Values at which arithmetic is peculiar.
    const SPECIAL: [Self; 24];
    /// The value with these low bits.
    fn from_low_bits(bits: u64) -> Self;
    /// The bits.
    fn low_bits(self) -> u64;
    /// `x` rounded to this type.
    fn round(x: f64) -> Self;
    /// The exact value.
    fn widen(self) -> f64;
    /// `self*factor + term`, rounded once.
    fn fused(self, factor: Self, term: Self) -> Self;
    /// The number `steps` representable numbers further away from zero (or nearer to it). Not beyond zero or the
    /// largest NaN.
    fn neighbour(self, steps: i8) -> Self;
}

macro_rules! oracle_real {
    ($real:ident, $bits:ident) => {
        impl OracleReal for $real {
            const NAME: &'static str = stringify!($real);
            const EXPONENTS: (i32, i32) = ($real::MIN_EXP - 1, $real::MAX_EXP - 1);
            const SIGNIFICAND_BITS: u32 = $real::MANTISSA_DIGITS - 1;
            const MOST_ROUNDS: u32 = $real::MAX_EXP as u32 + Self::SIGNIFICAND_BITS;
            const SPECIAL: [Self; 24] = {
                let denormal = $real::from_bits(1);
                [
                    0.0,
                    -0.0,
                    1.0,
                    -1.0,
                    0.5,
                    2.0,
                    -2.0,
                    6.0,
                    1.0 / 6.0,
                    $real::EPSILON,
                    1.0 + $real::EPSILON,
                    1.0 - $real::EPSILON / 2.0,
                    $real::MIN_POSITIVE,
                    -$real::MIN_POSITIVE,
                    denormal,
                    -denormal,
                    $real::from_bits($real::MIN_POSITIVE.to_bits() - 1),
                    $real::MAX,
                    -$real::MAX,
                    $real::MAX / 2.0,
                    $real::INFINITY,
                    $real::NEG_INFINITY,
                    $real::NAN,
                    -$real::NAN,
                ]
            };
            fn from_low_bits(bits: u64) -> Self {
                $real::from_bits(bits as $bits)
            }
            fn low_bits(self) -> u64 {
                self.to_bits().into()
            }
            fn round(x: f64) -> Self {
                x as $real
            }
            fn widen(self) -> f64 {
                self as f64
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
oracle_real!(f32, u32);
oracle_real!(f64, u64);
