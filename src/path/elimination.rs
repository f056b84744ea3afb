//! Newton's step: the unknowns stand along the path, so the work is linear in the sections. Those of a section are velocity and acceleration of
//! each axis at its start, with its offset if the points have tolerances, and then its duration.
//! `docs/path-theory.md` has the letters and the theory, in "The step". No root is taken, so powers of two in the units change no bit.

use super::{chain::Chain, memory::Band};
use crate::real::Real;

fn subtract<R: Real>(from: &mut [R], factor: R, row: &[R]) {
    for (number, other) in from.iter_mut().zip(row) {
        *number = *number - factor * *other;
    }
}

impl<R: Real> Band<'_, R> {
    /// Subtracts a row with this pivot from the rows after it, and keeps `1/D` in the place of the pivot.
    fn eliminate(&mut self, row: usize, pivot: R, right: &mut [R]) -> Option<()> {
        let per_pivot = R::ONE / pivot;
        let (_, rows) = self.numbers.split_at_mut_checked(row * self.width)?;
        let (own, mut after) = rows.split_at_mut_checked(self.width)?;
        let (diagonal, mut own) = own.split_first_mut()?;
        *diagonal = per_pivot;
        let (solved, others) = right.get_mut(row..)?.split_first_mut()?;
        subtract(others, per_pivot * *solved, own);
        while let (Some(number), Some((next, rest))) = (own.first(), after.split_at_mut_checked(self.width)) {
            subtract(next, per_pivot * *number, own);
            (own, after) = (own.get_mut(1..)?, rest);
        }
        Some(())
    }

    /// Solves the rows from `first` on, which are eliminated, the last one first.
    fn substitute(&self, first: usize, right: &mut [R]) {
        for row in (first..right.len()).rev() {
            let own = self.row(row).split_first();
            let right = right.get_mut(row..).and_then(<[R]>::split_first_mut);
            if let (Some((per_pivot, own)), Some((number, solved))) = (own, right) {
                // The one that was solved last comes last.
                let mut left = *number;
                for (factor, other) in own.iter().zip(solved).rev() {
                    left = left - *factor * *other;
                }
                *number = *per_pivot * left;
            }
        }
    }
}

impl<R: Real, const K: usize> Chain<'_, '_, R, K> {
    /// Newton's step with damped diagonals: those of the states by `of_states`, those of the durations by `lambda`. `None` if the matrix is not positive.
    pub fn solve(&mut self, of_states: R, lambda: R) -> Option<()> {
        let more = R::ONE + of_states;
        self.fill(0, more, lambda);
        for section in 0..self.sections {
            if section + 1 < self.sections {
                self.fill(section + 1, more, lambda);
            }
            self.eliminate(section, more)?;
        }
        // The states at the start of the first section are given.
        let first = self.row(0, self.axes);
        self.memory.band.substitute(first, self.memory.step.0);
        Some(())
    }

    /// The row of the first unknown of an axis at the start of a section. After those of all axes comes that of the duration.
    pub fn row(&self, section: usize, axis: usize) -> usize {
        section * (K * self.axes + 1) + K * axis
    }

    /// Writes the rows of a section, and their right sides.
    fn fill(&mut self, section: usize, more: R, lambda: R) {
        let (axes, next) = (self.axes, self.row(section + 1, 0));
        let duration = next - 1;
        self.memory.band.clear(self.row(section, 0)..next);
        for axis in 0..axes {
            let (row, ahead) = (self.row(section, axis), self.row(section + 1, axis));
            let piece = section * axes + axis;
            // A state that bends is damped by its durations.
            let more = if section > 0 && self.is_narrow(section, axis) { R::ONE } else { more };
            let memory = &mut self.memory;
            memory.band.put(duration, ahead, memory.to_duration.row(2 * piece + 1));
            if let Some(point) = piece.checked_sub(axes) {
                let (diagonal, to_duration) = (memory.diagonal(point), memory.to_duration.row(2 * piece));
                for (k, numbers) in diagonal.iter().enumerate() {
                    for (other, number) in numbers.iter().enumerate().skip(k) {
                        memory.band.put(row + k, row + other, [*number]);
                    }
                    memory.band.put(row + k, row + k, [more * numbers[k]]);
                    memory.band.put(row + k, duration, [to_duration[k]]);
                    memory.band.put(row + k, ahead, memory.coupling.row(K * point + k));
                    memory.step.put(row + k, -memory.gradient.row(point)[k]);
                }
            }
        }
        let ahead = self.row(section + 1, axes);
        let memory = &mut self.memory;
        let own = memory.of_durations.at(section) + lambda * memory.convex_part.at(section);
        memory.band.put(duration, duration, [own]);
        memory.band.put(duration, ahead, [memory.mixed.at(section)]);
        memory.step.put(duration, -memory.gradient_t.at(section));
    }

