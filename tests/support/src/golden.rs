//! Golden data: tables of what the original computed, and the comparison of an implementation with them.

use crate::comparison::Comparison;
use crate::family::Family;
use crate::implementation::Implementation;
use crate::real::Real;
use crate::repository::{read, root};
use std::path::PathBuf;

pub struct Move<R> {
    pub place: String,       // file and line
    pub arguments: Vec<R>,   // arguments of `gen`
    pub duration: Option<R>, // what `gen` returned, if it returns anything
    pub fields: Vec<R>,      // what `gen` wrote
}

pub struct Evaluation<R> {
    pub place: String,  // file and line
    pub case: usize,    // the number of the move
    pub x: R,           // the time
    pub values: Vec<R>, // the family's quantities
}

pub fn moves<R: Real>(family: Family) -> Vec<Move<R>> {
    moves_of(family, family.name())
}

/// The moves of another table: `newest_bell` and `newest_trap` are what liba planned on 2026-06-25, with [`atraj::Saturation::Numbers`].
pub fn moves_of<R: Real>(family: Family, table: &str) -> Vec<Move<R>> {
    let arguments = family.arguments().len();
    // A polynomial returns no duration, and its moves have no category.
    let (words, returned) = if family.is_polynomial() { (1, 0) } else { (2, 1) };
    let numbers = arguments + returned + family.fields().len();
    let table = format!("{table}_gen");
    let to_move = |(index, row): (usize, Row<R>)| {
        assert_eq!(row.case, index, "{}: case", row.place);
        Move {
            place: row.place,
            arguments: row.values[..arguments].to_vec(),
            duration: (returned > 0).then(|| row.values[arguments]),
            fields: row.values[arguments + returned..].to_vec(),
        }
    };
    rows(&table, words, numbers).into_iter().enumerate().map(to_move).collect()
}

pub fn evaluations<R: Real>(family: Family) -> Vec<Evaluation<R>> {
    let table = format!("{}_eval", family.name());
    let to_evaluation = |Row { place, case, values }: Row<R>| {
        let (x, values) = (values[0], values[1..].to_vec());
        Evaluation { place, case, x, values }
    };
    rows(&table, 1, 1 + family.quantities().len()).into_iter().map(to_evaluation).collect()
}

pub fn compare<R: Real>(comparison: &mut Comparison, implementation: &impl Implementation<R>, family: Family) {
    let moves = moves(family);
    let planned: Vec<_> = moves.iter().map(|golden| compare_plan(comparison, implementation, family, golden)).collect();
    for golden in evaluations::<R>(family) {
        let got = implementation.evaluate(family, &planned[golden.case], golden.x);
        for ((quantity, got), want) in family.quantities().iter().zip(got).zip(golden.values) {
            comparison.check(&golden.place, quantity.name, got, want);
        }
    }
}

pub fn compare_plans<R: Real>(
    comparison: &mut Comparison, implementation: &impl Implementation<R>, family: Family, moves: &[Move<R>],
) {
    for golden in moves {
        compare_plan(comparison, implementation, family, golden);
    }
}

fn compare_plan<R: Real>(
    comparison: &mut Comparison, implementation: &impl Implementation<R>, family: Family, golden: &Move<R>,
) -> Vec<R> {
    let mut fields = vec![R::ZERO; family.fields().len()];
    let duration = implementation.plan(family, &golden.arguments, &mut fields);
    if let Some(want) = golden.duration {
        comparison.check(&golden.place, "duration", duration, want);
    }
    for ((name, &got), &want) in family.fields().iter().zip(&fields).zip(&golden.fields) {
        comparison.check(&golden.place, name, got, want);
    }
    fields
}

pub struct Row<R> {
    pub place: String,  // file and line
    pub case: usize,    // the number of the move
    pub values: Vec<R>, // the numbers
}

/// All rows of `tests/golden/{table}_{f32|f64}.csv`. The first `words` columns are a case number and words, the other
/// `numbers` columns are bit patterns. Panics if the file is missing, has no rows or a row that is not of this form.
pub fn rows<R: Real>(table: &str, words: usize, numbers: usize) -> Vec<Row<R>> {
    let to_row = |(place, cells): (String, Vec<String>)| {
        let case = cells[0].parse().unwrap_or_else(|e| panic!("{place}: {e}"));
        let number = |cell: &String| R::parse(cell).unwrap_or_else(|| panic!("{place}: {cell:?}"));
        Row { values: cells[words..].iter().map(number).collect(), place, case }
    };
    cells(&format!("{table}_{}.csv", R::NAME), words + numbers).into_iter().map(to_row).collect()
}

/// File and line of each row of a golden file, and its `columns` cells. Panics if the file is missing, has no rows or a row of another length.
pub fn cells(name: &str, columns: usize) -> Vec<(String, Vec<String>)> {
    let row = |(index, line): (usize, &str)| {
        let place = format!("{name}:{}", index + 1);
        let cells: Vec<_> = line.split(',').map(str::to_owned).collect();
        assert_eq!(cells.len(), columns, "{place}: columns");
        (place, cells)
    };
    let rows: Vec<_> = read(directory().join(name)).lines().enumerate().skip(1).map(row).collect();
    assert!(!rows.is_empty(), "{name}: no rows");
    rows
}

pub fn directory() -> PathBuf {
    root().join("tests/golden")
}
