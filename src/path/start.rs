//! The first plan: it stops at every waypoint, or rolls past a point at which an axis cannot stop in time.

use super::chain::Chain;
use crate::findings::Error;
use crate::online::Move;
use crate::online::problem::Problem;
use crate::real::Real;
use crate::several::axis::next_duration;
use crate::several::cycle::Cycle;
use crate::state::State;

/// Durations that are tried for a section in which an axis passes its waypoint.
const TRIED: u8 = 8;

/// When an axis that moves on after its ramp is at the position, which is ahead of it, s.
fn time_at<R: Real>(ramp: &Move<R>, position: R) -> R {
    ramp.time_at(position).unwrap_or_else(|| {
        let end = ramp.state_at(ramp.t);
        ramp.t + (position - end.position) / end.velocity
    })
}

impl<R: Real, const K: usize> Chain<'_, '_, R, K> {
    /// The shortest duration of a section that is not below `least`, as the states stand, s.
    pub fn shortest(&self, section: usize, least: R) -> Result<R, Error> {
        let mut slowest = least;
        for axis in 0..self.axes {
            let (from, to) = self.ends(section, axis);
            let problem = Problem::new(self.limits(section, axis)?, from, to);
            slowest = slowest.at_least(problem.duration(&problem.fastest()));
        }
        let next_duration = |t| {
            let next = |axis| {
                let (from, to) = self.ends(section, axis);
                let limits = self.limits(section, axis);
                limits.map_or(t, |limits| next_duration(&Problem::new(limits, from, to), t))
            };
            (0..self.axes).map(next).fold(t, R::at_least)
        };
        let any_time = Cycle::new(R::ZERO, R::ZERO)?;
        any_time.until_possible(self.axes, slowest, next_duration)
    }

    /// Makes every section last until its end can be reached: the planner of the motions decides.
    pub fn promise(&mut self) -> Result<(), Error> {
        for section in 0..self.sections {
            let duration = self.memory.durations.at(section);
            let duration = self.shortest(section, duration)?;
            self.memory.durations.put(section, duration);
        }
        Ok(())
    }
}

impl<R: Real> Chain<'_, '_, R> {
    /// Makes all axes stop at every waypoint. Returns the duration of the path, s.
    pub fn stop_everywhere(&mut self) -> Result<R, Error> {
        for point in 1..self.sections {
            self.stop_at(point);
        }
        for section in 0..self.sections {
            let duration = self.shortest(section, R::ZERO)?;
            self.memory.durations.put(section, duration);
        }
        Ok(self.duration())
    }

    fn stop_at(&mut self, point: usize) {
        for axis in 0..self.axes {
            self.memory.states.set(point * self.axes + axis, [R::ZERO; 2]);
        }
    }

    /// Makes the sections last a little longer, so that the plan is strictly inside. Whether it is.
    pub fn come_inside(&mut self) -> bool {
        for section in 0..self.sections {
            let least = self.memory.durations.at(section);
            // 1/16, 1/64, … longer, and then longer and longer.
            let shorter = (2..=12).map(|k| (0..k).fold(R::ONE, |part, _| part * R::HALF * R::HALF));
            let longer = (0..8).map(|k| (0..k).fold(R::SIXTEENTH + R::SIXTEENTH, |part, _| part + part));
            let mut durations = shorter.chain(longer).map(|part| least + part * least);
            match durations.find(|&duration| self.is_possible(section, duration)) {
                Some(duration) => self.memory.durations.put(section, duration),
                None => return false,
            }
        }
        true
    }

    /// Makes axes that cannot stop before the next waypoint pass it, as long as this takes less time than to turn and return.
    ///
    /// To pass and to turn are separated by impossible durations, so the steps would keep the turn. Whether no axis turns.
    pub fn roll(&mut self) -> Result<bool, Error> {
        for point in 1..self.sections {
            let section = point - 1;
            let Some((earliest, latest)) = self.passing(section) else {
                return Ok(self.can_stop_in(section));
            };
            let turning = self.memory.durations.at(section);
            let stopping = self.memory.durations.at(point);
            let mut best = (turning, stopping);
            for k in 1..TRIED {
                let part = R::from(k) / R::from(TRIED);
                let duration = earliest + (latest - earliest) * part;
                if duration < turning && self.pass(point, duration) {
                    let after = self.shortest(point, R::ZERO)?;
                    if duration + after < best.0 + best.1 {
                        best = (duration, after);
                    }
                }
            }
            self.memory.durations.put(section, best.0);
            self.memory.durations.put(point, best.1);
            if best.0 == turning {
                self.stop_at(point);
                return Ok(false);
            }
            self.pass(point, best.0);
        }
        Ok(true)
    }

