//! The two real types of a profile and the operations that a profile needs.

mod primitives;
pub(crate) mod processor;
#[cfg(unit_lacks_binary64)]
mod soft;
/// The bodies that differ between targets: two files with one face.
#[cfg_attr(target_os = "none", path = "bare_metal.rs")]
#[cfg_attr(not(target_os = "none"), path = "host.rs")]
pub(crate) mod target;

/// The type that carries a C `double` through the profiles.
#[cfg(all(feature = "capi", not(feature = "float"), not(unit_lacks_binary64)))]
pub(crate) type Double = f64;
#[cfg(all(feature = "capi", not(feature = "float"), unit_lacks_binary64))]
pub(crate) use soft::Soft64 as Double;

use primitives::Primitives;
use target::keep_branch;

/// IEEE-754 binary32 (`f32`) or binary64 (`f64`).
///
/// The trait is sealed: the bit-for-bit guarantee holds for these two types and no other.
pub trait Real: Operations {}

impl Real for f32 {}
impl Real for f64 {}
#[cfg(unit_lacks_binary64)]
impl Real for soft::Soft64 {}

/// What the profiles compute with: the same formulas for every real type.
pub trait Operations: Primitives {
    /// The square root, correctly rounded; NaN below zero.
    fn sqrt(self) -> Self {
        target::sqrt(self)
    }

    /// A number not below the cube root of `self`, which is 0 or normal, above 0 and at most a quarter of the largest number, and at most 0.01 %
    /// above it. A factor of 8 in `self` is a factor of 2 in the result, exactly.
    fn cube_root_above(self) -> Self {
        if self > Self::ZERO {
            // Halley's step leaves two thirds of the cube of the error: 0.003 %. The factor is above 1 by 0.006 %.
            let root = self.rough_cube_root();
            let cube = root * root * root;
            let factor = Self::ONE + Self::HALF * Self::HALF * Self::SIXTEENTH * Self::SIXTEENTH * Self::SIXTEENTH;
            factor * root * ((cube + self + self) / (cube + cube + self))
        } else {
            self
        }
    }

    /// The cube root of such a number above 0, up to an ulp. Each step of Newton's method doubles the digits, and the first four are right.
    fn cube_root(self) -> Self {
        let mut root = self.cube_root_above();
        for _ in 0..2 {
            let square = root * root;
            root = root - (root * square - self) / (square + square + square);
        }
        root
    }

    /// The natural logarithm of a normal number above 0. Its error is below 1e-8 and the rounding of a dozen operations.
    fn ln(self) -> Self {
        let (mut m, mut octaves) = self.split();
        if m > Self::ONE + Self::HALF {
            m = Self::HALF * m;
            octaves += 1;
        }
        // m = (1 + s)/(1 - s) lies between 3/4 and 3/2, so |s| <= 1/5. The first term that is left out is 2/11 s^11.
        let s = (m - Self::ONE) / (m + Self::ONE);
        let part = |n| Self::ONE / Self::from(n);
        let (third, fifth, seventh, ninth) = (part(3), part(5), part(7), part(9));
        let square = s * s;
        let series = square * (third + square * (fifth + square * (seventh + square * ninth)));
        Self::from_index(octaves) * Self::LN_2 + (s + s) * (Self::ONE + series)
    }

    /// `e` to the power of `-self`, which is not negative. Its error is below the rounding of two dozen operations, and of `self`.
    fn exp_of_negative(self) -> Self {
        // self = n ln 2 + 2 y with 0 <= y < 0.35, and e^(-2y) = (1 - tanh y)/(1 + tanh y).
        let mut octaves = (self / Self::LN_2).to_index();
        let y = Self::HALF * (self - Self::from_index(octaves) * Self::LN_2).at_most(Self::ONE);
        // Lambert's continued fraction of the tangent. The first term that is left out changes less than 1e-18.
        let square = y * y;
        let fraction = [15, 13, 11, 9, 7, 5, 3, 1].map(Self::from).into_iter();
        let fraction = fraction.reduce(|rest, odd| odd + square / rest);
        let tanh = y / fraction.unwrap_or(Self::ONE);
        let mut power = (Self::ONE - tanh) / (Self::ONE + tanh);
        let mut half = Self::HALF;
        while octaves > 0 {
            if octaves % 2 == 1 {
                power = power * half;
            }
            half = half * half;
            octaves /= 2;
        }
        power
    }

