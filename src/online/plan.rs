//! Coming inside the limits, and the fastest motion from there on.

use super::border::{Border, Change, Course, Mean, Pace, Ramp};
use super::motion::{Leg, Pen};
use super::{Error, Limits, Move};
use crate::findings::Findings;
use crate::real::Real;
use crate::state::State;

impl<R: Real> Move<R> {
    /// Plans the fastest motion to a state, from any state: a start outside the limits comes inside in the fastest way, and then the limits
    /// are kept. The target may be behind, or nearer than the way to stop.
    ///
    /// Returns [`Findings::OVERSHOOTS`] and [`Findings::STARTS_OUTSIDE`], if they are so. [`Error::NotFinite`] if a state is not made of
    /// numbers, or the motion is beyond the range of the real type; [`Error::Limits`] if the limits are not around 0; [`Error::Target`] if
    /// the target is outside the limits, or the axis must have left them before, or will. On an error the move stays as it is.
    ///
    /// ```
    /// use atraj::online::{Limits, Move, State};
    /// let limits = Limits { vmax: 2.0, vmin: -1.0, amax: 4.0, amin: -8.0, jmax: 50.0, jmin: -100.0 };
    /// let now = State { position: 0.0, velocity: 1.5, acceleration: 2.0 };
    /// let mut axis = Move::default();
    /// axis.plan(&limits, now, State::at(3.0)).expect("numbers");
    /// assert_eq!((axis.position(axis.t), axis.velocity(axis.t)), (3.0, 0.0));
    /// ```
    pub fn plan(
        &mut self,
        limits: &Limits<R>,
        from: State<R>,
        to: State<R>,
    ) -> Result<Findings, Error> {
        limits.check(from, to)?;
        let task = Task::new(limits, from, to);
        task.write(self, &task.fastest())?;
        Ok(task.findings(self))
    }

    /// Plans the fastest motion to a velocity and an acceleration. The position is free. Findings and errors are those of [`Move::plan`].
    pub fn reach(
        &mut self,
        limits: &Limits<R>,
        from: State<R>,
        velocity: R,
        acceleration: R,
    ) -> Result<Findings, Error> {
        let to = State {
            velocity,
            acceleration,
            ..from
        };
        limits.check(from, to)?;
        let mut task = Task::new(limits, from, to);
        let direct = task.border.direct();
        task.to.position = from.position + (task.inside() + task.border.passed(direct).1);
        task.write(self, &(false, task.border.course(direct)))?;
        Ok(task.findings(self))
    }

    /// Plans the fastest stop. The position is free. Findings and errors are those of [`Move::plan`].
    pub fn stop(&mut self, limits: &Limits<R>, from: State<R>) -> Result<Findings, Error> {
        self.reach(limits, from, R::ZERO, R::ZERO)
    }

    /// Plans the fastest motion to a target that moves on at its velocity. The motion ends beside the target, with its velocity, at the
    /// position `target.position + t * target.velocity`. Findings and errors are those of [`Move::plan`]; [`Error::Target`] also if the
    /// target accelerates, or if its velocity is on a limit.
    ///
    /// Seen from the target, the limits of the velocity are shifted and the target is at rest.
    pub fn meet(
        &mut self,
        limits: &Limits<R>,
        from: State<R>,
        target: State<R>,
    ) -> Result<Findings, Error> {
        limits.check(from, target)?;
        let v = target.velocity;
        let seen = Limits {
            vmax: limits.vmax - v,
            vmin: limits.vmin - v,
            ..*limits
        };
        if seen.are_limits().is_err() || target.acceleration != R::ZERO {
            return Err(Error::Target);
        }
        let seen_from = State {
            position: from.position - target.position,
            velocity: from.velocity - v,
            ..from
        };
        let task = Task::new(&seen, seen_from, State::at(R::ZERO));
        task.write(self, &task.fastest())?;
        self.shift(from, target);
        Ok(task.findings(self))
    }
}

/// A motion on the border, and whether it belongs to the mirrored axis.
pub(crate) type Motion<R> = (bool, Course<R>);

/// What is to be planned for one axis.
pub(crate) struct Task<'a, R> {
    limits: &'a Limits<R>,
    from: State<R>,
    to: State<R>,
    start: Start<R>,
    /// The motions behind the way inside the limits.
    pub border: Border<R>,
}

