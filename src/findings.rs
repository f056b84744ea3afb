//! What a planner answers: what it found, why there is no plan, and what a move reaches.

use crate::real::Real;
use crate::state::{Boundary, State};
use core::ffi::CStr;
use core::fmt;

/// A set of at most eight findings. Each has a bit, a name and a sentence.
macro_rules! set {
    ($(#[$about:meta])* $Set:ident { $($(#[$doc:meta])* $NAME:ident = $bit:literal: $sentence:literal,)+ }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Default, PartialEq, Eq)]
        pub struct $Set(u8);

        impl $Set {
            $($(#[$doc])* pub const $NAME: Self = Self($bit);)+

            /// Every member with its name and its sentence. The sentence ends with a NUL, for C.
            pub(crate) const MEMBERS: &'static [(Self, &'static str, &'static core::ffi::CStr)] =
                &[$((Self::$NAME, stringify!($NAME), $sentence)),+];

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
        /// The jerk is above its limit.
        EXCEEDS_JERK = 1: c"the jerk is above its limit",
        /// The acceleration is above its limit.
        EXCEEDS_ACCELERATION = 2: c"the acceleration is above its limit",
        /// The velocity is above its limit.
        EXCEEDS_VELOCITY = 4: c"the velocity is above its limit",
        /// Position or velocity is not continuous, or not where the struct says.
        JUMPS = 8: c"position or velocity is not continuous, or not where the struct says",
        /// The move leaves the positions between its ends by more than rounding. A rounding is `ε (|p0| + |p1| + v t)`, with the highest speed
        /// `v`. A plan between any states tolerates 128 of them where it turns, the check of a profile 64.
        OVERSHOOTS = 16: c"the move leaves the positions between its ends",
        /// The move starts outside its limits, or will unavoidably exceed them.
        STARTS_OUTSIDE = 32: c"the move starts outside its limits, or will unavoidably exceed them",
        /// The axis will unavoidably exceed the limits after the move: the acceleration at the end does not vanish at once.
        ENDS_LEAVING = 64: c"the axis will unavoidably exceed its limits after the move",
        /// The path ends before its clock has the rate.
        RATE_NOT_REACHED = 128: c"the path ends before its clock has the rate",
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

/// A table of errors. Each has the code of the C functions and a sentence, which ends with a NUL for C.
macro_rules! errors {
    ($(#[$about:meta])* $Error:ident { $($(#[$doc:meta])* $Name:ident = $code:literal: $sentence:literal,)+ }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        #[repr(i8)]
        pub enum $Error {
            $($(#[$doc])* $Name = $code,)+
        }

        impl $Error {
            /// Every error with its sentence.
            pub(crate) const ALL: &'static [(Self, &'static CStr)] = &[$((Self::$Name, $sentence)),+];
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
    /// assert_eq!(Error::Duration.to_string(), "the duration or the cycle is negative, infinite or not a number, or a polynomial or a period takes no time");
    /// ```
    Error {
        /// There is no axis, or the slices have different lengths.
        Axes = -1: c"there is no axis, a pointer is NULL, or the lists have different lengths",
        /// A number is infinite or not a number, or the motion is beyond the range of the real type.
        NotFinite = -2: c"a number is infinite or not a number, or the motion is beyond the range of the real type",
        /// A limit is 0 or has the wrong sign, or a lowest position is not below the highest. Or neither a jerk nor both accelerations are
        /// finite.
        Limits = -3: c"a limit is 0 or has the wrong sign, or limits are in the wrong order, or neither a jerk nor both accelerations are finite",
        /// The target is outside the limits, or the axis must have left them before.
        Target = -4: c"the target is outside the limits, or the axis must have left them before",
        /// The duration or the cycle is negative, infinite or not a number, or a polynomial or a period takes no time. Or a horizon is not
        /// above 0.
        Duration = -5: c"the duration or the cycle is negative, infinite or not a number, or a polynomial or a period takes no time",
        /// The states of several axes do not lie on the straight line from their start to their end.
        Line = -6: c"the states do not lie on the straight line from their start to their end",
        /// The axis leaves the positions between which it has to stay.
        Position = -7: c"the axis leaves the positions between which it has to stay",
        /// The tick at which a plan was to take over has begun. Or the plan was for no later tick, or for one that is too far ahead. Or a
        /// change of a clock was to begin before the last one.
        Late = -8: c"the tick at which the plan was to take over has begun, or is too far ahead",
        /// liba finds no such move within the limits, or the move takes no time.
        Unreachable = -9: c"liba finds no such move within the limits, or the move takes no time",
        /// The axis must stand for this.
        Moving = -10: c"the axis must stand for this",
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
    /// The extremes of one state.
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
    if x < *lowest {
        *lowest = x;
    }
    if x > *highest {
        *highest = x;
    }
}
