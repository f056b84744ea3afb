//! First plans from rest that pass waypoints: straight rows of points as one move, and for one axis the highest speeds without acceleration.
//!
//! `docs/path-theory.md` has the reasons, in "The first plan".

use super::chain::Chain;
use crate::findings::Error;
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
    R::ONE - R::SIXTEENTH * R::SIXTEENTH
}

/// A row is straight if so many times its highest speed would not use a quarter of the limits across it.
const STRAIGHT: u8 = 60;

impl<R: Real> Chain<'_, '_, R> {
    /// Replaces the plan with stops by a shorter one, if the path begins and ends at rest. Whether there is one.
    pub fn pass_rows(&mut self) -> Result<bool, Error> {
        if !self.rests_at(0) || !self.rests_at(self.sections) {
            return Ok(false);
        }
        let is_row = self.merge_row().is_some();
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

    /// Plans the path as one move, if it is a straight row of points. `None` if it is not, or if the move is not possible.
    fn merge_row(&mut self) -> Option<()> {
        self.measure_axes(Self::whole_displacement);
        let limits = self.limits_along()?;
        let mut run = Move::default();
        let length = (0..self.sections).fold(R::ZERO, |sum, section| sum + self.arc(section));
        run.plan(&limits, State::at(R::ZERO), State::at(length)).ok()?;
        self.is_straight(R::from(STRAIGHT) * run.extremes().highest.velocity).then_some(())?;
        self.pass_along(&run, self.sections)
    }

    /// Sets what each axis counts in, so that units do not matter. An axis with 0 or infinity does not count.
    pub fn measure_axes(&mut self, measure: impl Fn(&Self, usize) -> R) {
        for axis in 0..self.axes {
            let measure = measure(self, axis);
            self.memory.product.set(axis, [measure, R::ZERO]);
        }
    }

    fn whole_displacement(&self, axis: usize) -> R {
        (0..self.sections).fold(R::ZERO, |sum, section| sum + self.displacement(section, axis).abs())
    }

    /// A quantity of an axis, by its measure.
    pub fn part(&self, axis: usize, of: R) -> R {
        let [measure, _] = self.memory.product.row(axis);
        if measure > R::ZERO { of / measure } else { R::ZERO }
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
    pub fn limits_along(&self) -> Option<Limits<R>> {
        let [mut velocity, mut acceleration, mut jerk] = [R::INFINITY; 3];
        for section in 0..self.sections {
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

    /// Whether the bends of the path use a quarter of the limits at most, at this speed.
    pub fn is_straight(&self, speed: R) -> bool {
        let quarter = R::HALF * R::HALF;
        (0..self.axes).all(|axis| {
            let mut last = None;
            (1..self.sections).all(|point| {
                let [before, after] = [point - 1, point].map(|section| self.chord(section));
                let [m0, m1] = [self.displacement(point - 1, axis) / before, self.displacement(point, axis) / after];
                let bend = (m1 - m0) / (R::HALF * (before + after));
                let change = last.map_or(R::ZERO, |last: R| (bend - last) / (before + after));
                last = Some(bend);
                self.limits(point, axis).is_ok_and(|limits| {
                    let square = speed * speed;
                    square * bend.abs() <= quarter * limits.amax.at_most(-limits.amin)
                        && square * speed * change.abs() <= quarter * limits.jmax.at_most(-limits.jmin)
                })
            })
        })
    }

    /// Makes one axis pass each point as fast as it can without acceleration there: a pass ahead and a pass back. Whether it is shorter.
    fn pass_twice(&mut self) -> Result<bool, Error> {
        let before = self.keep_plan();
        let mut speed = R::ZERO;
        for point in 1..self.sections {
            speed = self.reached(point - 1, speed, false)?.at_most(self.fastest_pass(point)?);
            if !speed.is_finite() {
                self.take_tried();
                return Ok(false);
            }
            self.memory.states.set(point, [speed, R::ZERO]);
        }
        speed = R::ZERO;
        for point in (1..self.sections).rev() {
            let [ahead, _] = self.at(point, 0);
            speed = self.reached(point, speed, true)?.at_most(ahead);
            let velocity = speed.copysign(self.displacement(point, 0));
            self.memory.states.set(point, [velocity, R::ZERO]);
        }
        let is_shorter = self.last_shortest()? < before;
        if !is_shorter {
            self.take_tried();
        }
        Ok(is_shorter)
    }

    /// The highest speed at which the axis may pass a point; 0 where it turns.
    fn fastest_pass(&self, point: usize) -> Result<R, Error> {
        let [before, after] = [point - 1, point].map(|section| self.displacement(section, 0));
        let mut fastest = if before * after <= R::ZERO { R::ZERO } else { R::INFINITY };
        // The limits of sections between them that do not last count too.
        for place in self.place(point - 1)..=self.place(point) {
            let limits = self.request.limits(place, 0)?;
            fastest = fastest.at_most(if after < R::ZERO { -limits.vmin } else { limits.vmax });
        }
        Ok(fastest)
    }

    fn limits_ahead(&self, section: usize) -> Result<Limits<R>, Error> {
        let limits = self.limits(section, 0)?;
        Ok(if self.displacement(section, 0) < R::ZERO { limits.mirrored() } else { *limits })
    }

    /// The highest speed at the end of a section after the speed `from` at its start, or in reversed time. The accelerations at both ends are 0. A
    /// 4096th of the section is left out, so that no rounding error makes it too short.
    fn reached(&self, section: usize, from: R, reversed: bool) -> Result<R, Error> {
        let limits = self.limits_ahead(section)?;
        let limits = if reversed { limits.reversed() } else { limits };
        let (per_jerk, zero) = (PerJerk::of(&limits), R::ZERO);
        let length = self.displacement(section, 0).abs() * (R::ONE - R::SIXTEENTH * R::SIXTEENTH * R::SIXTEENTH);
        let beyond = |gain: R| {
            let ramp = Ramp::over(gain, zero, zero, limits.amax, per_jerk);
            let displacement = ramp.passed(from, zero, zero, per_jerk).displacement;
            let slope = (from + gain) / ramp.peak + R::HALF * per_jerk.gd * ramp.peak;
            (displacement - length, slope)
        };
        let most = limits.vmax - from;
        let is_reached = !(most > zero && most < R::INFINITY && beyond(most).0 > zero);
        Ok(from + if is_reached { most.at_least(zero) } else { root_between(zero, most, beyond) })
    }
}
