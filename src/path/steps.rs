//! The steps: Newton's method at a falling weight of the logarithms. `docs/path-theory.md` has the reason of every number, in "The steps".

use super::chain::Chain;
use crate::real::Real;

/// More steps have no effect that the real type could show.
const MOST_STEPS: u32 = 1024;

/// How many steps a path gets.
#[derive(Clone, Copy)]
pub(super) struct NewtonBudget {
    pub most: u32,
    /// How often the weight of the logarithms falls.
    falls: u32,
}

impl NewtonBudget {
    /// So many steps; 0: as many as a path of so many sections needs.
    pub fn of(asked: u32, sections: usize) -> Self {
        let (most, falls) = match asked.min(MOST_STEPS) {
            0 if sections < MANY_SECTIONS => (MOST_BY_DEFAULT, FEW_FALLS),
            0 => (MOST_BY_DEFAULT, MOST_BY_DEFAULT - 1),
            asked => (asked, asked - 1),
        };
        Self { most, falls }
    }
}

/// A path that is not asked for a number of steps gets at most so many.
const MOST_BY_DEFAULT: u32 = 48;
/// A path of this many sections gets them all, because its points may be close.
const MANY_SECTIONS: usize = 10;
/// The plan of a shorter path is done after so many falls of the weight. After each a step is not halved.
const FEW_FALLS: u32 = 11;
/// Parts of a step that are tried: the first, its half, its quarter, …
const MOST_HALVINGS: u32 = 10;
/// How often the damping is raised for one step.
const MOST_DAMPINGS: u32 = 24;
/// By how many powers of two the weight of the logarithms falls.
const OCTAVES: u8 = 13;

/// The damping of a step: which part of the second derivatives is added to them.
pub(super) struct Damping<R> {
    lambda: R,
}

impl<R: Real> Damping<R> {
    /// 2⁻⁴⁸
    fn least() -> R {
        (0..12).fold(R::ONE, |least, _| R::SIXTEENTH * least)
    }

    /// 2¹⁰
    fn most() -> R {
        R::from(4) * (R::ONE / (R::SIXTEENTH * R::SIXTEENTH))
    }

    pub fn new() -> Self {
        Self { lambda: R::ONE / Self::most() }
    }

    #[inline(never)] // for its size: it is called in several places
    fn scale(&mut self, factor: R) {
        self.lambda = (self.lambda * factor).at_least(Self::least()).at_most(Self::most());
    }

    /// A step that is not halved shows that the model is right, a short one that it is not.
    fn learn(&mut self, halvings: u32) {
        if halvings == 0 {
            self.scale(R::SIXTEENTH);
        } else if halvings >= 3 {
            self.scale(R::from(3));
        }
    }
}

struct Taken<R> {
    /// The first part that was tried was taken.
    is_first: bool,
    /// How far the objective fell in the quadratic model, in weights of all logarithms: twice.
    distance: R,
}

impl<R: Real> Taken<R> {
    /// Whether the weight may fall.
    fn is_done(&self, octaves: R) -> bool {
        // While the weight is large, the plan chooses between several best ones, and must stay near the centre.
        let is_near = self.distance < R::HALF * R::HALF || octaves >= R::from(4);
        // In a zigzag where a shape changes, steps stay short at the centre too.
        self.is_first && is_near || self.distance < R::SIXTEENTH * R::HALF
    }
}

/// `base` divided by two to the power of `octaves`, which is not below 0. Between whole powers the quotient falls linearly.
fn fallen<R: Real>(base: R, octaves: R) -> R {
    let whole = octaves.to_index();
    let part = octaves - R::from_index(whole);
    let halved = (0..whole).fold(base, |weight, _| R::HALF * weight);
    halved * (R::ONE - R::HALF * part)
}

