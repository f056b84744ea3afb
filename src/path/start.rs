//! The first plan: it stops at every waypoint.

use super::chain::Chain;
use super::rows::nearly_all;
use crate::findings::Error;
use crate::online::problem::Problem;
use crate::real::Real;
use crate::several::axis::next_duration;
use crate::several::cycle::Cycle;

impl<R: Real, const K: usize> Chain<'_, '_, R, K> {
    /// The shortest duration of a section that is not below `least`, as the states stand, s.
    pub fn shortest(&self, section: usize, least: R) -> Result<R, Error> {
        let problem = |axis| {
            let (from, to) = self.ends(section, axis);
            self.limits(section, axis).map(|limits| Problem::new(limits, from, to))
        };
        let slowest = (0..self.axes).try_fold(least, |slowest, axis| {
            problem(axis).map(|problem| slowest.at_least(problem.duration(&problem.fastest())))
        })?;
        let next_duration = |t| {
            let next = |axis| problem(axis).map_or(t, |problem| next_duration(&problem, t));
            (0..self.axes).map(next).fold(t, R::at_least)
        };
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
}
