//! The motion of a given duration that gets farthest, and the first such motion that gets as far as wanted.
//!
//! The displacements that an axis can reach in a duration form an interval, because limits are convex: a mean of two motions within
//! the limits keeps the limits and travels the mean. So the fastest motion over a displacement lies on the border of the first
//! interval that holds the displacement. `docs/planner.md` has the theory.
//!
//! On the upper border the acceleration rises, (holds), falls, (holds) and rises. If the highest velocity is reached, the axis cruises in
//! the middle of the fall. The lower border is the upper border of the mirrored axis.

use super::part::{Easing, Part};
use crate::real::Real;
use crate::roots::larger_root;

/// The ends and the limits of the motions on the border.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Border<R> {
    /// Velocity at the start.
    pub v0: R,
    /// Acceleration at the start.
    pub a0: R,
    /// Velocity at the end.
    pub v1: R,
    /// Acceleration at the end.
    pub a1: R,
    /// Change of velocity from the start to the end, formed once.
    pub dv: R,
    /// Highest velocity.
    pub vmax: R,
    /// From the velocity at the start up to the highest one, formed once.
    pub above: R,
    /// Lowest velocity.
    pub vmin: R,
    /// From the lowest velocity up to the one at the start, formed once.
    pub below: R,
    /// Highest acceleration.
    pub rise: R,
    /// Highest deceleration, positive.
    pub fall: R,
    /// How long the acceleration takes to change.
    pub pace: Pace<R>,
}

/// The times in which the acceleration changes by 1: the reciprocals of the jerks. 0 where there is no limit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace<R> {
    /// For a rise.
    pub up: R,
    /// For a fall.
    pub down: R,
}

/// A motion on the border.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Course<R> {
    /// How far the acceleration rises at the start.
    pub first: R,
    /// The acceleration after the first rise.
    pub peak: R,
    /// How long it holds, s.
    pub top: R,
    /// How far the acceleration falls in the middle.
    pub fall: R,
    /// How long it pauses at 0, with the highest velocity, s.
    pub cruise: R,
    /// The acceleration after the fall.
    pub trough: R,
    /// How long it holds, s.
    pub bottom: R,
    /// How far the acceleration rises at the end.
    pub last: R,
}

/// The fastest change of velocity by way of a higher acceleration: the acceleration rises, (holds) and falls.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ramp<R> {
    /// How far the acceleration rises.
    pub out: R,
    /// The highest acceleration.
    pub peak: R,
    /// How long it holds, s.
    pub hold: R,
    /// How far the acceleration falls.
    pub back: R,
}

impl<R: Real> Pace<R> {
    /// Seen from the other side.
    fn mirrored(self) -> Self {
        Self {
            up: self.down,
            down: self.up,
        }
    }

    /// Seen from the other side if `mirror`.
    pub fn seen(self, mirror: bool) -> Self {
        if mirror { self.mirrored() } else { self }
    }

    /// Duration of a motion on the border, s.
    pub fn duration(self, course: &Course<R>) -> R {
        let Course {
            first,
            top,
            fall,
            cruise,
            bottom,
            last,
            ..
        } = *course;
        self.up * (first + last) + self.down * fall + (top + cruise + bottom)
    }

    /// Mean of both times.
    pub fn mean(self) -> R {
        R::HALF * (self.up + self.down)
    }

    /// What a straight change of the acceleration adds to the velocity.
    pub fn straight(self, from: R, to: R) -> R {
        let time = if to > from { self.up } else { self.down };
        R::HALF * (from + to) * (to - from).abs() * time
    }
}

