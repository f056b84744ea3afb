//! Newton's step: each axis is a chain of blocks, and only the durations tie the axes together.
//!
//! `docs/path.md` has the letters and the theory, in "The step". No root is taken, so powers of two in the units change no bit.

use super::chain::Chain;
use crate::real::Real;

/// A symmetric block as `L D Lᵀ`: `1/d0`, `l`, `1/d1`.
fn factors<R: Real>([vv, va, aa]: [R; 3]) -> [R; 3] {
    let l = va / vv;
    // The block is positive, up to roundings of its last entry.
    let rest = (aa - l * va).at_least(R::from(4) * R::EPSILON * aa);
    [R::ONE / vv, l, R::ONE / rest]
}

impl<R: Real> Chain<'_, '_, R> {
    /// Eliminates the states: the matrix `M` and the gradient of the durations then hold for the best states of given durations. Gives
    /// how much the quadratic model falls by the states alone, twice.
    pub fn eliminate(&mut self, lambda: R) -> R {
        let more = R::ONE + lambda;
        let mut fall = R::ZERO;
        for axis in 0..self.axes {
            let mut solved = [R::ZERO; 2];
            for point in 1..self.sections {
                let row = (point - 1) * self.axes + axis;
                let [vv, va, aa] = self.memory.diagonal.row(row);
                let (mut block, mut right) =
                    ([vv * more, va, aa * more], self.memory.gradient.row(row));
                match row.checked_sub(self.axes) {
                    Some(previous) => {
                        self.subtract(point, previous, solved, &mut block, &mut right);
                    }
                    None => self.memory.blocks[0].set(0, [R::ZERO; 2]),
                }
                self.add_own_blocks(point, axis);
                let [per_0, l, per_1] = factors(block);
                self.memory.diagonal.set(row, [per_0, l, per_1]);
                solved = [right[0], right[1] - l * right[0]];
                let scaled = [solved[0] * per_0, solved[1] * per_1];
                fall = fall + (solved[0] * scaled[0] + solved[1] * scaled[1]);
                self.reduce(point, [per_0, l, per_1], scaled);
                self.memory.blocks.swap(0, 1);
            }
        }
        fall
    }

    /// The blocks between a way point and the durations of both its sections.
    fn add_own_blocks(&mut self, point: usize, axis: usize) {
        let memory = &mut self.memory;
        let [blocks, _] = &mut memory.blocks;
        let row = (point - 1) * self.axes + axis;
        let [.., v1, a1] = memory.to_duration.row(row);
        let [v0, a0, ..] = memory.to_duration.row(row + self.axes);
        blocks.add(point - 1, [v1, a1]);
        blocks.set(point, [v0, a0]);
    }

    /// Subtracts what the way point before adds to the block and to the right side, and begins the blocks of the durations with it.
    fn subtract(
        &mut self,
        point: usize,
        previous: usize,
        solved: [R; 2],
        block: &mut [R; 3],
        right: &mut [R; 2],
    ) {
        let memory = &mut self.memory;
        let [per_0, l, per_1] = memory.diagonal.row(previous);
        let [vv, va, av, aa] = memory.coupling.row(previous);
        let (av, aa) = (av - l * vv, aa - l * va);
        memory.coupling.set(previous, [vv, va, av, aa]);
        let [s_vv, s_va, s_av, s_aa] = [vv * per_0, va * per_0, av * per_1, aa * per_1];
        let [d_vv, d_va, d_aa] = *block;
        *block = [
            d_vv - (vv * s_vv + av * s_av),
            d_va - (vv * s_va + av * s_aa),
            d_aa - (va * s_va + aa * s_aa),
        ];
        let less = |[x, y]: [R; 2], [z0, z1]: [R; 2]| {
            [x - (s_vv * z0 + s_av * z1), y - (s_va * z0 + s_aa * z1)]
        };
        *right = less(*right, solved);
        let [blocks, before] = &mut memory.blocks;
        for (column, rows) in before.rows(point).enumerate() {
            blocks.set(column, less([R::ZERO; 2], rows));
        }
    }

