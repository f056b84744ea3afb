//! Pieces of the border. On one piece all motions have the same shape, and the displacement is a polynomial in one quantity: how much more
//! the acceleration falls than in the first motion of the piece.
//!
//! A piece counts displacements from its first motion. `docs/planner.md` has the formulas and the letters: `u`, `y`, `r`, `s`, `k`, `c`, `x`.

mod easing;
mod free;
mod held;

use super::{border::Border, profile::Profile};
use crate::real::Real;
use crate::roots::root_between;
pub(super) use easing::Easing;
use free::Free;
use held::Held;

pub(super) enum Piece<'a, R> {
    /// No acceleration holds.
    Free(Free<'a, R>),
    /// The highest acceleration holds.
    Held(Held<'a, R>),
}

/// A value that both kinds of pieces have, each by its own formula.
macro_rules! in_piece {
    ($piece:expr, $own:ident => $value:expr) => {
        match $piece {
            Self::Free($own) => $value,
            Self::Held($own) => $value,
        }
    };
}

impl<'a, R: Real> Piece<'a, R> {
    /// The piece that begins with this motion. `holds`: the highest acceleration holds in it, else none.
    pub fn of(border: &Border<R>, motion: &'a mut Profile<R>, holds: bool) -> Self {
        if holds { Self::Held(Held::new(border, motion)) } else { Self::Free(Free::new(border, motion)) }
    }

    /// The displacement where the acceleration falls by `x` more, and its derivative with respect to `x`.
    #[inline(never)] // for its size: it is asked in several places
    pub fn displacement(&self, x: R) -> (R, R) {
        in_piece!(self, piece => piece.displacement(x))
    }

    /// How the easing ends, and where. `a0` is the acceleration at the start of the motion.
    pub fn end_of_easing(&self, a0: R) -> (R, Easing) {
        match self {
            Self::Free(free) => free.end_of_easing(a0),
            Self::Held(held) => held.end_of_easing(),
        }
    }

    /// Goes on to the motion whose displacement is `lacks` for the first time; else to the one at `end`, and returns what it lacks.
    #[inline(never)] // for its size: it is asked in several places
    pub fn go_on(&mut self, lacks: R, end: R, turns: bool) -> Option<R> {
        let crossing = self.find_crossing(lacks, end, turns);
        let x = crossing.unwrap_or(end);
        in_piece!(self, piece => piece.go_to(x));
        crossing.err()
    }

    /// Where the displacement is `lacks` for the first time; else what it lacks at `end`. `turns`: the acceleration changes its sign in the
    /// middle of the motion. Then the displacement is convex wherever it rises.
    fn find_crossing(&self, lacks: R, end: R, turns: bool) -> Result<R, R> {
        let beyond_at = |x| {
            let (displacement, slope) = self.displacement(x);
            (displacement - lacks, slope)
        };
        let rises = in_piece!(self, piece => piece.s) >= R::ZERO;
        let (mut low, mut high) = (R::ZERO, end);
        if !(turns && rises) {
            let turning_point = in_piece!(self, piece => piece.turning_point());
            if let Some(x) = turning_point.filter(|x| *x < end) {
                if rises && beyond_at(x).0 >= R::ZERO { high = x } else { low = x }
            }
        }
        let is_before_turn = high < end;
        if !is_before_turn && end.is_finite() {
            let beyond = beyond_at(end).0;
            if beyond < R::ZERO {
                return Err(-beyond);
            }
        }
        if turns && !is_before_turn {
            let left = if low > R::ZERO { -beyond_at(low).0 } else { lacks };
            let bound = low + in_piece!(self, piece => piece.bound(low, left));
            high = bound.at_most(end);
        }
        Ok(root_between(low, high, beyond_at))
    }
}
