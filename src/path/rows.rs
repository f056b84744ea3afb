//! First plans that pass rows of points: each row between two corners is a motion along its curve.
//!
//! `docs/path-theory.md` has the reasons, in "The first plan".

use core::ops::Range;

use super::chain::Chain;
use super::memory::Column;
use crate::findings::{Error, Findings};
use crate::interval::ramp::{PerJerk, Ramp};
use crate::limits::Limits;
use crate::online::Move;
use crate::real::Real;
use crate::roots::root_between;
use crate::state::State;

/// How much slower the first plan becomes before its steps: a part of its durations.
pub(super) fn slower<R: Real>() -> R {
    R::ONE + R::HALF * R::SIXTEENTH
}

/// Which part of the limits the first plan uses at most, so that it is off all of them.
fn most<R: Real>() -> R {
    R::ONE - R::SIXTEENTH * R::SIXTEENTH * R::SIXTEENTH
}

/// The share of the limits that a row takes first, in sixteenths: if the whole plan becomes slower before its steps, and if it does not.
const ALL: u8 = 16;
pub(super) const NEARLY_ALL: u8 = 15;
/// How often parts of a row become slower before it counts as impossible.
const MOST_TRIES: u32 = 40;

/// How a row is passed.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Pass {
    /// As one move, slower and slower until it can take the bends.
    AsOne,
    /// In parts with limits of their own, which bends lower.
    InParts,
}

/// Three quarters of a limit: what bends take at most, and what counts as left by them at least. Where this is too much, a row becomes slower.
fn for_bends<R: Real>(limit: R) -> R {
    (R::HALF + R::HALF * R::HALF) * limit
}

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
    let mut run = Move::default();
    let stops = run.stop(limits, start).is_ok();
    if stops { run.end().position } else { R::ZERO }
}

impl<R: Real> Chain<'_, '_, R> {
    /// Replaces the plan with stops by a shorter one, if the path begins and ends at rest. Whether there is one.
    pub fn pass_rows(&mut self) -> bool {
        self.rests_at(0) && self.rests_at(self.sections) && self.pass_rows_from(0, ALL)
    }

    pub fn rests_at(&self, point: usize) -> bool {
        (0..self.axes).all(|axis| self.at(point, axis) == [R::ZERO; 2])
    }

    /// Stretches the time of the plan by this factor. Its end keeps its state.
    pub fn scale_time(&mut self, slower: R) {
        for section in 0..self.sections {
            let duration = self.memory.durations.at(section);
            self.memory.durations.put(section, slower * duration);
        }
        for row in 0..self.axes * self.sections {
            let [v, a] = self.memory.states.row(row);
            self.memory.states.set(row, [v / slower, a / (slower * slower)]);
        }
    }

    pub fn is_strictly_inside(&self) -> bool {
        let mut sections = 0..self.sections;
        sections.all(|section| self.is_possible(section, self.memory.durations.at(section))) && self.points_are_inside()
    }

    /// Passes the points of each row between two rests from a point on, with this share of the limits. Whether there is such a row.
    pub fn pass_rows_from(&mut self, mut first: usize, share: u8) -> bool {
        self.keep_plan();
        self.measure_axes();
        let mut passes = false;
        while first < self.sections {
            let row = first..self.next_corner(first);
            first = row.end;
            let rests = self.rests_at(row.start) && self.rests_at(row.end);
            passes |= row.len() > 1 && rests && self.pass_row(share, State::at(R::ZERO), row);
        }
        passes
    }

    /// Passes the points of a row as a fast motion along its curve: as one move or in parts, whichever is shorter. Whether this is possible, and
    /// shorter than the plan that is kept.
    pub fn pass_row(&mut self, share: u8, start: State<R>, row: Range<usize>) -> bool {
        self.lay_curve(row.clone());
        let mut duration = |pass| {
            self.take_share(row.clone(), share);
            self.pass_along(start, row.clone(), pass)
        };
        let [as_one, in_parts] = [Pass::AsOne, Pass::InParts].map(&mut duration);
        let duration = if as_one < in_parts { duration(Pass::AsOne) } else { in_parts };
        duration < R::INFINITY
    }

    /// Takes this share of the limits along a row, in sixteenths.
    pub fn take_share(&mut self, row: Range<usize>, share: u8) {
        for section in row {
            self.memory.of_durations.put(section, R::from(share) * R::SIXTEENTH);
        }
    }