    /// Subtracts a way point from the matrix and the gradient of the durations.
    fn reduce(&mut self, point: usize, [per_0, l, per_1]: [R; 3], [z0, z1]: [R; 2]) {
        let memory = &mut self.memory;
        let [blocks, _] = &mut memory.blocks;
        for column in 0..=point {
            let [x, y] = blocks.row(column);
            let [x, y] = [x, y - l * x];
            blocks.set(column, [x, y]);
            memory.gradient_t.add(column, [-(x * z0 + y * z1)]);
            let (x, y) = (x * per_0, y * per_1);
            let row = memory.matrix.row_mut(column).iter_mut();
            for (number, [x1, y1]) in row.zip(blocks.rows(column + 1)) {
                *number = *number - (x * x1 + y * y1);
            }
        }
    }

    /// The step of the durations by the matrix `M + lambda G`, as `L D Lᵀ`. `None` if it is not positive.
    pub fn solve_durations(&mut self, lambda: R) -> Option<()> {
        let memory = &mut self.memory;
        for k in 0..self.sections {
            let least = memory.damping.at(k);
            let (above, row) = memory.factor.above(k);
            for (entry, number) in row.iter_mut().zip(memory.matrix.row(k)) {
                *entry = *number;
            }
            for column in 0..k {
                let (solved, rest) = row.split_at_mut_checked(column)?;
                let product = dot(solved, above.row(column));
                let entry = rest.first_mut()?;
                *entry = *entry - product;
            }
            let (diagonal, row) = row.split_last_mut()?;
            let size = diagonal.abs() + least;
            let mut pivot = *diagonal + lambda * least;
            for (column, entry) in row.iter_mut().enumerate() {
                let l = *entry / *above.row(column).last()?;
                pivot = pivot - *entry * l;
                *entry = l;
            }
            let is_positive = pivot > R::from(8) * R::EPSILON * size;
            *diagonal = is_positive.then_some(pivot)?;
        }
        self.substitute()
    }

    fn substitute(&mut self) -> Option<()> {
        let memory = &mut self.memory;
        for k in 0..self.sections {
            let (before, rest) = memory.changes.numbers_mut().split_at_mut_checked(k)?;
            *rest.first_mut()? = -memory.gradient_t.at(k) - dot(before, memory.factor.row(k));
        }
        for k in 0..self.sections {
            let pivot = *memory.factor.row(k).last()?;
            let change = memory.changes.at(k) / pivot;
            memory.changes.put(k, change);
        }
        for k in (0..self.sections).rev() {
            let (before, rest) = memory.changes.numbers_mut().split_at_mut_checked(k)?;
            let change = *rest.first()?;
            for (number, l) in before.iter_mut().zip(memory.factor.row(k)) {
                *number = *number - *l * change;
            }
        }
        Some(())
    }

    /// The step of the states that belongs to the step of the durations.
    pub fn solve_states(&mut self) {
        for axis in 0..self.axes {
            let mut before = [R::ZERO; 2];
            for point in 1..self.sections {
                before = self.forward(point, axis, before);
            }
            let mut behind = [R::ZERO; 2];
            for point in (1..self.sections).rev() {
                behind = self.backward(point, axis, behind);
            }
        }
    }

    fn forward(&mut self, point: usize, axis: usize, [z0, z1]: [R; 2]) -> [R; 2] {
        let memory = &mut self.memory;
        let row = (point - 1) * self.axes + axis;
        let (t0, t1) = (memory.changes.at(point - 1), memory.changes.at(point));
        let [.., v1, a1] = memory.to_duration.row(row);
        let [v0, a0, ..] = memory.to_duration.row(row + self.axes);
        let [g_v, g_a] = memory.gradient.row(row);
        let mut right = [-g_v - (v1 * t0 + v0 * t1), -g_a - (a1 * t0 + a0 * t1)];
        if let Some(previous) = row.checked_sub(self.axes) {
            let [vv, va, av, aa] = memory.coupling.row(previous);
            right = [
                right[0] - (vv * z0 + av * z1),
                right[1] - (va * z0 + aa * z1),
            ];
        }
        let [per_0, l, per_1] = memory.diagonal.row(row);
        let scaled = [right[0] * per_0, (right[1] - l * right[0]) * per_1];
        memory.directions.set(row, scaled);
        scaled
    }

