//! What a section can spare: how much farther the farthest motion of its duration gets, with gradient and Hessian.
//!
//! `docs/path.md` has the tables, in "The border" and "Its derivatives". A letter of theirs that is no name here stands in a comment.

use crate::limits::Limits;
use crate::online::ramp::{Change, PerJerk};
use crate::real::Real;

/// An axis in the direction of one border.
#[derive(Clone, Copy)]
struct Frame<R> {
    vmax: R,
    /// The highest acceleration.
    bu: R,
    /// The highest deceleration.
    bd: R,
    /// In which the acceleration rises by 1, s³ per unit.
    gu: R,
    /// In which the acceleration falls by 1, s³ per unit.
    gd: R,
    /// The mean of both.
    q: R,
}

impl<R: Real> Frame<R> {
    fn both(limits: &Limits<R>) -> [Self; 2] {
        let per_jerk = PerJerk::of(limits);
        let frame = |limits: &Limits<R>, PerJerk { gu, gd }| Self {
            vmax: limits.vmax,
            bu: limits.amax,
            bd: -limits.amin,
            gu,
            gd,
            q: per_jerk.q(),
        };
        [
            frame(limits, per_jerk),
            frame(&limits.mirrored(), per_jerk.mirrored()),
        ]
    }
}

/// Velocity and acceleration at both ends of a section.
#[derive(Clone, Copy)]
pub(super) struct Ends<R> {
    pub v0: R,
    pub a0: R,
    pub v1: R,
    pub a1: R,
}

impl<R: Real> Ends<R> {
    fn mirrored(self) -> Self {
        let Self { v0, a0, v1, a1 } = self;
        Self {
            v0: -v0,
            a0: -a0,
            v1: -v1,
            a1: -a1,
        }
    }
}

/// One border of a section of an axis.
pub(super) struct Border<R> {
    frame: Frame<R>,
    ends: Ends<R>,
    /// The duration, s.
    t: R,
    /// How long the section is.
    h: R,
    /// 1, and -1 in the mirrored axis.
    sign: R,
}

#[derive(Clone, Copy, PartialEq)]
enum Shape {
    NoHold,
    TopHolds,
    BottomHolds,
    BothHold,
    Cruise,
}

/// The motion of a duration that gets farthest.
pub(super) struct Farthest<R> {
    shape: Shape,
    /// The acceleration after the first rise: `A`.
    peak: R,
    /// The acceleration after the fall: `y`.
    trough: R,
    /// How long the peak holds, s.
    top: R,
    /// How long the trough holds, s.
    bottom: R,
    /// How long the acceleration falls in the middle, counted from the start and from the end, s. Where the axis cruises, the fall pauses.
    falls: [R; 2],
    /// How much farther the motion gets than the section is long.
    pub slack: R,
}

impl<R: Real> Border<R> {
    /// The upper border and the lower one, which is the upper border of the mirrored axis.
    pub fn both(limits: &Limits<R>, ends: Ends<R>, t: R, h: R) -> [Self; 2] {
        let [upper, lower] = Frame::both(limits);
        [
            Self {
                frame: upper,
                ends,
                t,
                h,
                sign: R::ONE,
            },
            Self {
                frame: lower,
                ends: ends.mirrored(),
                t,
                h: -h,
                sign: -R::ONE,
            },
        ]
    }

    /// The farthest motion, if there is one, and if it gets farther than the section is long.
    pub fn farthest(&self) -> Option<Farthest<R>> {
        let Frame { vmax, gu, q, .. } = self.frame;
        let Ends { v0, a0, a1, .. } = self.ends;
        let mut farthest = self.without_cruise()?;
        let Farthest {
            peak, trough, top, ..
        } = farthest;
        // Where the velocity is highest, its change is more than what is left up to `vmax`.
        let above = (vmax - v0) + R::HALF * gu * a0 * a0;
        if peak > R::ZERO && trough < R::ZERO && peak * (q * peak + top) > above {
            farthest = self.cruise();
        } else if !(peak >= a0 && trough <= a1) {
            return None;
        }
        (farthest.slack > R::ZERO).then_some(farthest)
    }