impl<R: Real, const K: usize> Chain<'_, '_, R, K> {
    /// Moves the states of the plan to the centre, where they are far from the limits.
    pub fn centre(&mut self, steps: u32, damping: &mut Damping<R>) {
        let Some(()) = self.begin() else { return };
        // The more weight the logarithms have, the longer the sections last, and few long ones may last long enough to turn back.
        let weight = if self.sections < MANY_SECTIONS { R::HALF } else { R::ONE };
        for _ in 0..steps {
            let mu = weight * self.per_logarithm() * self.duration();
            if self.step(mu, R::ONE, damping).is_none() {
                break;
            }
        }
    }

    /// Prepares the first step. `None` if the plan is not feasible.
    fn begin(&mut self) -> Option<()> {
        self.weigh();
        self.keep_plan();
        // No section counts as narrow until its slacks are known.
        self.memory.plan.slacks.fill(R::INFINITY);
        self.assemble().map(|_| ())
    }

    /// The first weight of a logarithm, as a part of the duration.
    fn per_logarithm(&self) -> R {
        R::from(11) * R::SIXTEENTH / R::from_index(self.logarithms() as i32)
    }

    /// Makes the plan shorter, which is strictly feasible and stays so. `octaves` says how near the plan is to the best one. Whether it is not longer.
    pub fn shorten(&mut self, NewtonBudget { most, mut falls }: NewtonBudget, octaves: u8) -> bool {
        let given = self.duration();
        let per_logarithm = self.per_logarithm();
        let mut octaves = R::from(octaves);
        let mut mu = fallen(per_logarithm * self.duration(), octaves);
        let mut damping = Damping::new();
        let mut is_done = false;
        let Some(()) = self.begin() else { return true };
        for step in 0..most {
            let left = most - step;
            // After a short step the weight waits, but not in the last two fifths of the steps.
            let may_wait = 5 * left > 2 * most;
            if step > 0 && falls == 0 && is_done {
                break;
            }
            if step > 0 && falls > 0 && (is_done || !may_wait) {
                let rounds = R::from_index(falls.min(left) as i32);
                octaves = octaves + (R::from(OCTAVES) - octaves) / rounds;
                falls -= 1;
            }
            let before = mu;
            mu = fallen(per_logarithm * self.duration(), octaves);
            match self.step(mu, (mu / before).at_most(R::ONE), &mut damping) {
                Some(taken) => is_done = taken.is_done(octaves),
                None => break,
            }
        }
        self.duration() <= given
    }

    /// One step, of which `first` is the first part that is tried. `None` if no step can be taken any more.
    fn step(&mut self, mu: R, first: R, damping: &mut Damping<R>) -> Option<Taken<R>> {
        self.add_durations(mu);
        let of_states = damping.lambda;
        let mut tries = 0..MOST_DAMPINGS;
        while self.solve(of_states, damping.lambda).is_none() {
            tries.next()?;
            damping.scale(R::from(4));
        }
        let distance = -self.slope();
        // At the centre of this weight rounding may hide the decrease, so being feasible is enough.
        let is_near = distance < R::SIXTEENTH * R::HALF * R::HALF;
        let mut part = first;
        for halvings in 0..MOST_HALVINGS {
            match self.try_step(part, mu) {
                Some(change) if change < R::ZERO || is_near => {
                    damping.learn(halvings);
                    let is_first = halvings == 0;
                    return Some(Taken { is_first, distance: distance / R::from_index(self.logarithms() as i32) });
                }
                Some(_) => self.swap_plans(),
                None => {}
            }
            part = R::HALF * part;
        }
        damping.scale(R::from(10));
        self.assemble()?;
        Some(Taken { is_first: false, distance: R::INFINITY })
    }

    pub fn keep_plan(&mut self) {
        self.memory.other.states.copy(&self.memory.plan.states);
        self.memory.other.durations.copy(&self.memory.plan.durations);
    }

    pub fn swap_plans(&mut self) {
        core::mem::swap(&mut self.memory.plan, &mut self.memory.other);
    }
}

#[cfg(test)]
mod tests {
    use super::fallen;

    #[test]
    fn an_octave_halves_the_weight() {
        let weights = [0.0, 0.5, 1.0, 1.5, 2.0].map(|octaves| fallen(8.0, octaves));
        assert_eq!(weights, [8.0, 6.0, 4.0, 3.0, 2.0]);
    }
}
