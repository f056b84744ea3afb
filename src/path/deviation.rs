//! How far the motions of a path leave the straight lines between its points.
//!
//! Between two borders of phases each axis moves on a cubic. A cubic stays in the hull of its four Bézier points, and the distance to a
//! straight line is convex. So the farthest of the four points is a bound, and it nears the motion with the square of the duration.

use super::memory;
use crate::interval::rounding::of_state;
use crate::online::Move;
use crate::real::Real;

/// The shortest part of a piece that is looked at is one of so many: the most that binary32 counts. An axis that turns next to its point needs them.
const PARTS: i32 = 1 << 24;

/// How often parts of a piece are halved at most. Of 2,000 random paths none takes more, and 16 are too few.
const MOST_HALVES: u32 = 32;

/// How far the motions of a path leave the straight lines between its points, unit: the greatest distance, in the space of all axes, of a
/// point of the motion from the line between the points of its section. It is a bound from above, by less than 1 % and rounding.
///
/// `moves` are those of [`path_moves`](crate::axes::path_moves): of all `axes` for the first section, then of all axes for the second one.
/// A line ends at its points, so an axis that overshoots leaves it. NaN if there is no axis or no section, if the moves are no whole
/// sections, or if a number of theirs is not finite or has no square within the range of the real type.
pub fn path_deviation<R: Real>(moves: &[Move<R>], axes: usize) -> R {
    let mut reached = Deviation { seen: R::ZERO, most: R::ZERO };
    let mut sections = 0;
    for section in moves.chunks(axes.max(1)) {
        if section.len() != axes || reached.follow(&Section::new(section)).is_none() {
            return R::NAN;
        }
        sections += 1;
    }
    if memory::size::<2>(axes, sections).is_some() { reached.most } else { R::NAN }
}

/// How far a motion is off its line.
struct Deviation<R> {
    /// At the times that were looked at, unit.
    seen: R,
    /// At all times: a bound from above, unit.
    most: R,
}

impl<R: Real> Deviation<R> {
    /// Takes account of a section. `None` if a number is not finite.
    fn follow(&mut self, section: &Section<R>) -> Option<()> {
        let mut from = R::ZERO;
        // Each border is that of another phase.
        while let Some(to) = section.border_after(from) {
            self.follow_piece(section, [from, to])?;
            from = to;
        }
        let sum = section.axes.iter().fold(section.size + section.square, |sum, axis| sum + axis.t.abs());
        sum.is_finite().then_some(())
    }

    /// Takes account of a section between two borders: as a whole, or else each half of it, and so on.
    fn follow_piece(&mut self, section: &Section<R>, [from, to]: [R; 2]) -> Option<()> {
        let least = (to - from) / R::from_index(PARTS);
        let (mut done, mut part, mut halves) = (0, PARTS, 0);
        while done < PARTS {
            let [from, to] = [done, done + part].map(|k| from + R::from_index(k) * least);
            let [start, one, other, end] = section.distances([from, to]);
            self.seen = self.seen.at_least(start.at_least(end));
            let most = start.at_least(end).at_least(one).at_least(other);
            (start + one + other + end).is_finite().then_some(())?;
            let rounding = of_state(section.size + most);
            if halves < MOST_HALVES && part > 1 && most > self.seen + R::SIXTEENTH * R::SIXTEENTH * self.seen + rounding
            {
                part /= 2;
                halves += 1;
            } else {
                self.most = self.most.at_least(most);
                done += part;
                // The largest part that begins here: the lowest bit that is set.
                part = done & done.wrapping_neg();
            }
        }
        Some(())
    }
}

struct Section<'a, R> {
    axes: &'a [Move<R>],
    /// How large its positions are, unit.
    size: R,
    /// The square of the length of its line.
    square: R,
}

impl<'a, R: Real> Section<'a, R> {
    fn new(axes: &'a [Move<R>]) -> Self {
        let (mut size, mut square) = (R::ZERO, R::ZERO);
        for axis in axes {
            let [from, to] = [axis.start(), axis.end()].map(|end| end.position);
            size = size + from.abs() + to.abs();
            square = square + (to - from) * (to - from);
        }
        Self { axes, size, square }
    }

    /// The first time after `x` at which a phase of an axis begins, s.
    fn border_after(&self, x: R) -> Option<R> {
        self.axes.iter().filter_map(|axis| axis.border_after(x)).reduce(R::at_most)
    }

    /// How far the Bézier points of the motion between two times are off the line, unit. No phase begins between them.
    fn distances(&self, times: [R; 2]) -> [R; 4] {
        let mut along = [R::ZERO; 4];
        for axis in self.axes {
            let (line, points) = offsets(axis, times);
            for (along, point) in along.iter_mut().zip(points) {
                *along = *along + line * point;
            }
        }
        let nearest = along.map(|along| {
            let part = if self.square > R::ZERO { along / self.square } else { R::ZERO };
            part.at_least(R::ZERO).at_most(R::ONE)
        });
        let mut squares = [R::ZERO; 4];
        for axis in self.axes {
            let (line, points) = offsets(axis, times);
            for (square, (part, point)) in squares.iter_mut().zip(nearest.into_iter().zip(points)) {
                let off = point - part * line;
                *square = *square + off * off;
            }
        }
        squares.map(R::sqrt)
    }
}

/// Where the line of an axis ends and where its Bézier points between two times are, from its start, unit.
fn offsets<R: Real>(axis: &Move<R>, [from, to]: [R; 2]) -> (R, [R; 4]) {
    let phase = axis.phase_at(from + R::HALF * (to - from));
    let start = axis.start().position;
    let [z0, z1] = [from, to].map(|x| x - phase.start);
    let [p0, p1] = [z0, z1].map(|z| phase.position(z) - start);
    let [v0, v1] = [z0, z1].map(|z| phase.velocity(z));
    let third = (R::SIXTH + R::SIXTH) * (to - from);
    (axis.end().position - start, [p0, p0 + third * v0, p1 - third * v1, p1])
}
