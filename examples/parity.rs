//! Is what a C program computes through the archive bit for bit the golden data? `parity SERVO` replays every golden row
//! of the double-S, the trapezoid and the septic polynomial through the program made of `servo.c` and prints a table.

use std::env;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};
use support::golden::{self, Evaluation, Move};
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
        assert_eq!(answer.len(), golden.len(), "{place}: numbers in the answer");
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
        self.comparison.compared += other.comparison.compared;
        self.comparison
            .differences
            .extend(other.comparison.differences);
    }

    fn print(&self) {
        println!("{:<18}{:>8}{:>16}", self.function, self.rows, self.bits);
    }
}

/// Every golden row of one family: the planner first, then its evaluations.
fn replay(servo: &Path, family: Family) -> Vec<Parity> {
    let (name, c_name) = (family.name(), family.c_name());
    let mut parities: Vec<_> = ["gen"]
        .into_iter()
        .chain(family.quantities().iter().map(|quantity| quantity.c))
        .map(|suffix| Parity::new(format!("a_{c_name}_{suffix}")))
        .collect();
    let (requests, expected) = requests(family);
    let answers = answers(servo, name, &requests);
    assert_eq!(
        answers.len(),
        expected.len(),
        "{name}: answers of the servo"
    );
    for ((word, answer), Expected { place, golden }) in answers.iter().zip(&expected) {
        if word == "plan" {
            parities[0].check(place, answer, golden);
        } else {
            // The answer begins with the time.
            assert_eq!(
                answer.len(),
                1 + golden.len(),
                "{place}: numbers in the answer"
            );
            for (i, parity) in parities[1..].iter_mut().enumerate() {
                parity.check(place, &answer[i + 1..=i + 1], &golden[i..=i]);
            }
        }
    }
    parities
}

/// The golden numbers behind an answer of the servo, and where they stand.
struct Expected {
    place: String,
    golden: Vec<f64>,
}

/// The file the servo reads, and what it must answer.
fn requests(family: Family) -> (String, Vec<Expected>) {
    let moves: Vec<Move<f64>> = golden::moves(family);
    let evaluations: Vec<Evaluation<f64>> = golden::evaluations(family);
    let mut requests = String::new();
    let mut expected = Vec::new();
    for (case, golden) in moves.iter().enumerate() {
        requests += family.name();
        for argument in &golden.arguments {
            write!(requests, " {argument:e}").unwrap();
        }
        requests.push('\n');
        expected.push(Expected {
            place: golden.place.clone(),
            golden: golden
                .duration
                .into_iter()
                .chain(golden.fields.clone())
                .collect(),
        });
        for golden in evaluations.iter().filter(|golden| golden.case == case) {
            writeln!(requests, "at {:e}", golden.x).unwrap();
            expected.push(Expected {
                place: golden.place.clone(),
                golden: golden.values.clone(),
            });
        }
    }
    assert_eq!(expected.len(), moves.len() + evaluations.len());
    (requests, expected)
}

/// What the servo answers: the word of each `plan` and `at` line and its numbers.
fn answers(servo: &Path, name: &str, requests: &str) -> Vec<(String, Vec<f64>)> {
    let file = servo.with_file_name(format!("golden-{name}.txt"));
    fs::write(&file, requests).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    let output = Command::new(servo)
        .arg(&file)
        .stderr(Stdio::inherit())
        .output()
        .unwrap_or_else(|e| panic!("{}: {e}", servo.display()));
    assert!(output.status.success(), "{name}: {}", output.status);
    String::from_utf8(output.stdout)
        .unwrap()
        .lines()
        .filter_map(|line| line.split_once(' '))
        .filter(|(word, _)| ["plan", "at"].contains(word))
        .map(|(word, numbers)| {
            let numbers = numbers.split(' ').map(|n| n.parse().unwrap());
            (word.to_owned(), numbers.collect())
        })
        .collect()
}