    /// The row of the table that belongs to the duration, without the highest velocity.
    fn without_cruise(&self) -> Option<Farthest<R>> {
        let Frame {
            bu, bd, gu, gd, q, ..
        } = self.frame;
        let Ends { v0, a0, v1, a1 } = self.ends;
        let rest = self.t - gu * (a1 - a0); // R
        let is_motion = rest > R::ZERO;
        is_motion.then_some(())?;
        let change = (v1 - v0) + R::HALF * gu * (a0 - a1) * (a0 + a1); // c
        let mut fall = rest / (q + q); // u
        let sum = change / (q * fall); // r
        let (mut peak, mut trough) = (R::HALF * (fall + sum), R::HALF * (sum - fall));
        let (mut top, mut bottom) = (R::ZERO, R::ZERO);
        let mut shape = Shape::NoHold;
        if !(peak <= bu && trough >= -bd) {
            let both = bu + bd;
            let holds = rest - (q + q) * both; // H
            let turned = change - q * (bu - bd) * both; // G
            let (above, below) = ((turned + bd * holds) / both, (bu * holds - turned) / both);
            let long = holds >= R::ZERO;
            let top_holds = if long { above >= R::ZERO } else { peak > bu };
            if long && above >= R::ZERO && below >= R::ZERO {
                shape = Shape::BothHold;
                (fall, peak, trough, top, bottom) = (both, bu, -bd, above, below);
            } else if top_holds {
                shape = Shape::TopHolds;
                fall = ((bu * rest - change) / q).sqrt();
                (peak, trough) = (bu, bu - fall);
                top = (rest - (q + q) * fall).at_least(R::ZERO);
            } else {
                shape = Shape::BottomHolds;
                fall = ((bd * rest + change) / q).sqrt();
                (peak, trough) = (fall - bd, -bd);
                bottom = (rest - (q + q) * fall).at_least(R::ZERO);
            }
        }
        let way = Change::of(a0, peak, gu * (peak - a0))
            .hold(peak, top)
            .then(peak, trough, gd * fall)
            .hold(trough, bottom)
            .then(trough, a1, gu * (a1 - trough));
        Some(Farthest {
            shape,
            peak,
            trough,
            top,
            bottom,
            falls: [gd * fall; 2],
            slack: (v0 * self.t - self.h) + way.displacement,
        })
    }

    /// The motion that cruises at the highest velocity.
    fn cruise(&self) -> Farthest<R> {
        let Frame {
            vmax,
            bu,
            bd,
            gu,
            gd,
            ..
        } = self.frame;
        let Ends { v0, a0, v1, a1 } = self.ends;
        let (peak, top) = self.frame.ramp(vmax - v0, a0, bu);
        let (depth, bottom) = self.frame.ramp(vmax - v1, -a1, bd);
        let up =
            Change::of(a0, peak, gu * (peak - a0))
                .hold(peak, top)
                .then(peak, R::ZERO, gd * peak);
        let down = Change::of(R::ZERO, -depth, gd * depth)
            .hold(-depth, bottom)
            .then(-depth, a1, gu * (a1 + depth));
        // By rounding the pause may be below 0.
        let at_vmax = (self.t - up.duration - down.duration).at_least(R::ZERO) + down.duration;
        Farthest {
            shape: Shape::Cruise,
            peak,
            trough: -depth,
            top,
            bottom,
            falls: [gd * peak, gd * depth],
            // The start counts while it lasts only: its velocity may be far beyond the highest one.
            slack: (vmax * at_vmax - self.h)
                + (v0 * up.duration + (up.displacement + down.displacement)),
        }
    }

    /// How long the acceleration rises at the start and at the end, s: `t1`, `t7`.
    fn rises(&self, farthest: &Farthest<R>) -> [R; 2] {
        let gu = self.frame.gu;
        [
            gu * (farthest.peak - self.ends.a0),
            gu * (self.ends.a1 - farthest.trough),
        ]
    }

    /// From both ends to the middle of the fall, s: `c0`, `c1`.
    fn middles([first, last]: [R; 2], farthest: &Farthest<R>) -> [R; 2] {
        let [after, before] = farthest.falls;
        [
            first + farthest.top + R::HALF * after,
            last + farthest.bottom + R::HALF * before,
        ]
    }

    /// The derivatives of the slack.
    pub fn derivatives(&self, farthest: &Farthest<R>) -> Derivatives<R> {
        if farthest.shape == Shape::Cruise {
            self.derivatives_of_cruise(farthest)
        } else {
            self.derivatives_without_cruise(farthest)
        }
    }

    fn derivatives_without_cruise(&self, farthest: &Farthest<R>) -> Derivatives<R> {
        let Frame {
            gu, gd, q, bu, bd, ..
        } = self.frame;
        let Ends { a0, v1, a1, .. } = self.ends;
        let rises @ [first, last] = self.rises(farthest);
        let [c0, c1] = Self::middles(rises, farthest);
        let per_fall = R::ONE / (farthest.peak - farthest.trough); // 1/u
        let half = R::HALF * per_fall / q; // 1/2qu
        let zero = R::ZERO;
        // The derivatives of `A`, `u` and `h1` with respect to `c`, then to `R`.
        let ([peak_c, fall_c, top_c], [peak_r, fall_r, top_r]) = match farthest.shape {
            Shape::NoHold => {
                let fall = R::HALF / q;
                let sum = farthest.peak + farthest.trough;
                (
                    [half, zero, zero],
                    [R::HALF * (fall - sum * half), fall, zero],
                )
            }
            Shape::TopHolds => (
                [zero, -half, per_fall],
                [zero, bu * half, R::ONE - bu * per_fall],
            ),
            Shape::BottomHolds => ([half, half, zero], [bd * half, bd * half, zero]),
            Shape::BothHold | Shape::Cruise => {
                ([zero, zero, per_fall], [zero, zero, bd * per_fall])
            }
        };
        let alpha = gu * peak_c + top_c + R::HALF * gd * fall_c;
        let beta = gu * peak_r + top_r + R::HALF * gd * fall_r;
        let nu = R::ONE - beta;
        let (k0, k1) = (c0 - first, c1 - last);
        let (first_c, first_r) = (gu * peak_c, gu * peak_r);
        let (last_c, last_r) = (gu * (fall_c - peak_c), gu * (fall_r - peak_r));
        let p = gu * (alpha * a0 + beta - R::ONE);
        let r = -gu * (alpha * a1 + beta);
        let sign = self.sign;
        let by_t = (v1 - c1 * a1) + (a1 - farthest.trough) * (c1 - R::HALF * last);
        Derivatives {
            first: self.first([first, last], [c0, c1], by_t),
            #[rustfmt::skip]
            second: [
                -alpha,
                p, k0 * gu * (first_c * a0 + first_r - R::ONE) + first * p,
                alpha, -p, -alpha,
                r, first * r - gu * k0 * (first_c * a1 + first_r),
                    -r, last * r - k1 * gu * (R::ONE - last_c * a1 - last_r),
                sign * beta, sign * (k0 * first_r + first * beta),
                    sign * nu, -sign * (k1 * last_r + last * nu), k1 * (fall_r - peak_r) - farthest.trough * nu,
            ],
        }
    }

