//! toppra plans in Python, and is asked where it is installed.

use crate::cases::Case;
use crate::copp::is_curve;
use oracle::judge::path::Chain;
use std::io::Write;
use std::process::{Command, Stdio};

pub fn print(case: &Case) {
    if !case.chains.iter().all(is_curve) {
        return;
    }
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/follow.py");
    let mut python = Command::new("python3");
    let python = python.arg(script).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
    let mut python = python.expect("python3");
    let mut input = python.stdin.take().expect("a pipe");
    for chain in &case.chains {
        let _ = writeln!(input, "{}", json(chain)); // the program ends early where toppra is missing
    }
    drop(input);
    let output = python.wait_with_output().expect("an end of python3");
    let answer = String::from_utf8_lossy(&output.stdout);
    let numbers: Vec<f64> = answer.split_whitespace().filter_map(|number| number.parse().ok()).collect();
    match numbers[..] {
        [s, ms] if output.status.success() => case.print_row("toppra on a cubic spline", false, s, ms),
        _ => eprintln!("SKIPPED: no row of toppra for \"{}\": python3 cannot import it, or it failed", case.name),
    }
}

fn json(chain: &Chain<f64>) -> String {
    let points: Vec<Vec<f64>> =
        chain.states.chunks(chain.axes).map(|point| point.iter().map(|state| state.position).collect()).collect();
    let velocity: Vec<_> = chain.limits.iter().map(|limits| [limits.vmin, limits.vmax]).collect();
    let acceleration: Vec<_> = chain.limits.iter().map(|limits| [limits.amin, limits.amax]).collect();
    format!("{{\"points\": {points:?}, \"velocity\": {velocity:?}, \"acceleration\": {acceleration:?}}}")
}
