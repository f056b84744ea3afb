//! Is what a C program computes through the archive bit for bit the golden data? `parity SERVO` replays every golden row
//! of the double-S, the trapezoid and the septic polynomial through the program made of `servo.c` and prints a table.

use std::env;
use std::fmt::Write;
use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, ExitCode};
use support::golden;
use support::tools::lines;
use support::{Comparison, Family, Real};

fn main() -> ExitCode {
    let servo = env::args_os().nth(1).expect("usage: parity SERVO");
    println!("{:<18}{:>8}{:>16}", "function", "rows", "differing bits");
    let mut comparison = Comparison::default();
    let mut total = Parity::default();
    for family in [Family::Bell, Family::Trap, Family::Poly7] {
        for parity in replay(Path::new(&servo), family, &mut comparison) {
            parity.print();
            total.rows += parity.rows;
            total.bits += parity.bits;
        }
    }
    total.function = "total".into();
    total.print();
    for difference in comparison.differences.iter().take(10) {
        println!("{difference}");
    }
    let same = total.rows > 0 && comparison.differences.is_empty();
    ExitCode::from(u8::from(!same))
}

/// A line of the table.
#[derive(Default)]
struct Parity {
    function: String,
    rows: usize,
    bits: u32,
}

impl Parity {
    fn print(&self) {
        println!("{:<18}{:>8}{:>16}", self.function, self.rows, self.bits);
    }
}

/// Every golden row of one family: the planner first, then its evaluations.
fn replay(servo: &Path, family: Family, comparison: &mut Comparison) -> Vec<Parity> {
    let quantities = family.quantities().iter().map(|quantity| quantity.c);
    let function = |suffix| Parity { function: format!("a_{}_{suffix}", family.c_name()), ..Parity::default() };
    let mut parities: Vec<_> = ["gen"].into_iter().chain(quantities).map(function).collect();
    let (requests, rows) = requests(family);
    let file = servo.with_file_name(format!("golden-{}.txt", family.name()));
    fs::write(&file, requests).unwrap();
    let answers = lines(Command::new(servo).stdin(File::open(&file).unwrap()));
    assert_eq!(answers.len(), rows.len(), "answers of the servo");
    for (answer, (place, golden, plans)) in answers.iter().zip(&rows) {
        let answer: Vec<f64> = answer.split(' ').map(|n| n.parse().unwrap()).collect();
        assert_eq!(answer.len(), golden.len(), "{place}: numbers");
        for (k, (&got, &want)) in answer.iter().zip(golden).enumerate() {
            let parity = &mut parities[if *plans { 0 } else { 1 + k }];
            parity.rows += usize::from(!plans || k == 0);
            parity.bits += if got.same(want) { 0 } else { (got.to_bits() ^ want.to_bits()).count_ones() };
            comparison.check(place, &parity.function, got, want);
        }
    }
    parities
}

/// Where golden numbers after an answer of the servo stand, the numbers, and whether they are a plan or the quantities at a time.
type Row = (String, Vec<f64>, bool);

/// What the servo reads, and what it must answer.
fn requests(family: Family) -> (String, Vec<Row>) {
    let moves = golden::moves(family);
    let evaluations = golden::evaluations(family);
    let mut requests = String::new();
    let mut rows = Vec::new();
    for (case, golden) in moves.iter().enumerate() {
        requests += family.name();
        for argument in &golden.arguments {
            write!(requests, " {argument:e}").unwrap();
        }
        requests.push('\n');
        let plan = golden.duration.iter().chain(&golden.fields);
        rows.push((golden.place.clone(), plan.copied().collect(), true));
        for evaluation in evaluations.iter().filter(|row| row.case == case) {
            writeln!(requests, "at {:e}", evaluation.x).unwrap();
            let (place, values) = (evaluation.place.clone(), evaluation.values.clone());
            rows.push((place, values, false));
        }
    }
    assert_eq!(rows.len(), moves.len() + evaluations.len());
    (requests, rows)
}
