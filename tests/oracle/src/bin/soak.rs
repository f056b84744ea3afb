//! `soak [first seed] [seeds] [calls|plans]`: a million calls per seed and real type against the original, and a million plans of
//! the least time against the referee. An interrupted run goes on from the seed after the one in its last progress line.

use oracle::abi::Original;
use oracle::comparison::Report;
use oracle::judge::{Fastest, PROBLEMS_PER_SEED, Tallies};
use oracle::volume::run_seed;
use std::io::{IsTerminal, Write, stderr};
use std::ops::Range;
use std::process::ExitCode;
use std::time::Instant;
use support::{Ours, Real};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |index: usize, default| {
        let argument = arguments.get(index);
        argument.map_or(default, |text| text.parse::<u64>().expect("a number"))
    };
    let first = number(0, 0);
    let seeds = first..first + number(1, 1000);
    let wanted = |what| arguments.get(2).is_none_or(|only| only == what);
    let mut clean = true;
    if wanted("calls") {
        clean &= soak_calls::<f64>(seeds.clone());
        clean &= soak_calls::<f32>(seeds.clone());
    }
    if wanted("plans") {
        clean &= soak_plans::<f64>(seeds.clone());
        clean &= soak_plans::<f32>(seeds);
    }
    ExitCode::from(u8::from(!clean))
}

fn soak_calls<R: Original>(seeds: Range<u64>) -> bool {
    let start = Instant::now();
    let mut total = Report::default();
    for seed in seeds.clone() {
        total.add(run_seed::<R>(&Ours, &R::ORIGINAL, seed));
        let done = format!("calls, {} differing", total.differing);
        progress::<R>(seed, total.calls, &done, start);
    }
    println!(
        "{}: seeds {seeds:?}, {:.0} s: {total}",
        R::NAME,
        start.elapsed().as_secs_f64()
    );
    for example in total.examples.iter().take(10) {
        println!("{example}");
    }
    total.values > 0 && total.differing == 0
}

fn soak_plans<R: Original>(seeds: Range<u64>) -> bool {
    let start = Instant::now();
    let mut tallies = Tallies::default();
    for seed in seeds.clone() {
        tallies.add(Tallies::of_seed::<R>(&Fastest, seed, PROBLEMS_PER_SEED));
        let total = tallies.total();
        let done = format!("plans, {} bad", total.bad());
        progress::<R>(seed, total.moves, &done, start);
    }
    println!(
        "{}: plans of seeds {seeds:?}, {:.0} s\n{tallies}",
        R::NAME,
        start.elapsed().as_secs_f64()
    );
    let total = tallies.total();
    total.moves > 0 && total.bad() == 0
}

/// Prints how far the run is: on a terminal after each seed, else after a hundred.
fn progress<R: Real>(seed: u64, count: u64, done: &str, start: Instant) {
    let end = if stderr().is_terminal() { "\r" } else { "\n" };
    if stderr().is_terminal() || seed % 100 == 99 {
        let million = count as f64 * 1e-6;
        let rate = million / start.elapsed().as_secs_f64();
        eprint!(
            "{}: seed {seed} done, {million:.0} million {done}, {rate:.1} million/s{end}",
            R::NAME
        );
        let _ = stderr().flush();
    }
}
