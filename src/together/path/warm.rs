//! The plan before the first step, from a plan that is there.
//!
//! A slower plan is off all limits at once: with durations longer by the factor `s`, velocities are divided by `s` and accelerations by `s²`.

use super::chain::Chain;
use super::steps::Steps;
use crate::findings::Error;
use crate::real::Real;

/// How much slower than the plan that is there the first plan is, in thousandths; by how many powers of two its logarithms weigh less; and how
/// many steps it takes at least to win back what is lost.
const SLOWER: [(u8, u8, u32); 6] = [
    (200, 2, 10),
    (100, 3, 10),
    (50, 4, 6),
    (20, 5, 6),
    (5, 5, 3),
    (0, 5, 1),
];

impl<R: Real> Chain<'_, '_, R> {
    /// Shortens a plan; if it is impossible, plans anew.
    pub fn improve(&mut self, given: &[R], steps: Steps) -> Result<(), Error> {
        let before = self.take_given(given)?;
        let begun = self.slow_down(given, steps.most);
        match begun {
            Some(octaves) => {
                self.shorten(steps, octaves);
                self.promise()?;
            }
            None => self.plan(steps)?,
        }
        let is_shorter = before.is_none_or(|before| self.duration() < before);
        if !is_shorter {
            self.take_given(given)?;
        }
        Ok(())
    }

    /// Takes over the plan that is there. Gives its duration if it is possible, s.
    fn take_given(&mut self, given: &[R]) -> Result<Option<R>, Error> {
        self.take_states(R::ONE)?;
        let mut is_possible = true;
        for section in 0..self.sections {
            let duration = self.given(section, given)?;
            let least = self.shortest(section, duration)?;
            let is_kept = duration == R::ZERO || least <= duration + R::DOUBT * duration;
            is_possible = is_possible && is_kept;
            let taken = if duration == R::ZERO { least } else { duration };
            self.memory.durations.put(section, taken);
        }
        for point in 1..self.sections {
            for axis in 0..self.axes {
                let bounds = self.bounds(point, axis);
                is_possible = is_possible && bounds.hold(self.at(point, axis));
            }
        }
        Ok(is_possible.then(|| self.duration()))
    }

    /// The duration of a section in the plan that is there, s.
    fn given(&self, section: usize, given: &[R]) -> Result<R, Error> {
        let duration = given.get(self.place(section)).copied().unwrap_or(R::NAN);
        let is_duration = duration >= R::ZERO && duration.is_finite();
        is_duration.then_some(duration).ok_or(Error::Duration)
    }

    fn take_states(&mut self, slower: R) -> Result<(), Error> {
        for point in 1..self.sections {
            for axis in 0..self.axes {
                let state = self.request.state(self.place(point), axis);
                let taken = [
                    state.velocity / slower,
                    state.acceleration / (slower * slower),
                ];
                if !taken.iter().all(|number| number.is_finite()) {
                    return Err(Error::NotFinite);
                }
                self.memory.states.set(point * self.axes + axis, taken);
            }
        }
        Ok(())
    }

    /// Takes over the slowest of some plans like the one that is there, if one is strictly inside. Gives the powers of two for the first step. A
    /// path of one section needs no step.
    fn slow_down(&mut self, given: &[R], steps: u32) -> Option<u8> {
        if self.sections == 1 {
            return None;
        }
        let mut slower = SLOWER.into_iter().filter(|&(_, _, least)| least <= steps);
        slower.find_map(|(thousandths, octaves, _)| {
            let slower = R::ONE + R::from(thousandths) / (R::from(250) * R::from(4));
            self.take_slower(slower, given).map(|()| octaves)
        })
    }

    fn take_slower(&mut self, slower: R, given: &[R]) -> Option<()> {
        self.take_states(slower).ok()?;
        for section in 0..self.sections {
            let duration = self.given(section, given).ok()?;
            let duration = if duration == R::ZERO {
                let least = self.shortest(section, R::ZERO).ok()?;
                least + R::SIXTEENTH * least
            } else {
                slower * duration
            };
            self.memory.durations.put(section, duration);
            self.is_possible(section, duration).then_some(())?;
        }
        let mut points = 1..self.sections;
        points
            .all(|point| {
                (0..self.axes).all(|axis| {
                    self.bounds(point, axis)
                        .product(self.at(point, axis))
                        .is_some()
                })
            })
            .then_some(())
    }
}
