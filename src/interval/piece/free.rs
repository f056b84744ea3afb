//! The piece of the border on which no acceleration holds.

use super::easing::Easing;
use crate::interval::{border::Border, profile::Profile, ramp::PerJerk};
use crate::real::Real;
use crate::roots::first_zero;

pub(crate) struct Free<'a, R> {
    motion: &'a mut Profile<R>,
    per_jerk: PerJerk<R>,
    /// How far the acceleration falls in the first motion.
    u: R,
    /// The slope of the first motion.
    pub(super) s: R,
}

impl<'a, R: Real> Free<'a, R> {
    pub fn new(border: &Border<R>, motion: &'a mut Profile<R>) -> Self {
        Self { per_jerk: border.per_jerk, u: motion.fall, s: border.slope(motion), motion }
    }

    pub fn displacement(&self, x: R) -> (R, R) {
        let Self { u, s, .. } = *self;
        let PerJerk { gu, gd } = self.per_jerk;
        let (half, three) = (R::HALF, R::from(3));
        let [first, last] = self.parts(x);
        let quarter_gu = half * half * gu;
        let third = R::SIXTH + R::SIXTH;
        let rises = quarter_gu * (first * last * (u + x) - (third + third) * x);
        let sum = rises + R::SIXTH * gd * (three * u + x);
        let growth = quarter_gu * first * last + half * gd;
        let twice_slope = s + s + x * (u + u + x) * growth;
        let q = self.per_jerk.q();
        (q * x * (s + s + x * sum), q * twice_slope)
    }

    /// What the first rise and the last one grow by, for each half of `x`: `(x - 2 trough)/(u + x)` and `(x + 2 peak)/(u + x)`. Where the
    /// acceleration changes its sign, no digits cancel in them.
    fn parts(&self, x: R) -> [R; 2] {
        let Profile { peak, trough, .. } = *self.motion;
        let fall = self.u + x;
        let part = |part: R| if fall > R::ZERO { part / fall } else { R::ZERO };
        [part(x - (trough + trough)), part(x + (peak + peak))]
    }

    /// `(gu + 2 gd)/12`
    fn c(&self) -> R {
        R::SIXTH * (R::HALF * self.per_jerk.gu + self.per_jerk.gd)
    }

    /// Where the displacement first stops rising, or falling. The product of the slope and of the square that the acceleration falls by is a
    /// quadratic in this square. In the unit of this formula nothing is out of range.
    pub fn turning_point(&self) -> Option<R> {
        let Self { u, s, .. } = *self;
        let r = self.motion.peak + self.motion.trough;
        let cubic = R::from(3) * self.c();
        let unit = (s.abs() / cubic).sqrt();
        let unit = u.at_least(r.abs()).at_least(unit);
        let (u, r) = (u / unit, r / unit);
        let s = s / (cubic * unit) / unit;
        let square = u * u;
        let quarter_gu = R::HALF * R::HALF * self.per_jerk.gu / cubic;
        let p = R::HALF * (square - quarter_gu * r * r) + s;
        let zero = first_zero(p, (s + s) * square)?;
        Some(unit * zero / ((square + zero).sqrt() + u))
    }

    /// Not below how much farther than `from` a displacement is: see [`Held::bound`](super::held::Held::bound).
    pub fn bound(&self, from: R, displacement: R) -> R {
        let slope = if from > R::ZERO { R::ZERO } else { self.s.at_least(R::ZERO) }; // -0 too
        let reduced = displacement / self.per_jerk.q();
        let linear = reduced / slope;
        let square = (reduced + reduced) / (self.per_jerk.gd * (self.u + from));
        // The third power of a time, not of an acceleration, is in range in any unit of length.
        let c = self.c();
        let cube = (reduced * c * c).cube_root_above() / c;
        (R::HALF * linear).at_most(square.sqrt().at_most(cube))
    }

    /// The lowest trough has the square of this function: then no rise is left at the start. Of two forms, it takes the one whose terms are small.
    pub fn end_of_easing(&self, a0: R) -> (R, Easing) {
        let u = self.u;
        let Profile { first: rise, peak, trough, .. } = *self.motion;
        let trough = trough.at_least(R::ZERO); // by rounding
        let (change, sum, remains) = if rise < u { (rise, peak + a0, trough) } else { (u, peak + trough, a0) };
        let square = remains * remains - change * sum;
        if a0 > R::ZERO && square > R::ZERO {
            let end = change * (sum / (remains + square.sqrt()) - R::ONE);
            (end, Easing::IsFollowedByGap)
        } else {
            let least_peak = (u * (peak + trough)).sqrt();
            (least_peak - u, Easing::Vanishes)
        }
    }

    pub fn go_to(&mut self, x: R) {
        let half = R::HALF * x;
        let [first, last] = self.parts(x);
        self.motion.fall_by(x, half * first, half * last);
    }
}
