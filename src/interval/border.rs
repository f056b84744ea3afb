//! The motion of a given duration that covers the largest displacement. The fastest motion over a displacement lies on the border of the first
//! interval that holds the displacement. `docs/planner.md` has the letters: `bu` and `bd` are the highest acceleration and the highest deceleration.
//!
//! On the upper border the acceleration rises, (holds), falls, (holds) and rises. If the highest velocity is reached, the axis cruises in
//! the middle of the fall. The lower border is the upper border of the mirrored axis.

use super::profile::{MOST_SEGMENTS, Profile, Segment};
use super::ramp::{Change, Fitted, Passed, PerJerk, Ramp, seen};
use super::rounding::{of_check, of_formula, of_state};
use crate::limits::Limits;
use crate::real::Real;
use crate::roots::larger_root;

/// The ends and the limits of the motions on the border: velocity and acceleration `v0` and `a0` at the start, `v1` and `a1` at the end.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Border<R> {
    pub v0: R,
    pub a0: R,
    pub v1: R,
    pub a1: R,
    /// Change of velocity from the start to the end. As `above` and `below` it is formed once, from the arguments.
    pub dv: R,
    /// From the velocity at the start up to the highest one.
    pub above: R,
    /// From the lowest velocity up to the one at the start.
    pub below: R,
    /// How much the velocity changes while the accelerations at both ends go to 0, in sum.
    pub eased: R,
    pub limits: Limits<R>,
    pub per_jerk: PerJerk<R>,
}

impl<R: Real> Border<R> {
    /// The motions between velocities and accelerations within the limits.
    pub fn between(ends: [[R; 2]; 2], limits: &Limits<R>) -> Self {
        Self::new(ends, limits, PerJerk::of(limits))
    }

    /// As [`Border::between`], with the reciprocals of the jerks.
    pub fn new([[v0, a0], [v1, a1]]: [[R; 2]; 2], limits: &Limits<R>, per_jerk: PerJerk<R>) -> Self {
        Self {
            v0,
            a0,
            v1,
            a1,
            dv: v1 - v0,
            above: limits.vmax - v0,
            below: v0 - limits.vmin,
            eased: per_jerk.straight(a0, R::ZERO).abs() + per_jerk.straight(R::ZERO, a1).abs(),
            limits: *limits,
            per_jerk,
        }
    }

    /// With another velocity at the start.
    pub fn starting_faster(self, change: R) -> Self {
        Self {
            v0: self.v0 + change,
            dv: self.dv - change,
            above: self.above - change,
            below: self.below + change,
            ..self
        }
    }

    #[inline(never)]
    pub fn mirrored(self) -> Self {
        Self {
            v0: -self.v0,
            a0: -self.a0,
            v1: -self.v1,
            a1: -self.a1,
            dv: -self.dv,
            above: self.below,
            below: self.above,
            eased: self.eased,
            limits: self.limits.mirrored(),
            per_jerk: self.per_jerk.mirrored(),
        }
    }

    pub fn mirrored_if(self, mirrored: bool) -> Self {
        if mirrored { self.mirrored() } else { self }
    }

    /// The motions in the other order of time, which have the same displacements.
    #[inline(never)]
    pub fn reversed(self) -> Self {
        Self {
            v0: self.v1,
            a0: -self.a1,
            v1: self.v0,
            a1: -self.a0,
            dv: -self.dv,
            above: self.above - self.dv,
            below: self.below + self.dv,
            limits: self.limits.reversed(),
            ..self
        }
    }

    /// The change of velocity beyond that of a straight change of the acceleration.
    pub fn beyond_straight(&self) -> R {
        self.dv - self.per_jerk.straight(self.a0, self.a1)
    }

    /// Whether a change of velocity is more than rounding.
    fn is_real(&self, change: R) -> bool {
        change.abs() > self.rounding_of_velocity()
    }

    /// The sum of the magnitudes of the velocities at both ends, and of `eased`.
    fn speeds(&self) -> R {
        self.v0.abs() + self.v1.abs() + self.eased
    }

    /// The rounding error of the velocities at both ends, and of the velocities once the accelerations are 0.
    pub fn rounding_of_velocity(&self) -> R {
        of_state(self.speeds())
    }

    /// Whether a change of velocity is the rounding error of one that a plan gave shortly before, when it was higher. A check accepts it.
    pub fn is_left_over(&self, change: R) -> bool {
        change.abs() <= of_state(self.speeds() + R::from(3) * self.eased)
    }