impl<R: Real> Ramp<R> {
    /// From the acceleration `a0` up and down to `a1`, with a change of velocity `beyond` that of the straight change.
    pub fn over(beyond: R, a0: R, a1: R, limit: R, pace: Pace<R>) -> Self {
        let higher = a0.at_least(a1);
        let most = (limit - higher).at_least(R::ZERO);
        let mut excess = larger_root(higher, -(beyond / pace.mean()));
        let (mut peak, mut hold) = (limit, R::ZERO);
        if excess < most {
            excess = excess.at_least(R::ZERO); // by rounding
            peak = higher + excess;
        } else {
            excess = most;
            hold = ((beyond - pace.mean() * most * (higher + limit)) / limit).at_least(R::ZERO);
        }
        Self {
            out: higher - a0 + excess,
            peak,
            hold,
            back: higher - a1 + excess,
        }
    }

    /// The straight change.
    fn straight(a0: R, a1: R) -> Self {
        let peak = a0.at_least(a1);
        Self {
            out: peak - a0,
            peak,
            hold: R::ZERO,
            back: peak - a1,
        }
    }

    /// Duration and displacement of the ramp between two accelerations, which begins at the velocity `v`.
    pub fn passed(&self, v: R, a0: R, a1: R, pace: Pace<R>) -> (R, R) {
        let mut change = Change::default();
        change.jerk(a0, self.peak, pace.up * self.out);
        change.jerk(self.peak, self.peak, self.hold);
        change.jerk(self.peak, a1, pace.down * self.back);
        (change.duration, v * change.duration + change.displacement)
    }
}

/// Changes since the start, beside those of a constant velocity.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Change<R> {
    /// s
    pub duration: R,
    /// Of the velocity.
    pub velocity: R,
    /// Beside velocity times duration.
    pub displacement: R,
}

impl<R: Real> Change<R> {
    /// Lets the acceleration change from `from` to `to` in the time `t`.
    pub fn jerk(&mut self, from: R, to: R, t: R) {
        let half = R::HALF * t;
        let third = (R::SIXTH + R::SIXTH) * t;
        let sum = from + to;
        self.displacement = self.displacement + t * self.velocity + half * (third * (from + sum));
        self.velocity = self.velocity + half * sum;
        self.duration = self.duration + t;
    }
}

/// Two motions of the same duration, whose mean travels a displacement.
pub(crate) struct Mean<R> {
    /// The motion that gets farthest.
    pub farthest: Course<R>,
    /// The motion that gets farthest to the other side. It belongs to the mirrored axis.
    pub nearest: Course<R>,
    /// The weight of the first motion.
    pub share: R,
}

impl<R: Real> Mean<R> {
    /// Whether no weight is negative. Then the mean keeps the limits that both motions keep.
    pub fn keeps_limits(&self) -> bool {
        self.share >= R::ZERO && self.share <= R::ONE
    }
}

/// How the search in a part of the border ends.
enum Search<R> {
    /// The displacement is reached.
    Reached(Course<R>),
    /// It is not: the last motion of the part, and what its displacement lacks.
    Lacking(Course<R>, R),
}

impl<R: Real> Border<R> {
    /// The axis seen from the other side.
    pub fn mirrored(self) -> Self {
        Self {
            v0: -self.v0,
            a0: -self.a0,
            v1: -self.v1,
            a1: -self.a1,
            dv: -self.dv,
            vmax: -self.vmin,
            above: self.below,
            vmin: -self.vmax,
            below: self.above,
            rise: self.fall,
            fall: self.rise,
            pace: self.pace.mirrored(),
        }
    }

    /// The motions in the other order of time, which have the same displacements.
    fn reversed(self) -> Self {
        Self {
            v0: self.v1,
            a0: -self.a1,
            v1: self.v0,
            a1: -self.a0,
            dv: -self.dv,
            above: self.above - self.dv,
            below: self.below + self.dv,
            rise: self.fall,
            fall: self.rise,
            ..self
        }
    }

