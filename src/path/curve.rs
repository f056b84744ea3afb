//! The curve of a row of points, a cubic spline by the length of its arcs, and the limits of a motion along it.

use super::chain::Chain;
use crate::limits::Limits;
use crate::real::Real;
use core::ops::Range;

/// Which part of the limits the first plan uses at most, so that it is off all of them, and which share of the highest speeds a row takes that begins
/// in motion. With 31/32 one axis of twenty could not end in motion without turning back.
pub(super) fn all_but_rounding<R: Real>() -> R {
    R::ONE - R::SIXTEENTH * R::SIXTEENTH * R::SIXTEENTH
}

/// Three quarters of a limit: what bends take at most, and what counts as left by them at least. Where this is too much, a row becomes slower.
fn for_bends<R: Real>(limit: R) -> R {
    (R::HALF + R::HALF * R::HALF) * limit
}

/// What bends leave of a limit at a power of the speed, which may be infinite without bends.
fn left<R: Real>(limit: R, bend: R, power: R) -> R {
    let taken = if bend > R::ZERO { bend * power } else { R::ZERO };
    (limit - taken).at_least(for_bends(limit))
}

impl<R: Real> Chain<'_, '_, R> {
    /// Makes each axis count in its least limit of the jerk, so that units do not matter: it counts as much as it takes time. An axis with 0 or
    /// infinity does not count.
    pub fn measure_axes(&mut self) {
        for axis in 0..self.axes {
            let limits = (0..self.sections).map(|section| self.limits(section, axis));
            let least = limits.fold(R::INFINITY, |least, limits| least.at_most(limits.jmax.at_most(-limits.jmin)));
            self.memory.rows_mut().measure.put(axis, least);
        }
    }

    /// A quantity of an axis, by its measure.
    pub fn part(&self, axis: usize, of: R) -> R {
        let measure = self.memory.rows().measure.at(axis);
        if measure > R::ZERO { of / measure } else { R::ZERO }
    }

    /// The next point after this one at which the path turns by more than 20°, or its end.
    pub fn next_corner(&self, point: usize) -> usize {
        let mut corner = point + 1;
        while corner < self.sections && !self.is_corner(corner) {
            corner += 1;
        }
        corner
    }

    fn is_corner(&self, point: usize) -> bool {
        let least = (R::ONE - R::SIXTEENTH) * self.chord(point - 1) * self.chord(point);
        let part = |section, axis| self.part(axis, self.displacement(section, axis));
        let product = (0..self.axes).fold(R::ZERO, |sum, axis| sum + part(point - 1, axis) * part(point, axis));
        product < least
    }

    fn norm(&self, of: impl Fn(usize) -> R) -> R {
        let parts = (0..self.axes).map(|axis| self.part(axis, of(axis)));
        parts.fold(R::ZERO, |sum, part| sum + part * part).sqrt()
    }

    fn chord(&self, section: usize) -> R {
        self.norm(|axis| self.displacement(section, axis))
    }

    pub fn lay_curve(&mut self, row: Range<usize>) {
        for section in row.clone() {
            let chord = self.chord(section);
            self.memory.rows_mut().arc.put(section, chord);
        }
        // An arc is longer than its chord by a 24th of the square of its angle: half of it for the bend at each end.
        for point in row.start + 1..row.end {
            let bend = self.bend_of_parabola(point);
            for section in [point - 1, point] {
                let chord = self.chord(section);
                let angle = bend * chord;
                self.memory.rows_mut().arc.add(section, [angle * angle * chord / R::from(48)]);
            }
        }
        for axis in 0..self.axes {
            for end in [row.start, row.end] {
                self.set_slope_and_bend(end, axis, [R::ZERO; 2]);
            }
            self.lay_spline(axis, row.clone());
        }
    }

    /// Makes the bends of a row limit no speed.
    pub fn ignore_bends(&mut self, row: Range<usize>) {
        for state in row.start * self.axes..(row.end - 1) * self.axes {
            let [slope, bend, _] = self.memory.rows().slope_and_bend.row(state);
            self.memory.rows_mut().slope_and_bend.set(state, [slope, bend, R::ZERO]);
        }
    }

    /// How much the parabola through a point and the points next to it bends there.
    fn bend_of_parabola(&self, point: usize) -> R {
        let [before, after] = [point - 1, point].map(|section| self.chord(section));
        let slope = |section, chord, axis| self.displacement(section, axis) / chord;
        let turn = self.norm(|axis| slope(point, after, axis) - slope(point - 1, before, axis));
        (turn + turn) / (before + after)
    }

    /// The spline of an axis: the slopes `m` at its points make its bends continuous, `m0/h1 + 2 (1/h1 + 1/h2) m1 + m2/h2 = 3 (d1/h1 + d2/h2)` with the
    /// mean slopes `d` of arcs of the lengths `h`. Its bend is constant in the first and in the last section: `m0 + m1 = 2 d1`.
    fn lay_spline(&mut self, axis: usize, row: Range<usize>) {
        let [two, three] = [2, 3].map(R::from);
        // The slope at a point is `s - e m` with the slope `m` at the next one.
        let (mut s, mut e) = (two * self.mean_slope(row.start, axis), R::ONE);
        for point in row.start + 1..row.end {
            let [h1, h2] = [point - 1, point].map(|section| self.arc(section));
            let [d1, d2] = [point - 1, point].map(|section| self.mean_slope(section, axis));
            let whole = (two - e) / h1 + two / h2;
            s = ((three * d1 - s) / h1 + three * d2 / h2) / whole;
            e = R::ONE / (h2 * whole);
            self.set_slope_and_bend(point, axis, [s, e]);
        }
        let mut next = (two * self.mean_slope(row.end - 1, axis) - s) / (R::ONE - e);
        for point in (row.start + 1..row.end).rev() {
            let [s, e, _] = self.at_point(point, axis);
            let slope = s - e * next;
            let bend = two * (three * self.mean_slope(point, axis) - two * slope - next) / self.arc(point);
            self.set_slope_and_bend(point, axis, [slope, bend]);
            next = slope;
        }
    }

