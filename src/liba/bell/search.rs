//! The search for the acceleration of a move without cruise, and its short cut.

use super::Bell;
use crate::real::{Real, target};

/// What one trial acceleration means for the two ramps.
pub(super) enum Fit {
    /// Both ramps last long enough to reach the trial acceleration.
    Both,
    /// The acceleration phase would last less than no time.
    DownOnly,
    /// The deceleration phase would last less than no time.
    UpOnly,
    /// One ramp is too short to reach the trial acceleration.
    TooSteep,
}

/// Where the search goes on.
struct Round<R> {
    trial: R,
    /// Step that led to the trial.
    step: R,
    /// The search ends here with a single ramp beyond doubt.
    single: bool,
}

impl<R: Real> Bell<R> {
    /// Looks for the highest acceleration whose two ramps fit into the displacement `h`, by halving a step from `am` down.
    /// Writes two ramps if both fit, and tells which do. The fields `am` and `dm` hold `am` and `am/16`.
    ///
    /// At most 1076 rounds for `f64` and 151 for `f32`: the step starts finite and every round halves it.
    // The many variables of the search would slow down plans with a cruise phase, if the compiler joined both.
    #[inline(never)]
    pub(super) fn search(&mut self, am: R, h: R, v0: R, v1: R) -> Fit {
        let two = R::from(2);
        let s = v0 + v1;
        let q = two * (v0 * v0 + v1 * v1);
        let Round { mut trial, mut step, single } = self.skip_plain_rounds(am, h, v0, v1, s, q);
        if single {
            // The single ramp overwrites every other duration of this round.
            self.taj = trial / self.jm;
            self.tdj = self.taj;
            return if v0 > v1 { Fit::DownOnly } else { Fit::UpOnly };
        }
        let (two_v0, two_v1) = (two * v0, two * v1);
        let four_h = R::from(4) * h;
        let (fit, tj) = loop {
            let tj = trial / self.jm;
            let tj2 = two * tj;
            let k = trial * tj;
            let r = k * k + q + (four_h - tj2 * s) * trial;
            let k = k + r.sqrt();
            let den = two * trial;
            self.ta = (k - two_v0) / den;
            let fit = if self.ta < R::ZERO {
                Fit::DownOnly
            } else {
                self.td = (k - two_v1) / den;
                if self.td < R::ZERO {
                    Fit::UpOnly
                } else if self.ta >= tj2 && self.td >= tj2 {
                    Fit::Both
                } else {
                    Fit::TooSteep
                }
            };
            let half_step = step * R::HALF;
            if matches!(fit, Fit::TooSteep) {
                trial = trial - half_step;
            } else if trial == am || step < self.dm {
                break (fit, tj);
            } else {
                trial = trial + half_step;
            }
            step = half_step;
            // Not `step <= EPSILON`: a NaN step ends the search too.
            #[expect(clippy::neg_cmp_op_on_partial_ord, reason = "a NaN step ends the search")]
            if !(step > R::EPSILON) {
                break (Fit::TooSteep, tj);
            }
        };
        (self.taj, self.tdj) = (tj, tj);
        if matches!(fit, Fit::Both) {
            self.am = trial;
            self.dm = -trial;
            self.vm = v0 + trial * (self.ta - tj);
        }
        fit
    }

    /// Passes over the rounds whose outcome is plain. `s = v0 + v1` and `q = 2 (v0^2 + v1^2)`.
    ///
    /// A round that goes on needs only its verdict. With `k = am^2/jm` and `w = |v0 - v1|` its root is that of `r = (k - s)^2 + w^2 + 4 h am`. Its shorter
    /// ramp lasts `(k + sqrt(r) - (s + w)) / (2 am)` and is too steep from 0 to below `2 am/jm`. So the round compares `sqrt(r)` with `x = s + w - k` and
    /// with `x = s + w + 3 k`. Where `x < 0`, `r >= x^2`, so it may compare `r` with `x^2`: too steep is `-w k <= 2 h am - w s < k (4 k + 4 s + 3 w)`.
    /// This comparison takes no root, and one division serves all rounds.
    ///
    /// With `size = 2 h am + 4 k^2 + q` and `u = EPSILON/2`, rounding moves these comparisons by at most 31 `u size` in the
    /// round itself and 20 `u size` here: a difference of more than 128 `u size` is beyond doubt. The guards keep off overflow
    /// and what underflow could move. `docs/search.md` has the proof.
    fn skip_plain_rounds(&self, am: R, h: R, v0: R, v1: R, s: R, q: R) -> Round<R> {
        // A search from at least `DOUBT` is settled when its step runs out, so its last round writes all durations.
        let (mut trial, mut step) = (am, am);
        if !(target::skipping_rounds_pays(R::HAS_UNIT) && am >= R::DOUBT && h >= R::EPSILON) {
            return Round { trial, step, single: false };
        }
        let two = R::from(2);
        let w = (v0 - v1).abs();
        let half_w = w * R::HALF;
        let slope = w + half_w + two * s;
        let ws = w * s;
        let two_h = two * h;
        let two_per_jm = two / self.jm;
        loop {
            let half_step = step * R::HALF;
            let distance = trial * two_h;
            let k2 = trial * two_per_jm * trial;
            let size = distance + k2 * k2 + q;
            let doubt = size * R::DOUBT;
            let excess = distance - ws;
            let above_shortest = excess + k2 * half_w;
            let below_longest = k2 * (k2 + slope) - excess;
            let margin = if below_longest < above_shortest { below_longest } else { above_shortest };
            let clear = size < R::HUGE && half_step > R::EPSILON;
            if clear && margin > doubt {
                trial = trial - half_step;
            } else if clear && margin < -doubt && trial != am && step >= self.dm {
                trial = trial + half_step;
            } else {
                return Round { trial, step, single: clear && above_shortest < -doubt };
            }
            step = half_step;
        }
    }
}