    /// The absolute value, but `-0.0` stays `-0.0` and a NaN keeps its sign.
    fn magnitude(self) -> Self {
        self.negate_if(self < Self::ZERO)
    }

    /// `-self` if `negative` holds, else `self`.
    fn negate_if(self, negative: bool) -> Self {
        if negative {
            keep_branch();
            -self
        } else {
            self
        }
    }

    /// `self` limited to `-most … most`; `most` is not below zero. NaN becomes `-most`, and so does a zero if `most` is zero.
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

    /// `self` limited to `-most … most`; `most` is not below zero. NaN stays NaN, and a zero keeps its sign.
    fn limit_numbers(self, most: Self) -> Self {
        if self < -most {
            -most
        } else if self > most {
            most
        } else {
            self
        }
    }

    /// `self`, but not below `least`; `least` for a NaN.
    fn at_least(self, least: Self) -> Self {
        if self > least { self } else { least }
    }

    /// `self`, but not above `most`; `most` for a NaN.
    fn at_most(self, most: Self) -> Self {
        if self < most { self } else { most }
    }

    fn is_finite(self) -> bool {
        self.abs() < Self::INFINITY
    }
}

impl<R: Primitives> Operations for R {}

#[cfg(test)]
mod tests {
    macro_rules! tests_of {
        ($R:ident, $Bits:ident) => {
            mod $R {
                use crate::real::Operations;

                #[test]
                fn roots_are_the_standard_librarys() {
                    let special = [0.0, 1.0, $R::MIN_POSITIVE / 4.0, $R::INFINITY, $R::NAN];
                    let special = special.into_iter().flat_map(|x| [x, -x]);
                    // A step that shares no factor with the range visits every kind of exponent and significand.
                    let spread = (0..200_000).map(|k| $R::from_bits((k as $Bits).wrapping_mul($Bits::MAX / 61 * 17)));
                    for x in special.chain(spread) {
                        let (root, expected) = (Operations::sqrt(x), x.sqrt());
                        let same = root.to_bits() == expected.to_bits() || root.is_nan() && expected.is_nan();
                        assert!(same, "sqrt({x:e}) = {root:e}, not {expected:e}");
                    }
                }

                #[test]
                fn logarithms_are_near() {
                    for octave in -60..60 {
                        for k in 0..1000 {
                            let x = (1.0 + k as $R / 1000.0) * (2.0 as $R).powi(octave);
                            let error = f64::from(Operations::ln(x)) - f64::from(x).ln();
                            let rounding = 8.0 * f64::from($R::EPSILON) * f64::from(x).ln().abs();
                            assert!(error.abs() < 1e-8 + rounding, "ln({x:e}): {error:e}");
                        }
                    }
                }

                #[test]
                fn powers_are_near() {
                    for k in 0..100_000 {
                        let x = k as $R / 5000.0;
                        let exact = (-f64::from(x)).exp();
                        let error = (f64::from(Operations::exp_of_negative(x)) - exact).abs();
                        let rounding = (12.0 + f64::from(x)) * f64::from($R::EPSILON);
                        assert!(error <= rounding * exact, "exp(-{x:e}): {error:e}");
                    }
                    assert_eq!(Operations::exp_of_negative($R::MAX), 0.0);
                }

                #[test]
                fn cube_roots_are_just_above() {
                    let excess = |x: $R| Operations::cube_root_above(x) / x.cbrt() - 1.0;
                    // Three octaves, in each of which the rough root errs differently.
                    let octaves = (0..100_000).map(|k| 1.0 + 7.0 * k as $R / 100_000.0);
                    for x in octaves.clone().chain([$R::MIN_POSITIVE, $R::MAX / 12.0]) {
                        assert!((0.0..1e-4).contains(&excess(x)), "{x:e}: {}", excess(x));
                    }
                    for x in octaves {
                        for (octaves, factor) in [(8.0, 2.0), (0.125, 0.5)] {
                            let above = Operations::cube_root_above(x) * factor;
                            assert!(Operations::cube_root_above(x * octaves) == above, "{x}");
                        }
                    }
                }
            }
        };
    }
    tests_of!(f32, u32);
    tests_of!(f64, u64);
}
