//! First plans that pass rows of points: each row between two corners is a motion along its curve.
//!
//! `docs/path-theory.md` has the reasons, in "The first plan".

use core::ops::Range;

use super::chain::Chain;
use super::memory::Column;
use crate::findings::Findings;
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

/// The part of the limits that a straight row takes, in sixteenths: if the whole plan becomes slower before its steps, and if it does not.
const ALL: u8 = 16;
pub(super) const NEARLY_ALL: u8 = 15;
/// Parts of the limits of acceleration and jerk that are tried along other rows, in sixteenths. Bends use the rest.
pub(super) const PARTS: [u8; 6] = [8, 12, 4, 14, 2, 1];
/// How often the speed along a row is halved until its bends allow it.
const MOST_HALVINGS: u32 = 10;

/// How fast the motion along a row may be.
#[derive(Clone, Copy)]
pub(super) struct Pace<R> {
    /// The highest speed.
    pub speed: R,
    /// The part of the limits of acceleration and jerk, in sixteenths.
    pub part: u8,
}

impl<R: Real> Pace<R> {
    pub fn unlimited() -> Self {
        Self { speed: R::INFINITY, part: ALL }
    }
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

    /// Passes the points of each row between two rests from a point on. A straight row takes the part `straight` of its limits. Whether there is
    /// such a row.
    pub fn pass_rows_from(&mut self, mut first: usize, straight: u8) -> bool {
        self.keep_plan();
        self.measure_axes();
        let mut passes = false;
        while first < self.sections {
            let row = first..self.next_corner(first);
            first = row.end;
            passes |= self.rests_at(row.start) && self.rests_at(row.end) && self.pass_row(row, straight);
        }
        passes
    }

    fn pass_row(&mut self, row: Range<usize>, straight: u8) -> bool {
        if row.len() == 1 {
            return false;
        }
        self.lay_curve(row.clone());
        let (start, highest) = (State::at(R::ZERO), self.highest_speed(row.clone()));
        let speed_of = |part: u8| R::from(part) * R::SIXTEENTH * highest;
        if self.is_straight(row.clone()) {
            // Close to the limits rounding may make a section impossible.
            for part in [straight, NEARLY_ALL] {
                if self.pass_along(Pace { speed: speed_of(part), part }, start, row.clone()) {
                    return true;
                }
            }
        }
        self.slow_until(speed_of(straight), |chain, pace| chain.pass_along(pace, start, row.clone()))
    }

    /// The highest speed that the limits of the velocities allow in one of these sections.
    pub fn highest_speed(&self, row: Range<usize>) -> R {
        let highest = |section| self.limits_along(Pace::unlimited(), section..section + 1).vmax;
        row.map(highest).fold(R::ZERO, R::at_least)
    }

    /// Tries slower and slower motions along a row. Whether one passes.
    pub fn slow_until(&mut self, mut speed: R, passes: impl Fn(&mut Self, Pace<R>) -> bool) -> bool {
        let halvings = if speed.is_finite() { MOST_HALVINGS } else { 1 };
        for _ in 0..halvings {
            for part in PARTS {
                if passes(self, Pace { speed, part }) {
                    return true;
                }
            }
            speed = R::HALF * speed;
        }
        false
    }

    /// The limits of a motion along some sections.
    pub fn limits_along(&self, pace: Pace<R>, sections: Range<usize>) -> Limits<R> {
        let mut along = Limits::symmetric(R::INFINITY, R::INFINITY, pace.speed);
        for section in sections {
            let chord = self.chord(section);
            for axis in 0..self.axes {
                let slope = self.displacement(section, axis) / chord;
                let steepness = slope.abs();
                if let (true, Ok(limits)) = (steepness > R::ZERO, self.limits(section, axis)) {
                    let limits = if slope < R::ZERO { limits.mirrored() } else { *limits };
                    along.vmax = along.vmax.at_most(limits.vmax / steepness);
                    along.amax = along.amax.at_most(limits.amax / steepness);
                    along.amin = along.amin.at_least(limits.amin / steepness);
                    along.jmax = along.jmax.at_most(limits.jmax / steepness);
                    along.jmin = along.jmin.at_least(limits.jmin / steepness);
                }
            }
        }
        let most = most::<R>();
        let part = most * R::from(pace.part) * R::SIXTEENTH;
        let vmax = most * along.vmax;
        Limits {
            vmax,
            vmin: -vmax,
            amax: part * along.amax,
            amin: part * along.amin,
            jmax: part * along.jmax,
            jmin: part * along.jmin,
        }
    }

    /// Passes the points of a row as a fast motion along its curve. Whether this is possible, and shorter than the plan that is kept.
    pub fn pass_along(&mut self, pace: Pace<R>, start: State<R>, row: Range<usize>) -> bool {
        self.limit_speeds(pace, start.velocity, row.clone());
        let duration = |durations: &Column<R>| row.clone().fold(R::ZERO, |sum, section| sum + durations.at(section));
        let passes = self.pass_parts(pace, start, row.clone()).is_some()
            && duration(&self.memory.durations) < duration(&self.memory.tried);
        if !passes {
            self.take_back(row);
        }
        passes
    }

    /// Finds the highest speeds along a row at the points where its limits change: a pass ahead, and a pass back. They stand in `weights`, which
    /// are infinite at the other points.
    fn limit_speeds(&mut self, pace: Pace<R>, mut speed: R, row: Range<usize>) {
        let mut first = row.start;
        for point in row.start + 1..row.end {
            let mut highest = R::INFINITY;
            if !self.has_limits_like(point, first) {
                let sections = first..point;
                speed = reached(&self.limits_along(pace, sections.clone()), self.length(sections), speed);
                (first, highest) = (point, speed);
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
                let limits = self.limits_along(pace, sections.clone()).reversed();
                speed = reached(&limits, self.length(sections), speed).at_most(ahead);
                self.memory.weights.put(point - 1, speed);
                last = point;
            }
        }
    }

    /// Whether the limits along two sections differ by at most a quarter.
    fn has_limits_like(&self, section: usize, other: usize) -> bool {
        let [one, other] = [section, other].map(|section| self.limits_along(Pace::unlimited(), section..section + 1));
        let quarter = R::ONE + R::HALF * R::HALF;
        let is_like = |x: R, y: R| x <= quarter * y && y <= quarter * x;
        is_like(one.vmax, other.vmax)
            && is_like(one.amax, other.amax)
            && is_like(-one.amin, -other.amin)
            && is_like(one.jmax, other.jmax)
            && is_like(-one.jmin, -other.jmin)
    }

    fn length(&self, sections: Range<usize>) -> R {
        sections.fold(R::ZERO, |sum, section| sum + self.arc(section))
    }

    /// Passes the parts of a row between the points where its limits change, each as one move.
    fn pass_parts(&mut self, pace: Pace<R>, start: State<R>, row: Range<usize>) -> Option<()> {
        let (mut first, mut state) = (row.start, start);
        for point in row.start + 1..=row.end {
            let speed = self.memory.weights.at(point - 1);
            if speed.is_finite() {
                let sections = first..point;
                let end = State { velocity: speed, ..State::at(self.length(sections.clone())) };
                self.pass_part(&self.limits_along(pace, sections.clone()), state, end, sections)?;
                (first, state) = (point, State { position: R::ZERO, ..end });
            }
        }
        Some(())
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
