//! The motion of a given duration that covers the largest displacement, and the first such motion that covers the wanted one.
//! `docs/planner.md` has the theory: the fastest motion over a displacement lies on such a border. The motion on the upper border accelerates,
//! then decelerates: jerk up, (hold), jerk down, (hold), jerk up. The lower border is the upper border of the mirrored axis.
//!
//! The acceleration is 0 at both ends. An end with an acceleration becomes such an end if the acceleration goes to 0: slid along the
//! parabola of the jerk to where it is 0. The formulas hold for these ends.
//!
//! All quantities here are divided by the jerk, which leaves powers of time: an acceleration is in s, a velocity in s^2, a
//! displacement in s^3. So a jerk part lasts as long as the acceleration that it adds is large.

use crate::real::Real;
use crate::roots::{convex_root, larger_root};

/// The ends and limits of the motions on the upper border. The acceleration is 0 at both ends.
#[derive(Clone, Copy)]
pub(crate) struct ScaledBorder<R> {
    /// Velocity at the start.
    pub v0: R,
    /// Change of velocity from the start to the end: one difference, taken before the division.
    pub dv: R,
    /// Highest acceleration and deceleration.
    pub limit: R,
}

/// A ramp from one velocity to another, with the acceleration 0 at both ends.
#[derive(Clone, Copy)]
pub(crate) struct ScaledRamp<R> {
    /// Duration of each jerk part, which is the acceleration reached.
    pub tj: R,
    /// Duration of the ramp.
    pub t: R,
}

impl<R: Real> ScaledRamp<R> {
    /// The fastest ramp over the change of velocity `dv`, which is not below 0.
    pub fn over(dv: R, limit: R) -> Self {
        if dv < limit * limit {
            let tj = dv.sqrt();
            Self { tj, t: tj + tj }
        } else {
            Self { tj: limit, t: limit + dv / limit }
        }
    }
}

impl<R: Real> ScaledBorder<R> {
    /// The axis seen from the other side.
    pub fn mirrored(self) -> Self {
        Self { v0: -self.v0, dv: -self.dv, ..self }
    }

    /// Displacement of the ramp that leads from the start straight to the end. Its duration allows no other displacement.
    pub fn direct(&self) -> R {
        self.mean() * ScaledRamp::over(self.dv.abs(), self.limit).t
    }

    /// The two ramps by way of the velocity `v0 + room`, and their displacement.
    pub fn by_way_of(&self, room: R) -> ([ScaledRamp<R>; 2], R) {
        let up = ScaledRamp::over(room, self.limit);
        let down = ScaledRamp::over((room - self.dv).at_least(R::ZERO), self.limit);
        let change = R::HALF * room * (up.t + down.t) + R::HALF * self.dv * down.t;
        ([up, down], self.v0 * (up.t + down.t) + change)
    }

    /// The two ramps of the first motion on the border that covers the displacement `h`, which is not below `direct`. The peak velocity has no limit.
    pub fn first_over(&self, h: R, direct: R) -> [ScaledRamp<R>; 2] {
        // As the duration grows, the ramp with the larger change of velocity holds the limit first, and later the other one too.
        let up_first = self.dv >= R::ZERO;
        let hold = Hold::of(self, up_first);
        let beyond = h - hold.least();
        if beyond >= hold.displacement(hold.limit).0 {
            return self.both_holds(h);
        }
        // Where the hold begins. There is no such place if the limit is infinite, or if the direct ramp has a hold too.
        let begins = hold.begins();
        let apart = self.dv.abs().sqrt();
        let y = hold.limit + begins - apart;
        let beyond_direct = (h - direct).at_least(R::ZERO);
        if self.limit < R::INFINITY && !(begins > R::ZERO && beyond_direct < self.no_hold(apart, y).0) {
            let [held, other] = hold.ramps(beyond);
            return if up_first { [held, other] } else { [other, held] };
        }
        self.without_hold(beyond_direct, apart, y)
    }

    /// The ramps over a displacement beyond the direct one if none of them holds. `y`, by which the acceleration falls more than in
    /// the direct ramp, is at most `most`.
    fn without_hold(&self, beyond: R, apart: R, most: R) -> [ScaledRamp<R>; 2] {
        let bound = self.no_hold_bound(beyond, apart).at_most(most);
        let y = convex_root(R::ZERO, bound, beyond, |y| self.no_hold(apart, y));
        let u = apart + y;
        let ratio = if u > R::ZERO { self.dv / u } else { R::ZERO };
        [u + ratio, u - ratio].map(|twice| {
            let tj = R::HALF * twice.at_least(R::ZERO);
            ScaledRamp { tj, t: tj + tj }
        })
    }

    fn mean(&self) -> R {
        self.v0 + R::HALF * self.dv
    }

