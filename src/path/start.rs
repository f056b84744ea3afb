//! The first plan. It stops at every waypoint, or passes rows of points. A path that begins or ends in motion passes the points of a path with slower
//! ends, which become faster step by step. `docs/path-theory.md` has the reasons, in "The first plan".

use super::chain::Chain;
use super::curve::all_but_rounding;
use super::rows::{nearly_all, stop_length};
use super::steps::{Damping, NewtonBudget};
use crate::findings::{Error, Findings};
use crate::online::{Move, problem::Problem};
use crate::real::Real;
use crate::several::axis::next_duration;
use crate::several::cycle::Cycle;
use crate::state::State;

/// Ends that are tried, each 5/4 times slower than the ones before.
const SLOWER_ENDS: usize = 64;
/// The steps that speed up the ends, in multiples of those of a path.
const STEPS: u32 = 8;
/// Steps to the centre before the ends become faster again.
const STEPS_TO_CENTRE: u32 = 2;
/// Gains of speed that are tried: the first, its half, its quarter, …
const MOST_GAINS: u32 = 8;

impl<R: Real, const K: usize> Chain<'_, '_, R, K> {
    /// The shortest duration of a section that is not below `least`, as the states stand, s.
    pub fn shortest(&self, section: usize, least: R) -> Result<R, Error> {
        let problem = |axis| {
            let (from, to) = self.ends(section, axis);
            Problem::new(&self.limits(section, axis), &from, &to)
        };
        let fastest = (0..self.axes).map(problem).map(|problem| problem.duration(&problem.fastest()));
        let slowest = fastest.fold(least, R::at_least);
        let next_duration = |t| (0..self.axes).map(|axis| next_duration(&problem(axis), t)).fold(t, R::at_least);
        let any_time = Cycle::new(R::ZERO, R::ZERO)?;
        any_time.until_possible(self.axes, slowest, next_duration)
    }

    /// Makes every section last until its end can be reached: the planner of the motions decides.
    pub fn promise(&mut self) -> Result<(), Error> {
        for section in 0..self.sections {
            let duration = self.memory.plan.durations.at(section);
            let duration = self.shortest(section, duration)?;
            self.memory.plan.durations.put(section, duration);
        }
        Ok(())
    }
}

impl<R: Real> Chain<'_, '_, R> {
    /// Makes all axes stop at every waypoint, and every section as short as it can be then.
    pub fn stop_everywhere(&mut self) -> Result<(), Error> {
        for row in self.axes..self.sections * self.axes {
            self.memory.plan.states.set(row, [R::ZERO; 2]);
        }
        self.memory.plan.durations.clear();
        self.promise()
    }

    /// Makes the sections from `first` on last a little longer, so that the plan is strictly feasible, and passes rows. Whether it is.
    pub fn lengthen(&mut self, first: usize) -> bool {
        for section in first..self.sections {
            let least = self.memory.plan.durations.at(section);
            // 1/16, 1/64, … longer, and then longer and longer.
            let shorter = (2..13).map(|k| (0..k).fold(R::ONE, |part, _| part * R::HALF * R::HALF));
            let longer = (0..8).map(|k| (0..k).fold(R::SIXTEENTH + R::SIXTEENTH, |part, _| part + part));
            let mut durations = shorter.chain(longer).map(|part| least + part * least);
            match durations.find(|&duration| self.is_possible(section, duration)) {
                Some(duration) => self.memory.plan.durations.put(section, duration),
                None => return false,
            }
        }
        self.pass_rows_from(first, nearly_all());
        true
    }

    /// The first plan: it stops at every waypoint, or, if the path begins at rest, passes rows where this is shorter. Whether it passes any.
    pub fn stop_or_pass(&mut self) -> Result<bool, Error> {
        self.stop_everywhere()?;
        Ok(self.sections > 1 && self.rests_at(0) && self.pass_rows_from(0, R::ONE))
    }

    /// Makes the first plan strictly feasible: the one that passes rows, made slower, or the one with stops. Whether it is.
    pub fn make_feasible(&mut self, passes: bool, budget: NewtonBudget) -> Result<bool, Error> {
        if passes && !self.swerves() {
            self.scale_time(R::ONE / nearly_all());
            (0..self.axes).for_each(|axis| self.set_end(self.sections, axis, R::ONE));
            if self.is_strictly_feasible() {
                return Ok(true);
            }
        }
        if passes {
            self.stop_everywhere()?;
        }
        self.make_feasible_from_stops(budget)
    }

    /// Makes the plan strictly feasible: the one with stops, or one that passes points at which an axis cannot stop in time. Whether it is.
    fn make_feasible_from_stops(&mut self, budget: NewtonBudget) -> Result<bool, Error> {
        let mut brakes = self.brake_along();
        let starts_outside = (0..self.axes).any(|axis| self.memory.recovery_time.at(axis) > R::ZERO);
        if self.swerves() && !starts_outside {
            let passes = self.slow_ends()?.is_some_and(|times| self.speed_up(times, budget));
            self.set_ends(R::ONE);
            if passes && self.is_strictly_feasible() {
                return Ok(true);
            }
            self.stop_everywhere()?;
            brakes = self.brake_along();
        }
        Ok(brakes || self.lengthen(0))
    }

