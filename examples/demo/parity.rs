//! Is what a C program computes through the archive bit for bit the golden data? `parity SERVO` replays every golden row
//! of the double-S, the trapezoid and the septic polynomial through the program made of `servo.c` and prints a table.

use std::env;
use std::fmt::Write;
use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};
use support::golden;
use support::{Comparison, Family, Real};

fn main() -> ExitCode {
    let servo = env::args_os().nth(1).expect("usage: parity SERVO");
    println!("{:<18}{:>8}{:>16}", "function", "rows", "differing bits");
    let mut total = Parity::new("total".into());
    for family in [Family::Bell, Family::Trap, Family::Poly7] {
        for parity in replay(Path::new(&servo), family) {
            parity.print();
            total.add(parity);
        }
    }
    total.print();
    for difference in total.comparison.differences.iter().take(10) {
        println!("{difference}");
    }
    if total.rows > 0 && total.comparison.differences.is_empty() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// A line of the table.
struct Parity {
    function: String,
    rows: usize,
    bits: u32,
    comparison: Comparison,
}

impl Parity {
    fn new(function: String) -> Self {
        Self {
            function,
            rows: 0,
            bits: 0,
            comparison: Comparison::default(),
        }
    }

    /// Compares an answer of the servo with a golden row.
    fn check(&mut self, place: &str, answer: &[f64], golden: &[f64]) {
        self.rows += 1;
        for (&got, &want) in answer.iter().zip(golden) {
            self.comparison.check(place, &self.function, got, want);
            if !got.same(want) {
                self.bits += (got.to_bits() ^ want.to_bits()).count_ones();
            }
        }
    }

    fn add(&mut self, other: Self) {
        self.rows += other.rows;
        self.bits += other.bits;
        let differences = other.comparison.differences;
        self.comparison.differences.extend(differences);
    }

    fn print(&self) {
        println!("{:<18}{:>8}{:>16}", self.function, self.rows, self.bits);
    }
}

/// Every golden row of one family: the planner first, then its evaluations.
fn replay(servo: &Path, family: Family) -> Vec<Parity> {
    let suffixes = family.quantities().iter().map(|quantity| quantity.c);
    let mut parities: Vec<_> = ["gen"]
        .into_iter()
        .chain(suffixes)
        .map(|suffix| Parity::new(format!("a_{}_{suffix}", family.c_name())))
        .collect();
    let (requests, rows) = requests(family);
    let answers = answers(servo, family.name(), &requests);
    assert_eq!(answers.len(), rows.len(), "answers of the servo");
    for (answer, row) in answers.iter().zip(&rows) {
        let Row {
            place,
            golden,
            plans,
        } = row;
        assert_eq!(answer.len(), golden.len(), "{place}: numbers");
        if *plans {
            parities[0].check(place, answer, golden);
        } else {
            let numbers = answer.chunks(1).zip(golden.chunks(1));
            for (parity, (answer, golden)) in parities[1..].iter_mut().zip(numbers) {
                parity.check(place, answer, golden);
            }
        }
    }
    parities
}

/// The golden numbers behind an answer of the servo, where they stand, and whether they are a plan.
struct Row {
    place: String,
    golden: Vec<f64>,
    plans: bool,
}

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
        rows.push(Row {
            place: golden.place.clone(),
            golden: golden
                .duration
                .iter()
                .chain(&golden.fields)
                .copied()
                .collect(),
            plans: true,
        });
        for golden in evaluations.iter().filter(|golden| golden.case == case) {
            writeln!(requests, "at {:e}", golden.x).unwrap();
            rows.push(Row {
                place: golden.place.clone(),
                golden: golden.values.clone(),
                plans: false,
            });
        }
    }
    assert_eq!(rows.len(), moves.len() + evaluations.len());
    (requests, rows)
}

/// The numbers in each line that the servo answers.
fn answers(servo: &Path, name: &str, requests: &str) -> Vec<Vec<f64>> {
    let file = servo.with_file_name(format!("golden-{name}.txt"));
    fs::write(&file, requests).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    let output = Command::new(servo)
        .stdin(File::open(&file).unwrap())
        .stderr(Stdio::inherit())
        .output()
        .unwrap_or_else(|e| panic!("{}: {e}", servo.display()));
    assert!(output.status.success(), "{name}: {}", output.status);
    let text = String::from_utf8(output.stdout).unwrap();
    let numbers = |line: &str| line.split(' ').map(|n| n.parse().unwrap()).collect();
    text.lines().map(numbers).collect()
}