    /// Eliminates the unknowns of a section. `None` if a pivot is not positive.
    fn eliminate(&mut self, section: usize, more: R) -> Option<()> {
        let (axes, duration) = (self.axes, self.row(section, self.axes));
        for axis in 0..axes {
            let row = self.row(section, axis);
            let Some(point) = (section * axes + axis).checked_sub(axes) else { break };
            let sizes = self.memory.diagonal(point);
            for (k, size) in sizes.iter().enumerate() {
                let memory = &mut self.memory;
                let pivot = memory.band.pivot(row + k);
                // The states' part is positive, up to rounding.
                let least = R::from(4) * R::EPSILON * more * size[k];
                let pivot = if pivot >= -least { pivot.at_least(least) } else { pivot };
                (pivot > R::ZERO).then_some(())?;
                memory.band.eliminate(row + k, pivot, memory.step.0)?;
            }
        }
        let memory = &mut self.memory;
        let size = memory.of_durations.at(section).abs() + memory.convex_part.at(section);
        let pivot = memory.band.pivot(duration);
        let is_positive = pivot > R::from(8) * R::EPSILON * size;
        is_positive.then(|| memory.band.eliminate(duration, pivot, memory.step.0))?
    }

    /// The slope of the objective along the step.
    pub fn slope(&self) -> R {
        let mut slope = R::ZERO;
        for section in 0..self.sections {
            let waypoint = section.checked_sub(1).map_or(0..0, |point| point * self.axes..section * self.axes);
            for (axis, row) in waypoint.enumerate() {
                for (gradient, step) in self.memory.gradient.row(row).into_iter().zip(self.direction(section, axis)) {
                    slope = slope + gradient * step;
                }
            }
            slope = slope + self.memory.gradient_t.at(section) * self.change(section);
        }
        slope
    }

    /// The step of the unknowns of a waypoint.
    pub fn direction(&self, point: usize, axis: usize) -> [R; K] {
        let numbers = self.memory.step.0.get(self.row(point, axis)..);
        numbers.and_then(<[R]>::first_chunk).copied().unwrap_or([R::ZERO; K])
    }

