//! The piece of the border on which the highest acceleration holds.

use super::easing::Easing;
use crate::interval::{border::Border, profile::Profile, ramp::PerJerk};
use crate::real::Real;
use crate::roots::first_zero;

pub(crate) struct Held<'a, R> {
    motion: &'a mut Profile<R>,
    per_jerk: PerJerk<R>,
    /// The highest acceleration.
    bu: R,
    /// How far the acceleration falls in the first motion.
    u: R,
    /// The slope of the first motion.
    pub(super) s: R,
    /// The derivative of the slope in the first motion.
    k: R,
}

impl<'a, R: Real> Held<'a, R> {
    pub fn new(border: &Border<R>, motion: &'a mut Profile<R>) -> Self {
        let Profile { fall: u, trough: y, .. } = *motion;
        let PerJerk { gu, gd } = border.per_jerk;
        Self {
            per_jerk: border.per_jerk,
            bu: border.limits.amax,
            u,
            s: border.slope(motion),
            k: R::HALF * gd * (u - y) - gu * y,
            motion,
        }
    }

    pub fn displacement(&self, x: R) -> (R, R) {
        let Self { bu, u, s, k, .. } = *self;
        let (half, third, q) = (R::HALF, R::SIXTH + R::SIXTH, self.per_jerk.q());
        let cubic = q * x * (third * u + half * half * x);
        let sum = s * (u + half * x) + x * (k * (half * u + third * x) + cubic);
        let slope = s + x * (k + q * x);
        let factor = (q + q) / bu;
        (factor * x * sum, factor * (u + x) * slope)
    }

    /// Where the displacement first stops rising, or falling: the slope is a quadratic.
    pub fn turning_point(&self) -> Option<R> {
        let q = self.per_jerk.q();
        first_zero(R::HALF * self.k / q, self.s / q)
    }

    /// Not below how much farther than `from`, which is 0 or a turning point, the `x` of a displacement from there is, if the displacement rises and is
    /// convex from there: each of its terms alone would have to reach farther. At a turning point the slope is 0.
    pub fn bound(&self, from: R, displacement: R) -> R {
        let (bu, q) = (self.bu, self.per_jerk.q());
        let (u, k) = (self.u + from, self.k + (q + q) * from);
        let slope = if from > R::ZERO { R::ZERO } else { self.s.at_least(R::ZERO) }; // -0 too
        let reduced = displacement / q;
        let fourth = (reduced + reduced) / bu / q;
        let reduced = reduced * bu;
        let linear = reduced / (slope * u);
        let square = reduced / (k * u);
        let fourth = (bu * fourth.sqrt()).sqrt();
        (R::HALF * linear).at_most(square.sqrt().at_most(fourth))
    }

    pub fn end_of_easing(&self) -> (R, Easing) {
        let Profile { top, trough: y, .. } = *self.motion;
        let product = top * self.bu / self.per_jerk.q();
        let d = y * y - product;
        if d >= R::ZERO { (product / (y + d.sqrt()), Easing::HoldEnds) } else { (y, Easing::Vanishes) }
    }

    pub fn go_to(&mut self, x: R) {
        let Profile { top, trough: y, .. } = *self.motion;
        let longer = self.per_jerk.q() * x * (x - (y + y)) / self.bu;
        self.motion.top = (top + longer).at_least(R::ZERO);
        self.motion.fall_by(x, R::ZERO, x);
    }
}