    /// The rounding error of the difference of both velocities and of the area of a fall.
    pub fn rounding_of_area(&self) -> R {
        of_formula(self.speeds())
    }

    /// The rounding error of a displacement of this duration, from that of the states at both ends: of the positions, whose magnitudes have the
    /// sum `positions`, and of what the velocities and the accelerations travel. It is 0 between standstills, where no rounding error makes an axis overshoot.
    #[inline(never)] // for its size: it is asked in several places
    pub fn rounding_of_displacement(&self, duration: R, positions: R) -> R {
        let (a0, a1) = (self.a0.abs(), self.a1.abs());
        let added = self.eased.at_most(a0.at_least(a1) * duration);
        let speed = self.v0.abs().at_least(self.v1.abs()) + added;
        let of_end = of_state(positions + speed * duration);
        if speed > R::ZERO { of_end + of_end } else { R::ZERO }
    }

    /// The fastest change of velocity: the direct ramp. Its duration allows no other displacement. The argument comes from [`Border::beyond_straight`].
    pub fn direct(&self, beyond: R) -> Ramp<R> {
        // Where both accelerations point against the ramp, the least ramp is a long one. A rounding is no reason for such a ramp.
        let against = self.a0 * beyond < R::ZERO && self.a1 * beyond < R::ZERO;
        if beyond == R::ZERO || against && !self.is_real(beyond) {
            Ramp::straight(self.a0, self.a1)
        } else {
            self.ramp(beyond, beyond < R::ZERO)
        }
    }

    /// The shortest duration of all: that of the direct ramp, s.
    pub fn shortest(&self) -> R {
        self.passed(&self.direct(self.beyond_straight())).duration
    }

    /// How much faster the start is to be for the direct ramp to last `t`; 0 if it lasts no longer, or if a check sees the step at the start.
    pub fn faster_for(&self, t: R) -> R {
        let direct = self.direct(self.beyond_straight());
        let shorter = t - self.passed(&direct).duration;
        let most = of_check(self.speeds() + self.limits.speed_within(t));
        // The peak of a shorter ramp is lower, so no limit decides.
        let fitted = direct.longer(shorter, R::INFINITY, most, self.per_jerk.mirrored_if(direct.mirrored));
        fitted.filter(|_| shorter < R::ZERO).map_or(R::ZERO, |fitted| -fitted.faster.negate_if(direct.mirrored))
    }

    /// How much faster the start is to be for a straight change of the acceleration; 0 if that is more than rounding.
    pub fn faster_for_straight(&self) -> R {
        let beyond = self.beyond_straight();
        if self.is_real(beyond) { R::ZERO } else { beyond }
    }

    /// The change of velocity after the gap: it turns against both accelerations.
    pub fn after_gap(&self) -> Ramp<R> {
        self.ramp(self.beyond_straight(), self.a0 >= R::ZERO)
    }

    /// The change of velocity by way of a higher acceleration, in the mirrored axis if `mirrored`.
    fn ramp(&self, beyond: R, mirrored: bool) -> Ramp<R> {
        let [beyond, a0, a1] = seen([beyond, self.a0, self.a1], mirrored);
        let limit = if mirrored { -self.limits.amin } else { self.limits.amax };
        let ramp = Ramp::over(beyond, a0, a1, limit, self.per_jerk.mirrored_if(mirrored));
        ramp.mirrored_if(mirrored)
    }

    /// The straight change of the acceleration, in the mirrored axis if `mirrored`.
    pub fn straight(&self, mirrored: bool) -> Ramp<R> {
        let (a0, a1) = (self.a0.negate_if(mirrored), self.a1.negate_if(mirrored));
        Ramp::straight(a0, a1).mirrored_if(mirrored)
    }

    /// The ramp that makes up for what its displacement `lacks`. The end stays, so the start is the slower. `None` if that is more than rounding.
    pub fn fitted(&self, ramp: &Ramp<R>, lacks: R) -> Option<Fitted<R>> {
        let mirrored = ramp.mirrored;
        let (v0, lacks) = (self.v0.negate_if(mirrored), lacks.negate_if(mirrored));
        let limit = if mirrored { -self.limits.amin } else { self.limits.amax };
        let per_jerk = self.per_jerk.mirrored_if(mirrored);
        // While the axis holds its highest acceleration longer, it travels at its velocity there, and before at a lower velocity.
        let faster = v0 - R::HALF * per_jerk.gu * ramp.rise * ramp.rise;
        let most = self.rounding_of_velocity();
        let Fitted { ramp, faster } = ramp.longer(lacks / faster, limit, most, per_jerk)?;
        Some(Fitted { ramp, faster: faster.negate_if(mirrored) })
    }

