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
