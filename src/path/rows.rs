//! First plans that pass rows of points: each row between two corners is one move along its chords.
//!
//! `docs/path-theory.md` has the reasons, in "The first plan".

use core::ops::Range;

use super::chain::Chain;
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::online::Move;
use crate::real::Real;
use crate::state::State;

/// How much slower the first plan becomes before its steps: a part of its durations.
pub(super) fn slower<R: Real>() -> R {
    R::ONE + R::HALF * R::SIXTEENTH
}

/// Which part of the limits the first plan uses at most, so that it is off all of them.
fn most<R: Real>() -> R {
    R::ONE - R::SIXTEENTH * R::SIXTEENTH
}

/// Parts of the limits of acceleration and jerk along a path that are tried, in sixteenths. Bends use the rest. In the middle both have most room.
pub(super) const PARTS: [u8; 4] = [8, 12, 4, 14];
/// The part of a row without bends.
const STRAIGHT: u8 = 15;
/// How often the speed along a path is halved until its bends allow it.
const MOST_HALVINGS: u32 = 10;

pub(super) fn part_of<R: Real>(limits: &Limits<R>, sixteenths: u8) -> Limits<R> {
    let part = R::from(sixteenths) * R::SIXTEENTH;
    Limits::symmetric(part * limits.jmax, part * limits.amax, limits.vmax)
}