    /// The straight change of the acceleration that lasts until its displacement is what it `lacks` farther. `None` if it has no such duration, or
    /// if the acceleration at its end is off by more than rounding.
    pub fn timed(&self, straight: &Ramp<R>, lacks: R) -> Option<Ramp<R>> {
        let longer = lacks / self.v0;
        let PerJerk { gu, gd } = self.per_jerk;
        let (rises, falls) = if straight.rise > R::ZERO { (longer / gu, R::ZERO) } else { (R::ZERO, longer / gd) };
        let is_rounding = (rises + falls).abs() <= of_state(self.a0.abs() + self.a1.abs());
        let (rise, fall) = (straight.rise + rises, straight.fall + falls);
        let is_ramp = rise >= R::ZERO && fall >= R::ZERO;
        (is_rounding && is_ramp).then_some(Ramp { rise, fall, ..*straight })
    }

    pub fn passed(&self, ramp: &Ramp<R>) -> Passed<R> {
        let mirrored = ramp.mirrored;
        let [v0, a0, a1] = seen([self.v0, self.a0, self.a1], mirrored);
        let per_jerk = self.per_jerk.mirrored_if(mirrored);
        let Passed { duration, displacement } = ramp.passed(v0, a0, a1, per_jerk);
        Passed { duration, displacement: displacement.negate_if(mirrored) }
    }

    #[inline(never)] // for its size: it is asked in several places
    pub fn profile(&self, ramp: &Ramp<R>) -> Profile<R> {
        let Ramp { mirrored, rise, peak, hold, fall } = *ramp;
        if mirrored {
            Profile { peak: self.a0, fall: rise, trough: -peak, bottom: hold, last: fall, ..Profile::default() }
        } else {
            Profile { first: rise, peak, top: hold, fall, trough: self.a1, ..Profile::default() }
        }
    }

    /// The fastest ramps from the start up to the highest velocity, and from the end up to it in the other order of time.
    pub fn ramps_to_vmax(&self) -> [Ramp<R>; 2] {
        let per_jerk = self.per_jerk;
        let (a0, a1) = (self.a0, -self.a1);
        let up = self.above - per_jerk.straight(a0, R::ZERO);
        let down = self.above - self.dv - per_jerk.straight(a1, R::ZERO);
        [
            Ramp::over(up, a0, R::ZERO, self.limits.amax, per_jerk),
            Ramp::over(down, a1, R::ZERO, -self.limits.amin, per_jerk),
        ]
    }

    /// The motion that cruises for the duration `cruise` between the ramps to the highest velocity.
    pub fn by_way_of_vmax([up, down]: [Ramp<R>; 2], cruise: R) -> Profile<R> {
        Profile {
            mirrored: false,
            first: up.rise,
            peak: up.peak,
            top: up.hold,
            fall: up.fall + down.fall,
            cruise,
            trough: -down.peak,
            bottom: down.hold,
            last: down.rise,
        }
    }

    /// The motion of the duration `t`, not below that of the direct ramp, that covers the largest displacement. `None` if it cannot reach the end.
    pub fn farthest(&self, t: R) -> Option<Profile<R>> {
        if !self.is_real(self.beyond_straight()) {
            let straight = self.profile(&Ramp::straight(self.a0, self.a1));
            let waits = t - straight.duration(self.per_jerk);
            if waits.abs() <= of_state(t) {
                return Some(straight);
            }
        }
        let cruise = Self::by_way_of_vmax(self.ramps_to_vmax(), R::ZERO);
        let without_cruise = cruise.duration(self.per_jerk);
        // Ramps of infinite numbers have an infinite duration, or NaN.
        if t >= without_cruise {
            return Some(Profile { cruise: t - without_cruise, ..cruise });
        }
        self.without_cruise(t)
    }

