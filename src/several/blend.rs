//! The motion of a given duration: a mean of two motions on the border. `docs/planner.md` has the theory, in "Several axes".

use crate::interval::border::Border;
use crate::interval::crossing;
use crate::interval::profile::{MOST_SEGMENTS, Profile, Segment};
use crate::online::{Move, problem::Problem};
use crate::real::Real;

/// Two motions of the same duration, whose mean travels a displacement.
pub(super) struct Blend<R> {
    /// The motion that covers the largest displacement.
    farthest: Profile<R>,
    /// The motion that covers the largest displacement in the mirrored axis.
    nearest: Profile<R>,
    /// The weight of the first motion.
    share: R,
}

/// The shortest possible duration from `duration` on, which is not below that of the fastest motion, s.
pub(super) fn next_duration<R: Real>(problem: &Problem<R>, duration: R) -> R {
    let t = problem.after_recovery(duration);
    let next = crossing::next_duration(&problem.border, t, R::INFINITY, problem.displacement());
    if next > t { problem.with_recovery(next) } else { duration }
}

impl<R: Real> Blend<R> {
    /// A motion of this duration, if one is possible: a slow one that keeps its limits, if there is one.
    pub fn of(problem: &Problem<R>, duration: R) -> Option<Self> {
        let (border, h, t) = (&problem.border, problem.displacement().h, problem.after_recovery(duration));
        let slow = Self::over(&slower(border, h, t), h, t);
        // Without a negative weight the mean keeps the limits that both motions keep.
        let slow = slow.filter(|mean| mean.share >= R::ZERO && mean.share <= R::ONE);
        slow.or_else(|| Self::over(border, h, t))
    }

    /// The mean over `h` of the motions of the duration `t`. `None` if the end cannot be reached in this duration.
    fn over(border: &Border<R>, h: R, t: R) -> Option<Self> {
        let mirrored = border.mirrored();
        let farthest = border.farthest(t)?;
        let nearest = Profile { mirrored: true, ..mirrored.farthest(t)? };
        let most = border.displacement(&farthest);
        let least = -mirrored.displacement(&nearest);
        let (beyond, width) = (h - least, most - least);
        // An axis that need not move has no width.
        let share = if beyond == width { R::ONE } else { beyond / width };
        Some(Self { farthest, nearest, share })
    }

    /// Writes the recovery and the mean.
    pub fn write(&self, problem: &Problem<R>, ctx: &mut Move<R>, duration: R) {
        let t = problem.after_recovery(duration);
        let share = self.share.at_least(R::ZERO).at_most(R::ONE);
        // The motion with the larger weight comes first. So the mean of equal numbers is exact, and a small one has a small rounding error.
        let (one, other, weight) = if share > R::HALF {
            (&self.farthest, &self.nearest, R::ONE - share)
        } else {
            (&self.nearest, &self.farthest, share)
        };
        let mut one = Cursor::over(t, &problem.border.segments(one));
        let mut other = Cursor::over(t, &problem.border.segments(other));
        let mean = |x: R, y: R| x + weight * (y - x);
        let mut writer = problem.writer(ctx);
        let mut now = Instant::start(t);
        // Each round ends a segment of one motion, or of both.
        for _ in 1..one.count + other.count {
            let next = one.end().first(other.end());
            writer.write(&Segment {
                from: mean(one.acceleration(now), other.acceleration(now)),
                jerk: mean(one.segment().jerk, other.segment().jerk),
                duration: next.since(now),
            });
            one.pass(next);
            other.pass(next);
            now = next;
        }
        writer.end(problem.to);
        ctx.end_at(duration);
    }
}

/// The axis with a lower limit of its velocity, if it has time: twice the mean velocity is enough between standstills. So the numbers of a
/// slow motion are small, and with them their rounding errors.
fn slower<R: Real>(border: &Border<R>, h: R, t: R) -> Border<R> {
    let mean = h.abs() / t;
    let speed = mean + mean + border.v0.abs() + border.v1.abs() + border.eased;
    let mut slower = *border;
    slower.limits.vmax = border.limits.vmax.at_most(speed);
    slower.limits.vmin = border.limits.vmin.at_least(-speed);
    slower.above = border.above.at_most(speed - border.v0);
    slower.below = border.below.at_most(speed + border.v0);
    slower
}

