//! The moves of an axis, section by section.

use crate::online::Move;
use crate::real::Real;

/// Whether the moves are whole sections of `n` axes.
pub(super) fn are_whole<R>(moves: &[Move<R>], n: usize) -> bool {
    n > 0 && !moves.is_empty() && moves.chunks(n).all(|section| section.len() == n)
}

pub(super) fn start_at_rest<R: Real>(moves: &[Move<R>], n: usize) -> bool {
    moves.iter().take(n).all(|of| of.start().is_at_rest())
}

/// How long the slowest axis moves, s.
#[inline(never)] // for its size
pub(super) fn duration<R: Real>(moves: &[Move<R>], n: usize) -> R {
    (0..n).map(|index| AxisPath::new(moves, n, index).duration()).fold(R::ZERO, R::at_least)
}

/// When all axes have come to rest, s; infinite if one of them moves on.
pub(super) fn time_of_rest<R: Real>(moves: &[Move<R>], n: usize) -> R {
    let rests = moves.iter().rev().take(n).all(|of| of.end().is_at_rest());
    if rests { duration(moves, n) } else { R::INFINITY }
}

/// The moves of an axis: the first one, and then each `n` moves after the one before.
#[derive(Clone, Copy)]
pub(super) struct AxisPath<'a, R> {
    moves: &'a [Move<R>],
    n: usize,
}

impl<'a, R: Real> AxisPath<'a, R> {
    /// The moves of axis `index` of `n` axes.
    pub fn new(moves: &'a [Move<R>], n: usize, index: usize) -> Self {
        Self { moves: moves.get(index..).unwrap_or_default(), n }
    }

    /// The moves, each with the time at which it starts and the time at which the next one does. The last move goes on.
    pub fn sections(self) -> impl Iterator<Item = (&'a Move<R>, R, R)> {
        let (mut rest, mut end) = (self.moves, R::ZERO);
        core::iter::from_fn(move || {
            let (of, start) = (rest.first()?, end);
            rest = rest.get(self.n.max(1)..).unwrap_or_default();
            end = if rest.is_empty() { R::INFINITY } else { start + of.t };
            Some((of, start, end))
        })
    }

    /// The move at the time `s`, and when it starts. The first move is there before its start, too.
    pub fn section(self, s: R) -> Option<(&'a Move<R>, R)> {
        let mut found = None;
        for (of, start, end) in self.sections() {
            found = Some((of, start));
            if s < end {
                break;
            }
        }
        found
    }

    pub fn duration(self) -> R {
        self.sections().last().map_or(R::ZERO, |(of, start, _)| start + of.t)
    }

    /// Position, velocity, acceleration and jerk by the time of the path and its derivatives. All are NaN if there is no move.
    pub fn state(self, [s, rate, slowing, bending]: [R; 4]) -> [R; 4] {
        let Some((of, start)) = self.section(s) else { return [R::NAN; 4] };
        // The path is at its end, whatever a difference is rounded to.
        let passed = if s < start + of.t { s - start } else { (s - start).at_least(of.t) };
        let [position, v, a, j] = of.state(passed);
        let square = rate * rate;
        let jerk = j * square * rate + R::from(3) * a * rate * slowing + v * bending;
        [position, v * rate, a * square + v * slowing, jerk]
    }

    /// Whether the axis stays between two positions from one time of the path to another, up to the rounding of its moves.
    #[inline(never)] // for its stack
    pub fn stays(self, [from, to]: [R; 2], [lowest, highest]: [R; 2]) -> bool {
        let mut passed = self.sections().filter(|(_, start, end)| from < *end && to > *start);
        passed.all(|(of, start, end)| {
            let Some(part) = of.between((from - start).at_least(R::ZERO), to.at_most(end) - start) else {
                return false;
            };
            !part.extremes().overshoots(lowest, highest, of.rounding())
        })
    }
}
