//! The first plan of one axis from rest: the highest speeds without acceleration at the waypoints.
//!
//! `docs/path-theory.md` has the reasons, in "The first plan".

use super::chain::Chain;
use crate::findings::Error;
use crate::interval::ramp::{PerJerk, Ramp};
use crate::limits::Limits;
use crate::real::Real;
use crate::roots::root_between;

impl<R: Real> Chain<'_, '_, R> {
    /// Makes one axis pass each point as fast as it can without acceleration there: a pass ahead and a pass back. Whether it is shorter.
    pub fn pass_twice(&mut self) -> Result<bool, Error> {
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