    /// Without a hold: the displacement beyond the direct one, and its derivative. In the middle of the motion the acceleration falls
    /// by `u = apart + y`; in the direct ramp it falls by `apart = sqrt(|dv|)`. The displacement is convex.
    fn no_hold(&self, apart: R, y: R) -> (R, R) {
        let quarter_y = R::HALF * R::HALF * y;
        let ratio = if apart > R::ZERO { apart / (apart + y) } else { R::ZERO };
        let slope = self.direct_slope();
        let cubic = y + apart * (R::from(3) - ratio);
        let its_slope = R::from(3) * y + apart * (R::from(6) - ratio * (R::ONE + ratio));
        (y * (slope + quarter_y * cubic), slope + quarter_y * its_slope)
    }

    /// The derivative of the displacement in the direct ramp: twice the higher velocity of both ends.
    fn direct_slope(&self) -> R {
        R::from(2) * (self.v0 + self.dv.at_least(R::ZERO))
    }

    /// Not below the `y` of a displacement beyond the direct one, and above it by a small factor: the displacement is not below
    /// `y (s + apart y/2 + y^2/4)`, where `s` is its slope in the direct ramp.
    fn no_hold_bound(&self, beyond: R, apart: R) -> R {
        let slope = self.direct_slope();
        if slope >= R::ZERO {
            let cubic = (R::from(4) * beyond).cube_root_above();
            let quadratic = ((beyond + beyond) / apart).sqrt();
            return (beyond / slope).at_most(quadratic.at_most(cubic));
        }
        let cubic = (R::from(8) * beyond).cube_root_above().at_least((R::from(8) * -slope).sqrt());
        let quadratic = (R::from(4) * beyond / apart).sqrt().at_least(R::from(4) * -slope / apart);
        quadratic.at_most(cubic)
    }

    /// With both holds the displacement is a quadratic in the duration of the first ramp.
    fn both_holds(&self, h: R) -> [ScaledRamp<R>; 2] {
        let Self { v0, dv, limit } = *self;
        // The second ramp lasts so much longer.
        let offset = -dv / limit;
        let half_b = v0 / limit - R::HALF * limit;
        let c = offset * (v0 + R::HALF * (dv - limit * limit)) - h;
        let root = larger_root(half_b, c / limit);
        // Where one ramp is hardly more than the direct one, the root may come out shorter than its jerk parts by rounding.
        let least = limit + limit;
        let up = root.at_least(least.at_least(least - offset));
        let down = (up + offset).at_least(least);
        [up, down].map(|t| ScaledRamp { tj: limit, t })
    }
}

/// One ramp holds the limit, the other reaches less. Reversed in time, the second ramp is the first.
struct Hold<R> {
    limit: R,
    /// Change of velocity from the end of the ramp that holds to the end of the other.
    dv: R,
    /// Velocity at the end of the other ramp.
    end: R,
    /// Mean of the velocities at both ends.
    mean: R,
}

impl<R: Real> Hold<R> {
    fn of(border: &ScaledBorder<R>, up: bool) -> Self {
        let &ScaledBorder { v0, dv, limit } = border;
        let (dv, end) = if up { (dv, v0 + dv) } else { (-dv, v0) };
        Self { limit, dv, end, mean: border.mean() }
    }

    /// The acceleration that the other ramp reaches where the hold begins; 0 if the direct ramp has a hold too.
    fn begins(&self) -> R {
        (self.limit * self.limit - self.dv).at_least(R::ZERO).sqrt()
    }

    /// The ramp that holds and the other one, over a displacement beyond the least one.
    fn ramps(&self, beyond: R) -> [ScaledRamp<R>; 2] {
        let bound = self.bound(beyond).at_most(self.limit);
        let w = convex_root(self.begins(), bound, beyond, |w| self.displacement(w));
        let held = ScaledRamp { tj: self.limit, t: self.limit + (w * w + self.dv) / self.limit };
        [held, ScaledRamp { tj: w, t: w + w }]
    }

    /// The displacement where the other ramp reaches no acceleration.
    fn least(&self) -> R {
        let Self { limit, dv, end, mean, .. } = *self;
        limit * end + dv / limit * (mean - R::HALF * limit * limit)
    }

    /// The displacement beyond the least one, and its derivative, where the other ramp reaches the acceleration `w`. Where the
    /// displacement grows, it is convex.
    fn displacement(&self, w: R) -> (R, R) {
        let Self { limit, end, .. } = *self;
        let u = limit + w;
        let ratio = w / limit;
        (ratio * (end * (u + limit) + R::HALF * u * u * w), (R::ONE + ratio) * (end + end + w * (u + w)))
    }

    /// Not below the `w` of a displacement beyond the least one, and above it by a small factor.
    fn bound(&self, beyond: R) -> R {
        let against = (-(self.end + self.end)).at_least(R::ZERO);
        let product = against + (against * against + R::from(2) * self.limit * beyond.at_least(R::ZERO)).sqrt();
        let bound = (product / self.limit).at_most(product.sqrt());
        if self.end > R::ZERO { bound.at_most(beyond / (self.end + self.end)) } else { bound }
    }
}
