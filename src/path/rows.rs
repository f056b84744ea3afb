//! First plans that pass waypoints: straight rows of points as one move, and for one axis the highest speeds without acceleration.
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

/// How much slower the first plan becomes, so that it is off all limits: a part of its durations.
fn slower<R: Real>() -> R {
    R::ONE + R::HALF * R::SIXTEENTH
}

/// A row is straight if so many times its highest speed would not use a quarter of the limits across it.
const STRAIGHT: u8 = 60;

impl<R: Real> Chain<'_, '_, R> {
    /// Replaces the plan with stops by a shorter one, if the path begins and ends at rest. Whether there is one.
    pub fn pass_rows(&mut self) -> Result<bool, Error> {
        let ends = [0, self.sections];
        let is_moving = |axis| ends.iter().any(|&point| self.at(point, axis) != [R::ZERO; 2]);
        if (0..self.axes).any(is_moving) {
            return Ok(false);
        }
        let is_row = self.merge_row().is_some();
        let passes = self.axes == 1 && self.pass_twice()?;
        Ok(is_row || passes)
    }

    /// Makes the plan slower, so that it is strictly inside. Whether it is.
    pub fn slow_down_all(&mut self) -> bool {
        let slower = slower::<R>();
        for section in 0..self.sections {
            let duration = self.memory.durations.at(section);
            self.memory.durations.put(section, slower * duration);
        }
        for row in self.axes..self.axes * self.sections {
            let [v, a] = self.memory.states.row(row);
            self.memory.states.set(row, [v / slower, a / (slower * slower)]);
        }
        let mut sections = 0..self.sections;
        sections.all(|section| self.is_possible(section, self.memory.durations.at(section))) && self.points_are_inside()
    }

    /// Plans the path as one move, if it is a straight row of points. `None` if it is not, or if the move is not possible.
    fn merge_row(&mut self) -> Option<()> {
        for axis in 0..self.axes {
            let way = (0..self.sections).fold(R::ZERO, |way, section| way + self.displacement(section, axis).abs());
            self.memory.product.set(axis, [way, R::ZERO]);
        }
        let length = (0..self.sections).fold(R::ZERO, |sum, section| sum + self.chord(section));
        let mut run = Move::default();
        run.plan(&self.limits_along()?, State::at(R::ZERO), State::at(length)).ok()?;
        let is_worth = run.t < self.duration() && self.is_straight(run.extremes().highest.velocity);
        is_worth.then_some(())?;
        self.memory.tried_states.clear();
        let (mut passed, mut time) = (R::ZERO, R::ZERO);
        for section in 0..self.sections {
            passed = passed + self.chord(section);
            let is_last = section + 1 == self.sections;
            let at = if is_last { run.t } else { run.time_at(passed)? };
            self.memory.tried.put(section, at - time);
            time = at;
            if !is_last {
                self.try_point_of_row(section + 1, run.state_at(at));
            }
        }
        (0..self.sections).all(|section| self.is_tried_possible(section)).then(|| self.take_tried())
    }

    /// The length of the chord of a section. Each axis counts in parts of its whole displacement, so that units do not matter.
    fn chord(&self, section: usize) -> R {
        let squares = (0..self.axes).map(|axis| {
            let [way, _] = self.memory.product.row(axis);
            let part = if way > R::ZERO { self.displacement(section, axis) / way } else { R::ZERO };
            part * part
        });
        squares.fold(R::ZERO, |sum, square| sum + square).sqrt()
    }

    /// The motion along the parabola through a point and the points next to it.
    fn try_point_of_row(&mut self, point: usize, along: State<R>) {
        let [before, after] = [point - 1, point].map(|section| self.chord(section));
        let (speed, per) = (along.velocity, R::ONE / (before + after));
        for axis in 0..self.axes {
            let [m0, m1] = [self.displacement(point - 1, axis) / before, self.displacement(point, axis) / after];
            let slope = (m0 * after + m1 * before) * per;
            let bend = (m1 - m0) * per;
            let acceleration = (bend + bend) * speed * speed + slope * along.acceleration;
            self.memory.tried_states.set(point * self.axes + axis, [slope * speed, acceleration]);
        }
    }

    fn is_tried_possible(&self, section: usize) -> bool {
        let duration = self.memory.tried.at(section);
        (0..self.axes).all(|axis| {
            let row = section * self.axes + axis;
            let ends = [self.memory.tried_states.row(row), self.memory.tried_states.row(row + self.axes)];
            let is_inside = section == 0 || self.bounds(section, axis).product(ends[0]).is_some();
            is_inside && self.slacks(section, axis, ends, duration).is_some()
        })
    }

    /// The limits of the motion along the chords, less a 256th: a row that bends a little needs some of them across.
    fn limits_along(&self) -> Option<Limits<R>> {
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
        let part = R::ONE - R::SIXTEENTH * R::SIXTEENTH;
        Some(Limits::symmetric(part * jerk, part * acceleration, part * velocity))
    }

    /// Whether the line bends so little that the motion across it hardly counts.
    fn is_straight(&self, speed: R) -> bool {
        let speed = R::from(STRAIGHT) * speed;
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

    /// Makes one axis pass each point as fast as it can without acceleration there: a pass ahead and a pass back. Takes the plan if it is shorter.
    fn pass_twice(&mut self) -> Result<bool, Error> {
        self.memory.tried_states.copy(&self.memory.states);
        let mut speed = R::ZERO;
        for point in 1..self.sections {
            speed = self.reached(point - 1, speed, false)?.at_most(self.fastest_pass(point)?);
            if !speed.is_finite() {
                return Ok(false);
            }
            self.memory.tried_states.set(point, [speed, R::ZERO]);
        }
        speed = R::ZERO;
        for point in (1..self.sections).rev() {
            let [ahead, _] = self.memory.tried_states.row(point);
            speed = self.reached(point, speed, true)?.at_most(ahead);
            let velocity = speed.copysign(self.displacement(point, 0));
            self.memory.tried_states.set(point, [velocity, R::ZERO]);
        }
        let before = self.duration();
        core::mem::swap(&mut self.memory.states, &mut self.memory.tried_states);
        let mut sum = R::ZERO;
        for section in 0..self.sections {
            let duration = self.shortest(section, R::ZERO)?;
            self.memory.tried.put(section, duration);
            sum = sum + duration;
        }
        let is_shorter = sum < before;
        if is_shorter {
            core::mem::swap(&mut self.memory.durations, &mut self.memory.tried);
        } else {
            core::mem::swap(&mut self.memory.states, &mut self.memory.tried_states);
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

    /// The limits in the direction of a section.
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
