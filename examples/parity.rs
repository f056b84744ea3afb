//! Does a C program that links the archive compute the golden data bit for bit? `parity SERVO` replays every golden row of
//! the double-S, the trapezoid and the septic polynomial through the program built from `servo.c` and prints a table.

use std::env;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};

#[path = "../tests/common/mod.rs"]
mod common;
use common::{Comparison, GoldenReal, Row, golden};

/// A planner of the servo program and the shape of its golden files.
struct Profile {
    name: &'static str,
    words: usize,
    arguments: usize,
    results: usize,
    evaluations: &'static [&'static str],
}

const PROFILES: [Profile; 3] = [
    Profile {
        name: "bell",
        words: 2,
        arguments: 7,
        results: 1 + 14,
        evaluations: &["pos", "vel", "acc", "jer"],
    },
    Profile {
        name: "trap",
        words: 2,
        arguments: 7,
        results: 1 + 12,
        evaluations: &["pos", "vel", "acc"],
    },
    Profile {
        name: "poly7",
        words: 1,
        arguments: 9,
        results: 8 + 7 + 6 + 5,
        evaluations: &["pos", "vel", "acc", "jer"],
    },
];

fn main() -> ExitCode {
    let servo = env::args_os().nth(1).expect("usage: parity SERVO");
    println!("{:<18}{:>8}{:>16}", "function", "rows", "differing bits");
    let mut total = Parity::new("total".into());
    for profile in &PROFILES {
        for parity in replay(Path::new(&servo), profile) {
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

    /// Compares the servo's answer with one golden row.
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

/// Every golden row of one profile: the planner first, then its evaluations.
fn replay(servo: &Path, profile: &Profile) -> Vec<Parity> {
    let name = profile.name;
    let plans = golden::<f64>(
        &format!("{name}_gen"),
        profile.words,
        profile.arguments + profile.results,
    );
    let points = golden::<f64>(&format!("{name}_eval"), 1, 1 + profile.evaluations.len());

    let mut parities: Vec<_> = ["gen"]
        .iter()
        .chain(profile.evaluations)
        .map(|suffix| Parity::new(format!("a_traj{name}_{suffix}")))
        .collect();
    let (requests, asked) = requests(profile, &plans, &points);
    let answers = answers(servo, name, &requests);
    assert_eq!(answers.len(), asked.len(), "{name}: answers of the servo");
    for ((word, answer), row) in answers.iter().zip(asked) {
        if word == "plan" {
            parities[0].check(&row.place, answer, &row.values[profile.arguments..]);
        } else {
            for (i, parity) in parities[1..].iter_mut().enumerate() {
                parity.check(
                    &row.place,
                    &answer[i + 1..=i + 1],
                    &row.values[i + 1..=i + 1],
                );
            }
        }
    }
    parities
}

/// The requests for the servo, and the golden row behind each answer.
fn requests<'a>(
    profile: &Profile,
    plans: &'a [Row<f64>],
    points: &'a [Row<f64>],
) -> (String, Vec<&'a Row<f64>>) {
    let mut requests = String::new();
    let mut asked = Vec::new();
    for plan in plans {
        requests += profile.name;
        for argument in &plan.values[..profile.arguments] {
            write!(requests, " {argument:e}").unwrap();
        }
        requests.push('\n');
        asked.push(plan);
        for point in points.iter().filter(|point| point.case == plan.case) {
            writeln!(requests, "at {:e}", point.values[0]).unwrap();
            asked.push(point);
        }
    }
    assert_eq!(asked.len(), plans.len() + points.len());
    (requests, asked)
}

/// The servo's answers: the first word of each `plan` and `at` line, and its numbers.
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