impl<'a, R: Real> Task<'a, R> {
    /// From a state to a state within the limits.
    pub fn new(limits: &'a Limits<R>, from: State<R>, to: State<R>) -> Self {
        let pace = Pace::of(limits);
        let start = Start::inside(limits, pace, from);
        let border = start.border(limits, pace, from, to);
        Self {
            limits,
            from,
            to,
            start,
            border,
        }
    }

    /// Displacement on the way inside the limits.
    fn inside(&self) -> R {
        let Change {
            duration,
            displacement,
            ..
        } = self.start.change;
        self.from.velocity * duration + displacement
    }

    /// Displacement behind the way inside the limits, and the rounding that both positions bring.
    pub fn displacement(&self) -> (R, R) {
        let (p0, p1) = (self.from.position, self.to.position);
        ((p1 - p0) - self.inside(), p0.abs() + p1.abs())
    }

    /// The fastest motion.
    pub fn fastest(&self) -> Motion<R> {
        let (h, positions) = self.displacement();
        self.border.fastest(h, positions)
    }

    /// Duration of a motion with the way inside the limits, s: the sum that [`Task::write`] writes.
    pub fn duration(&self, (mirror, course): &Motion<R>) -> R {
        let mut t = self.start.time + self.start.hold;
        self.border
            .each_leg(self.limits, *mirror, course, |leg| t = t + leg.duration);
        t
    }

    /// The shortest possible duration from `duration` on, which is not below that of the fastest motion, s.
    pub fn next_duration(&self, duration: R) -> R {
        if self.slow(duration).is_some() {
            return duration;
        }
        let inside = self.start.change.duration;
        let (h, positions) = self.displacement();
        let next = self.border.next_duration(duration - inside, h, positions);
        if next > duration - inside {
            inside + next
        } else {
            duration
        }
    }

    /// A slow motion of this duration over the displacement, if there is one.
    fn slow(&self, duration: R) -> Option<Mean<R>> {
        let (h, t) = (self.displacement().0, duration - self.start.change.duration);
        self.border
            .slower(h, t)
            .mean(h, t)
            .filter(Mean::keeps_limits)
    }

    /// A motion of this duration over the displacement, if one is possible: a slow one if there is one.
    pub fn mean(&self, duration: R) -> Option<Mean<R>> {
        let (h, t) = (self.displacement().0, duration - self.start.change.duration);
        self.slow(duration).or_else(|| self.border.mean(h, t))
    }

    /// Writes the way inside the limits and the mean of two motions.
    pub fn write_mean(&self, ctx: &mut Move<R>, duration: R, mean: &Mean<R>) {
        let t = duration - self.start.change.duration;
        let share = mean.share.at_least(R::ZERO).at_most(R::ONE);
        let (farthest, nearest) = ((false, &mean.farthest), (true, &mean.nearest));
        // The motion with the larger weight comes first. So the mean of equal numbers is exact, and a small one has small roundings.
        let (motions, weight) = if share > R::HALF {
            ([farthest, nearest], R::ONE - share)
        } else {
            ([nearest, farthest], share)
        };
        let (mut one, mut other) = (Walk::new(t), Walk::new(t));
        for (walk, (mirror, course)) in [&mut one, &mut other].into_iter().zip(motions) {
            self.border
                .each_leg(self.limits, mirror, course, |leg| walk.add(leg));
            walk.count_from_end();
        }
        let mut pen = self.pen(ctx);
        let mut now = Instant::start(t);
        // Each turn ends a leg of one motion, or of both.
        for _ in 1..one.count + other.count {
            let next = one.end().first(other.end());
            let mean = |x: R, y: R| x + weight * (y - x);
            pen.write(Leg {
                from: mean(one.acceleration(now), other.acceleration(now)),
                jerk: mean(one.leg().jerk, other.leg().jerk),
                duration: next.since(now),
            });
            one.pass(next);
            other.pass(next);
            now = next;
        }
        pen.end(self.to);
        ctx.end_at(duration);
    }

    /// Writes the way inside the limits and a motion, unless the numbers are beyond the range of the real type.
    pub fn write(&self, ctx: &mut Move<R>, (mirror, course): &Motion<R>) -> Result<(), Error> {
        let about = self.start.change.duration + self.border.pace.seen(*mirror).duration(course);
        if !(about + self.inside().abs() + self.to.position.abs()).is_finite() {
            return Err(Error::NotFinite);
        }
        let mut pen = self.pen(ctx);
        self.border
            .each_leg(self.limits, *mirror, course, |leg| pen.write(leg));
        pen.end(self.to);
        Ok(())
    }

