//! Parts of the border on which the motions have one shape. There the displacement is a polynomial in one quantity.

use super::border::{Border, Course, Pace};
use crate::real::Real;
use crate::roots::{larger_root, root_between};

/// How the part of the border ends in which the acceleration eases.
pub(super) enum Easing {
    /// The hold is over.
    HoldEnds,
    /// The acceleration eases down to 0.
    Vanishes,
    /// The acceleration can ease no further.
    IsFollowedByGap,
}

/// A part of the border on which one quantity determines the motion: how much more the acceleration falls than in the first motion of
/// the part. Either no acceleration holds or the highest one. The part counts displacements from its first motion.
#[derive(Clone, Copy)]
pub(super) struct Part<R> {
    base: Course<R>,
    /// Whether the highest acceleration holds.
    holds: bool,
    limit: R,
    pace: Pace<R>,
    /// How far the acceleration falls in the first motion.
    fall: R,
    /// The derivative of the displacement with respect to the duration, in the first motion.
    slope: R,
    /// With a hold: the derivative of the slope. Without one: the sum of peak and trough.
    shape: R,
}

impl<R: Real> Part<R> {
    pub fn of(border: &Border<R>, base: &Course<R>, holds: bool) -> Self {
        let Course {
            peak, fall, trough, ..
        } = *base;
        let Pace { up, down } = border.pace;
        Self {
            base: *base,
            holds,
            limit: border.rise,
            pace: border.pace,
            fall,
            slope: border.slope(base),
            shape: if holds {
                R::HALF * down * (fall - trough) - up * trough
            } else {
                peak + trough
            },
        }
    }

    /// The displacement where the acceleration falls by `x` more, and its derivative with respect to `x`.
    pub fn displacement(&self, x: R) -> (R, R) {
        let Self {
            fall, slope, shape, ..
        } = *self;
        let (half, mean) = (R::HALF, self.pace.mean());
        if self.holds {
            let third = R::SIXTH + R::SIXTH;
            let cubic = mean * x * (third * fall + half * half * x);
            let sum = slope * (fall + half * x) + x * (shape * (half * fall + third * x) + cubic);
            let slope = slope + x * (shape + mean * x);
            let factor = (mean + mean) / self.limit;
            (factor * x * sum, factor * (fall + x) * slope)
        } else {
            let ratio = self.ratio(fall + x);
            let (cubic, quarter_up) = (self.cubic(), half * half * self.pace.up);
            let three = R::from(3);
            let sum = cubic * (three * fall + x) - quarter_up * shape * ratio;
            let growth = three * cubic - quarter_up * ratio * ratio;
            let twice_slope = slope + slope + x * (fall + fall + x) * growth;
            (mean * x * (slope + slope + x * sum), mean * twice_slope)
        }
    }

    /// Without a hold: coefficient of the third power of what the acceleration falls by, divided by the mean pace.
    fn cubic(&self) -> R {
        R::SIXTH * (R::HALF * self.pace.up + self.pace.down)
    }

    /// Without a hold: the sum of peak and trough in the first motion, divided by what the acceleration falls by.
    fn ratio(&self, fall: R) -> R {
        if fall > R::ZERO {
            self.shape / fall
        } else {
            R::ZERO
        }
    }

    /// Where the displacement first stops rising, or falling.
    fn turning_point(&self) -> Option<R> {
        let Self {
            fall, slope, shape, ..
        } = *self;
        if self.holds {
            // The slope is a quadratic.
            let mean = self.pace.mean();
            return first_zero(R::HALF * shape / mean, slope / mean);
        }
        // The product of the slope and of the square that the acceleration falls by is a quadratic in this square. In this unit nothing is out
        // of range.
        let cubic = R::from(3) * self.cubic();
        let unit = (slope.abs() / cubic).sqrt();
        let unit = fall.at_least(shape.abs()).at_least(unit);
        let (fall, shape) = (fall / unit, shape / unit);
        let slope = slope / (cubic * unit) / unit;
        let square = fall * fall;
        let quarter_up = R::HALF * R::HALF * self.pace.up / cubic;
        let p = R::HALF * (square - quarter_up * shape * shape) + slope;
        let zero = first_zero(p, (slope + slope) * square)?;
        Some(unit * zero / ((square + zero).sqrt() + fall))
    }