    /// How much the change of velocity exceeds the one of the straight change of the acceleration, and whether by more than roundings of
    /// the velocities that the axis has beside those of both ends: those with the acceleration undone.
    fn beyond_straight(&self) -> (R, bool) {
        let Self { v0, a0, v1, a1, .. } = *self;
        let beyond = self.dv - self.pace.straight(a0, a1);
        let rounding = R::from(16) * R::EPSILON * (v0.abs() + v1.abs() + self.undone());
        (beyond, beyond.abs() > rounding)
    }

    /// The changes of velocity in which the accelerations at both ends are undone.
    fn undone(&self) -> R {
        self.pace.straight(self.a0, R::ZERO).abs() + self.pace.straight(R::ZERO, self.a1).abs()
    }

    /// The fastest change of velocity, and whether it rises; else it is a ramp of the mirrored axis. Its duration allows no other
    /// displacement.
    pub fn direct(&self) -> (Ramp<R>, bool) {
        let (beyond, is_real) = self.beyond_straight();
        self.direct_beyond(beyond, is_real)
    }

    fn direct_beyond(&self, beyond: R, is_real: bool) -> (Ramp<R>, bool) {
        // Where both accelerations point against the ramp, the least ramp is a long one. None is made for a rounding.
        let against = self.a0 * beyond < R::ZERO && self.a1 * beyond < R::ZERO;
        if beyond == R::ZERO || against && !is_real {
            self.straight()
        } else {
            self.ramp(beyond, beyond > R::ZERO)
        }
    }

    /// The straight change of the acceleration.
    fn straight(&self) -> (Ramp<R>, bool) {
        (Ramp::straight(self.a0, self.a1), true)
    }

    /// The change of velocity by way of a higher acceleration if `rises`, else of a lower one.
    fn ramp(&self, beyond: R, rises: bool) -> (Ramp<R>, bool) {
        let [beyond, a0, a1] = [beyond, self.a0, self.a1].map(|x| x.negate_if(!rises));
        let (limit, pace) = if rises {
            (self.rise, self.pace)
        } else {
            (self.fall, self.pace.mirrored())
        };
        (Ramp::over(beyond, a0, a1, limit, pace), rises)
    }

    /// Duration and displacement of a ramp.
    pub fn passed(&self, (ramp, rises): (Ramp<R>, bool)) -> (R, R) {
        let [v0, a0, a1] = [self.v0, self.a0, self.a1].map(|x| x.negate_if(!rises));
        let (duration, displacement) = ramp.passed(v0, a0, a1, self.pace.seen(!rises));
        (duration, displacement.negate_if(!rises))
    }

    /// A ramp as a motion on the border.
    pub fn course(&self, (ramp, rises): (Ramp<R>, bool)) -> Course<R> {
        let Ramp {
            out,
            peak,
            hold,
            back,
        } = ramp;
        if rises {
            Course {
                first: out,
                peak,
                top: hold,
                fall: back,
                trough: self.a1,
                ..Course::default()
            }
        } else {
            Course {
                peak: self.a0,
                fall: out,
                trough: -peak,
                bottom: hold,
                last: back,
                ..Course::default()
            }
        }
    }

    /// The fastest motion over the displacement `h`, and whether it is a motion on the border of the mirrored axis. `positions` is the
    /// sum of the magnitudes of both positions.
    pub fn fastest(&self, h: R, positions: R) -> (bool, Course<R>) {
        let (beyond, is_real) = self.beyond_straight();
        // What is left of a move may be a straight change of the acceleration, but for a rounding.
        if !is_real {
            let straight = self.straight();
            let (lacks, tie) = self.lacking(straight, h, positions);
            if lacks.abs() <= tie && tie.is_finite() {
                return (false, self.course(straight));
            }
        }
        let mut ramp = self.direct_beyond(beyond, is_real);
        // One gap may follow the direct ramp.
        for _ in 0..2 {
            let (lacks, tie) = self.lacking(ramp, h, positions);
            if lacks.abs() <= tie && tie.is_finite() {
                break;
            }
            let mirror = lacks < R::ZERO;
            let border = if mirror { self.mirrored() } else { *self };
            let base = border.split_at_0(border.course((ramp.0, ramp.1 != mirror)));
            match border.first_over(base, h.negate_if(mirror), lacks.abs(), tie) {
                Some(course) => return (mirror, course),
                None => ramp = self.behind_gap(),
            }
        }
        (false, self.course(ramp))
    }