    /// The motion of the duration `t` that covers the largest displacement between ends that are strictly within their limits. `None` if it is no more than a ramp,
    /// or if the end cannot be reached in this duration.
    #[inline]
    pub fn farthest_of_feasible_ends(&self, t: R) -> Option<Profile<R>> {
        let Self { a0, a1, .. } = *self;
        if !self.is_too_short_to_cruise(t) {
            let cruise = Self::by_way_of_vmax(self.ramps_to_vmax(), R::ZERO);
            let rest = t - cruise.duration(self.per_jerk);
            if rest > R::ZERO {
                return Some(Profile { cruise: rest, ..cruise });
            }
        }
        let rises = t > self.per_jerk.gu * (a1 - a0);
        let profile = rises.then(|| self.without_cruise(t))??;
        (profile.peak >= a0 && profile.trough <= a1).then_some(profile)
    }

    /// Whether the duration is too short to cruise even if both ramps were at the highest acceleration and deceleration all the time.
    fn is_too_short_to_cruise(&self, t: R) -> bool {
        let (bu, bd) = (self.limits.amax, -self.limits.amin);
        t * (bu * bd) < self.above * bd + (self.above - self.dv) * bu
    }

    /// The motion of the duration `t` that covers the largest displacement, if the duration is too short to cruise.
    fn without_cruise(&self, t: R) -> Option<Profile<R>> {
        let Self { a0, a1, dv, .. } = *self;
        let (bu, bd) = (self.limits.amax, -self.limits.amin);
        let (gu, q, half) = (self.per_jerk.gu, self.per_jerk.q(), R::HALF);
        let rest = t + gu * (a0 - a1);
        let fall = half * rest / q;
        let rises = fall - (a0 - a1);
        let difference = (dv - half * t * (a0 + a1)) / (q * fall);
        let (first, last) = (half * (rises + difference), half * (rises - difference));
        let (peak, trough) = (a0 + first, a1 - last);
        if peak <= bu && trough >= -bd {
            let rounding = of_state(a0.abs() + a1.abs() + fall);
            // A rise that is longer at one end of the fall and shorter at the other changes the velocity by twice the area of the fall.
            let change = (q + q) * fall;
            let is_rise = |rise: R| rise >= -rounding || change * -rise <= self.rounding_of_area();
            let profile = Profile { first, peak, fall, trough, last, ..Profile::default() };
            return (is_rise(first) && is_rise(last)).then_some(profile);
        }
        let both = bu + bd;
        let holds = rest - (q + q) * both;
        let turned = dv + half * gu * (a0 * a0 - a1 * a1) - q * (bu * bu - bd * bd);
        let top = (turned + bd * holds) / both;
        let bottom = (bu * holds - turned) / both;
        let is_trapezoid = q == R::ZERO;
        let top_holds = if holds >= R::ZERO { top >= R::ZERO } else { peak > bu };
        if holds >= R::ZERO && (top >= R::ZERO && bottom >= R::ZERO || is_trapezoid) {
            let (first, last) = (bu - a0, a1 + bd);
            let (top, bottom) = (top.at_least(R::ZERO), bottom.at_least(R::ZERO));
            Some(Profile { first, peak: bu, top, fall: both, trough: -bd, bottom, last, ..Profile::default() })
        } else if top_holds {
            self.top_alone(t)
        } else {
            let mut profile = self.reversed().top_alone(t)?;
            profile.reverse();
            Some(profile)
        }
    }

    /// The motion of the duration `t` in which the highest acceleration holds and the lowest one does not. `None` if the velocity at the end
    /// cannot be reached in this duration, or if the ramps to the highest acceleration and from it take longer.
    fn top_alone(&self, t: R) -> Option<Profile<R>> {
        let Self { a0, a1, dv, .. } = *self;
        let PerJerk { gu, gd } = self.per_jerk;
        let (q, bu) = (self.per_jerk.q(), self.limits.amax);
        let (first, least) = (bu - a0, bu - a1);
        let held = bu * t;
        // The change of velocity that is too much, if the acceleration fell to the end and no rise followed.
        let beyond = held - dv - R::HALF * (gu * first * first + gd * least * least);
        let rounding = self.rounding_of_area() + of_formula(held);
        // A rise below 0 by rounding does not exist. Else the hold would have to leave its acceleration.
        let last = larger_root(least, -(beyond.at_least(R::ZERO) / q));
        let top = t - gu * (first + last) - gd * (least + last);
        (beyond >= -rounding && top >= -of_formula(t)).then(|| {
            let (top, trough) = (top.at_least(R::ZERO), a1 - last);
            Profile { first, peak: bu, top, fall: least + last, trough, last, ..Profile::default() }
        })
    }

    pub fn displacement(&self, profile: &Profile<R>) -> R {
        let change = self.change(profile);
        self.v0 * change.duration + change.displacement
    }

