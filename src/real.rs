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

    /// The processor's or the C library's square root, correctly rounded; NaN below zero.
    fn plain_sqrt(self) -> Self;

    /// The number of a sample, rounded once.
    fn from_index(k: i32) -> Self;

    /// Rounded towards zero, limited to what an index can be; 0 for a NaN.
    fn to_index(self) -> i32;

    /// The absolute value.
    fn abs(self) -> Self;

    /// This absolute value with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;

    /// Square root, correctly rounded; NaN below zero.
    fn sqrt(self) -> Self {
        if cfg!(target_os = "none") {
            return self.plain_sqrt();
        }
        // Of a root that cannot fail LLVM leaves the instruction alone; any other is also a call, around which values have to
        // be kept in memory.
        let root = self.abs().plain_sqrt();
        let zero = Self::from(0);
        if self > zero {
            root
        } else {
            keep_branch();
            let nan = zero * Self::INFINITY;
            if self < zero { nan } else { self }
        }
    }

    /// A displacement and two velocities in the axis in which the displacement is not below zero.
    fn forward(p: Self, v0: Self, v1: Self) -> [Self; 3] {
        if !cfg!(target_os = "none") {
            let side = Self::side(p);
            [p * side, v0 * side, v1 * side]
        } else if p < Self::from(0) {
            keep_branch();
            [-p, -v0, -v1]
        } else {
            [p, v0, v1]
        }
    }

    /// -1 for a displacement below zero, which -0.0 and NaN are not, else 1; without a branch, as moves to and fro would
    /// mispredict it.
    fn side(p: Self) -> Self {
        let zero = Self::from(0);
        Self::from(1).copysign(if p < zero { p } else { zero })
    }

    /// The absolute value, but `-0.0` stays `-0.0` and a NaN keeps its sign.
    fn magnitude(self) -> Self {
        if self < Self::from(0) {
            keep_branch_on_bare_metal();
            -self
        } else {
            self
        }
    }

    /// `self` limited to `±most`, which is not below zero; NaN becomes `-most`.
    fn limit(self, most: Self) -> Self {
        if self.abs() < most {
            keep_branch_on_bare_metal();
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

/// Keeps the branch it stands in, where the compiler would compute both sides and select.
#[inline(always)]
fn keep_branch() {
    core::sync::atomic::compiler_fence(core::sync::atomic::Ordering::SeqCst);
}

/// Likewise on a microcontroller, which has nothing to predict: a value that is not computed costs nothing.
#[inline(always)]
pub(crate) fn keep_branch_on_bare_metal() {
    if cfg!(target_os = "none") {
        keep_branch();
    }
}

/// Gives the branch in which `this` holds a way out of its own on a host: the compiler would share what ends it with other
/// branches, and jump there.
#[inline(always)]
pub(crate) fn leave_apart_on_hosts(this: bool) {
    if this && !cfg!(target_os = "none") {
        keep_branch();
    }
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

    fn plain_sqrt(self) -> Self {
        sqrtf(self)
    }

    fn abs(self) -> Self {
        f32::abs(self)
    }

    fn copysign(self, sign: Self) -> Self {
        f32::copysign(self, sign)
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

    fn plain_sqrt(self) -> Self {
        sqrt(self)
    }

    fn abs(self) -> Self {
        f64::abs(self)
    }

    fn copysign(self, sign: Self) -> Self {
        f64::copysign(self, sign)
    }

    fn from_index(k: i32) -> Self {
        k as Self
    }

    fn to_index(self) -> i32 {
        self as i32
    }
}
