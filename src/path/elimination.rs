//! Newton's step: the unknowns stand along the path, so the work is linear in the sections. They stand in groups of `K`: velocity and acceleration
//! of each axis at the start of a section, with its offset if the points have tolerances, and then the section's duration with unknowns that
//! are always 0.
//!
//! `docs/path-theory.md` has the letters and the theory, in "The step". No root is taken, so powers of two in the units change no bit.

use core::ops::Range;

use super::chain::Chain;
use super::memory::{Table, Tile, Triangle, each};
use crate::real::Real;

/// `a - x y`
#[inline(always)] // the place of each number is known then
fn minus<R: Real, const K: usize>(mut a: Tile<R, K>, x: Tile<R, K>, y: Tile<R, K>) -> Tile<R, K> {
    let columns = transposed(y);
    each!(row: a[row] = less(a[row], columns, x[row]));
    a
}

#[inline(always)] // as above
fn transposed<R: Real, const K: usize>(a: Tile<R, K>) -> Tile<R, K> {
    let mut columns = a;
    each!(row: each!(column: columns[column][row] = a[row][column]));
    columns
}

#[inline(always)] // as above
fn dot<R: Real, const K: usize>(x: [R; K], y: [R; K]) -> R {
    let mut sum = x[0] * y[0];
    sum = sum + x[1] * y[1];
    if K > 2 {
        sum = sum + x[2] * y[2];
    }
    sum
}

/// `z - a x`
#[inline(always)] // as above
fn less<R: Real, const K: usize>(mut z: [R; K], a: Tile<R, K>, x: [R; K]) -> [R; K] {
    each!(row: z[row] = z[row] - dot(a[row], x));
    z
}

/// The factors of a tile on the diagonal: `L` below the diagonal, and `1/D` on it.
#[derive(Clone, Copy)]
struct Factors<R, const K: usize>(Tile<R, K>);

impl<R: Real, const K: usize> Factors<R, K> {
    /// `1/D x`
    #[inline(always)] // as above
    fn divide(self, mut x: [R; K]) -> [R; K] {
        each!(k: x[k] = self.0[k][k] * x[k]);
        x
    }

    /// `1/L x`
    #[inline(always)] // as above
    fn solve(self, mut x: [R; K]) -> [R; K] {
        x[1] = x[1] - self.0[1][0] * x[0];
        if K > 2 {
            x[2] = x[2] - self.0[2][0] * x[0];
            x[2] = x[2] - self.0[2][1] * x[1];
        }
        x
    }

    /// `1/Lᵀ x`
    #[inline(always)] // as above
    fn solve_transposed(self, mut x: [R; K]) -> [R; K] {
        if K > 2 {
            x[0] = x[0] - self.0[2][0] * x[2];
            x[1] = x[1] - self.0[2][1] * x[2];
        }
        x[0] = x[0] - self.0[1][0] * x[1];
        x
    }

    /// `1/D` times each row.
    #[inline(always)] // as above
    fn divide_rows(self, mut rows: Tile<R, K>) -> Tile<R, K> {
        each!(row: rows[row] = self.divide(rows[row]));
        rows
    }

    /// `1/L` times each row.
    #[inline(always)] // as above
    fn solve_rows(self, mut rows: Tile<R, K>) -> Tile<R, K> {
        each!(row: rows[row] = self.solve(rows[row]));
        rows
    }
}

/// A group with a number and zeros.
fn alone<R: Real, const K: usize>(number: R) -> [R; K] {
    let mut group = [R::ZERO; K];
    group[0] = number;
    group
}

/// A tile with a row and zeros.
fn row_alone<R: Real, const K: usize>(row: [R; K]) -> Tile<R, K> {
    let mut tile = [[R::ZERO; K]; K];
    tile[0] = row;
    tile
}

impl<R: Real, const K: usize> Chain<'_, '_, R, K> {
    /// Newton's step with damped diagonals: those of the states by `of_states`, those of the durations by `lambda`. `None` if the matrix is not
    /// positive.
    pub fn solve(&mut self, of_states: R, lambda: R) -> Option<()> {
        for section in 0..self.sections {
            self.fill(section, R::ONE + of_states, lambda);
            self.subtract(section);
            self.factor(section, R::ONE + of_states)?;
            if section + 1 < self.sections {
                self.couple(section);
            }
        }
        for section in (0..self.sections).rev() {
            self.substitute(section);
        }
        Some(())
    }

    /// The first group of unknowns of a section. The states at the start of the first section are given, so only its duration is unknown.
    fn first(&self, section: usize) -> usize {
        if section > 0 { 0 } else { self.axes }
    }

    /// The row of the first group of a section in the step.
    fn groups(&self, section: usize) -> usize {
        section * (self.axes + 1)
    }