    /// Plans between ends that are slow enough to pass the points. Returns how many times slower they are than the given ones.
    fn slow_ends(&mut self) -> Result<Option<R>, Error> {
        let mut times = R::ONE;
        for _ in 0..SLOWER_ENDS {
            times = times + R::HALF * R::HALF * times;
            self.set_ends(R::ONE / times);
            self.stop_everywhere()?;
            let passes = if self.swerves() { self.brake_along() && !self.swerves() } else { self.lengthen(0) };
            if passes {
                return Ok(Some(times));
            }
        }
        Ok(None)
    }

    /// Whether an axis would have to turn and come back to stop at the first point, or to start at the last one, although it moves ahead.
    fn swerves(&self) -> bool {
        let last = self.sections - 1;
        self.rests_at(1) && self.turns(0) || self.rests_at(last) && self.turns(last)
    }

    /// Whether an axis turns and comes back in a section of which one end rests.
    #[inline(never)] // for its stack
    fn turns(&self, section: usize) -> bool {
        (0..self.axes).any(|axis| {
            let (from, to) = self.ends(section, axis);
            let found = Move::default().plan(&self.limits(section, axis), from, to).unwrap_or_default();
            let ahead = (from.velocity + to.velocity) * (to.position - from.position);
            ahead > R::ZERO && found.contains(Findings::OVERSHOOTS)
        })
    }

    /// Gives the start and the end this part of their given velocities, and its square of the accelerations.
    fn set_ends(&mut self, part: R) {
        for axis in 0..self.axes {
            self.set_end(0, axis, part);
            self.set_end(self.sections, axis, part);
        }
    }

    /// Speeds up a plan whose ends are too slow by the factor `times`. Before each gain its states move back to the centre, away from the limits.
    /// Whether it reaches the given ends.
    fn speed_up(&mut self, mut times: R, budget: NewtonBudget) -> bool {
        let mut damping = Damping::new();
        for _ in 0..STEPS * budget.most / STEPS_TO_CENTRE {
            self.centre(STEPS_TO_CENTRE, &mut damping);
            let mut gain = times - R::ONE;
            for halvings in 0..MOST_GAINS {
                let faster = R::ONE + gain;
                self.scale_time(R::ONE / faster);
                if self.is_strictly_feasible() {
                    if halvings == 0 {
                        return true;
                    }
                    // Half of what is possible leaves room for the steps.
                    let half = R::ONE + R::HALF * gain;
                    self.scale_time(faster / half);
                    times = times / half;
                    break;
                }
                self.scale_time(faster);
                gain = R::HALF * gain;
            }
        }
        false
    }

    /// Makes the path brake along its points: to the first corner or the end, or to a stop as early as it can. Whether this is possible, and shorter.
    pub fn brake_along(&mut self) -> bool {
        self.measure_axes();
        let Some(start) = self.along(0).filter(|start| start.velocity != R::ZERO) else { return false };
        self.keep_plan();
        let (corner, end) = (self.next_corner(0), self.sections);
        let mut brakes_to = |last| self.brake(all_but_rounding(), start, last);
        brakes_to(corner) || brakes_to(end) || self.stop_along(start)
    }

    fn brake(&mut self, share: R, start: State<R>, last: usize) -> bool {
        self.pass_row(share, start, 0..last) && self.lengthen(last)
    }

    fn stop_along(&mut self, start: State<R>) -> bool {
        let share = R::ONE - R::HALF * R::HALF;
        self.lay_curve(0..self.sections);
        self.take_share(0..self.sections, share);
        let stop = stop_length(&self.limits_along(0..self.sections), start);
        self.brake(share, start, self.next_point(stop))
    }

    /// Takes the states of the fastest move from start to end. If it passes the points in order, one axis has no faster path.
    #[inline(never)] // for its stack
    pub fn pass_at_once(&mut self) -> Option<()> {
        (self.axes == 1 && !self.request.has_zones()).then_some(())?;
        let limits = self.limits(0, 0);
        let mut run = Move::default();
        run.plan(&limits, self.ends(0, 0).0, self.ends(self.sections - 1, 0).1).ok()?;
        for point in 1..self.sections {
            let (_, to) = self.ends(point - 1, 0);
            let state = run.state_at(run.time_at(to.position)?);
            limits.check(to, state).ok()?;
            self.memory.plan.states.set(point, [state.velocity, state.acceleration]);
        }
        self.memory.plan.durations.clear();
        self.promise().ok()?;
        // A section that rounding hides would count as one in which nothing moves.
        self.memory.plan.durations.numbers().iter().all(|t| *t > R::ZERO).then_some(())
    }

    /// The first point that is so far along the path, or its end.
    fn next_point(&self, length: R) -> usize {
        let mut passed = R::ZERO;
        let reached = (0..self.sections).find(|&section| {
            passed = passed + self.arc(section);
            passed >= length
        });
        reached.map_or(self.sections, |section| section + 1)
    }

    /// The motion at the start or at the end of the path along its section: back, if the axis turns there; at rest, if it rests. `None` across it.
    pub fn along(&self, point: usize) -> Option<State<R>> {
        if self.rests_at(point) {
            return Some(State::at(R::ZERO));
        }
        let section = point.saturating_sub(1);
        let [mut square, mut power, mut ahead] = [R::ZERO; 3];
        for axis in 0..self.axes {
            let [v, a] = self.at(point, axis).map(|of| self.part(axis, of));
            square = square + v * v;
            power = power + v * a;
            ahead = ahead + v * self.part(axis, self.displacement(section, axis));
        }
        let velocity = square.sqrt().copysign(ahead);
        (ahead != R::ZERO).then(|| State { position: R::ZERO, velocity, acceleration: power / velocity })
    }
}
