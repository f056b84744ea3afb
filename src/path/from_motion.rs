//! The first plan of a path that begins in motion: it passes the points of a path with a slower start, and this start becomes faster step by step.
//!
//! `docs/path-theory.md` has the reasons, in "A start in motion".

use super::chain::Chain;
use super::rows::{nearly_all, stop_length};
use super::steps::{Damping, Steps};
use crate::findings::{Error, Findings};
use crate::online::Move;
use crate::real::Real;
use crate::state::State;

/// Starts that are tried, each 5/4 times slower than the one before.
const SLOWER_STARTS: usize = 64;
/// The steps that speed up the start, in multiples of those of a path.
const STEPS: u32 = 8;
/// Steps to the centre before the start becomes faster again.
const STEPS_TO_CENTRE: u32 = 2;
/// Gains of speed that are tried: the first, its half, its quarter, …
const MOST_GAINS: u32 = 8;

impl<R: Real> Chain<'_, '_, R> {
    /// Brings the plan strictly inside: the one with stops, or one that passes points at which an axis cannot stop in time. Whether it is.
    pub fn bring_inside(&mut self, steps: Steps) -> Result<bool, Error> {
        if self.brake_along() {
            return Ok(true);
        }
        if !self.swerves() || (0..self.axes).any(|axis| self.memory.inside.at(axis) > R::ZERO) {
            return Ok(self.come_inside(0));
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

    /// Makes the path brake along its points: to the first corner or the end, or to a stop as early as it can. Whether this is possible, and
    /// shorter.
    pub fn brake_along(&mut self) -> bool {
        self.measure_axes();
        let Some(start) = self.start_along() else {
            return false;
        };
        self.keep_plan();
        let (corner, end) = (self.next_corner(0), self.sections);
        let mut brakes_to = |last| self.rests_at(last) && self.brake(nearly_all(), start, last);
        brakes_to(corner) || brakes_to(end) || self.stop_along(start)
    }

    fn brake(&mut self, share: R, start: State<R>, last: usize) -> bool {
        self.pass_row(share, start, 0..last) && self.come_inside(last)
    }

    fn stop_along(&mut self, start: State<R>) -> bool {
        let share = R::ONE - R::HALF * R::HALF;
        self.lay_curve(0..self.sections);
        self.take_share(0..self.sections, share);
        let stop = stop_length(&self.limits_along(0..self.sections), start);
        self.brake(share, start, self.next_point(stop))
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
}