    /// A pen that has written the way inside the limits.
    pub fn pen<'b>(&self, ctx: &'b mut Move<R>) -> Pen<'b, R> {
        let mut pen = Pen::new(ctx, self.from);
        let (from, to) = (self.from.acceleration, self.start.acceleration);
        let jerk = if to > from {
            self.limits.jmax
        } else {
            self.limits.jmin
        };
        pen.write(Leg {
            from,
            jerk,
            duration: self.start.time,
        });
        pen.write(Leg {
            from: to,
            jerk: R::ZERO,
            duration: self.start.hold,
        });
        pen
    }

    /// What there is to know of a written move.
    pub fn findings(&self, ctx: &Move<R>) -> Findings {
        Findings::OVERSHOOTS.when(ctx.overshoots())
            | Findings::STARTS_OUTSIDE.when(self.start.outside)
    }
}

/// The most legs of a motion on the border.
const LEGS: usize = 7;

/// A time in a motion. It is counted from the nearer end, so that a short leg beside a long cruise keeps its digits.
#[derive(Clone, Copy)]
struct Instant<R> {
    /// Since the start, s.
    since_start: R,
    /// Until the end, s.
    until_end: R,
}

impl<R: Real> Instant<R> {
    fn start(t: R) -> Self {
        Self {
            since_start: R::ZERO,
            until_end: t,
        }
    }

    fn end(t: R) -> Self {
        Self {
            since_start: t,
            until_end: R::ZERO,
        }
    }

    fn is_late(self) -> bool {
        self.until_end < self.since_start
    }

    fn first(self, other: Self) -> Self {
        let later = if self.is_late() && other.is_late() {
            self.until_end < other.until_end
        } else {
            self.since_start > other.since_start
        };
        if later { other } else { self }
    }

    /// Time from an earlier instant to this one.
    fn since(self, earlier: Self) -> R {
        if earlier.is_late() {
            earlier.until_end - self.until_end
        } else {
            self.since_start - earlier.since_start
        }
    }
}

/// The legs of a motion, walked through in order of time.
struct Walk<R> {
    t: R,
    legs: [Leg<R>; LEGS],
    /// When each leg ends.
    ends: [Instant<R>; LEGS],
    count: usize,
    current: usize,
    /// When the leg under way began.
    began: Instant<R>,
}

impl<R: Real> Walk<R> {
    /// Through a motion of the duration `t`.
    fn new(t: R) -> Self {
        Self {
            t,
            legs: [Leg::default(); LEGS],
            ends: [Instant::end(t); LEGS],
            count: 0,
            current: 0,
            began: Instant::start(t),
        }
    }

    /// Adds a leg, if it has a duration.
    fn add(&mut self, leg: Leg<R>) {
        let before = self.ends.get(self.count.wrapping_sub(1));
        let began = before.map_or(R::ZERO, |end| end.since_start);
        let places = self
            .legs
            .get_mut(self.count)
            .zip(self.ends.get_mut(self.count));
        if let Some((place, end)) = places.filter(|_| leg.duration > R::ZERO) {
            *place = leg;
            end.since_start = began + leg.duration;
            self.count += 1;
        }
    }

    /// Finds when the legs end, seen from the end of the motion.
    fn count_from_end(&mut self) {
        let mut until_end = R::ZERO;
        let legs = self.legs.iter().zip(&mut self.ends).take(self.count);
        for (leg, end) in legs.rev() {
            end.until_end = until_end;
            // One of both counts rules.
            if end.is_late() {
                end.since_start = self.t - until_end;
            } else {
                end.until_end = self.t - end.since_start;
            }
            until_end = until_end + leg.duration;
        }
    }

    fn leg(&self) -> Leg<R> {
        self.legs.get(self.current).copied().unwrap_or_default()
    }

    /// When the leg under way ends.
    fn end(&self) -> Instant<R> {
        let end = self.ends.get(self.current).copied();
        end.unwrap_or(Instant::end(self.t))
    }

    fn acceleration(&self, now: Instant<R>) -> R {
        let leg = self.leg();
        leg.from + leg.jerk * now.since(self.began)
    }

    /// Goes on to the instant `next`.
    fn pass(&mut self, next: Instant<R>) {
        let end = self.end();
        if self.current + 1 < self.count && end.since(next) <= R::ZERO {
            self.began = end;
            self.current += 1;
        }
    }
}

/// The way inside the limits.
struct Start<R> {
    /// The acceleration at the end of the way.
    acceleration: R,
    /// How long the acceleration changes, s.
    time: R,
    /// How long it holds, s.
    hold: R,
    /// What the way changes.
    change: Change<R>,
    outside: bool,
}