    /// What the displacement of a ramp lacks of `h`, and up to which rounding it is reached.
    fn lacking(&self, ramp: (Ramp<R>, bool), h: R, positions: R) -> (R, R) {
        let (duration, displacement) = self.passed(ramp);
        (h - displacement, self.tie(duration, positions))
    }

    /// Up to which rounding a motion of this duration reaches its displacement. Its velocities have roundings in proportion to those of both
    /// ends and to what the accelerations at the ends add. Between standstills any way is made: it costs no detour.
    fn tie(&self, duration: R, positions: R) -> R {
        let (a0, a1) = (self.a0.abs(), self.a1.abs());
        let added = self.undone().at_most(a0.at_least(a1) * duration);
        let speed = self.v0.abs().at_least(self.v1.abs()) + added;
        if speed > R::ZERO {
            R::from(32) * R::EPSILON * (positions + speed * duration)
        } else {
            R::ZERO
        }
    }

    /// The first reachable motion behind the gap. It turns against both accelerations.
    fn behind_gap(&self) -> (Ramp<R>, bool) {
        self.ramp(self.beyond_straight().0, self.a0 < R::ZERO)
    }

    /// A straight rise through 0, or from or to 0, as two rises: the acceleration may pause at 0.
    fn split_at_0(&self, course: Course<R>) -> Course<R> {
        let is_straight = course.fall == R::ZERO && course.top + course.bottom == R::ZERO;
        if is_straight && self.a0 <= R::ZERO && self.a1 >= R::ZERO {
            Course {
                first: -self.a0,
                last: self.a1,
                ..Course::default()
            }
        } else {
            course
        }
    }

    /// The first motion of the border over `h`: it gets `lacks` farther than `base`. `None` if a gap comes first.
    fn first_over(&self, base: Course<R>, h: R, lacks: R, tie: R) -> Option<Course<R>> {
        Some(match self.before_gap(base, lacks, tie)? {
            Search::Reached(course) => course,
            Search::Lacking(base, lacks) => self.turning(base, h, lacks),
        })
    }

    /// The part of the border in which the acceleration keeps its sign in the middle of the motion. `None` if a gap follows, that is,
    /// durations in which the end cannot be reached.
    fn before_gap(&self, base: Course<R>, lacks: R, tie: R) -> Option<Search<R>> {
        if base.trough > R::ZERO {
            self.easing(base, lacks, tie)
        } else if base.peak < R::ZERO {
            Some(match self.reversed().easing(base.reversed(), lacks, tie)? {
                Search::Reached(course) => Search::Reached(course.reversed()),
                Search::Lacking(course, lacks) => Search::Lacking(course.reversed(), lacks),
            })
        } else {
            Some(Search::Lacking(base, lacks))
        }
    }

    /// The part of the border in which the acceleration stays positive, and eases more and more in the middle of the motion.
    fn easing(&self, mut base: Course<R>, mut lacks: R, tie: R) -> Option<Search<R>> {
        // A hold ends once at most.
        for _ in 0..2 {
            let part = Part::of(self, &base, base.top > R::ZERO);
            let (end, what) = part.end_of_easing(self.a0);
            if let Some(x) = part.first_over(lacks, end, false) {
                return Some(Search::Reached(part.course(x)));
            }
            lacks = lacks - part.displacement(end).0;
            base = part.course(end);
            match what {
                Easing::HoldEnds => base.top = R::ZERO,
                Easing::Vanishes => return Some(Search::Lacking(base, lacks)),
                Easing::IsFollowedByGap => {
                    base.last = base.last + base.first;
                    base.trough = base.trough - base.first;
                    (base.first, base.peak) = (R::ZERO, self.a0);
                    return (lacks <= tie).then_some(Search::Reached(base));
                }
            }
        }
        None
    }

