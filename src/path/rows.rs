//! First plans that pass rows of points: each row between two corners is a motion along its curve.
//! `docs/path-theory.md` has the reasons, in "The first plan".

use super::chain::Chain;
use super::memory::Memory;
use crate::findings::Findings;
use crate::interval::ramp::{PerJerk, Ramp};
use crate::limits::Limits;
use crate::online::Move;
use crate::real::Real;
use crate::roots::root_between;
use crate::state::State;
use core::ops::Range;

/// How fast the first plan is at most when the steps begin, so that it is strictly feasible: a part of its speed.
pub(super) fn nearly_all<R: Real>() -> R {
    R::ONE - R::HALF * R::SIXTEENTH
}

/// How often parts of a row become slower before it counts as impossible.
const MOST_TRIES: u32 = 80;

/// Whether two limits differ by at most a quarter.
fn are_like<R: Real>(one: &Limits<R>, other: &Limits<R>) -> bool {
    let quarter = R::ONE + R::HALF * R::HALF;
    let is_like = |x: R, y: R| x <= quarter * y && y <= quarter * x;
    is_like(one.vmax, other.vmax)
        && is_like(one.amax, other.amax)
        && is_like(-one.amin, -other.amin)
        && is_like(one.jmax, other.jmax)
        && is_like(-one.jmin, -other.jmin)
}

/// The highest speed after this length that a motion reaches from the speed `from`. The accelerations at both ends are 0.
fn reached<R: Real>(limits: &Limits<R>, length: R, from: R) -> R {
    let (per_jerk, zero) = (PerJerk::of(limits), R::ZERO);
    let from = from.at_most(limits.vmax);
    let beyond = |gain: R| {
        let ramp = Ramp::over(gain, zero, zero, limits.amax, per_jerk);
        let displacement = ramp.passed(from, zero, zero, per_jerk).displacement;
        let slope = (from + gain) / ramp.peak + R::HALF * per_jerk.gd * ramp.peak;
        (displacement - length, slope)
    };
    let most = limits.vmax - from;
    let is_reached = !(most > zero && most < R::INFINITY && beyond(most).0 > zero);
    from + if is_reached { most } else { root_between(zero, most, beyond) }
}

/// How far a start gets until it stops as early as possible.
#[inline(never)] // for its stack
pub(super) fn stop_length<R: Real>(limits: &Limits<R>, start: State<R>) -> R {
    if start.velocity == R::ZERO {
        return R::ZERO;
    }
    let mut run = Move::default();
    if run.stop(limits, start).is_ok() { run.end().position } else { R::ZERO }
}

/// How long a narrow section takes, whose duration rounding makes inaccurate as the difference of two times, s. With a constant jerk its length is
/// `(v0 + v1) t/2 + (a0 - a1) t²/12`.
fn duration_of<R: Real>(length: R, from: State<R>, to: State<R>, inaccurate: R) -> R {
    let by_accelerations = (from.acceleration - to.acceleration) * inaccurate * inaccurate / R::from(12);
    R::from(2) * (length - by_accelerations) / (from.velocity + to.velocity)
}

fn sum<R: Real>(sections: Range<usize>, of: impl Fn(usize) -> R) -> R {
    sections.fold(R::ZERO, |sum, section| sum + of(section))
}

impl<R: Real> Chain<'_, '_, R> {
    /// Stretches the time of the plan by this factor, also at its ends.
    pub fn scale_time(&mut self, slower: R) {
        for section in 0..self.sections {
            let duration = self.memory.plan.durations.at(section);
            self.memory.plan.durations.put(section, slower * duration);
        }
        for row in 0..self.axes * (self.sections + 1) {
            let [v, a] = self.memory.plan.states.row(row);
            self.memory.plan.states.set(row, [v / slower, a / (slower * slower)]);
        }
    }

    /// Passes the points of each row that begins at rest from a point on, at this share of the highest speeds. Whether there is such a row.
    pub fn pass_rows_from(&mut self, mut first: usize, share: R) -> bool {
        self.keep_plan();
        self.measure_axes();
        let mut passes = false;
        while first < self.sections {
            let row = first..self.next_corner(first);
            first = row.end;
            if row.len() > 1 && self.rests_at(row.start) {
                passes |= self.pass_row(share, State::at(R::ZERO), row);
            }
        }
        passes
    }

    /// Passes the points of a row as a fast motion along its curve: in parts whose bends limit the speed, or as one move that is slow enough for
    /// its bends, whichever is shorter. Whether this is possible, and shorter than the plan that is kept.
    pub fn pass_row(&mut self, share: R, start: State<R>, row: Range<usize>) -> bool {
        let Some(end) = self.along(row.end) else { return false };
        self.lay_curve(row.clone());
        let in_parts = self.pass_along(share, [start, end], row.clone(), true);
        self.ignore_bends(row.clone());
        let as_one = self.pass_along(share, [start, end], row, false);
        in_parts || as_one
    }

    /// Keeps the pass of a row if it is shorter than the plan that is kept, else takes that one back. Whether it is shorter.
    fn pass_along(&mut self, share: R, ends: [State<R>; 2], row: Range<usize>, has_parts: bool) -> bool {
        self.take_share(row.clone(), share);
        let is_shorter = self.find_pass(ends, row.clone(), has_parts);
        let states = (row.start + 1) * self.axes..row.end * self.axes;
        let Memory { plan, other, .. } = &mut self.memory;
        let (to, from) = if is_shorter { (other, plan) } else { (plan, other) };
        to.durations.copy_rows(&from.durations, row);
        to.states.copy_rows(&from.states, states);
        is_shorter
    }

