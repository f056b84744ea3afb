//! `soak [first seed] [seeds] [calls|plans|moves|replans|axes]`: a million calls per seed and real type against the original, a million
//! plans of the least time against the referee, a quarter of a million moves from any state to any state, a thousand moves that are planned
//! anew in every millisecond, and ten thousand sets of axes that move together. An interrupted run goes on from the seed after the one in
//! its last progress line.

use oracle::abi::Original;
use oracle::comparison::Report;
use oracle::judge::{Fastest, PROBLEMS_PER_SEED, Tallies};
use oracle::online::axes::judge as axes;
use oracle::online::judge as moves;
use oracle::online::replan::Replans;
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
        clean &= soak_plans::<f32>(seeds.clone());
    }
    if wanted("moves") {
        clean &= soak_moves::<f64>(seeds.clone());
        clean &= soak_moves::<f32>(seeds.clone());
    }
    if wanted("replans") {
        clean &= soak_replans::<f64>(seeds.clone());
        clean &= soak_replans::<f32>(seeds.clone());
    }
    if wanted("axes") {
        clean &= soak_axes::<f64>(seeds.clone());
        clean &= soak_axes::<f32>(seeds);
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

fn soak_moves<R: Real>(seeds: Range<u64>) -> bool {
    let start = Instant::now();
    let mut tallies = moves::Tallies::default();
    for seed in seeds.clone() {
        let problems = moves::PROBLEMS_PER_SEED;
        tallies.add(moves::Tallies::of_seed::<R>(
            &moves::Fastest,
            seed,
            problems,
        ));
        let total = tallies.total();
        let done = format!("moves, {} bad", total.bad());
        progress::<R>(seed, total.moves, &done, start);
    }
    println!(
        "{}: moves of seeds {seeds:?}, {:.0} s\n{tallies}",
        R::NAME,
        start.elapsed().as_secs_f64()
    );
    let total = tallies.total();
    total.moves > 0 && total.bad() == 0
}

fn soak_replans<R: Real>(seeds: Range<u64>) -> bool {
    let start = Instant::now();
    let mut replans = Replans::default();
    for seed in seeds.clone() {
        replans.add(Replans::of_seed::<R>(seed, 1000));
        let done = format!("plans in motion, {} bad moves", replans.bad);
        progress::<R>(seed, replans.plans, &done, start);
    }
    println!(
        "{}: replans of seeds {seeds:?}, {:.0} s: {replans:#?}",
        R::NAME,
        start.elapsed().as_secs_f64()
    );
    replans.moves > 0 && replans.refused == 0 && !replans.has_too_many_bad()
}

fn soak_axes<R: Real>(seeds: Range<u64>) -> bool {
    let start = Instant::now();
    let mut tallies = axes::Tallies::default();
    for seed in seeds.clone() {
        let sets = axes::SETS_PER_SEED;
        tallies.add(axes::Tallies::of_seed::<R>(&axes::Together, seed, sets));
        let total = tallies.total();
        let done = format!("sets of axes, {} bad", total.bad());
        progress::<R>(seed, total.sets, &done, start);
    }
    println!(
        "{}: axes of seeds {seeds:?}, {:.0} s\n{tallies}",
        R::NAME,
        start.elapsed().as_secs_f64()
    );
    let total = tallies.total();
    total.sets > 0 && total.bad() == 0
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