impl<R: Real> Start<R> {
    /// The fastest way to a state from which the limits can be kept: the ramp to the limit of the velocity, without its last part.
    fn inside(limits: &Limits<R>, pace: Pace<R>, from: State<R>) -> Self {
        let State {
            velocity: v,
            acceleration: a,
            ..
        } = from;
        let &Limits {
            vmax,
            vmin,
            amax,
            amin,
            ..
        } = limits;
        // The velocity after the acceleration is undone.
        let undone = v + pace.straight(a, R::ZERO);
        let (above, below) = ((a - amax).at_least(R::ZERO), (amin - a).at_least(R::ZERO));
        // Where the acceleration goes, how far that is, whether it rises, and how long it stays there.
        let (to, way, rises, hold) = if undone > vmax {
            let ramp = Ramp::over(undone - vmax, (-a).at_most(-amin), R::ZERO, -amin, pace);
            (-ramp.peak, ramp.out + below, below > R::ZERO, ramp.hold)
        } else if undone < vmin {
            let ramp = Ramp::over(vmin - undone, a.at_most(amax), R::ZERO, amax, pace);
            (ramp.peak, ramp.out + above, above == R::ZERO, ramp.hold)
        } else {
            let limited = a.at_most(amax).at_least(amin);
            (limited, above + below, below > R::ZERO, R::ZERO)
        };
        let time = way * if rises { pace.up } else { pace.down };
        let mut change = Change::default();
        change.jerk(a, to, time);
        change.jerk(to, to, hold);
        let few = R::from(16) * R::EPSILON;
        let rounding = few * (v.abs() + (undone - v).abs());
        let outside = undone.at_least(v) > vmax + rounding
            || undone.at_most(v) < vmin - rounding
            || above > few * amax
            || -below < few * amin;
        Self {
            acceleration: to,
            time,
            hold,
            change,
            outside,
        }
    }

    /// The motions on the border from here on.
    fn border(&self, limits: &Limits<R>, pace: Pace<R>, from: State<R>, to: State<R>) -> Border<R> {
        let change = self.change.velocity;
        Border {
            v0: from.velocity + change,
            a0: self.acceleration,
            v1: to.velocity,
            a1: to.acceleration,
            dv: (to.velocity - from.velocity) - change,
            vmax: limits.vmax,
            above: (limits.vmax - from.velocity) - change,
            vmin: limits.vmin,
            below: (from.velocity - limits.vmin) + change,
            rise: limits.amax,
            fall: -limits.amin,
            pace,
        }
    }
}

impl<R: Real> Border<R> {
    /// Visits the legs of a motion on the border, or of one on the border of the mirrored axis.
    pub fn each_leg(
        &self,
        limits: &Limits<R>,
        mirror: bool,
        course: &Course<R>,
        mut visit: impl FnMut(Leg<R>),
    ) {
        let Pace { up, down } = self.pace.seen(mirror);
        let (rising, falling) = if mirror {
            (limits.jmin, limits.jmax)
        } else {
            (limits.jmax, limits.jmin)
        };
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
        // A rise may come out below 0 by rounding. The sum of both stays, and with it the duration.
        let rises = first + last;
        let first = first.at_least(R::ZERO).at_most(rises);
        let last = rises - first;
        // The accelerations at the ends are exact.
        let [peak, trough] = [peak, trough].map(|a| a.negate_if(mirror));
        let peak = if first + top > R::ZERO { peak } else { self.a0 };
        let trough = if last + bottom > R::ZERO {
            trough
        } else {
            self.a1
        };
        // The fall pauses at 0 for the cruise.
        let (pause, before, after) = if cruise > R::ZERO {
            (R::ZERO, peak.abs(), trough.abs())
        } else {
            (trough, fall, R::ZERO)
        };
        let mut visit = |from, jerk, duration| {
            visit(Leg {
                from,
                jerk,
                duration,
            })
        };
        visit(self.a0, rising, up * first);
        visit(peak, R::ZERO, top);
        visit(peak, falling, down * before);
        visit(pause, R::ZERO, cruise);
        visit(pause, falling, down * after);
        visit(trough, R::ZERO, bottom);
        visit(trough, rising, up * last);
    }
}

impl<R: Real> Pace<R> {
    fn of(limits: &Limits<R>) -> Self {
        Self {
            up: R::ONE / limits.jmax,
            down: -(R::ONE / limits.jmin),
        }
    }
}