    /// The two ramps know nothing of each other, and the duration adds to the cruise alone.
    fn derivatives_of_cruise(&self, farthest: &Farthest<R>) -> Derivatives<R> {
        let Ends { a0, a1, .. } = self.ends;
        let rises @ [first, last] = self.rises(farthest);
        let [c0, c1] = Self::middles(rises, farthest);
        let zero = R::ZERO;
        let ramp = |peak: R, limit: R, hold: R, a: R, rise: R, middle: R| {
            let Frame { gu, gd, q, .. } = self.frame;
            let (per_peak, per_hold) = if hold > zero {
                (zero, R::ONE / limit)
            } else if peak > zero {
                (R::HALF / (q * peak), zero)
            } else {
                (zero, zero)
            };
            let alpha = (gu + R::HALF * gd) * per_peak + per_hold;
            let mixed = gu * (alpha * a - R::ONE);
            let of_a = (middle - rise) * gu * (gu * per_peak * a - R::ONE) + rise * mixed;
            [-alpha, mixed, of_a]
        };
        let start = ramp(farthest.peak, self.frame.bu, farthest.top, a0, first, c0);
        // In the other order of time the acceleration has the other sign.
        let [vv, va, aa] = ramp(
            -farthest.trough,
            self.frame.bd,
            farthest.bottom,
            -a1,
            last,
            c1,
        );
        let [v0v0, a0v0, a0a0] = start;
        Derivatives {
            first: self.first([first, last], [c0, c1], self.frame.vmax),
            #[rustfmt::skip]
            second: [
                v0v0,
                a0v0, a0a0,
                zero, zero, vv,
                zero, zero, -va, aa,
                zero, zero, zero, zero, zero,
            ],
        }
    }

    fn first(&self, [first, last]: [R; 2], [c0, c1]: [R; 2], by_t: R) -> [R; 5] {
        let sign = self.sign;
        [
            sign * c0,
            sign * first * (c0 - R::HALF * first),
            sign * c1,
            -sign * last * (c1 - R::HALF * last),
            by_t,
        ]
    }
}

impl<R: Real> Frame<R> {
    /// The fastest ramp that raises the velocity by `above`, from the acceleration `a` to 0: its peak, and how long the peak holds, s.
    fn ramp(&self, above: R, a: R, limit: R) -> (R, R) {
        // An end may be beyond `vmax` by rounding.
        let rise = (above + R::HALF * self.gu * a * a).at_least(R::ZERO);
        let peak = if rise > R::ZERO {
            (rise / self.q).sqrt()
        } else {
            rise
        };
        if peak > limit {
            (limit, (rise - self.q * limit * limit) / limit)
        } else {
            (peak.at_least(a), R::ZERO)
        }
    }
}

/// The derivatives by velocity and acceleration at the start and at the end, and by the duration.
pub(super) struct Derivatives<R> {
    /// By `v0`, `a0`, `v1`, `a1`, `t`.
    pub first: [R; 5],
    /// By two of them, row by row up to the diagonal.
    pub second: [R; 15],
}

#[cfg(test)]
mod tests {
    use super::{Border, Ends};
    use crate::limits::Limits;

    /// From standstill to standstill the farthest motion of 4 s gets 2 units far: each second of jerk changes the acceleration by 1.
    #[test]
    fn a_border_is_no_place_for_a_plan() {
        let limits = Limits::symmetric(1.0, 2.0, 3.0);
        let rest = Ends {
            v0: 0.0,
            a0: 0.0,
            v1: 0.0,
            a1: 0.0,
        };
        for (h, slack) in [(2.0, None), (1.75, Some(0.25))] {
            let [upper, lower] = Border::both(&limits, rest, 4.0, h);
            assert_eq!(upper.farthest().map(|farthest| farthest.slack), slack);
            assert_eq!(
                lower.farthest().map(|farthest| farthest.slack),
                Some(h + 2.0)
            );
        }
    }
}