    pub fn arc(&self, section: usize) -> R {
        self.memory.rows().arc.at(section)
    }

    #[inline(never)] // for its size: it is asked in several places
    pub fn mean_slope(&self, section: usize, axis: usize) -> R {
        self.displacement(section, axis) / self.arc(section)
    }

    /// Sets the slope of the curve at a point, and its second derivative, which limits the speed.
    fn set_slope_and_bend(&mut self, point: usize, axis: usize, [slope, bend]: [R; 2]) {
        if let Some(before) = point.checked_sub(1) {
            self.memory.rows_mut().slope_and_bend.set(before * self.axes + axis, [slope, bend, bend]);
        }
    }

    /// Slope, bend, and the bend that limits the speed. All are 0 at the ends of a row.
    #[inline(never)] // for its size: it is asked in several places
    pub fn at_point(&self, point: usize, axis: usize) -> [R; 3] {
        let before = point.checked_sub(1);
        before.map_or([R::ZERO; 3], |before| self.memory.rows().slope_and_bend.row(before * self.axes + axis))
    }

    /// The largest second derivative of the curve in a section that limits the speed, and the third one, without signs. The third one counts as 0
    /// next to an end of the row.
    pub fn bend_and_twist(&self, section: usize, axis: usize) -> [R; 2] {
        let [[_, _, b0], [_, _, b1]] = [section, section + 1].map(|point| self.at_point(point, axis));
        let is_at_end = b0 == R::ZERO || b1 == R::ZERO;
        let twist = if is_at_end { R::ZERO } else { (b1 - b0).abs() / self.arc(section) };
        [b0.abs().at_least(b1.abs()), twist]
    }

    /// Takes this share of the highest speeds along a row.
    pub fn take_share(&mut self, row: Range<usize>, share: R) {
        for section in row {
            let speeds = (0..self.axes).map(|axis| self.highest_speed(axis, section));
            let highest = speeds.fold(R::INFINITY, R::at_most);
            self.memory.rows_mut().highest_speed.put(section, highest);
            self.memory.rows_mut().share.put(section, share);
        }
    }

    /// The highest speed along a section that the limits of an axis allow. Its bends take `|q''| v²` of the acceleration, and `|q'''| v³` of the jerk.
    fn highest_speed(&self, axis: usize, section: usize) -> R {
        let limits = self.limits_by_slope(section, axis);
        let [bend, twist] = self.bend_and_twist(section, axis);
        let most_a = for_bends(limits.amax.at_most(-limits.amin));
        let most_j = for_bends(limits.jmax.at_most(-limits.jmin));
        let speed = (limits.vmax / self.mean_slope(section, axis).abs()).at_most((most_a / bend).sqrt());
        let is_too_fast = twist * speed * speed * speed > most_j;
        if is_too_fast { (most_j / twist).cube_root_above().at_most(speed) } else { speed }
    }

    /// The limits of an axis in the direction in which it moves along a section.
    fn limits_by_slope(&self, section: usize, axis: usize) -> Limits<R> {
        let limits = self.limits(section, axis);
        if self.displacement(section, axis) < R::ZERO { limits.mirrored() } else { limits }
    }

    pub fn speed(&self, section: usize) -> R {
        self.memory.rows().share.at(section) * self.memory.rows().highest_speed.at(section)
    }

    /// The limits of a motion along some sections: what their bends leave of acceleration and jerk.
    pub fn limits_along(&self, sections: Range<usize>) -> Limits<R> {
        let vmax =
            all_but_rounding::<R>() * sections.clone().map(|section| self.speed(section)).fold(R::INFINITY, R::at_most);
        let (square, cube) = (vmax * vmax, vmax * vmax * vmax);
        let mut along = Limits::symmetric(R::INFINITY, R::INFINITY, vmax);
        for section in sections {
            let share = self.memory.rows().share.at(section);
            for axis in 0..self.axes {
                let limits = self.limits_by_slope(section, axis);
                let [bend, twist] = self.bend_and_twist(section, axis);
                let of_a = all_but_rounding::<R>() * share * share / self.mean_slope(section, axis).abs();
                let of_j = share * of_a;
                along.amax = along.amax.at_most(of_a * left(limits.amax, bend, square));
                along.amin = along.amin.at_least(-of_a * left(-limits.amin, bend, square));
                along.jmax = along.jmax.at_most(of_j * left(limits.jmax, twist, cube));
                along.jmin = along.jmin.at_least(-of_j * left(-limits.jmin, twist, cube));
            }
        }
        along
    }

    /// Makes some sections slower, the more the slower they are: by 1/64 at first, and by 1/16 at most. Rounding alone makes a narrow section
    /// impossible at the highest jerk.
    pub fn ease(&mut self, sections: Range<usize>) {
        for section in sections {
            let share = self.memory.rows().share.at(section);
            let less = (R::ONE - share + R::HALF * R::HALF * R::SIXTEENTH).at_most(R::SIXTEENTH);
            self.memory.rows_mut().share.put(section, share - less * share);
        }
    }
}