    fn backward(&mut self, point: usize, axis: usize, [v, a]: [R; 2]) -> [R; 2] {
        let memory = &mut self.memory;
        let row = (point - 1) * self.axes + axis;
        let [per_0, l, per_1] = memory.diagonal.row(row);
        let mut scaled = memory.directions.row(row);
        if point + 1 < self.sections {
            let [vv, va, av, aa] = memory.coupling.row(row);
            scaled = [
                scaled[0] - (vv * v + va * a) * per_0,
                scaled[1] - (av * v + aa * a) * per_1,
            ];
        }
        let [z0, z1] = scaled;
        let direction = [z0 - l * z1, z1];
        memory.directions.set(row, direction);
        direction
    }
}

/// The sum of the products; what one slice has more than the other is left out.
fn dot<R: Real>(x: &[R], y: &[R]) -> R {
    x.iter().zip(y).fold(R::ZERO, |sum, (x, y)| sum + *x * *y)
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::chain::{Chain, Request};
    use super::super::memory::{Memory, size};
    use crate::findings::Findings;

    /// Numbers between -1 and 1 that look random: the parts of the multiples of the golden ratio.
    fn numbers() -> impl FnMut() -> f64 {
        let mut k = 0.0;
        move || {
            k += 1.618_033_988_749_895;
            2.0 * (k - f64::floor(k)) - 1.0
        }
    }

    /// A chain whose tables hold a system of equations: `diagonal` stands on the diagonal of the durations.
    fn chain(
        axes: usize,
        sections: usize,
        work: &mut [f64],
        diagonal: f64,
    ) -> Chain<'static, '_, f64> {
        let mut memory = Memory::of(work, axes, sections).expect("room");
        let mut number = numbers();
        for row in 0..axes * (sections - 1) {
            memory
                .diagonal
                .set(row, [4.0 + number(), number(), 4.0 + number()]);
            memory.coupling.set(row, [(); 4].map(|()| number()));
            memory.gradient.set(row, [(); 2].map(|()| number()));
        }
        for piece in 0..axes * sections {
            memory.to_duration.set(piece, [(); 4].map(|()| number()));
        }
        for section in 0..sections {
            memory.gradient_t.put(section, number());
            memory.damping.put(section, 2.0 + number());
            (0..section).for_each(|column| memory.matrix.add(section, column, number()));
            memory.matrix.add(section, section, diagonal);
        }
        let request = Request {
            axes,
            sections,
            states: &[],
            limits: &[],
        };
        Chain {
            request,
            axes,
            sections,
            memory,
            findings: Findings::default(),
        }
    }

    /// The step of a state; none at the start and at the end.
    fn direction(solved: &Chain<f64>, point: usize, axis: usize) -> [f64; 2] {
        if point > 0 && point < solved.sections {
            solved
                .memory
                .directions
                .row((point - 1) * solved.axes + axis)
        } else {
            [0.0; 2]
        }
    }

    /// What the equations of a state miss. The elimination overwrites the equations, so `given` is a copy of them.
    fn errors_of_state(
        given: &Memory<f64>,
        solved: &Chain<f64>,
        [point, axis]: [usize; 2],
        lambda: f64,
    ) -> [f64; 2] {
        let row = (point - 1) * solved.axes + axis;
        let ([g_v, g_a], [vv, va, aa]) = (given.gradient.row(row), given.diagonal.row(row));
        let ([v, a], more) = (direction(solved, point, axis), 1.0 + lambda);
        let mut sums = [g_v + more * vv * v + va * a, g_a + va * v + more * aa * a];
        let mut add = |[by_v, by_a]: [f64; 2]| sums = [sums[0] + by_v, sums[1] + by_a];
        if let Some(before) = row.checked_sub(solved.axes) {
            let [vv, va, av, aa] = given.coupling.row(before);
            let [v, a] = direction(solved, point - 1, axis);
            add([vv * v + av * a, va * v + aa * a]);
        }
        let [vv, va, av, aa] = given.coupling.row(row);
        let [v, a] = direction(solved, point + 1, axis);
        add([vv * v + va * a, av * v + aa * a]);
        let [.., v1, a1] = given.to_duration.row(row);
        let [v0, a0, ..] = given.to_duration.row(row + solved.axes);
        let [before, behind] = [point - 1, point].map(|section| solved.memory.changes.at(section));
        add([v1 * before + v0 * behind, a1 * before + a0 * behind]);
        sums
    }

    /// What the equation of a duration misses.
    fn error_of_duration(
        given: &Memory<f64>,
        solved: &Chain<f64>,
        section: usize,
        lambda: f64,
    ) -> f64 {
        let change = |section| solved.memory.changes.at(section);
        let mut sum =
            given.gradient_t.at(section) + lambda * given.damping.at(section) * change(section);
        for other in 0..solved.sections {
            let (high, low) = (section.max(other), section.min(other));
            sum += given.matrix.row(high)[low] * change(other);
        }
        for axis in 0..solved.axes {
            let ends = given.to_duration.row(section * solved.axes + axis);
            let [start, end] = [section, section + 1].map(|point| direction(solved, point, axis));
            let products = ends.into_iter().zip(start.into_iter().chain(end));
            sum += products.map(|(number, x)| number * x).sum::<f64>();
        }
        sum
    }

    /// What all equations miss: those of the states, then those of the durations.
    pub fn errors(
        given: &Memory<f64>,
        solved: &Chain<f64>,
        lambda: f64,
    ) -> impl Iterator<Item = f64> {
        let places =
            (1..solved.sections).flat_map(|point| (0..solved.axes).map(move |axis| [point, axis]));
        let of_states = places.flat_map(move |place| errors_of_state(given, solved, place, lambda));
        let of_durations = (0..solved.sections)
            .map(move |section| error_of_duration(given, solved, section, lambda));
        of_states.chain(of_durations)
    }

    #[test]
    fn the_step_solves_its_equations() {
        for (axes, sections) in [(1, 1), (1, 2), (1, 4), (2, 3), (3, 5)] {
            for lambda in [0.0, 0.5] {
                let room = size(axes, sections).expect("a size");
                let [mut work, mut copy] = [(); 2].map(|()| [0.0; 1_000]);
                let given = chain(axes, sections, &mut copy[..room], 20.0).memory;
                let mut chain = chain(axes, sections, &mut work[..room], 20.0);
                let fall = chain.eliminate(lambda);
                // With the durations held, the states alone take the step of the gradient.
                chain.solve_states();
                let rows = given.gradient.rows(axes * (sections - 1));
                let directions = chain.memory.directions.rows(axes * (sections - 1));
                let slope: f64 = rows
                    .zip(directions)
                    .map(|([g_v, g_a], [v, a])| g_v * v + g_a * a)
                    .sum();
                assert!(
                    (fall + slope).abs() < 1e-12,
                    "{axes} {sections}: {fall} {slope}"
                );
                assert_eq!(chain.solve_durations(lambda), Some(()));
                chain.solve_states();
                assert!(
                    errors(&given, &chain, lambda).all(|error| error.abs() < 1e-12),
                    "{axes} axes, {sections} sections, {lambda}"
                );
            }
        }
    }

    /// What counts as positive has no unit.
    #[test]
    fn small_numbers_have_a_step() {
        let mut work = [0.0; 100];
        let mut chain = chain(1, 1, &mut work, 0.0);
        let (least, gradient) = (f64::exp2(-60.0), f64::exp2(-50.0));
        chain.memory.matrix.clear();
        chain.memory.matrix.add(0, 0, least);
        chain.memory.damping.clear();
        chain.memory.gradient_t.put(0, gradient);
        assert_eq!(chain.solve_durations(0.0), Some(()));
        assert_eq!(chain.memory.changes.at(0), -gradient / least);
    }

    #[test]
    fn a_matrix_that_is_not_positive_has_no_step() {
        let mut work = [0.0; 1_000];
        let mut chain = chain(2, 3, &mut work, -20.0);
        chain.eliminate(0.0);
        assert_eq!(chain.solve_durations(0.0), None);
    }
}