    /// Whether all axes can stop before the end of a section.
    fn can_stop_in(&self, section: usize) -> bool {
        (0..self.axes).all(|axis| self.overshoot(section, axis).is_none_or(|(_, time)| time == R::INFINITY))
    }

    /// Between which durations all axes are at the end of the section, if one cannot stop before, s.
    fn passing(&self, section: usize) -> Option<(R, R)> {
        let mut latest = R::INFINITY;
        for axis in 0..self.axes {
            latest = latest.at_most(self.overshoot(section, axis)?.1);
        }
        let is_passed = latest < R::INFINITY;
        is_passed.then_some(())?;
        let far = self.memory.durations.at(section);
        let mut earliest = R::ZERO;
        for axis in 0..self.axes {
            let (from, to) = self.ends(section, axis);
            let (stopping, time) = self.overshoot(section, axis)?;
            let displacement = to.position - from.position;
            let overshoots = time < R::INFINITY;
            let (side, moves) = if overshoots { (stopping, true) } else { (displacement, displacement != R::ZERO) };
            if moves {
                let [upper, lower] = self.farthest(section, axis, far)?;
                let farthest = if side > R::ZERO { upper } else { lower };
                earliest = earliest.at_least(time_at(&farthest, to.position));
            }
        }
        (earliest < latest).then_some((earliest, latest))
    }

    /// The displacement of the stop, and when an axis that brakes has passed the end of the section, s; infinite if it can stop before.
    fn overshoot(&self, section: usize, axis: usize) -> Option<(R, R)> {
        let (from, to) = self.ends(section, axis);
        let displacement = to.position - from.position;
        let mut stop = Move::default();
        stop.stop(self.limits(section, axis).ok()?, from).ok()?;
        let stopping = stop.state_at(stop.t).position - from.position;
        let overshoots = stopping * displacement >= R::ZERO && stopping.abs() > displacement.abs();
        let time = if overshoots { time_at(&stop, to.position) } else { R::INFINITY };
        Some((stopping, time))
    }

    /// The motions with free ends that get farthest to both sides, for times up to `t`.
    fn farthest(&self, section: usize, axis: usize, t: R) -> Option<[Move<R>; 2]> {
        let limits = self.limits(section, axis).ok()?;
        let (from, _) = self.ends(section, axis);
        let State { velocity, acceleration, .. } = from;
        // A ramp to this velocity does not ease before `t`: what the acceleration at `t` adds while it eases is part of it.
        let gain = |most: R, jerk: R, easing: R| {
            let a = most.at_most(acceleration.abs() + jerk * t).at_least(acceleration.abs());
            velocity.abs() + a * t + R::HALF * a * a / easing
        };
        let highest = limits.vmax.at_most(gain(limits.amax, limits.jmax, -limits.jmin));
        let lowest = limits.vmin.at_least(-gain(-limits.amin, -limits.jmin, limits.jmax));
        let ramp = |velocity| {
            let mut ramp = Move::default();
            ramp.reach(limits, from, velocity, R::ZERO).ok()?;
            Some(ramp)
        };
        Some([ramp(highest)?, ramp(lowest)?])
    }

    /// Makes every axis be at the waypoint after `duration`: at rest where this is possible, else in the mean of the motions with the largest
    /// displacement to both sides. Whether all can.
    fn pass(&mut self, point: usize, duration: R) -> bool {
        let mut axes = 0..self.axes;
        axes.all(|axis| {
            self.memory.states.set(point * self.axes + axis, [R::ZERO; 2]);
            self.can_pass(point, axis, duration)
                || self.mean(point, axis, duration).is_some_and(|state| {
                    self.memory.states.set(point * self.axes + axis, state);
                    self.can_pass(point, axis, duration)
                })
        })
    }

    fn can_pass(&self, point: usize, axis: usize, duration: R) -> bool {
        let ends = [self.at(point - 1, axis), self.at(point, axis)];
        let is_inside = self.bounds(point, axis).product(self.at(point, axis)).is_some();
        is_inside && self.slacks(point - 1, axis, ends, duration).is_some()
    }

    fn mean(&self, point: usize, axis: usize, duration: R) -> Option<[R; 2]> {
        let farthest = self.farthest(point - 1, axis, duration)?;
        let [upper, lower] = farthest.map(|ramp| ramp.state_at(duration));
        let position = self.ends(point - 1, axis).1.position;
        // The weights of the mirrored axis are the same numbers.
        let (below, above) = (position - lower.position, upper.position - position);
        let mean = |upper: R, lower: R| (below * upper + above * lower) / (below + above);
        let is_between = below > R::ZERO && above > R::ZERO;
        is_between.then_some([mean(upper.velocity, lower.velocity), mean(upper.acceleration, lower.acceleration)])
    }
}
