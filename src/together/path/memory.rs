//! The working memory of a path: tables of numbers, which the caller provides.

use crate::real::Real;

/// A table with `W` numbers a row. A row that is not there has zeros, and is not written.
pub(super) struct Table<'a, R, const W: usize>(&'a mut [R]);

impl<R: Real, const W: usize> Table<'_, R, W> {
    pub fn row(&self, k: usize) -> [R; W] {
        match self.0.get(k * W..).and_then(<[R]>::first_chunk) {
            Some(row) => *row,
            None => [R::ZERO; W],
        }
    }

    pub fn set(&mut self, k: usize, row: [R; W]) {
        if let Some(place) = self.row_mut(k) {
            *place = row;
        }
    }

    pub fn add(&mut self, k: usize, more: [R; W]) {
        if let Some(row) = self.row_mut(k) {
            for (number, more) in row.iter_mut().zip(more) {
                *number = *number + more;
            }
        }
    }

    fn row_mut(&mut self, k: usize) -> Option<&mut [R; W]> {
        self.0.get_mut(k * W..)?.first_chunk_mut()
    }

    pub fn clear(&mut self) {
        self.0.fill(R::ZERO);
    }

    pub fn copy(&mut self, other: &Self) {
        for (number, other) in self.0.iter_mut().zip(&*other.0) {
            *number = *other;
        }
    }

    /// The first `count` rows.
    pub fn rows(
        &self,
        count: usize,
    ) -> impl DoubleEndedIterator<Item = [R; W]> + ExactSizeIterator {
        let rows = self.0.chunks_exact(W).take(count);
        rows.map(|row| row.first_chunk().copied().unwrap_or([R::ZERO; W]))
    }
}

/// A column of numbers.
pub(super) type Column<'a, R> = Table<'a, R, 1>;

impl<R: Real> Column<'_, R> {
    pub fn at(&self, k: usize) -> R {
        let [number] = self.row(k);
        number
    }

    pub fn put(&mut self, k: usize, number: R) {
        self.set(k, [number]);
    }

    pub fn numbers(&self) -> &[R] {
        self.0
    }

    pub fn numbers_mut(&mut self) -> &mut [R] {
        self.0
    }
}

/// The lower half of a symmetric matrix, row by row.
pub(super) struct Triangle<'a, R>(&'a mut [R]);

/// How many numbers stand before row `k`.
fn before(k: usize) -> usize {
    k * (k + 1) / 2
}

impl<R: Real> Triangle<'_, R> {
    /// Row `k` up to the diagonal.
    pub fn row(&self, k: usize) -> &[R] {
        self.0.get(before(k)..before(k + 1)).unwrap_or_default()
    }

    pub fn row_mut(&mut self, k: usize) -> &mut [R] {
        self.0.get_mut(before(k)..before(k + 1)).unwrap_or_default()
    }

    /// The triangle above row `k`, and row `k`.
    pub fn above(&mut self, k: usize) -> (Triangle<'_, R>, &mut [R]) {
        let (above, rest) = self.0.split_at_mut_checked(before(k)).unwrap_or_default();
        (Triangle(above), rest.get_mut(..=k).unwrap_or_default())
    }

    pub fn add(&mut self, row: usize, column: usize, more: R) {
        if let Some(number) = self.row_mut(row).get_mut(column) {
            *number = *number + more;
        }
    }

    pub fn clear(&mut self) {
        self.0.fill(R::ZERO);
    }
}

