//! The first plan of a path that begins in motion: it passes the points of a path with a slower start, and this start becomes faster step by step.
//!
//! `docs/path-theory.md` has the reasons, in "A start in motion".

use super::chain::Chain;
use super::steps::{Damping, Steps};
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::online::Move;
use crate::real::Real;
use crate::state::State;

/// Starts that are tried, each 5/4 times slower than the one before.
const SLOWER_STARTS: usize = 64;
/// How often the speed along a path is halved until its bends allow it.
const MOST_HALVINGS: u32 = 32;
/// The steps that speed up the start, in multiples of those of a path.
const STEPS: u32 = 8;
/// Steps to the centre before the start becomes faster again.
const STEPS_TO_CENTRE: u32 = 2;
/// Gains of speed that are tried: the first, its half, its quarter, …
const MOST_GAINS: u32 = 8;

impl<R: Real> Chain<'_, '_, R> {
    /// Brings the plan strictly inside: the one with stops, or one that passes points at which an axis cannot stop in time. Whether it is.
    pub fn bring_inside(&mut self, steps: Steps) -> Result<bool, Error> {
        if !self.swerves() {
            return Ok(self.come_inside(0));
        }
        self.measure_axes(Self::least_jerk);
        if (0..self.axes).any(|axis| self.memory.inside.at(axis) > R::ZERO) {
            return Ok(self.brake_along() || self.come_inside(0));
        }
        let passes = self.slow_start()?.is_some_and(|times| self.speed_up(times, steps));
        self.set_start(R::ONE);
        if passes && self.is_strictly_inside() {
            return Ok(true);
        }
        self.stop_everywhere()?;
        Ok(self.come_inside(0))
    }

    /// Plans from a start that is slow enough to pass the points. Returns how many times slower it is than the given one.
    fn slow_start(&mut self) -> Result<Option<R>, Error> {
        let mut times = R::ONE;
        for _ in 0..SLOWER_STARTS {
            times = times + R::HALF * R::HALF * times;
            self.set_start(R::ONE / times);
            let duration = self.shortest(0, R::ZERO)?;
            self.memory.durations.put(0, duration);
            let passes = if self.swerves() { self.brake_along() } else { self.come_inside(0) };
            if passes {
                return Ok(Some(times));
            }
        }
        Ok(None)
    }

    /// Whether an axis would have to turn and come back to stop at the first point, although it moves towards it.
    #[inline(never)] // for its stack
    fn swerves(&self) -> bool {
        (0..self.axes).any(|axis| {
            let (from, to) = self.ends(0, axis);
            let stop = |limits| Move::default().plan(limits, from, State::at(to.position));
            let found = self.limits(0, axis).and_then(stop).unwrap_or_default();
            from.velocity * (to.position - from.position) > R::ZERO && found.contains(Findings::OVERSHOOTS)
        })
    }

    /// Starts at this part of the given velocity, and at its square of the given acceleration.
    fn set_start(&mut self, part: R) {
        for axis in 0..self.axes {
            let State { velocity, acceleration, .. } = self.request.state(0, axis);
            self.memory.states.set(axis, [part * velocity, part * part * acceleration]);
        }
    }

    /// Speeds up a plan whose start is too slow by the factor `times`. Before each gain its states move back to the centre, away from the limits.
    /// Whether it reaches the given start.
    fn speed_up(&mut self, mut times: R, steps: Steps) -> bool {
        let mut damping = Damping::new();
        for _ in 0..STEPS * steps.most / STEPS_TO_CENTRE {
            self.centre(STEPS_TO_CENTRE, &mut damping);
            let mut gain = times - R::ONE;
            for halvings in 0..MOST_GAINS {
                let faster = R::ONE + gain;
                self.scale_time(R::ONE / faster);
                if self.is_strictly_inside() {
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

    /// The least limit of the jerk of an axis. By it, an axis counts as much as it takes time.
    fn least_jerk(&self, axis: usize) -> R {
        let limits = (0..self.sections).filter_map(|section| self.limits(section, axis).ok());
        limits.fold(R::INFINITY, |least, limits| least.at_most(limits.jmax.at_most(-limits.jmin)))
    }

    /// Makes the path brake along its points: to a speed that its bends allow, or to a stop. Whether this is possible, and shorter.
    fn brake_along(&mut self) -> bool {
        let (Some(start), Some(limits)) = (self.start_along(), self.limits_along()) else {
            return false;
        };
        // Bends use the rest of the limits.
        let within = |sixteenths: u8, speed| {
            let part = R::from(sixteenths) * R::SIXTEENTH;
            Limits::symmetric(part * limits.jmax, part * limits.amax, speed)
        };
        let parts = [4, 8, 12, 14];
        let slow = self.speed_of_bends(limits.vmax);
        let mut brakes = |part, speed, to_end| self.brake(&within(part, speed), start, to_end).is_some();
        slow.is_some_and(|speed| parts.into_iter().any(|part| brakes(part, speed, true)))
            || parts.into_iter().any(|part| brakes(part, limits.vmax, false))
    }

    /// The highest speed that the bends of a path to rest allow: `highest`, its half, its quarter, …
    fn speed_of_bends(&self, highest: R) -> Option<R> {
        let mut speeds = (0..MOST_HALVINGS).map(|k| (0..k).fold(highest, |speed, _| R::HALF * speed));
        if self.rests_at(self.sections) { speeds.find(|&speed| self.is_straight(speed)) } else { None }
    }

    /// Makes the path slow down along its points: to its end, or to a stop as early as it can.
    #[inline(never)] // for its stack
    fn brake(&mut self, limits: &Limits<R>, start: State<R>, to_end: bool) -> Option<()> {
        let (mut run, mut end, mut length) = (Move::default(), R::INFINITY, R::ZERO);
        if !to_end {
            run.stop(limits, start).ok()?;
            end = run.end().position;
        }
        let reached = (0..self.sections).find(|&section| {
            length = length + self.arc(section);
            length >= end
        });
        let last = reached.map_or(self.sections, |section| section + 1);
        let found = run.plan(limits, start, State::at(length)).ok()?;
        (!found.contains(Findings::OVERSHOOTS)).then_some(())?;
        self.pass_along(&run, last)
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

    /// Passes the waypoints before `last` as the motion along the path does. `None` if this is not possible, or not shorter.
    pub fn pass_along(&mut self, run: &Move<R>, last: usize) -> Option<()> {
        let before = self.keep_plan();
        let passes = self.follow(run, last).is_some() && self.duration() < before && self.come_inside(last);
        if !passes {
            self.take_tried();
        }
        passes.then_some(())
    }

    fn follow(&mut self, run: &Move<R>, last: usize) -> Option<()> {
        let (mut passed, mut time) = (R::ZERO, R::ZERO);
        for section in 0..last {
            passed = passed + self.arc(section);
            let point = section + 1;
            let at = if point == last { run.t } else { run.time_at(passed)? };
            let duration = at - time;
            self.memory.durations.put(section, duration);
            time = at;
            let passes = if point == last {
                self.is_possible(section, duration)
            } else {
                self.pass(point, run.state_at(at), duration)
            };
            passes.then_some(())?;
        }
        Some(())
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