    /// The step of the duration of a section, s.
    pub fn change(&self, section: usize) -> R {
        self.memory.step.at(self.row(section, self.axes))
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::chain::{Chain, Request};
    use super::super::memory::{Memory, size};
    use crate::findings::Findings;
    use support::Random;

    /// A chain whose tables hold a system of equations: `diagonal` stands on the diagonal of the durations.
    fn chain<const K: usize>(
        axes: usize, sections: usize, work: &mut [f64], diagonal: f64,
    ) -> Chain<'static, '_, f64, K> {
        let mut memory = Memory::of(work, axes, sections).expect("room");
        let mut random = Random::seeded(0);
        let mut number = || random.between(-1.0, 1.0);
        for row in 0..axes * (sections - 1) {
            memory.diagonal.set(row, [4.0 + number(), number(), 4.0 + number()]);
            memory.of_offsets.set(row, [number(), number(), 4.0 + number()]);
            memory.coupling.set_tile(row, [(); K].map(|()| [(); K].map(|()| number())));
            memory.gradient.set(row, [(); K].map(|()| number()));
        }
        for row in 0..2 * axes * sections {
            memory.to_duration.set(row, [(); K].map(|()| number()));
        }
        for section in 0..sections {
            memory.gradient_t.put(section, number());
            memory.convex_part.put(section, 2.0 + number());
            memory.mixed.put(section, number());
            memory.of_durations.put(section, diagonal);
        }
        let request =
            Request { axes, sections, states: &[], limits: &[], parts: &[], tolerances: &[], is_begun: false };
        Chain { request, axes, sections, memory, findings: Findings::default(), last_assembled: 0 }
    }

    /// What all equations miss: those of the states, then those of the durations. The elimination overwrites the equations, so `given` is a copy.
    pub fn errors<const K: usize>(
        given: &Memory<f64, K>, solved: &Chain<f64, K>, lambda: f64,
    ) -> impl Iterator<Item = f64> {
        let (axes, sections) = (solved.axes, solved.sections);
        let (rows, states) = (axes * (sections - 1), K * axes * (sections - 1));
        let (mut step, mut sums) = ([0.0; 50], [0.0; 50]);
        for row in 0..rows {
            step[K * row..][..K].copy_from_slice(&solved.direction(1 + row / axes, row % axes));
            sums[K * row..][..K].copy_from_slice(&given.gradient.row(row));
        }
        for section in 0..sections {
            step[states + section] = solved.change(section);
            sums[states + section] = given.gradient_t.at(section);
        }
        // The matrix is symmetric.
        let mut add = |one: usize, other: usize, number: f64| {
            sums[one] += number * step[other];
            if other != one {
                sums[other] += number * step[one];
            }
        };
        for row in 0..rows {
            let (own, section) = (given.diagonal(row), states + row / axes);
            for (k, numbers) in own.iter().enumerate() {
                let one = K * row + k;
                add(one, one, lambda * numbers[k]);
                (0..=k).for_each(|column| add(one, K * row + column, numbers[column]));
                if row + axes < rows {
                    let coupling = given.coupling.row(one);
                    (0..K).for_each(|column| add(one, K * (row + axes) + column, coupling[column]));
                }
                add(one, section, given.to_duration.row(2 * row + 1)[k]);
                add(one, section + 1, given.to_duration.row(2 * (row + axes))[k]);
            }
        }
        for section in 0..sections {
            let own = given.of_durations.at(section) + lambda * given.convex_part.at(section);
            add(states + section, states + section, own);
            if section + 1 < sections {
                add(states + section, states + section + 1, given.mixed.at(section));
            }
        }
        sums.into_iter().take(states + sections)
    }

    fn the_step_solves<const K: usize>() {
        for (axes, sections) in [(1, 1), (1, 2), (1, 4), (2, 3), (3, 5)] {
            for lambda in [0.0, 0.5] {
                let room = size::<K>(axes, sections).expect("a size");
                let [mut work, mut copy] = [(); 2].map(|()| [0.0; 2_000]);
                let given = chain::<K>(axes, sections, &mut copy[..room], 20.0).memory;
                let mut chain = chain::<K>(axes, sections, &mut work[..room], 20.0);
                assert_eq!(chain.solve(lambda, lambda), Some(()));
                let of_states = (0..axes * (sections - 1)).map(|row| {
                    let (gradient, step) = (given.gradient.row(row), chain.direction(1 + row / axes, row % axes));
                    gradient.iter().zip(step).map(|(gradient, step)| gradient * step).sum()
                });
                let of_durations = (0..sections).map(|section| given.gradient_t.at(section) * chain.change(section));
                let slope: f64 = of_states.chain(of_durations).sum();
                assert!((chain.slope() - slope).abs() < 1e-12, "{axes} {sections}: {slope}");
                let is_solved = errors(&given, &chain, lambda).all(|error| error.abs() < 1e-12);
                assert!(is_solved, "{K} unknowns, {axes} axes, {sections} sections, {lambda}");
            }
        }
    }

    #[test]
    fn the_step_solves_its_equations() {
        the_step_solves::<2>();
        the_step_solves::<3>();
    }

    /// What counts as positive has no unit.
    #[test]
    fn small_numbers_have_a_step() {
        let mut work = [0.0; 100];
        let mut chain = chain::<2>(1, 1, &mut work, 0.0);
        let (least, gradient) = (f64::exp2(-60.0), f64::exp2(-50.0));
        chain.memory.of_durations.put(0, least);
        chain.memory.convex_part.clear();
        chain.memory.gradient_t.put(0, gradient);
        assert_eq!(chain.solve(0.0, 0.0), Some(()));
        assert_eq!(chain.change(0), -gradient / least);
    }

    #[test]
    fn a_matrix_that_is_not_positive_has_no_step() {
        let mut work = [0.0; 1_000];
        assert_eq!(chain::<2>(2, 3, &mut work, -20.0).solve(0.0, 0.0), None);
        assert_eq!(chain::<3>(2, 3, &mut work, -20.0).solve(0.0, 0.0), None);
    }
}