    /// The block of a section and its right side.
    fn fill(&mut self, section: usize, more: R, lambda: R) {
        let (axes, first, groups) = (self.axes, self.first(section), self.groups(section));
        for axis in first..axes {
            let row = (section - 1) * axes + axis;
            // A state that bends is damped by its durations.
            let more = if self.is_narrow(section, axis) { R::ONE } else { more };
            let memory = &mut self.memory;
            let mut own = memory.diagonal(row);
            each!(k: own[k][k] = own[k][k] * more);
            let mut block = memory.factors.at(section);
            for column in 0..axis {
                block.set(axis, column, [[R::ZERO; K]; K]);
            }
            block.set(axis, axis, own);
            block.set(axes, axis, row_alone(memory.to_duration.row(2 * (section * axes + axis))));
            memory.step.set(groups + axis, memory.gradient.row(row).map(|g| -g));
        }
        let memory = &mut self.memory;
        let mut block = memory.factors.at(section);
        let of_duration = memory.of_durations.at(section) + lambda * memory.damping.at(section);
        block.set(axes, axes, row_alone(alone(of_duration)));
        memory.step.set(groups + axes, alone(-memory.gradient_t.at(section)));
    }

    /// Subtracts what the section before adds to the block and to the right side.
    fn subtract(&mut self, section: usize) {
        let Some(previous) = section.checked_sub(1) else { return };
        let (axes, first, groups) = (self.axes, self.first(previous), self.groups(section));
        let memory = &mut self.memory;
        let [before, mut block] = memory.factors.with_next(previous);
        for index in first..=axes {
            let factors = Factors(before.tile(index, index));
            let solved = memory.step.row(groups - (axes + 1) + index);
            for row in 0..=index {
                let scaled = factors.divide_rows(transposed(memory.front.tile(index, row)));
                memory.step.set(groups + row, less(memory.step.row(groups + row), scaled, solved));
                for column in 0..=row {
                    block.set(row, column, minus(block.tile(row, column), scaled, memory.front.tile(index, column)));
                }
            }
        }
    }

    /// Factors the block as `L D Lᵀ`, and solves the right side by `L`. `None` if it is not positive.
    fn factor(&mut self, section: usize, more: R) -> Option<()> {
        let (axes, first, groups) = (self.axes, self.first(section), self.groups(section));
        for row in first..=axes {
            let mut block = self.memory.factors.at(section);
            for column in first..row {
                let mut tile = block.tile(row, column);
                for k in first..column {
                    tile = minus(tile, block.tile(row, k), transposed(block.tile(column, k)));
                }
                let factors = Factors(block.tile(column, column));
                block.set(row, column, factors.solve_rows(tile));
            }
            let mut diagonal = block.tile(row, row);
            for column in first..row {
                let product = block.tile(row, column);
                let factors = Factors(block.tile(column, column));
                let divided = factors.divide_rows(product);
                block.set(row, column, divided);
                diagonal = minus(diagonal, product, transposed(divided));
            }
            let Factors(tile) = self.pivots(section, row, diagonal, more)?;
            self.memory.factors.at(section).set(row, row, tile);
        }
        let memory = &mut self.memory;
        solve_by_rows(&memory.factors.at(section), first..axes + 1, &mut memory.step, groups);
        Some(())
    }

    /// Factors a tile on the diagonal. `None` if it is not positive.
    fn pivots(&self, section: usize, group: usize, mut tile: Tile<R, K>, more: R) -> Option<Factors<R, K>> {
        let memory = &self.memory;
        if group == self.axes {
            let size = memory.of_durations.at(section).abs() + memory.damping.at(section);
            let pivot = tile[0][0];
            let is_positive = pivot > R::from(8) * R::EPSILON * size;
            return is_positive.then(|| Factors(row_alone(alone(R::ONE / pivot))));
        }
        let sizes = memory.diagonal((section - 1) * self.axes + group);
        each!(row: {
            // Those of the row before they are divided.
            let mut entries: [R; K] = tile[row];
            let mut pivot = entries[row];
            for column in 0..row {
                for k in 0..column {
                    entries[column] = entries[column] - tile[column][k] * entries[k];
                }
                let l = entries[column] * tile[column][column];
                pivot = pivot - entries[column] * l;
                tile[row][column] = l;
            }
            // The states' part is positive, up to rounding.
            let least = R::from(4) * R::EPSILON * more * sizes[row][row];
            let pivot = if pivot >= -least { pivot.at_least(least) } else { pivot };
            (pivot > R::ZERO).then_some(())?;
            tile[row][row] = R::ONE / pivot;
        });
        Some(Factors(tile))
    }

