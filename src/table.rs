//! Tables of numbers in the memory of the caller.

use crate::real::Real;
use core::ops::Range;

/// A table with `W` numbers a row. A row that is not there has zeros, and is not written.
pub(crate) struct Table<'a, R, const W: usize>(pub(crate) &'a mut [R]);

impl<R: Real, const W: usize> Table<'_, R, W> {
    pub fn row(&self, k: usize) -> [R; W] {
        match self.0.get(k * W..k * W + W).and_then(<[R]>::first_chunk) {
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
        self.0.get_mut(k * W..k * W + W)?.first_chunk_mut()
    }

    pub fn fill(&mut self, number: R) {
        self.0.fill(number);
    }

    pub fn clear(&mut self) {
        self.fill(R::ZERO);
    }

    pub fn copy(&mut self, other: &Self) {
        self.copy_rows(other, 0..self.0.len() / W);
    }

    pub fn copy_rows(&mut self, other: &Self, rows: Range<usize>) {
        for row in rows {
            self.set(row, other.row(row));
        }
    }
}

/// A table with one number a row.
pub(crate) type Column<'a, R> = Table<'a, R, 1>;

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
}