    /// The first motion over `h` on the part of the border in which the acceleration changes its sign in the middle of the motion: it
    /// gets `lacks` farther than `base`.
    fn turning(&self, mut base: Course<R>, h: R, mut lacks: R) -> Course<R> {
        let ramps @ [up, down] = self.ramps_to_vmax();
        let (a0, a1, zero) = (self.a0, -self.a1, R::ZERO);
        let displacement =
            up.passed(self.v0, a0, zero, self.pace).1 + down.passed(self.v1, a1, zero, self.pace).1;
        if h >= displacement {
            let mut cruise = Self::by_way_of_vmax(ramps);
            cruise.cruise = (h - displacement) / self.vmax;
            return cruise;
        }
        if !(base.top > R::ZERO || base.bottom > R::ZERO) {
            let part = Part::of(self, &base, false);
            let end = self.first_hold(&base) - base.fall;
            if end > R::ZERO {
                if let Some(x) = part.first_over(lacks, end, true) {
                    return part.course(x);
                }
                lacks = lacks - part.displacement(end).0;
                base = part.course(end);
            }
        }
        let holds = base.top > R::ZERO || base.bottom > R::ZERO;
        let nearer = self.rise - base.peak <= self.fall + base.trough;
        if base.top > R::ZERO || !holds && nearer {
            self.holding(base, lacks)
        } else {
            self.reversed().holding(base.reversed(), lacks).reversed()
        }
    }

    /// The highest acceleration holds, and at last the lowest one too.
    fn holding(&self, mut base: Course<R>, lacks: R) -> Course<R> {
        base.peak = self.rise;
        let part = Part::of(self, &base, true);
        let end = (self.fall + base.trough).at_least(R::ZERO);
        match part.first_over(lacks, end, true) {
            Some(x) => part.course(x),
            None => {
                let lacks = lacks - part.displacement(end).0;
                self.both_hold(part.course(end), lacks)
            }
        }
    }

    /// Both accelerations hold, and the displacement is a quadratic.
    fn both_hold(&self, base: Course<R>, lacks: R) -> Course<R> {
        let sum = self.rise + self.fall;
        let curvature = self.rise * self.fall / sum;
        let slope = self.slope(&base);
        let longer = larger_root(slope / curvature, -(lacks + lacks) / curvature);
        Course {
            top: base.top + self.fall / sum * longer,
            trough: -self.fall,
            bottom: base.bottom + self.rise / sum * longer,
            ..base
        }
    }

    /// The fastest ramps from the start up to the highest velocity, and from the end up to it in the other order of time.
    fn ramps_to_vmax(&self) -> [Ramp<R>; 2] {
        let (a0, a1) = (self.a0, -self.a1);
        let up = self.above - self.pace.straight(a0, R::ZERO);
        let down = self.above - self.dv - self.pace.straight(a1, R::ZERO);
        [
            Ramp::over(up, a0, R::ZERO, self.rise, self.pace),
            Ramp::over(down, a1, R::ZERO, self.fall, self.pace),
        ]
    }

    /// The fastest motion by way of the highest velocity.
    fn by_way_of_vmax([up, down]: [Ramp<R>; 2]) -> Course<R> {
        Course {
            first: up.out,
            peak: up.peak,
            top: up.hold,
            fall: up.back + down.back,
            cruise: R::ZERO,
            trough: -down.peak,
            bottom: down.hold,
            last: down.out,
        }
    }

    /// How far the acceleration falls where a hold begins.
    fn first_hold(&self, base: &Course<R>) -> R {
        let Course { peak, trough, .. } = *base;
        let above = (self.rise - peak) * (self.rise + peak);
        let below = (self.fall + trough) * (self.fall - trough);
        let top = self.rise + (trough * trough + above).sqrt();
        top.at_most(self.fall + (peak * peak + below).sqrt())
    }