/// All tables. A row of a point or of a section stands for one axis: that of axis `i` at point or section `k` is `k * axes + i`.
pub(super) struct Memory<'a, R> {
    /// Velocity and acceleration at each point, also at the start and at the end.
    pub states: Table<'a, R, 2>,
    /// The states of a step that is tried, also of the start and of the end.
    pub tried_states: Table<'a, R, 2>,
    /// The step of the states.
    pub directions: Table<'a, R, 2>,
    /// Displacements of the sections; in the first section behind the way inside the limits.
    pub displacements: Column<'a, R>,
    /// How long each axis comes inside the limits in the first section, s.
    pub inside: Column<'a, R>,
    /// The slacks of both borders.
    pub slacks: Table<'a, R, 2>,
    /// The limits of the way points.
    pub bounds: Table<'a, R, 6>,
    /// `D`: the blocks of the way points, as `vv`, `va`, `aa`; later their factors.
    pub diagonal: Table<'a, R, 3>,
    /// `E`: the blocks between a way point and the next one, by rows.
    pub coupling: Table<'a, R, 4>,
    /// `B`: the blocks between a section's ends and its duration: start, end.
    pub to_duration: Table<'a, R, 4>,
    /// The gradient by the states of the way points.
    pub gradient: Table<'a, R, 2>,
    /// Which section of the caller each one is.
    pub places: Column<'a, R>,
    /// s
    pub durations: Column<'a, R>,
    /// The durations of a step that is tried, s.
    pub tried: Column<'a, R>,
    /// The step of the durations, s.
    pub changes: Column<'a, R>,
    /// The weights of the sections' logarithms.
    pub weights: Column<'a, R>,
    /// The gradient by the durations.
    pub gradient_t: Column<'a, R>,
    /// `G`: the part of `M` that is never negative.
    pub damping: Column<'a, R>,
    /// Two rows of blocks in the elimination.
    pub blocks: [Table<'a, R, 2>; 2],
    /// `M`: the matrix of the durations.
    pub matrix: Triangle<'a, R>,
    /// The factors of the damped matrix.
    pub factor: Triangle<'a, R>,
}

/// The most axes, and the most sections. So a count of numbers stays within 32 bits, and a processor without a long product or a divider
/// counts it.
const MOST: usize = 4096;

/// How many numbers the tables have. `None` if there is no axis or no section, or more than 4,096.
pub(super) fn size(axes: usize, sections: usize) -> Option<usize> {
    let is_count = |count: usize| count > 0 && count <= MOST;
    let of_axes = |sections: usize| axes * (28 * sections - 12) + sections * (sections + 12);
    (is_count(axes) && is_count(sections)).then(|| of_axes(sections))
}

/// Takes numbers off the front of the memory.
fn take<'a, R>(rest: &mut &'a mut [R], count: usize) -> Option<&'a mut [R]> {
    let (taken, left) = core::mem::take(rest).split_at_mut_checked(count)?;
    *rest = left;
    Some(taken)
}

impl<'a, R: Real> Memory<'a, R> {
    /// The tables, if the memory has room for them.
    pub fn of(mut work: &'a mut [R], axes: usize, sections: usize) -> Option<Self> {
        size(axes, sections).filter(|&size| size <= work.len())?;
        let (way_points, points) = (axes * (sections - 1), axes * (sections + 1));
        let pieces = axes * sections;
        let mut table = |numbers| take(&mut work, numbers);
        Some(Self {
            states: Table(table(2 * points)?),
            tried_states: Table(table(2 * points)?),
            directions: Table(table(2 * way_points)?),
            displacements: Table(table(pieces)?),
            inside: Table(table(axes)?),
            slacks: Table(table(2 * pieces)?),
            bounds: Table(table(6 * way_points)?),
            diagonal: Table(table(3 * way_points)?),
            coupling: Table(table(4 * way_points)?),
            to_duration: Table(table(4 * pieces)?),
            gradient: Table(table(2 * way_points)?),
            places: Table(table(sections)?),
            durations: Table(table(sections)?),
            tried: Table(table(sections)?),
            changes: Table(table(sections)?),
            weights: Table(table(sections)?),
            gradient_t: Table(table(sections)?),
            damping: Table(table(sections)?),
            blocks: [Table(table(2 * sections)?), Table(table(2 * sections)?)],
            matrix: Triangle(table(before(sections))?),
            factor: Triangle(table(before(sections))?),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Memory, size};

    /// The tables stand one behind the other, so the last one ends where the memory does.
    #[test]
    fn the_tables_take_all_of_the_memory() {
        for (axes, sections) in [(1, 1), (1, 2), (3, 5), (4, 9)] {
            let mut work = [0.0_f64; 2000];
            let work = &mut work[..size(axes, sections).expect("a size")];
            let end = work.as_ptr_range().end;
            let memory = Memory::of(work, axes, sections).expect("room");
            let last = memory.factor.row(sections - 1);
            assert_eq!((last.len(), last.as_ptr_range().end), (sections, end));
        }
    }
}
