//! What a planner answers: what it found, why there is no plan, and what a move reaches.

use crate::real::Real;
use crate::state::{Boundary, State};
use core::{ffi::CStr, fmt};

/// A set of at most eight findings. Each has a bit, a name and a sentence, which is its documentation, perhaps with more.
macro_rules! set {
    ($(#[$about:meta])* $Set:ident { $($(#[$more:meta])* $NAME:ident = $bit:literal: $sentence:literal,)+ }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Default, PartialEq, Eq)]
        pub struct $Set(u8);

        impl $Set {
            $(#[doc = concat!($sentence, "\n")] $(#[$more])* pub const $NAME: Self = Self($bit);)+

            /// Every member with its name and its sentence. The sentence ends with a NUL, for C.
            pub(crate) const MEMBERS: &'static [(Self, &'static str, &'static core::ffi::CStr)] =
                &[$((Self::$NAME, stringify!($NAME), $crate::findings::for_c(concat!($sentence, "\0")))),+];

            /// The members whose bits are in `bits`; the other bits are ignored.
            pub const fn from_bits(bits: u8) -> Self {
                Self(bits & ($($bit)|+))
            }

            /// The set as the sum of its bits; 0 for the empty set.
            pub const fn bits(self) -> u8 {
                self.0
            }

            /// Whether the set has every member of `others`.
            pub const fn contains(self, others: Self) -> bool {
                self.0 & others.0 == others.0
            }

            /// Whether the set has no member.
            pub const fn is_empty(self) -> bool {
                self.0 == 0
            }

            fn members(self) -> impl Iterator<Item = &'static (Self, &'static str, &'static core::ffi::CStr)> {
                Self::MEMBERS.iter().filter(move |(member, ..)| self.contains(*member))
            }
        }

        impl core::ops::BitOr for $Set {
            type Output = Self;
            fn bitor(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }
        }

        impl core::ops::BitOrAssign for $Set {
            fn bitor_assign(&mut self, other: Self) {
                *self = *self | other;
            }
        }

        /// `Findings(OVERSHOOTS | STARTS_OUTSIDE)`
        impl core::fmt::Debug for $Set {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.write_str(concat!(stringify!($Set), "("))?;
                $crate::findings::join(f, " | ", self.members().map(|&(_, name, _)| name))?;
                f.write_str(")")
            }
        }

        /// A sentence for each member, with "; " between two.
        impl core::fmt::Display for $Set {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                let nothing = self.is_empty().then_some($crate::findings::NOTHING);
                let sentences = self.members().map(|&(_, _, sentence)| sentence).chain(nothing);
                $crate::findings::join(f, "; ", sentences.map($crate::findings::text))
            }
        }
    };
}
pub(crate) use set;

/// A sentence as C wants it. It ends with a NUL. Constants alone call it, so a NUL within is an error of the compiler.
pub(crate) const fn for_c(sentence: &'static str) -> &'static CStr {
    match CStr::from_bytes_with_nul(sentence.as_bytes()) {
        Ok(sentence) => sentence,
        Err(_) => panic!("a NUL within"),
    }
}

set! {
    /// What a check found, as a set.
    ///
    /// ```
    /// use atraj::{Boundary, Findings, Trap};
    /// let trap = Trap::fastest(5.0, 4.0, -2.0, Boundary { p0: 0.0, p1: 1.0, v0: 4.0, v1: 0.0 })?;
    /// let found = trap.check(3.0, 4.0, -2.0)?;
    /// assert!(found.contains(Findings::OVERSHOOTS));
    /// assert_eq!(format!("{found:?}"), "Findings(EXCEEDS_VELOCITY | OVERSHOOTS)");
    /// assert_eq!(found.to_string(), "the velocity is above its limit; the move leaves the positions between its ends");
    /// # Ok::<(), atraj::Error>(())
    /// ```
    Findings {
        EXCEEDS_JERK = 1: "the jerk is above its limit",
        EXCEEDS_ACCELERATION = 2: "the acceleration is above its limit",
        EXCEEDS_VELOCITY = 4: "the velocity is above its limit",
        JUMPS = 8: "position or velocity is not continuous, or not where the struct says",
        /// By more than rounding: an ulp is that of `|p0| + |p1| + v t`, with the highest speed `v`. A plan between any states tolerates 128 of them
        /// where it turns, and counts no more than four times its way for `v t`; the check of a profile 64.
        OVERSHOOTS = 16: "the move leaves the positions between its ends",
        STARTS_OUTSIDE = 32: "the move starts outside its limits, or will unavoidably exceed them",
        /// The acceleration at the end does not vanish at once.
        ENDS_LEAVING = 64: "the axis will unavoidably exceed its limits after the move",
        RATE_NOT_REACHED = 128: "the path ends before its clock has the rate",
    }
}

impl Findings {
    pub(crate) fn when(self, found: bool) -> Self {
        if found { self } else { Self::default() }
    }
}

/// The sentence for the empty set.
pub(crate) const NOTHING: &CStr = c"nothing is wrong";

/// A sentence without its NUL.
pub(crate) fn text(sentence: &CStr) -> &str {
    sentence.to_str().unwrap_or_default()
}

/// Writes the words with the separator between two.
pub(crate) fn join<'a>(
    f: &mut fmt::Formatter<'_>, separator: &str, words: impl Iterator<Item = &'a str>,
) -> fmt::Result {
    for (k, word) in words.enumerate() {
        f.write_str(if k > 0 { separator } else { "" })?;
        f.write_str(word)?;
    }
    Ok(())
}