    #[inline]
    pub fn change(&self, profile: &Profile<R>) -> Change<R> {
        let Profile { first, peak, top, fall, cruise, trough, bottom, last, .. } = *profile;
        let PerJerk { gu, gd } = self.per_jerk;
        let rise = Change::of(self.a0, peak, gu * first).hold(peak, top);
        let fall = if cruise > R::ZERO {
            rise.then(peak, R::ZERO, gd * peak).hold(R::ZERO, cruise).then(R::ZERO, trough, gd * -trough)
        } else {
            rise.then(peak, trough, gd * fall)
        };
        fall.hold(trough, bottom).then(trough, self.a1, gu * last)
    }

    /// The derivative of the displacement on the border with respect to the duration.
    pub fn slope(&self, profile: &Profile<R>) -> R {
        let Profile { trough, fall, bottom, last, .. } = *profile;
        let PerJerk { gu, gd } = self.per_jerk;
        let before_last = self.v1 - R::HALF * gu * last * (self.a1 + trough);
        before_last - trough * (R::HALF * gd * fall + bottom)
    }

    /// The segments of a motion on this border, or on the border of the mirrored axis, in order of time.
    pub fn segments(&self, profile: &Profile<R>) -> [Segment<R>; MOST_SEGMENTS] {
        let Profile { mirrored, first, peak, top, fall, cruise, trough, bottom, last } = *profile;
        let PerJerk { gu, gd } = self.per_jerk.mirrored_if(mirrored);
        let Limits { jmax, jmin, .. } = self.limits;
        let (rising, falling) = if mirrored { (jmin, jmax) } else { (jmax, jmin) };
        // A rise may come out below 0 by rounding. The sum of both stays, and with it the duration.
        let rises = first + last;
        let first_rise = first.at_least(R::ZERO).at_most(rises);
        let last = if first_rise == first { last } else { rises - first_rise };
        // Then the fall begins and ends at other accelerations. The accelerations at the ends of the motion are exact.
        let moved = first_rise - first;
        let first = first_rise;
        let (peak, trough) = ((peak + moved).negate_if(mirrored), (trough + moved).negate_if(mirrored));
        let peak = if first + top > R::ZERO { peak } else { self.a0 };
        let trough = if last + bottom > R::ZERO { trough } else { self.a1 };
        // The fall pauses at 0 for the cruise.
        let (pause, before, after) =
            if cruise > R::ZERO { (R::ZERO, peak.abs(), trough.abs()) } else { (trough, fall, R::ZERO) };
        [
            Segment::new(self.a0, rising, gu * first),
            Segment::new(peak, R::ZERO, top),
            Segment::new(peak, falling, gd * before),
            Segment::new(pause, R::ZERO, cruise),
            Segment::new(pause, falling, gd * after),
            Segment::new(trough, R::ZERO, bottom),
            Segment::new(trough, rising, gu * last),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::Border;
    use crate::limits::Limits;

    /// In 2 s the acceleration falls from 0.5 to -0.5 and rises to 0.5 again, without a rise before. At a lower velocity at the end, this rise is below 0
    /// by half of the difference. It is rounding up to 16 ulps of both accelerations and the fall, or if it changes the velocity by 4 ulps of both
    /// velocities at most.
    #[test]
    fn a_rise_below_0_is_rounding() {
        let limits = Limits::symmetric(1.0, 9.0, 1e4);
        let is_rounding = |v: f64, ulps: f64| {
            let ends = [[v, 0.5], [v - 2.0 * ulps * f64::EPSILON, 0.5]];
            Border::between(ends, &limits).without_cruise(2.0).is_some()
        };
        assert!(is_rounding(0.0, 28.0) && !is_rounding(0.0, 36.0));
        assert!(is_rounding(1024.0, 3072.0) && !is_rounding(1024.0, 5120.0));
    }

    /// A brake from 1 m/s by a jerk of 1 m/s³ takes 2 s, and its highest deceleration is 1 m/s².
    #[test]
    fn a_shorter_brake_begins_slower() {
        let brake = Border::between([[1.0, 0.0], [0.0, 0.0]], &Limits::symmetric(1.0, 9.0, 9.0));
        let ulps = |shorter: f64| (brake.faster_for(2.0 - shorter * f64::EPSILON) / f64::EPSILON).round();
        assert_eq!([-64.0, 0.0, 64.0].map(ulps), [0.0, 0.0, -64.0]);
    }
}