impl<R: Real> Chain<'_, '_, R> {
    /// Replaces the plan with stops by a shorter one, if the path begins and ends at rest. Whether there is one.
    pub fn pass_rows(&mut self) -> Result<bool, Error> {
        if !self.rests_at(0) || !self.rests_at(self.sections) {
            return Ok(false);
        }
        self.measure_axes(Self::least_jerk);
        let is_row = self.pass_rows_from(0);
        let passes = self.axes == 1 && self.pass_twice()?;
        Ok(is_row || passes)
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

    /// Passes the points of each row between two rests from a point on as one move. Whether there is such a row.
    pub fn pass_rows_from(&mut self, mut first: usize) -> bool {
        self.keep_plan();
        let mut passes = false;
        while first < self.sections {
            let corner = self.next_corner(first);
            passes |= self.rests_at(first) && self.rests_at(corner) && self.pass_row(first..corner);
            first = corner;
        }
        passes
    }

    /// The next point after this one at which the path turns by more than 20°, or its end.
    pub fn next_corner(&self, point: usize) -> usize {
        let mut corner = point + 1;
        while corner < self.sections && !self.is_corner(corner) {
            corner += 1;
        }
        corner
    }

    fn is_corner(&self, point: usize) -> bool {
        let least = (R::ONE - R::SIXTEENTH) * self.chord(point - 1) * self.chord(point);
        self.product(point - 1, point) < least
    }

    fn pass_row(&mut self, row: Range<usize>) -> bool {
        let Some(limits) = self.limits_along(row.clone()) else {
            return false;
        };
        let start = State::at(R::ZERO);
        row.len() > 1
            && (self.is_straight(row.clone()) && self.pass_along(&part_of(&limits, STRAIGHT), start, row.clone())
                || self.slow_until(&limits, |chain, limits| chain.pass_along(limits, start, row.clone())))
    }

    /// Whether all chords of a row have one direction, up to rounding.
    fn is_straight(&self, row: Range<usize>) -> bool {
        let sections = || row.clone();
        let length = sections().fold(R::ZERO, |sum, section| sum + self.chord(section));
        let whole = self.norm(|axis| sections().fold(R::ZERO, |sum, section| sum + self.displacement(section, axis)));
        (R::ONE - R::from_index(row.len() as i32) * R::EPSILON) * length <= whole
    }

    /// Tries slower and slower motions with parts of these limits. Whether one passes.
    pub fn slow_until(&mut self, limits: &Limits<R>, passes: impl Fn(&mut Self, &Limits<R>) -> bool) -> bool {
        let mut speed = limits.vmax;
        let halvings = if speed.is_finite() { MOST_HALVINGS } else { 1 };
        for _ in 0..halvings {
            for part in PARTS {
                let slower = Limits { vmax: speed, vmin: -speed, ..*limits };
                if passes(self, &part_of(&slower, part)) {
                    return true;
                }
            }
            speed = R::HALF * speed;
        }
        false
    }

    /// Sets what each axis counts in, so that units do not matter. An axis with 0 or infinity does not count.
    pub fn measure_axes(&mut self, measure: impl Fn(&Self, usize) -> R) {
        for axis in 0..self.axes {
            let measure = measure(self, axis);
            self.memory.product.set(axis, [measure, R::ZERO]);
        }
    }

    /// The least limit of the jerk of an axis. By it, an axis counts as much as it takes time.
    pub fn least_jerk(&self, axis: usize) -> R {
        let limits = (0..self.sections).filter_map(|section| self.limits(section, axis).ok());
        limits.fold(R::INFINITY, |least, limits| least.at_most(limits.jmax.at_most(-limits.jmin)))
    }

    /// A quantity of an axis, by its measure.
    pub fn part(&self, axis: usize, of: R) -> R {
        let [measure, _] = self.memory.product.row(axis);
        if measure > R::ZERO { of / measure } else { R::ZERO }
    }

    /// The product of the displacements of two sections.
    fn product(&self, one: usize, other: usize) -> R {
        let part = |section, axis| self.part(axis, self.displacement(section, axis));
        (0..self.axes).fold(R::ZERO, |sum, axis| sum + part(one, axis) * part(other, axis))
    }

    fn norm(&self, of: impl Fn(usize) -> R) -> R {
        let parts = (0..self.axes).map(|axis| self.part(axis, of(axis)));
        parts.fold(R::ZERO, |sum, part| sum + part * part).sqrt()
    }

    /// The length of a section. Its arc is longer than its chord by a third of what the chords next to the waypoint turn.
    pub fn arc(&self, section: usize) -> R {
        let point = section + 1;
        let turn = if point < self.sections { R::ONE - self.steepness(point) } else { R::ZERO };
        self.chord(section) * (R::ONE + turn / R::from(3))
    }

    /// The length of the slopes of all axes at a waypoint: 1 on a straight line.
    pub fn steepness(&self, point: usize) -> R {
        self.norm(|axis| self.slope_and_bend(point, axis)[0])
    }

    /// The slope and half of the bend of the parabola through a point and the points next to it.
    pub fn slope_and_bend(&self, point: usize, axis: usize) -> [R; 2] {
        let [before, after] = [point - 1, point].map(|section| self.chord(section));
        let per = R::ONE / (before + after);
        let [m0, m1] = [self.displacement(point - 1, axis) / before, self.displacement(point, axis) / after];
        [(m0 * after + m1 * before) * per, (m1 - m0) * per]
    }

    fn chord(&self, section: usize) -> R {
        self.norm(|axis| self.displacement(section, axis))
    }

    /// The limits of the motion along the chords.
    pub fn limits_along(&self, row: Range<usize>) -> Option<Limits<R>> {
        let [mut velocity, mut acceleration, mut jerk] = [R::INFINITY; 3];
        for section in row {
            let chord = self.chord(section);
            for axis in 0..self.axes {
                let slope = self.displacement(section, axis).abs() / chord;
                let &Limits { vmax, vmin, amax, amin, jmax, jmin } = self.limits(section, axis).ok()?;
                if slope > R::ZERO {
                    velocity = velocity.at_most(vmax.at_most(-vmin) / slope);
                    acceleration = acceleration.at_most(amax.at_most(-amin) / slope);
                    jerk = jerk.at_most(jmax.at_most(-jmin) / slope);
                }
            }
        }
        let most = most::<R>();
        Some(Limits::symmetric(most * jerk, most * acceleration, most * velocity))
    }

    /// Passes the points of a row as the fastest motion along its chords. `None` if this is not possible, or not shorter than the plan that is kept.
    #[inline(never)] // for its stack
    pub fn pass_along(&mut self, limits: &Limits<R>, start: State<R>, row: Range<usize>) -> bool {
        let mut run = Move::default();
        let length = row.clone().fold(R::ZERO, |sum, section| sum + self.arc(section));
        let arrives =
            run.plan(limits, start, State::at(length)).is_ok_and(|found| !found.contains(Findings::OVERSHOOTS));
        let lasted = row.clone().fold(R::ZERO, |sum, section| sum + self.memory.tried.at(section));
        let passes = arrives && run.t < lasted && self.follow(&run, row.clone()).is_some();
        if !passes {
            self.take_back(row);
        }
        passes
    }

    fn follow(&mut self, run: &Move<R>, row: Range<usize>) -> Option<()> {
        let (mut passed, mut time) = (R::ZERO, R::ZERO);
        for section in row.clone() {
            passed = passed + self.arc(section);
            let point = section + 1;
            let at = if point == row.end { run.t } else { run.time_at(passed)? };
            let duration = at - time;
            self.memory.durations.put(section, duration);
            time = at;
            let passes = if point == row.end {
                self.is_possible(section, duration)
            } else {
                self.pass(point, run.state_at(at), duration)
            };
            passes.then_some(())?;
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

    /// Makes every axis pass a waypoint after `duration`, as near to the parabola through three points as it can. Whether all can.
    fn pass(&mut self, point: usize, along: State<R>, duration: R) -> bool {
        let (speed, steepness) = (along.velocity, self.steepness(point));
        (0..self.axes).all(|axis| {
            let [slope, bend] = self.slope_and_bend(point, axis);
            let slope = slope / steepness;
            let aim = [slope * speed, (bend + bend) * speed * speed + slope * along.acceleration];
            let smooth = self.at_constant_jerk(point - 1, axis, duration);
            [16u8, 12, 8, 4, 0].into_iter().any(|sixteenths| {
                let part = R::from(sixteenths) * R::SIXTEENTH;
                let between = |aim: R, smooth: R| part * aim + (R::ONE - part) * smooth;
                let state = [between(aim[0], smooth[0]), between(aim[1], smooth[1])];
                self.memory.states.set(point * self.axes + axis, state);
                self.bounds(point, axis).product(state).is_some()
                    && self.slacks(point - 1, axis, [self.at(point - 1, axis), state], duration).is_some()
            })
        })
    }

    /// The end of a section of this duration at constant jerk: velocity and acceleration.
    fn at_constant_jerk(&self, section: usize, axis: usize, t: R) -> [R; 2] {
        let [v, a] = self.at(section, axis);
        let mean = self.displacement(section, axis) / t;
        let change = R::from(3) * (mean - v - R::HALF * a * t);
        [v + a * t + change, a + (change + change) / t]
    }
}