    /// Passes the points of a row, slower and slower. Returns its duration, s, which is infinite if it is impossible, or not shorter than the plan that
    /// is kept.
    fn pass_along(&mut self, start: State<R>, row: Range<usize>, pass: Pass) -> R {
        let duration = |durations: &Column<R>| row.clone().fold(R::ZERO, |sum, section| sum + durations.at(section));
        for _ in 0..MOST_TRIES {
            self.limit_speeds(start, row.clone(), pass);
            if self.pass_parts(start, row.clone(), pass) {
                let passed = duration(&self.memory.durations);
                if passed < duration(&self.memory.tried) {
                    return passed;
                }
                break;
            }
        }
        self.take_back(row);
        R::INFINITY
    }

    /// Which share of the limits the motion takes along a section. They stand in `of_durations` before the first step.
    fn share(&self, section: usize) -> R {
        self.memory.of_durations.at(section)
    }

    /// The highest speed along a section.
    fn highest_speed(&self, section: usize, pass: Pass) -> R {
        let speeds = (0..self.axes).filter_map(|axis| self.highest_speed_for(axis, section, pass).ok());
        speeds.fold(R::INFINITY, R::at_most)
    }

    /// The highest speed along a section that the limits of an axis allow. Its bends take `|q''| v²` of the acceleration, and `|q'''| v³` of the jerk.
    fn highest_speed_for(&self, axis: usize, section: usize, pass: Pass) -> Result<R, Error> {
        let limits = self.limits_by_slope(section, axis)?;
        let [bend, twist] = self.limiting_bends(section, axis, pass);
        let most_a = for_bends(limits.amax.at_most(-limits.amin));
        let most_j = for_bends(limits.jmax.at_most(-limits.jmin));
        let speed = (limits.vmax / self.mean_slope(section, axis).abs()).at_most((most_a / bend).sqrt());
        let is_too_fast = twist * speed * speed * speed > most_j;
        Ok(if is_too_fast { (most_j / twist).cube_root_above().at_most(speed) } else { speed })
    }

    fn limiting_bends(&self, section: usize, axis: usize, pass: Pass) -> [R; 2] {
        if pass == Pass::AsOne { [R::ZERO; 2] } else { self.bend_and_twist(section, axis) }
    }

    /// The limits of an axis in the direction in which it moves along a section.
    fn limits_by_slope(&self, section: usize, axis: usize) -> Result<Limits<R>, Error> {
        let limits = self.limits(section, axis)?;
        Ok(if self.displacement(section, axis) < R::ZERO { limits.mirrored() } else { *limits })
    }

    /// The limits of a motion along some sections: what their bends leave of acceleration and jerk.
    pub fn limits_along(&self, sections: Range<usize>, pass: Pass) -> Limits<R> {
        let speeds = sections.clone().map(|section| self.share(section) * self.highest_speed(section, pass));
        let vmax = most::<R>() * speeds.fold(R::INFINITY, R::at_most);
        let (square, cube) = (vmax * vmax, vmax * vmax * vmax);
        let mut along = Limits::symmetric(R::INFINITY, R::INFINITY, vmax);
        for section in sections {
            for axis in 0..self.axes {
                if let Ok(limits) = self.limits_by_slope(section, axis) {
                    let [bend, twist] = self.limiting_bends(section, axis, pass);
                    let share = most::<R>() * self.share(section) / self.mean_slope(section, axis).abs();
                    let left = |limit: R, of: R, power: R| {
                        let by_bends = if of > R::ZERO { of * power } else { R::ZERO };
                        share * (limit - by_bends).at_least(for_bends(limit))
                    };
                    along.amax = along.amax.at_most(left(limits.amax, bend, square));
                    along.amin = along.amin.at_least(-left(-limits.amin, bend, square));
                    along.jmax = along.jmax.at_most(left(limits.jmax, twist, cube));
                    along.jmin = along.jmin.at_least(-left(-limits.jmin, twist, cube));
                }
            }
        }
        along
    }