/// A time in a motion. It is counted from the nearer end, so that a short segment next to a long cruise keeps its digits.
#[derive(Clone, Copy)]
struct Instant<R> {
    /// Since the start, s.
    since_start: R,
    /// Until the end, s.
    until_end: R,
}

impl<R: Real> Instant<R> {
    fn start(t: R) -> Self {
        Self { since_start: R::ZERO, until_end: t }
    }

    fn end(t: R) -> Self {
        Self { since_start: t, until_end: R::ZERO }
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

    fn since(self, earlier: Self) -> R {
        if earlier.is_late() { earlier.until_end - self.until_end } else { self.since_start - earlier.since_start }
    }
}

/// A place in a motion that moves on in order of time.
struct Cursor<R> {
    t: R,
    segments: [Segment<R>; MOST_SEGMENTS],
    /// When each segment ends.
    ends: [Instant<R>; MOST_SEGMENTS],
    count: usize,
    current: usize,
    /// When the segment under way began.
    began: Instant<R>,
}

impl<R: Real> Cursor<R> {
    fn over(t: R, segments: &[Segment<R>; MOST_SEGMENTS]) -> Self {
        let mut cursor = Self {
            t,
            segments: [Segment::default(); MOST_SEGMENTS],
            ends: [Instant::end(t); MOST_SEGMENTS],
            count: 0,
            current: 0,
            began: Instant::start(t),
        };
        // Those that have a duration.
        let mut passed = R::ZERO;
        let lasting = segments.iter().filter(|segment| segment.duration > R::ZERO);
        for (segment, (place, end)) in lasting.zip(cursor.segments.iter_mut().zip(&mut cursor.ends)) {
            passed = passed + segment.duration;
            *place = *segment;
            end.since_start = passed;
            cursor.count += 1;
        }
        cursor.count_from_end();
        cursor
    }

    /// Finds when the segments end, seen from the end of the motion.
    fn count_from_end(&mut self) {
        let mut until_end = R::ZERO;
        let segments = self.segments.iter().zip(&mut self.ends).take(self.count);
        for (segment, end) in segments.rev() {
            end.until_end = until_end;
            // One of both counts rules.
            if end.is_late() {
                end.since_start = self.t - until_end;
            } else {
                end.until_end = self.t - end.since_start;
            }
            until_end = until_end + segment.duration;
        }
    }

    fn segment(&self) -> Segment<R> {
        self.segments.get(self.current).copied().unwrap_or_default()
    }

    fn end(&self) -> Instant<R> {
        self.ends.get(self.current).copied().unwrap_or(Instant::end(self.t))
    }

    fn acceleration(&self, now: Instant<R>) -> R {
        let segment = self.segment();
        segment.from + segment.jerk * now.since(self.began)
    }

    fn pass(&mut self, next: Instant<R>) {
        let end = self.end();
        if self.current + 1 < self.count && end.since(next) <= R::ZERO {
            self.began = end;
            self.current += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::slower;
    use crate::interval::border::Border;
    use crate::limits::Limits;

    /// Twice the mean velocity, those of both ends, and what the accelerations at both ends add.
    #[test]
    fn a_slow_motion_has_a_lower_limit_of_its_velocity() {
        let border = Border::between([[-3.0, 4.0], [5.0, -6.0]], &Limits::symmetric(1.0, 9.0, 99.0));
        let numbers = |Border { limits, above, below, .. }| [limits.vmax, limits.vmin, above, below];
        let lower = 7.0 + 7.0 + 3.0 + 5.0 + 8.0 + 18.0;
        assert_eq!(numbers(slower(&border, -14.0, 2.0)), [lower, -lower, lower + 3.0, lower - 3.0]);
        assert_eq!(numbers(slower(&border, 98.0, 2.0)), [99.0, -99.0, 102.0, 96.0]);
    }
}