/// A table of errors. Each has the code of the C functions and a sentence, which is its documentation, perhaps with more.
macro_rules! errors {
    ($(#[$about:meta])* $Error:ident { $($(#[$more:meta])* $Name:ident = $code:literal: $sentence:literal,)+ }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        #[repr(i8)]
        pub enum $Error {
            $(#[doc = concat!($sentence, "\n")] $(#[$more])* $Name = $code,)+
        }

        impl $Error {
            /// Every error with its sentence.
            pub(crate) const ALL: &'static [(Self, &'static CStr)] = &[$((Self::$Name, for_c(concat!($sentence, "\0")))),+];
        }
    };
}

errors! {
    /// Why there is no plan. The numbers are the codes of the C functions.
    ///
    /// ```
    /// use atraj::online::{Error, Limits, Move, State};
    /// let why = Move::default().plan(&Limits::symmetric(0.0, 10.0, 5.0), State::at(0.0), State::at(1.0));
    /// assert_eq!(why, Err(Error::Limits));
    /// assert_eq!(Error::Duration.to_string(), "a duration, cycle, period, horizon or frequency is out of range, or a duration is too short for the motion");
    /// ```
    Error {
        Axes = -1: "there is no axis, a pointer is NULL, or the lists have different lengths",
        NotFinite = -2: "a number is infinite or not a number, or the motion is beyond the range of the real type",
        /// Or a lowest position is not below the highest.
        Limits = -3: "a limit is 0 or has the wrong sign or order, neither a jerk nor both accelerations are finite, or a step or damping is out of range",
        Target = -4: "the target is outside the limits, or the axis must have left them before",
        Duration = -5: "a duration, cycle, period, horizon or frequency is out of range, or a duration is too short for the motion",
        Line = -6: "the states do not lie on the straight line from their start to their end",
        Position = -7: "the axis leaves the positions between which it has to stay",
        /// Or the plan was for no later tick, or a change of a clock was to begin before the last one.
        Late = -8: "the tick at which the plan was to take over has begun, or is too far ahead",
        Unreachable = -9: "liba finds no such move within the limits, or the move takes no time",
        Moving = -10: "this needs an axis at rest",
    }
}

impl Error {
    /// Why there is no plan within these limits: what is wrong with the arguments, else `otherwise`.
    pub(crate) fn of_plan<R: Real>(limits: [R; 3], boundary: Boundary<R>, otherwise: Self) -> Self {
        if !boundary.is_numbers() || limits.iter().any(|x| x.partial_cmp(x).is_none()) {
            Self::NotFinite
        } else if limits.contains(&R::ZERO) {
            Self::Limits
        } else {
            otherwise
        }
    }

    /// This error, unless a condition holds.
    pub(crate) fn unless(self, holds: bool) -> Result<(), Self> {
        if holds { Ok(()) } else { Err(self) }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let row = Self::ALL.iter().find(|row| row.0 == *self);
        f.write_str(row.map_or("", |row| text(row.1)))
    }
}

impl core::error::Error for Error {}

/// The lowest and the highest position, velocity and acceleration of a move, each at its own time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes<R> {
    /// The lowest of each.
    pub lowest: State<R>,
    /// The highest of each.
    pub highest: State<R>,
}

impl<R: Real> Extremes<R> {
    pub(crate) fn of(state: State<R>) -> Self {
        Self { lowest: state, highest: state }
    }

    pub(crate) fn include_position(&mut self, p: R) {
        include(&mut self.lowest.position, &mut self.highest.position, p);
    }

    pub(crate) fn include_velocity(&mut self, v: R) {
        include(&mut self.lowest.velocity, &mut self.highest.velocity, v);
    }

    pub(crate) fn include_acceleration(&mut self, a: R) {
        include(&mut self.lowest.acceleration, &mut self.highest.acceleration, a);
    }

    /// The highest magnitude of the velocity.
    pub(crate) fn speed(&self) -> R {
        self.lowest.velocity.abs().at_least(self.highest.velocity.abs())
    }

    /// The highest magnitude of the acceleration.
    pub(crate) fn acceleration(&self) -> R {
        self.lowest.acceleration.abs().at_least(self.highest.acceleration.abs())
    }

    /// Whether the positions leave the range from `p0` to `p1` by more than `rounding`.
    pub(crate) fn overshoots(&self, p0: R, p1: R, rounding: R) -> bool {
        let (near, far) = if p0 < p1 { (p0, p1) } else { (p1, p0) };
        self.lowest.position < near - rounding || self.highest.position > far + rounding
    }
}

fn include<R: Real>(lowest: &mut R, highest: &mut R, x: R) {
    *lowest = x.at_most(*lowest);
    *highest = x.at_least(*highest);
}
