//! Bounds of sums and products of quantities that change together: how [`super::change`] proves that a change of the rate keeps the limits.

use crate::online::Phase;
use crate::real::Real;

/// A quantity in a part of the time: `middle + slope e + bend e²`, up to `rest`, while `e` goes from -1 to 1. Sums and products hold all sums and products
/// at the same time. So what rises while another quantity falls does not count twice, and a parabola is exact.
#[derive(Clone, Copy)]
pub struct Enclosure<R> {
    middle: R,
    slope: R,
    bend: R,
    rest: R,
}

impl<R: Real> Enclosure<R> {
    pub fn constant(middle: R) -> Self {
        Self { middle, slope: R::ZERO, bend: R::ZERO, rest: R::ZERO }
    }

    pub fn between(from: R, to: R) -> Self {
        Self { slope: R::HALF * (to - from), ..Self::constant(R::HALF * (from + to)) }
    }

    /// Position, velocity, acceleration and jerk of a phase at this time.
    pub fn along(self, phase: &Phase<R>) -> [Self; 4] {
        let z = self.middle;
        let [p, v, a, j] =
            [phase.position(z), phase.velocity(z), phase.acceleration(z), phase.jerk].map(Self::constant);
        let d = self.plus(Self::constant(-z));
        let (change, half) = (d.scaled(phase.jerk), d.scaled(R::HALF));
        let velocity = v.plus(d.scaled(a.middle)).plus(half.times(change));
        let position = p.plus(d.times(v.plus(half.times(a.plus(change.scaled(R::SIXTH + R::SIXTH))))));
        [position, velocity, a.plus(change), j]
    }

    /// Where it may be between two numbers: `e = c + d e'`, and `e'` goes from -1 to 1.
    pub fn when_between(self, low: R, high: R) -> [R; 2] {
        let middle = self.middle + R::HALF * self.bend;
        let width = self.rest + R::HALF * self.bend.abs();
        let mut ends = [low - middle - width, high - middle + width].map(|offset| offset / self.slope);
        if self.slope < R::ZERO {
            ends.reverse();
        }
        let [from, to] =
            if self.slope == R::ZERO { [-R::ONE, R::ONE] } else { ends.map(|e| e.at_least(-R::ONE).at_most(R::ONE)) };
        [R::HALF * (from + to), R::HALF * (to - from)]
    }

    /// For `e = c + d e'`.
    pub fn narrowed(self, [c, d]: [R; 2]) -> Self {
        let (slope, bend) = (self.slope, self.bend);
        Self {
            middle: self.middle + c * (slope + bend * c),
            slope: d * (slope + (bend + bend) * c),
            bend: d * d * bend,
            rest: self.rest,
        }
    }

    pub fn plus(self, other: Self) -> Self {
        Self {
            middle: self.middle + other.middle,
            slope: self.slope + other.slope,
            bend: self.bend + other.bend,
            rest: self.rest + other.rest,
        }
    }

    pub fn scaled(self, by: R) -> Self {
        let Self { middle, slope, bend, rest } = self;
        Self { middle: by * middle, slope: by * slope, bend: by * bend, rest: by.abs() * rest }
    }

    /// The parabolas nearest to `e³` and `e⁴` are `3/4 e` up to 1/4 and `e² - 1/8` up to 1/8.
    pub fn times(self, other: Self) -> Self {
        let quarter = R::HALF * R::HALF;
        let third = self.slope * other.bend + self.bend * other.slope;
        let fourth = self.bend * other.bend;
        let eighth = R::HALF * quarter * fourth;
        let size = |of: Self| of.middle.abs() + of.slope.abs() + of.bend.abs();
        Self {
            middle: self.middle * other.middle - eighth,
            slope: self.middle * other.slope + self.slope * other.middle + (third - quarter * third),
            bend: self.middle * other.bend + self.slope * other.slope + self.bend * other.middle + fourth,
            rest: quarter * third.abs()
                + eighth.abs()
                + size(self) * other.rest
                + (size(other) + other.rest) * self.rest,
        }
    }

    pub fn range(self) -> [R; 2] {
        let Self { middle, slope, bend, rest } = self;
        let [one, other] = [middle + bend - slope, middle + bend + slope];
        // At `e = -slope/(2 bend)`, if this is between -1 and 1.
        let turn = if slope.abs() < (bend + bend).abs() { middle - slope * slope / (R::from(4) * bend) } else { one };
        [one.at_most(other).at_most(turn) - rest, one.at_least(other).at_least(turn) + rest]
    }

    /// Up to 64 ulps of the limits.
    pub fn is_between(self, lowest: R, highest: R) -> bool {
        let [low, high] = self.range();
        let wider = R::ONE + R::DOUBT;
        low >= wider * lowest && high <= wider * highest
    }
}

#[cfg(test)]
mod tests {
    use super::Enclosure;
    use crate::online::Phase;

    fn at(Enclosure { middle, slope, bend, .. }: Enclosure<f64>, e: f64) -> f64 {
        middle + e * (slope + e * bend)
    }

    /// In a part of the time a parabola goes through the same numbers.
    #[test]
    fn a_part_of_a_parabola_is_on_it() {
        let whole = Enclosure { middle: 1.0, slope: -3.0, bend: 5.0, rest: 0.25 };
        let [c, d] = [0.5, 0.25];
        let part = whole.narrowed([c, d]);
        for e in [-1.0, -0.5, 0.0, 0.5, 1.0] {
            assert_eq!(at(part, e), at(whole, c + d * e));
        }
        assert_eq!(part.rest, whole.rest);
    }

    /// The quantities of a phase, at times around 2 s, are in their parabolas. Only the position has a rest: a quarter of its cubic part.
    #[test]
    fn a_phase_is_in_its_parabolas() {
        let phase = Phase { start: 0.0, duration: 4.0, position: 1.0, velocity: -3.0, acceleration: 2.0, jerk: 6.0 };
        let quantities = Enclosure::between(1.5, 2.5).along(&phase);
        for e in [-1.0_f64, -0.5, 0.0, 0.5, 1.0] {
            let x = 2.0 + 0.5 * e;
            let states = [phase.position(x), phase.velocity(x), phase.acceleration(x), phase.jerk];
            for (parabola, number) in quantities.into_iter().zip(states) {
                let off = (number - at(parabola, e)).abs();
                assert!(off <= parabola.rest + 1e-12, "{e}: {off} {}", parabola.rest);
            }
        }
        let rests = quantities.map(|parabola| parabola.rest);
        assert_eq!(rests, [phase.jerk / 6.0 * 0.125 / 4.0, 0.0, 0.0, 0.0]);
    }
}