    /// Where the displacement is `lacks` for the first time, if not beyond `end`. `turns`: the acceleration changes its sign in the
    /// middle of the motion. Then the displacement is convex wherever it rises.
    pub fn first_over(&self, lacks: R, end: R, turns: bool) -> Option<R> {
        let beside = |x| {
            let (displacement, slope) = self.displacement(x);
            (displacement - lacks, slope)
        };
        let mut low = R::ZERO;
        if let Some(x) = self.turning_point().filter(|x| *x < end) {
            if self.slope > R::ZERO && beside(x).0 >= R::ZERO {
                return Some(root_between(R::ZERO, x, beside));
            }
            low = x;
        }
        if end < R::INFINITY && beside(end).0 < R::ZERO {
            return None;
        }
        let mut high = end;
        if turns {
            let bound = if low > R::ZERO {
                low + self.from(low).bound(-beside(low).0)
            } else {
                self.bound(lacks)
            };
            high = bound.at_most(end);
        }
        Some(root_between(low, high, beside))
    }

    /// The part from the turning point `x` on, where the slope is 0.
    fn from(&self, x: R) -> Self {
        let fall = self.fall + x;
        let mean = self.pace.mean();
        let shape = if self.holds {
            self.shape + (mean + mean) * x
        } else {
            self.fall * self.ratio(fall)
        };
        Self {
            fall,
            slope: R::ZERO,
            shape,
            ..*self
        }
    }

    /// Not below the `x` of a displacement, on a part on which the displacement rises and is convex: each of its terms alone would have to
    /// reach farther.
    fn bound(&self, displacement: R) -> R {
        let Self {
            fall, slope, shape, ..
        } = *self;
        let slope = slope.at_least(R::ZERO); // -0 too
        let reduced = displacement / self.pace.mean();
        let [linear, square, last] = if self.holds {
            let fourth = (reduced + reduced) / self.limit / self.pace.mean();
            let reduced = reduced * self.limit;
            [
                reduced / (slope * fall),
                reduced / (shape * fall),
                (self.limit * fourth.sqrt()).sqrt(),
            ]
        } else {
            [
                reduced / slope,
                (reduced + reduced) / (self.pace.down * fall),
                (reduced / self.cubic()).cube_root_above(),
            ]
        };
        (R::HALF * linear).at_most(square.sqrt().at_most(last))
    }

    /// How the easing ends, and where. `a0` is the acceleration at the start of the motion.
    pub fn end_of_easing(&self, a0: R) -> (R, Easing) {
        let Course {
            first,
            peak,
            top,
            trough,
            ..
        } = self.base;
        if self.holds {
            let product = top * self.limit / self.pace.mean();
            let d = trough * trough - product;
            return if d >= R::ZERO {
                (product / (trough + d.sqrt()), Easing::HoldEnds)
            } else {
                (trough, Easing::Vanishes)
            };
        }
        // The lowest trough has this square: then no rise is left at the start. Of two forms, the one whose terms are small.
        let (change, sum) = if first < self.fall {
            (first, peak + a0)
        } else {
            (self.fall, peak + trough)
        };
        let remains = if first < self.fall { trough } else { a0 };
        let square = remains * remains - change * sum;
        if a0 > R::ZERO && square > R::ZERO {
            let end = change * (sum / (remains + square.sqrt()) - R::ONE);
            (end, Easing::IsFollowedByGap)
        } else {
            let least_peak = (self.fall * (peak + trough)).sqrt();
            (least_peak - self.fall, Easing::Vanishes)
        }
    }

    /// The motion.
    pub fn course(&self, x: R) -> Course<R> {
        let base = self.base;
        let fall = self.fall + x;
        let mut course = Course { fall, ..base };
        if self.holds {
            let longer = self.pace.mean() * x * (x - (base.trough + base.trough)) / self.limit;
            course.top = (base.top + longer).at_least(R::ZERO);
        } else {
            let first = base.first + R::HALF * x * (R::ONE - self.ratio(fall));
            course.first = first;
            course.peak = base.peak + (first - base.first);
        }
        // What rises falls, so the sum of both rises grows by `x`: the duration does not depend on the rounding of their difference.
        course.last = base.first + base.last + x - course.first;
        course.trough = base.trough - (course.last - base.last);
        course
    }
}

/// Where `x^2 + 2 p x + q` first is 0 for a positive `x`, or for 0 if `q` is not positive.
fn first_zero<R: Real>(p: R, q: R) -> Option<R> {
    if q <= R::ZERO {
        return Some(larger_root(p, q));
    }
    let d = p * p - q;
    (p < R::ZERO && d > R::ZERO).then(|| q / (d.sqrt() - p))
}