    /// Passes the points of a row, slower and slower until this is possible. Whether it is shorter than the plan that is kept.
    fn find_pass(&mut self, ends: [State<R>; 2], row: Range<usize>, has_parts: bool) -> bool {
        let kept = sum(row.clone(), |section| self.memory.other.durations.at(section));
        for _ in 0..MOST_TRIES {
            let least = sum(row.clone(), |section| self.arc(section) / self.speed(section));
            if least >= kept {
                break;
            }
            self.limit_speeds(ends, row.clone(), has_parts);
            if self.pass_parts(ends, row.clone()) {
                return sum(row, |section| self.memory.plan.durations.at(section)) < kept;
            }
        }
        false
    }

    /// Finds the highest speeds along a row at the points where its limits change: a pass ahead, and a pass back. They are infinite
    /// at the other points, where the start could not stop yet or the end could not be reached from rest, and along one move.
    fn limit_speeds(&mut self, [start, end]: [State<R>; 2], row: Range<usize>, has_parts: bool) {
        let (mut first, mut speed, mut passed) = (row.start, start.velocity.at_least(R::ZERO), R::ZERO);
        let mut limits = self.limits_along(first..first + 1);
        let uncut = if has_parts { stop_length(&limits, start) } else { R::INFINITY };
        let back = State { acceleration: -end.acceleration, ..end };
        let until = self.length(row.clone()) - stop_length(&self.limits_along(row.end - 1..row.end).reversed(), back);
        for point in row.start + 1..row.end {
            let mut highest = R::INFINITY;
            passed = passed + self.arc(point - 1);
            if passed >= uncut && passed <= until {
                let next = self.limits_along(point..point + 1);
                if !are_like(&limits, &next) {
                    speed = reached(&self.limits_along(first..point), self.length(first..point), speed);
                    (first, limits, highest) = (point, next, speed);
                }
            }
            self.memory.rows_mut().boundary_speed.put(point - 1, highest);
        }
        let mut last = row.end;
        self.memory.rows_mut().boundary_speed.put(last - 1, end.velocity);
        speed = end.velocity.at_least(R::ZERO);
        for point in (row.start + 1..row.end).rev() {
            let ahead = self.memory.rows().boundary_speed.at(point - 1);
            if ahead.is_finite() {
                let limits = self.limits_along(point..last).reversed();
                speed = reached(&limits, self.length(point..last), speed).at_most(ahead);
                self.memory.rows_mut().boundary_speed.put(point - 1, speed);
                last = point;
            }
        }
    }

    #[inline(never)] // for its size: it is asked in several places
    fn length(&self, sections: Range<usize>) -> R {
        sum(sections, |section| self.arc(section))
    }

    /// Passes the parts of a row between the points where its limits change, each as one move. A part that is impossible becomes slower for
    /// the next try. Whether all are possible.
    fn pass_parts(&mut self, [start, end]: [State<R>; 2], row: Range<usize>) -> bool {
        let (mut first, mut state, mut passes) = (row.start, start, true);
        for section in row.clone() {
            let point = section + 1;
            let speed = self.memory.rows().boundary_speed.at(section);
            if speed.is_finite() {
                let sections = first..point;
                let next = if point == row.end { end } else { State { velocity: speed, ..State::at(R::ZERO) } };
                let to = State { position: self.length(sections.clone()), ..next };
                let limits = self.limits_along(sections.clone());
                if self.pass_part(&limits, state, to, sections.clone()).is_none() {
                    self.ease(sections);
                    passes = false;
                }
                (first, state) = (point, next);
            }
        }
        passes
    }

    #[inline(never)] // for its stack
    fn pass_part(&mut self, limits: &Limits<R>, start: State<R>, end: State<R>, sections: Range<usize>) -> Option<()> {
        let mut run = Move::default();
        let found = run.plan(limits, start, end).ok()?;
        let turns = start.velocity < R::ZERO || end.velocity < R::ZERO;
        // Of one axis the move through all points is the fastest plan.
        let is_all = self.axes == 1 && sections == (0..self.sections);
        (turns || is_all || !found.contains(Findings::OVERSHOOTS)).then_some(())?;
        let (mut passed, mut time, mut from) = (R::ZERO, R::ZERO, start);
        for section in sections.clone() {
            let point = section + 1;
            passed = passed + self.arc(section);
            let at = if point == sections.end { run.t } else { run.time_at(passed)? };
            let to = if point == sections.end { end } else { run.state_at(at) };
            if point < self.sections {
                self.pass(point, to);
            }
            let mut duration = at - time;
            if !self.is_possible(section, duration) {
                duration = duration_of(self.arc(section), from, to, duration);
            }
            self.memory.plan.durations.put(section, duration);
            self.is_section_feasible(section).then_some(())?;
            (time, from) = (at, to);
        }
        Some(())
    }

    /// Makes every axis pass a point with this motion along the curve.
    fn pass(&mut self, point: usize, along: State<R>) {
        let State { velocity, acceleration, .. } = along;
        for axis in 0..self.axes {
            let [slope, bend, _] = self.at_point(point, axis);
            let state = [slope * velocity, bend * velocity * velocity + slope * acceleration];
            self.memory.plan.states.set(point * self.axes + axis, state);
        }
    }
}