    /// Finds the highest speeds along a row at the points where its limits change: a pass ahead, and a pass back. They stand in `weights`, which
    /// are infinite at the other points, where the start could not stop yet, and along one move.
    fn limit_speeds(&mut self, start: State<R>, row: Range<usize>, pass: Pass) {
        let (mut first, mut speed, mut passed) = (row.start, start.velocity, R::ZERO);
        let mut limits = self.limits_along(first..first + 1, pass);
        let uncut = if pass == Pass::AsOne { R::INFINITY } else { stop_length(&limits, start) };
        for point in row.start + 1..row.end {
            let mut highest = R::INFINITY;
            let next = self.limits_along(point..point + 1, pass);
            passed = passed + self.arc(point - 1);
            if passed >= uncut && !are_like(&limits, &next) {
                let sections = first..point;
                speed = reached(&self.limits_along(sections.clone(), pass), self.length(sections), speed);
                (first, limits, highest) = (point, next, speed);
            }
            self.memory.weights.put(point - 1, highest);
        }
        let mut last = row.end;
        speed = R::ZERO;
        self.memory.weights.put(last - 1, speed);
        for point in (row.start + 1..row.end).rev() {
            let ahead = self.memory.weights.at(point - 1);
            if ahead.is_finite() {
                let sections = point..last;
                let limits = self.limits_along(sections.clone(), pass).reversed();
                speed = reached(&limits, self.length(sections), speed).at_most(ahead);
                self.memory.weights.put(point - 1, speed);
                last = point;
            }
        }
    }

    fn length(&self, sections: Range<usize>) -> R {
        sections.fold(R::ZERO, |sum, section| sum + self.arc(section))
    }

    /// Passes the parts of a row between the points where its limits change, each as one move. A part that is impossible becomes slower for
    /// the next try. Whether all are possible.
    fn pass_parts(&mut self, start: State<R>, row: Range<usize>, pass: Pass) -> bool {
        let (mut first, mut state, mut passes) = (row.start, start, true);
        for point in row.start + 1..=row.end {
            let speed = self.memory.weights.at(point - 1);
            if speed.is_finite() {
                let sections = first..point;
                let end = State { velocity: speed, ..State::at(self.length(sections.clone())) };
                let limits = self.limits_along(sections.clone(), pass);
                if self.pass_part(&limits, state, end, sections.clone()).is_none() {
                    self.ease(sections);
                    passes = false;
                }
                (first, state) = (point, State { position: R::ZERO, ..end });
            }
        }
        passes
    }

    fn ease(&mut self, sections: Range<usize>) {
        for section in sections {
            let share = self.share(section) * (R::ONE - R::SIXTEENTH - R::SIXTEENTH);
            self.memory.of_durations.put(section, share);
        }
    }

    #[inline(never)] // for its stack
    fn pass_part(&mut self, limits: &Limits<R>, start: State<R>, end: State<R>, sections: Range<usize>) -> Option<()> {
        let mut run = Move::default();
        let found = run.plan(limits, start, end).ok()?;
        (!found.contains(Findings::OVERSHOOTS)).then_some(())?;
        let (mut passed, mut time) = (R::ZERO, R::ZERO);
        for section in sections.clone() {
            let point = section + 1;
            passed = passed + self.arc(section);
            let at = if point == sections.end { run.t } else { run.time_at(passed)? };
            let state = if point == sections.end { end } else { run.state_at(at) };
            if state.velocity > R::ZERO {
                self.pass(point, state);
            }
            let duration = at - time;
            self.memory.durations.put(section, duration);
            (self.is_possible(section, duration) && self.is_point_inside(point)).then_some(())?;
            time = at;
        }
        Some(())
    }

    /// Takes back the plan of a row that is kept.
    pub fn take_back(&mut self, row: Range<usize>) {
        for section in row.clone() {
            let kept = self.memory.tried.at(section);
            self.memory.durations.put(section, kept);
        }
        for state in (row.start + 1) * self.axes..row.end * self.axes {
            let kept = self.memory.tried_states.row(state);
            self.memory.states.set(state, kept);
        }
    }

    /// Makes every axis pass a point with this motion along the curve.
    fn pass(&mut self, point: usize, along: State<R>) {
        let State { velocity, acceleration, .. } = along;
        for axis in 0..self.axes {
            let [slope, bend] = self.slope_and_bend(point, axis);
            let state = [slope * velocity, bend * velocity * velocity + slope * acceleration];
            self.memory.states.set(point * self.axes + axis, state);
        }
    }
}