    /// The shortest duration from `t` on in which the displacement `h` is possible; infinite if numbers are beyond the range.
    pub fn next_duration(&self, mut t: R, h: R, positions: R) -> R {
        // A displacement may become impossible once, and a gap may follow, on each side.
        for _ in 0..4 {
            let mirrored = self.mirrored();
            let (Some(farthest), Some(nearest)) = (self.of_duration(t), mirrored.of_duration(t))
            else {
                t = self.passed(self.behind_gap()).0;
                continue;
            };
            let tie = self.tie(t, positions);
            let lacks = h - self.displacement(&farthest);
            let exceeds = -h - mirrored.displacement(&nearest);
            if !(lacks - exceeds).is_finite() {
                return R::INFINITY;
            }
            let (border, h, base, lacks) = if lacks > tie {
                (*self, h, farthest, lacks)
            } else if exceeds > tie {
                (mirrored, -h, nearest, exceeds)
            } else {
                return t;
            };
            t = match border.first_over(base, h, lacks, tie) {
                Some(course) => border.pace.duration(&course),
                None => self.passed(self.behind_gap()).0,
            };
        }
        t
    }

    /// The mean over `h` of the motions of the duration `t`. `None` if the end cannot be reached in this duration.
    pub fn mean(&self, h: R, t: R) -> Option<Mean<R>> {
        let mirrored = self.mirrored();
        let (farthest, nearest) = (self.of_duration(t)?, mirrored.of_duration(t)?);
        let (most, least) = (
            self.displacement(&farthest),
            -mirrored.displacement(&nearest),
        );
        let (beyond, width) = (h - least, most - least);
        // An axis that need not move has no width.
        let share = if beyond == width {
            R::ONE
        } else {
            beyond / width
        };
        Some(Mean {
            farthest,
            nearest,
            share,
        })
    }

    /// The axis with a lower limit of its velocity, if it has time: twice the mean velocity is enough between standstills. So the numbers of a
    /// slow motion are small, and with them their roundings.
    pub fn slower(&self, h: R, t: R) -> Self {
        let mean = h.abs() / t;
        let speed = mean + mean + self.v0.abs() + self.v1.abs() + self.undone();
        Self {
            vmax: self.vmax.at_most(speed),
            above: self.above.at_most(speed - self.v0),
            vmin: self.vmin.at_least(-speed),
            below: self.below.at_most(speed + self.v0),
            ..*self
        }
    }

    /// The motion of the duration `t` that gets farthest. `None` if the end cannot be reached in this duration, which is not below that of
    /// the direct ramp.
    pub fn of_duration(&self, t: R) -> Option<Course<R>> {
        let few = R::from(16) * R::EPSILON;
        let straight = self.course(self.straight());
        let waits = t - self.pace.duration(&straight);
        if !self.beyond_straight().1 && waits.abs() <= few * t {
            return Some(straight);
        }
        let mut cruise = Self::by_way_of_vmax(self.ramps_to_vmax());
        let without_cruise = self.pace.duration(&cruise);
        let course = if t >= without_cruise {
            cruise.cruise = t - without_cruise;
            cruise
        } else {
            self.without_cruise(t)
        };
        let rounding = few * (self.a0.abs() + self.a1.abs() + course.fall);
        let is_motion = course.first >= -rounding && course.last >= -rounding;
        is_motion.then_some(course)
    }

