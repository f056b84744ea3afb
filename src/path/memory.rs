//! The working memory of a path: tables of numbers, which the caller provides.

use crate::real::Real;
use crate::table::{Column, Table};
use core::ops::Range;

/// The unknowns of an axis at a point by those of another: `K` rows.
pub(super) type Tile<R, const K: usize> = [[R; K]; K];

/// The first `K` of three, where `K` is 2 or 3.
#[inline(always)] // the place of each one is known then
pub(super) fn group<T: Copy, const K: usize>(all: [T; 3]) -> [T; K] {
    all.first_chunk().copied().unwrap_or([all[0]; K])
}

/// The first `K` numbers of the first `K` rows.
#[inline(always)] // the place of each number is known then
pub(super) fn tile<R: Real, const K: usize>([one, other, third]: [[R; 3]; 3]) -> Tile<R, K> {
    group([group(one), group(other), group(third)])
}

impl<R: Real, const K: usize> Table<'_, R, K> {
    pub fn set_tile(&mut self, k: usize, tile: Tile<R, K>) {
        // No loop: where firmware is small, the compiler unrolls none.
        self.set(K * k, tile[0]);
        self.set(K * k + 1, tile[1]);
        if K > 2 {
            self.set(K * k + 2, tile[2]);
        }
    }
}

/// A symmetric matrix: each row has `width` numbers from the diagonal on, and zeros after them.
pub(super) struct Band<'a, R> {
    pub numbers: &'a mut [R],
    pub width: usize,
}

impl<R: Real> Band<'_, R> {
    pub fn row(&self, row: usize) -> &[R] {
        self.numbers.get(row * self.width..(row + 1) * self.width).unwrap_or_default()
    }

    pub fn pivot(&self, row: usize) -> R {
        self.row(row).first().copied().unwrap_or(R::ZERO)
    }

    pub fn clear(&mut self, rows: Range<usize>) {
        let numbers = self.numbers.get_mut(rows.start * self.width..rows.end * self.width);
        numbers.unwrap_or_default().fill(R::ZERO);
    }

    /// Writes numbers of a row, the first one in this column.
    pub fn put<const N: usize>(&mut self, row: usize, column: usize, numbers: [R; N]) {
        let place = self.numbers.get_mut(row * self.width + (column - row)..);
        if let Some(place) = place.and_then(<[R]>::first_chunk_mut) {
            *place = numbers;
        }
    }
}

pub(super) struct Plan<'a, R> {
    /// Velocity and acceleration at each point, also at the start and at the end.
    pub states: Table<'a, R, 2>,
    /// How far each waypoint is from where it is given, in tolerances. Only with three unknowns.
    pub offsets: Column<'a, R>,
    /// The slacks of both borders.
    pub slacks: Table<'a, R, 2>,
    /// s
    pub durations: Column<'a, R>,
}

/// All tables. A row of a point or of a section stands for one axis: that of axis `i` at point or section `k` is `k * axes + i`. An axis has `K`
/// unknowns at a point: velocity, acceleration, and as the third one, if the point has a tolerance, the position.
pub(super) struct Memory<'a, R, const K: usize> {
    pub plan: Plan<'a, R>,
    /// The plan that is tried or kept, or the one before a step.
    pub other: Plan<'a, R>,
    /// Only with three unknowns, as all tables of positions.
    pub tolerances: Column<'a, R>,
    /// The step, section by section: of the states of all axes at its start, and of its duration. Those of the first start mean nothing.
    pub step: Column<'a, R>,
    /// Displacements of the sections between the given points; in the first section after the recovery.
    pub displacements: Column<'a, R>,
    /// How long the recovery of each axis lasts in the first section, s.
    pub recovery_time: Column<'a, R>,
    pub bounds: Table<'a, R, 6>,
    /// `D`: the blocks of the waypoints, as `vv`, `va`, `aa`.
    pub diagonal: Table<'a, R, 3>,
    /// The rest of `D`, with the offset `x`: `vx`, `ax`, `xx`.
    pub of_offsets: Table<'a, R, 3>,
    /// `E`: the blocks between a waypoint and the next one.
    pub coupling: Table<'a, R, K>,
    /// `B`: the blocks between a section's ends and its duration: a row for the start, and one for the end.
    pub to_duration: Table<'a, R, K>,
    pub gradient: Table<'a, R, K>,
    /// Which section of the caller each one is.
    pub places: Column<'a, R>,
    /// The weights of the sections' logarithms.
    pub weights: Column<'a, R>,
    /// The gradient by the durations.
    pub gradient_t: Column<'a, R>,
    /// The second derivatives by each duration.
    pub of_durations: Column<'a, R>,
    /// The second derivatives by each duration and the next one.
    pub mixed: Column<'a, R>,
    /// `G`: the part of `of_durations` that is never negative.
    pub convex_part: Column<'a, R>,
    /// The matrix, and then its factors: a row for each number of the step.
    pub band: Band<'a, R>,
}

/// The tables of rows of points, before the steps. They stand in tables of the steps, which are not needed yet: see [`Memory::rows`].
pub(super) struct RowTables<Column, Rows> {
    /// The length of each section along the curve.
    pub arc: Column,
    /// The highest speed along each section.
    pub highest_speed: Column,
    /// At which share of it a section is passed: with the square of it of the acceleration, and with its cube of the jerk.
    pub share: Column,
    /// The speed at the end of each section, if the limits change there; else infinite.
    pub boundary_speed: Column,
    /// Slope and bend of each axis at each waypoint, and the bend that limits the speed.
    pub slope_and_bend: Rows,
    /// The unit of each axis.
    pub measure: Column,
}

