//! First plans that pass waypoints: straight rows of points as one move, a start in motion that brakes along the points, and for one axis the
//! highest speeds without acceleration.
//!
//! `docs/path-theory.md` has the reasons, in "The first plan".

use super::chain::Chain;
use crate::findings::{Error, Findings};
use crate::interval::ramp::{PerJerk, Ramp};
use crate::limits::Limits;
use crate::online::Move;
use crate::real::Real;
use crate::roots::root_between;
use crate::state::State;

/// How much slower the first plan becomes before its steps: a part of its durations.
fn slower<R: Real>() -> R {
    R::ONE + R::HALF * R::SIXTEENTH
}

/// Which part of the limits the first plan uses at most, so that it is off all of them.
fn most<R: Real>() -> R {
    R::ONE - R::SIXTEENTH * R::SIXTEENTH
}

/// A row is straight if so many times its highest speed would not use a quarter of the limits across it.
const STRAIGHT: u8 = 60;
/// How often the speed along a path is halved until its bends allow it.
const MOST_HALVINGS: u32 = 32;

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

    fn rests_at(&self, point: usize) -> bool {
        (0..self.axes).all(|axis| self.at(point, axis) == [R::ZERO; 2])
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
        self.measure_axes();
        let limits = self.limits_along(most())?;
        let mut run = Move::default();
        run.plan(&limits, State::at(R::ZERO), State::at(self.length())).ok()?;
        self.is_straight(R::from(STRAIGHT) * run.extremes().highest.velocity).then_some(())?;
        self.pass_along(&run)
    }

    /// Makes a path that begins in motion, and ends at rest, brake to a speed at which its bends use a quarter of the limits at most. `None` if
    /// this is not possible, or not shorter.
    pub fn brake_along(&mut self) -> Option<()> {
        self.measure_axes();
        let start = self.start_along().filter(|_| self.rests_at(self.sections))?;
        let mut parts = [4u8, 8, 12, 14].into_iter().map(|part| R::from(part) * R::SIXTEENTH);
        parts.find_map(|part| {
            let mut limits = self.limits_along(part)?;
            let speed = self.speed_in_bends(limits.vmax)?;
            (limits.vmax, limits.vmin) = (speed, -speed);
            let mut run = Move::default();
            let found = run.plan(&limits, start, State::at(self.length())).ok()?;
            (!found.contains(Findings::OVERSHOOTS)).then_some(())?;
            self.pass_along(&run)
        })
    }

    /// The speed, at most the given one, at which the bends of the path use a quarter of the limits at most.
    fn speed_in_bends(&self, most: R) -> Option<R> {
        let mut speeds = (0..MOST_HALVINGS).map(|k| (0..k).fold(most, |speed, _| R::HALF * speed));
        speeds.find(|&speed| self.is_straight(speed))
    }

    /// The motion of the start in its own direction, if this is ahead.
    fn start_along(&self) -> Option<State<R>> {
        let [mut square, mut power, mut ahead] = [R::ZERO; 3];
        for axis in 0..self.axes {
            let [v, a] = self.at(0, axis).map(|of| self.part(axis, of));
            square = square + v * v;
            power = power + v * a;
            ahead = ahead + v * self.part(axis, self.displacement(0, axis));
        }
        let velocity = square.sqrt();
        (ahead > R::ZERO).then(|| State { position: R::ZERO, velocity, acceleration: power / velocity })
    }

    /// Passes the waypoints as the motion along the path does. `None` if this is not possible, or not shorter.
    fn pass_along(&mut self, run: &Move<R>) -> Option<()> {
        (run.t < self.duration()).then_some(())?;
        self.memory.tried_states.copy(&self.memory.states);
        let (mut passed, mut time) = (R::ZERO, R::ZERO);
        for section in 0..self.sections {
            passed = passed + self.arc(section);
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

    /// Each axis counts in parts of its whole displacement, so that units do not matter.
    fn measure_axes(&mut self) {
        for axis in 0..self.axes {
            let whole = (0..self.sections).fold(R::ZERO, |sum, section| sum + self.displacement(section, axis).abs());
            self.memory.product.set(axis, [whole, R::ZERO]);
        }
    }

    /// A quantity of an axis, by its whole displacement.
    fn part(&self, axis: usize, of: R) -> R {
        let [whole, _] = self.memory.product.row(axis);
        if whole > R::ZERO { of / whole } else { R::ZERO }
    }

    /// The length of what all axes have in parts of their whole displacements.
    fn norm(&self, of: impl Fn(usize) -> R) -> R {
        let parts = (0..self.axes).map(|axis| self.part(axis, of(axis)));
        parts.fold(R::ZERO, |sum, part| sum + part * part).sqrt()
    }

    /// The length of the path.
    fn length(&self) -> R {
        (0..self.sections).fold(R::ZERO, |sum, section| sum + self.arc(section))
    }

    /// The length of a section. Its arc is longer than its chord by a third of what the chords next to the waypoint turn.
    fn arc(&self, section: usize) -> R {
        let point = section + 1;
        let turn = if point < self.sections { R::ONE - self.steepness(point) } else { R::ZERO };
        self.chord(section) * (R::ONE + turn / R::from(3))
    }

    /// The length of the slopes of all axes at a waypoint: 1 on a straight line.
    fn steepness(&self, point: usize) -> R {
        self.norm(|axis| self.slope_and_bend(point, axis)[0])
    }

    /// The slope and half of the bend of the parabola through a point and the points next to it.
    fn slope_and_bend(&self, point: usize, axis: usize) -> [R; 2] {
        let [before, after] = [point - 1, point].map(|section| self.chord(section));
        let per = R::ONE / (before + after);
        let [m0, m1] = [self.displacement(point - 1, axis) / before, self.displacement(point, axis) / after];
        [(m0 * after + m1 * before) * per, (m1 - m0) * per]
    }

    /// The length of the chord of a section.
    fn chord(&self, section: usize) -> R {
        self.norm(|axis| self.displacement(section, axis))
    }

    /// The motion along the parabola through a point and the points next to it.
    fn try_point_of_row(&mut self, point: usize, along: State<R>) {
        let (speed, steepness) = (along.velocity, self.steepness(point));
        for axis in 0..self.axes {
            let [slope, bend] = self.slope_and_bend(point, axis);
            let slope = slope / steepness;
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

    /// The limits of the motion along the chords: of acceleration and jerk a part, because a row that bends needs some of them across.
    fn limits_along(&self, part: R) -> Option<Limits<R>> {
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
        Some(Limits::symmetric(part * jerk, part * acceleration, most::<R>() * velocity))
    }

    /// Whether the bends of the path use a quarter of the limits at most, at this speed.
    fn is_straight(&self, speed: R) -> bool {
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