    /// Solves the coupling with the next section by `L`. An axis does not know the axes after it, so the tiles above the diagonal stay 0.
    fn couple(&mut self, section: usize) {
        let (axes, first) = (self.axes, self.first(section));
        let memory = &mut self.memory;
        let block = memory.factors.at(section);
        for row in first..=axes {
            for column in 0..=row {
                let mut tile = if row == axes && column < axes {
                    row_alone(memory.to_duration.row(2 * (section * axes + column) + 1))
                } else if row == axes {
                    row_alone(alone(memory.mixed.at(section)))
                } else if row == column {
                    memory.coupling.tile((section - 1) * axes + row)
                } else {
                    [[R::ZERO; K]; K]
                };
                for k in first.max(column)..row {
                    tile = minus(tile, block.tile(row, k), memory.front.tile(k, column));
                }
                let factors = Factors(block.tile(row, row));
                memory.front.set(row, column, transposed(factors.solve_rows(transposed(tile))));
            }
        }
    }

    fn substitute(&mut self, section: usize) {
        let (axes, first, groups) = (self.axes, self.first(section), self.groups(section));
        let is_last = section + 1 == self.sections;
        let memory = &mut self.memory;
        let block = memory.factors.at(section);
        if !is_last {
            let next = groups + axes + 1;
            let mut of_duration = memory.mixed.at(section) * memory.step.row(next + axes)[0];
            for axis in 0..axes {
                let change = memory.step.row(next + axis);
                of_duration = of_duration + dot(memory.to_duration.row(2 * (section * axes + axis) + 1), change);
                if first == 0 {
                    let coupling = memory.coupling.tile((section - 1) * axes + axis);
                    memory.product.set(axis, less([R::ZERO; K], coupling, change));
                }
            }
            memory.product.set(axes, alone(-of_duration));
            solve_by_rows(&block, first..axes + 1, &mut memory.product, 0);
            for group in first..=axes {
                memory.step.add(groups + group, memory.product.row(group));
            }
        }
        for group in first..=axes {
            let factors = Factors(block.tile(group, group));
            memory.step.set(groups + group, factors.divide(memory.step.row(groups + group)));
        }
        for group in (first..=axes).rev() {
            let factors = Factors(block.tile(group, group));
            let solved = factors.solve_transposed(memory.step.row(groups + group));
            memory.step.set(groups + group, solved);
            for k in first..group {
                let row = memory.step.row(groups + k);
                memory.step.set(groups + k, less(row, transposed(block.tile(group, k)), solved));
            }
        }
    }

    /// The slope of the objective along the step.
    pub fn slope(&self) -> R {
        let memory = &self.memory;
        let mut slope = R::ZERO;
        for section in 0..self.sections {
            for axis in self.first(section)..self.axes {
                let gradient = memory.gradient.row((section - 1) * self.axes + axis);
                slope = slope + dot(gradient, self.direction(section, axis));
            }
            slope = slope + memory.gradient_t.at(section) * self.change(section);
        }
        slope
    }

    /// The step of the unknowns of a waypoint.
    pub fn direction(&self, point: usize, axis: usize) -> [R; K] {
        self.memory.step.row(self.groups(point) + axis)
    }

    /// The step of the duration of a section, s.
    pub fn change(&self, section: usize) -> R {
        self.memory.step.row(self.groups(section) + self.axes)[0]
    }
}

/// Solves by `L`: the groups from row `from` of the table on.
fn solve_by_rows<R: Real, const K: usize>(
    block: &Triangle<R, K>, groups: Range<usize>, right: &mut Table<R, K>, from: usize,
) {
    for row in groups.clone() {
        let mut group = right.row(from + row);
        for k in groups.start..row {
            group = less(group, block.tile(row, k), right.row(from + k));
        }
        right.set(from + row, Factors(block.tile(row, row)).solve(group));
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::chain::{Chain, Request};
    use super::super::memory::{Memory, size};
    use super::dot;
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
            memory.damping.put(section, 2.0 + number());
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
            let (own, coupling, section) = (given.diagonal(row), given.coupling.tile(row), states + row / axes);
            for k in 0..K {
                let one = K * row + k;
                add(one, one, lambda * own[k][k]);
                (0..=k).for_each(|column| add(one, K * row + column, own[k][column]));
                if row + axes < rows {
                    (0..K).for_each(|column| add(one, K * (row + axes) + column, coupling[k][column]));
                }
                add(one, section, given.to_duration.row(2 * row + 1)[k]);
                add(one, section + 1, given.to_duration.row(2 * (row + axes))[k]);
            }
        }
        for section in 0..sections {
            let own = given.of_durations.at(section) + lambda * given.damping.at(section);
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
                let of_states = (0..axes * (sections - 1))
                    .map(|row| dot(given.gradient.row(row), chain.direction(1 + row / axes, row % axes)));
                let of_durations = (0..sections).map(|section| given.gradient_t.at(section) * chain.change(section));
                let slope: f64 = of_states.chain(of_durations).sum();
                assert!((chain.slope() - slope).abs() < 1e-12, "{axes} {sections}: {slope}");
                assert!(
                    errors(&given, &chain, lambda).all(|error| error.abs() < 1e-12),
                    "{K} unknowns, {axes} axes, {sections} sections, {lambda}"
                );
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
        chain.memory.damping.clear();
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