/// The most axes and the most sections. So a count of numbers stays within 32 bits, and a processor without a long product counts it.
const MOST_AXES: usize = 100;
const MOST_SECTIONS: usize = 65_536;

/// How many numbers the tables have with `K` unknowns. `None` if there is no axis or no section, or too many: three unknowns leave half of the sections.
pub(super) fn size<const K: usize>(axes: usize, sections: usize) -> Option<usize> {
    let is_count = |count: usize, most: usize| count > 0 && count <= most;
    let fits = is_count(axes, MOST_AXES) && is_count(sections, MOST_SECTIONS >> (K - 2));
    fits.then(|| {
        if K == 2 {
            sections * (axes * (4 * axes + 38) + 12) - 10 * axes
        } else {
            sections * (axes * (9 * axes + 60) + 13) - 22 * axes
        }
    })
}

impl<'a, R: Real, const K: usize> Memory<'a, R, K> {
    /// The block of a waypoint: `D`.
    pub fn diagonal(&self, row: usize) -> Tile<R, K> {
        let ([vv, va, aa], [vx, ax, xx]) = (self.diagonal.row(row), self.of_offsets.row(row));
        tile([[vv, va, vx], [va, aa, ax], [vx, ax, xx]])
    }

    /// The tables of rows, each in place of the table of the steps that stands before it here.
    pub fn rows(&self) -> RowTables<&Column<'a, R>, &Table<'a, R, 3>> {
        let Self { gradient_t: arc, mixed: highest_speed, of_durations: share, .. } = self;
        let Self { weights: boundary_speed, diagonal: slope_and_bend, step: measure, .. } = self;
        RowTables { arc, highest_speed, share, boundary_speed, slope_and_bend, measure }
    }

    pub fn rows_mut(&mut self) -> RowTables<&mut Column<'a, R>, &mut Table<'a, R, 3>> {
        let Self { gradient_t: arc, mixed: highest_speed, of_durations: share, .. } = self;
        let Self { weights: boundary_speed, diagonal: slope_and_bend, step: measure, .. } = self;
        RowTables { arc, highest_speed, share, boundary_speed, slope_and_bend, measure }
    }

    /// The position of the state in row `row`, which is given at `position`. Rounding does not take it out of the tolerance.
    pub fn moved(&self, position: R, row: usize, axes: usize) -> R {
        let Some(row) = row.checked_sub(axes).filter(|_| K > 2) else { return position };
        let tolerance = self.tolerances.at(row);
        let moved = position + tolerance * self.plan.offsets.at(row);
        if (moved - position).abs() <= tolerance { moved } else { position }
    }

    pub fn of(mut work: &'a mut [R], axes: usize, sections: usize) -> Option<Self> {
        size::<K>(axes, sections).filter(|&size| size <= work.len())?;
        let (waypoints, points) = (axes * (sections - 1), axes * (sections + 1));
        let pieces = axes * sections;
        let positions = (K - 2) * waypoints;
        let unknowns = K * axes + 1;
        let (rows, width) = (unknowns * sections, unknowns + K);
        let mut table = |numbers| {
            let (taken, left) = core::mem::take(&mut work).split_at_mut_checked(numbers)?;
            work = left;
            Some(taken)
        };
        let mut plan = || {
            Some(Plan {
                states: Table(table(2 * points)?),
                offsets: Table(table(positions)?),
                slacks: Table(table(2 * pieces)?),
                durations: Table(table(sections)?),
            })
        };
        Some(Self {
            plan: plan()?,
            other: plan()?,
            tolerances: Table(table(positions)?),
            step: Table(table(rows)?),
            displacements: Table(table(pieces)?),
            recovery_time: Table(table(axes)?),
            bounds: Table(table(6 * waypoints)?),
            diagonal: Table(table(3 * waypoints)?),
            of_offsets: Table(table(3 * positions)?),
            coupling: Table(table(K * K * waypoints)?),
            to_duration: Table(table(2 * K * pieces)?),
            gradient: Table(table(K * waypoints)?),
            places: Table(table(sections)?),
            weights: Table(table(sections)?),
            gradient_t: Table(table(sections)?),
            of_durations: Table(table(sections)?),
            mixed: Table(table(sections)?),
            convex_part: Table(table(sections)?),
            band: Band { numbers: table(rows * width)?, width },
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Memory, size};

    /// The tables stand one after the other, so the last one ends where the memory does.
    #[test]
    fn the_tables_take_all_of_the_memory() {
        ends_with_the_memory::<2>();
        ends_with_the_memory::<3>();
    }

    fn ends_with_the_memory<const K: usize>() {
        for (axes, sections) in [(1, 1), (1, 2), (3, 5), (4, 9)] {
            let mut work = [0.0_f64; 4000];
            let work = &mut work[..size::<K>(axes, sections).expect("a size")];
            let end = work.as_ptr_range().end;
            let memory = Memory::<_, K>::of(work, axes, sections).expect("room");
            assert_eq!(memory.band.numbers.as_ptr_range().end, end);
        }
    }
}
