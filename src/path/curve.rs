//! The curve of a row of points: a cubic spline by the length of its arcs.
//!
//! Before the first step the curve stands in tables of the steps: the lengths in `gradient_t`, slopes and bends in `diagonal`, and the measures of
//! the axes in `product`.

use core::ops::Range;

use super::chain::Chain;
use crate::real::Real;

impl<R: Real> Chain<'_, '_, R> {
    /// Makes each axis count in its least limit of the jerk, so that units do not matter: it counts as much as it takes time. An axis with 0 or
    /// infinity does not count. Forgets the curves of other rows.
    pub fn measure_axes(&mut self) {
        self.memory.diagonal.clear();
        for axis in 0..self.axes {
            let limits = (0..self.sections).filter_map(|section| self.limits(section, axis).ok());
            let least = limits.fold(R::INFINITY, |least, limits| least.at_most(limits.jmax.at_most(-limits.jmin)));
            self.memory.product.set(axis, [least, R::ZERO]);
        }
    }

    /// A quantity of an axis, by its measure.
    pub fn part(&self, axis: usize, of: R) -> R {
        let [measure, _] = self.memory.product.row(axis);
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

    pub fn chord(&self, section: usize) -> R {
        self.norm(|axis| self.displacement(section, axis))
    }

    /// Lays the curve through the points of a row.
    pub fn lay_curve(&mut self, row: Range<usize>) {
        for section in row.clone() {
            let chord = self.chord(section);
            self.memory.gradient_t.put(section, chord);
        }
        // An arc is longer than its chord by a 24th of the square of its angle: half of it for the bend at each end.
        for point in row.start + 1..row.end {
            let bend = self.bend_of_parabola(point);
            for section in [point - 1, point] {
                let chord = self.chord(section);
                let angle = bend * chord;
                self.memory.gradient_t.add(section, [angle * angle * chord / R::from(48)]);
            }
        }
        for axis in 0..self.axes {
            self.lay_spline(axis, row.clone());
        }
    }

    /// How much the parabola through a point and the points next to it bends there.
    fn bend_of_parabola(&self, point: usize) -> R {
        let [before, after] = [point - 1, point].map(|section| self.chord(section));
        let slope = |section, chord, axis| self.displacement(section, axis) / chord;
        let turn = self.norm(|axis| slope(point, after, axis) - slope(point - 1, before, axis));
        (turn + turn) / (before + after)
    }

    /// The spline of an axis: the slopes `m` at its points make its bends continuous,
    /// `m0/h1 + 2 (1/h1 + 1/h2) m1 + m2/h2 = 3 (d1/h1 + d2/h2)` with the mean slopes `d` of arcs of the lengths `h`. Its bend is constant in the first
    /// and in the last section: `m0 + m1 = 2 d1`.
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
            let [s, e] = self.slope_and_bend(point, axis);
            let slope = s - e * next;
            let bend = two * (three * self.mean_slope(point, axis) - two * slope - next) / self.arc(point);
            self.set_slope_and_bend(point, axis, [slope, bend]);
            next = slope;
        }
    }

    /// The length of a section along the curve.
    pub fn arc(&self, section: usize) -> R {
        self.memory.gradient_t.at(section)
    }

    pub fn mean_slope(&self, section: usize, axis: usize) -> R {
        self.displacement(section, axis) / self.arc(section)
    }

    fn set_slope_and_bend(&mut self, point: usize, axis: usize, [slope, bend]: [R; 2]) {
        self.memory.diagonal.set((point - 1) * self.axes + axis, [slope, bend, R::ZERO]);
    }

    /// The slope of the curve at a point, and its second derivative. Both are 0 at the ends of a row.
    pub fn slope_and_bend(&self, point: usize, axis: usize) -> [R; 2] {
        let Some(before) = point.checked_sub(1) else {
            return [R::ZERO; 2];
        };
        let [slope, bend, _] = self.memory.diagonal.row(before * self.axes + axis);
        [slope, bend]
    }

    /// The largest second derivative of the curve in a section, and the third one, without signs. The third one counts as 0 next to an end of the row.
    pub fn bend_and_twist(&self, section: usize, axis: usize) -> [R; 2] {
        let [[_, b0], [_, b1]] = [section, section + 1].map(|point| self.slope_and_bend(point, axis));
        let is_at_end = b0 == R::ZERO || b1 == R::ZERO;
        let twist = if is_at_end { R::ZERO } else { (b1 - b0).abs() / self.arc(section) };
        [b0.abs().at_least(b1.abs()), twist]
    }
}