    /// The motion of the duration `t` that gets farthest, if it is too short to cruise.
    fn without_cruise(&self, t: R) -> Course<R> {
        let &Self {
            a0,
            a1,
            dv,
            rise,
            fall: depth,
            pace,
            ..
        } = self;
        let (mean, half) = (pace.mean(), R::HALF);
        // The duration without what a rise from `a0` to `a1` takes.
        let rest = t + pace.up * (a0 - a1);
        let fall = half * rest / mean;
        let rises = fall - (a0 - a1);
        let difference = (dv - half * t * (a0 + a1)) / (mean * fall);
        let (first, last) = (half * (rises + difference), half * (rises - difference));
        let (peak, trough) = (a0 + first, a1 - last);
        if peak <= rise && trough >= -depth {
            return Course {
                first,
                peak,
                fall,
                trough,
                last,
                ..Course::default()
            };
        }
        let both = rise + depth;
        let holds = rest - (mean + mean) * both;
        let turned =
            dv + half * pace.up * (a0 * a0 - a1 * a1) - mean * (rise * rise - depth * depth);
        let (top, bottom) = (
            (turned + depth * holds) / both,
            (rise * holds - turned) / both,
        );
        let is_trapezoid = mean == R::ZERO;
        let top_holds = if holds >= R::ZERO {
            top >= R::ZERO
        } else {
            peak > rise
        };
        if holds >= R::ZERO && (top >= R::ZERO && bottom >= R::ZERO || is_trapezoid) {
            Course {
                first: rise - a0,
                peak: rise,
                top: top.at_least(R::ZERO),
                fall: both,
                trough: -depth,
                bottom: bottom.at_least(R::ZERO),
                last: a1 + depth,
                ..Course::default()
            }
        } else if top_holds {
            self.top_alone(t)
        } else {
            self.reversed().top_alone(t).reversed()
        }
    }

    /// The motion of the duration `t` in which the highest acceleration holds and the lowest one does not.
    fn top_alone(&self, t: R) -> Course<R> {
        let &Self {
            a0,
            a1,
            dv,
            rise,
            pace,
            ..
        } = self;
        let mean = pace.mean();
        let beside = pace.up * (a0 - a1) * (rise - R::HALF * (a0 + a1));
        let fall = ((rise * t - dv + beside) / mean).at_least(R::ZERO).sqrt();
        let trough = rise - fall;
        Course {
            first: rise - a0,
            peak: rise,
            top: (t + pace.up * (a0 - a1) - (mean + mean) * fall).at_least(R::ZERO),
            fall,
            trough,
            last: a1 - trough,
            ..Course::default()
        }
    }

    /// Displacement of a motion.
    pub fn displacement(&self, course: &Course<R>) -> R {
        let Course {
            first,
            peak,
            top,
            fall,
            cruise,
            trough,
            bottom,
            last,
        } = *course;
        let Pace { up, down } = self.pace;
        let mut change = Change::default();
        change.jerk(self.a0, peak, up * first);
        change.jerk(peak, peak, top);
        if cruise > R::ZERO {
            change.jerk(peak, R::ZERO, down * peak);
            change.jerk(R::ZERO, R::ZERO, cruise);
            change.jerk(R::ZERO, trough, down * -trough);
        } else {
            change.jerk(peak, trough, down * fall);
        }
        change.jerk(trough, trough, bottom);
        change.jerk(trough, self.a1, up * last);
        self.v0 * change.duration + change.displacement
    }

    /// The derivative of the displacement on the border with respect to the duration.
    pub fn slope(&self, course: &Course<R>) -> R {
        let Course {
            trough,
            fall,
            bottom,
            last,
            ..
        } = *course;
        let before_last = self.v1 - R::HALF * self.pace.up * last * (self.a1 + trough);
        before_last - trough * (R::HALF * self.pace.down * fall + bottom)
    }
}

impl<R: Real> Course<R> {
    /// In the other order of time.
    fn reversed(self) -> Self {
        Self {
            first: self.last,
            peak: -self.trough,
            top: self.bottom,
            fall: self.fall,
            cruise: self.cruise,
            trough: -self.peak,
            bottom: self.top,
            last: self.first,
        }
    }
}
