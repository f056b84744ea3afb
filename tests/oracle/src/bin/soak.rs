//! `soak [first seed] [seeds] [calls|plans|moves|replans|axes|paths]`: a million calls per seed and real type against the original, a million
//! motions without acceleration at their ends against the referee, a quarter of a million moves from any state to any state, a thousand
//! moves that are planned anew in every millisecond, ten thousand sets of axes that move together, and a thousand paths through way points.
//! An interrupted run goes on from the seed after the one in its last progress line.

use oracle::judge::axes::together::Together;
use oracle::judge::axes::{self, SETS_PER_SEED};
use oracle::judge::path::problems::Chains;
use oracle::judge::path::{self, Paths};
use oracle::judge::planner::Fastest;
use oracle::judge::problems::Problems;
use oracle::judge::replan::Replans;
use oracle::judge::tally::{MOVES_PER_SEED, PROFILES_PER_SEED, Tallies};
use oracle::liba::abi::Original;
use oracle::liba::comparison::Report;
use oracle::liba::volume::run_seed;
use std::io::{IsTerminal, Write, stderr};
use std::ops::Range;
use std::process::ExitCode;
use std::time::Instant;
use support::{Ours, Random, Real};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |index: usize, default| {
        let argument = arguments.get(index);
        argument.map_or(default, |text| text.parse::<u64>().expect("a number"))
    };
    let first = number(0, 0);
    let seeds = first..first + number(1, 1000);
    let soaks = [
        (
            "calls",
            soak_calls::<f64> as Soak,
            soak_calls::<f32> as Soak,
        ),
        ("plans", soak_plans::<f64>, soak_plans::<f32>),
        ("moves", soak_moves::<f64>, soak_moves::<f32>),
        ("replans", soak_replans::<f64>, soak_replans::<f32>),
        ("axes", soak_axes::<f64>, soak_axes::<f32>),
        ("paths", soak_paths::<f64>, soak_paths::<f32>),
    ];
    let mut clean = true;
    for (what, of_f64, of_f32) in soaks {
        if arguments.get(2).is_none_or(|only| only == what) {
            clean &= of_f64(seeds.clone());
            clean &= of_f32(seeds.clone());
        }
    }
    ExitCode::from(u8::from(!clean))
}

/// Whether nothing bad was found.
type Soak = fn(Range<u64>) -> bool;

fn soak_calls<R: Original>(seeds: Range<u64>) -> bool {
    let start = Instant::now();
    let mut total = Report::default();
    for seed in seeds.clone() {
        total.add(run_seed::<R>(&Ours, &R::ORIGINAL, seed));
        let done = format!("calls, {} differing", total.differing);
        progress::<R>(seed, total.calls, &done, start);
    }
    println!("{}", heading::<R>("calls", seeds, start));
    println!("{total}");
    for example in total.examples.iter().take(10) {
        println!("{example}");
    }
    total.values > 0 && total.differing == 0
}

fn soak_plans<R: Original>(seeds: Range<u64>) -> bool {
    soak_tallies::<R>("plans", seeds, |seed| {
        Tallies::of_seed::<R>(&Fastest, Problems::of_profiles, seed, PROFILES_PER_SEED)
    })
}

fn soak_moves<R: Original>(seeds: Range<u64>) -> bool {
    soak_tallies::<R>("moves", seeds, |seed| {
        Tallies::of_seed::<R>(&Fastest, Problems::new, seed, MOVES_PER_SEED)
    })
}

fn soak_axes<R: Original>(seeds: Range<u64>) -> bool {
    soak_tallies::<R>("sets of axes", seeds, |seed| {
        axes::of_seed::<R>(&Together, seed, SETS_PER_SEED)
    })
}

fn soak_tallies<R: Real>(what: &str, seeds: Range<u64>, of_seed: impl Fn(u64) -> Tallies) -> bool {
    let start = Instant::now();
    let mut tallies = Tallies::default();
    for seed in seeds.clone() {
        tallies.add(&of_seed(seed));
        let total = tallies.total();
        let done = format!("{what}, {} bad", total.bad());
        progress::<R>(seed, total.problems, &done, start);
    }
    println!("{}\n{tallies}", heading::<R>(what, seeds, start));
    let total = tallies.total();
    total.problems > 0 && total.bad() == 0
}

fn soak_replans<R: Real>(seeds: Range<u64>) -> bool {
    let start = Instant::now();
    let mut replans = Replans::default();
    for seed in seeds.clone() {
        replans.add(Replans::of_seed::<R>(seed, 1000));
        let done = format!("plans in motion, {} bad moves", replans.bad);
        progress::<R>(seed, replans.plans, &done, start);
    }
    println!("{}: {replans:#?}", heading::<R>("replans", seeds, start));
    replans.moves > 0 && replans.refused == 0 && !replans.has_too_many_bad()
}

fn soak_paths<R: Original>(seeds: Range<u64>) -> bool {
    let start = Instant::now();
    let (mut paths, mut bad) = (0, 0);
    for seed in seeds.clone() {
        let (mut chains, mut random) = (Chains::new(seed), Random::seeded(seed));
        for k in 0..PATHS_PER_SEED {
            let chain = chains.draw::<R>();
            if let Err(what) = path::judge(&Paths, &chain, &mut random) {
                println!("seed {seed}, path {k}, {:?}: {what}", chain.family);
                bad += 1;
            }
            paths += 1;
        }
        progress::<R>(seed, paths, &format!("paths, {bad} bad"), start);
    }
    println!(
        "{}: {bad} of {paths} are bad",
        heading::<R>("paths", seeds, start)
    );
    paths > 0 && bad == 0
}

const PATHS_PER_SEED: u64 = 1000;

fn heading<R: Real>(what: &str, seeds: Range<u64>, start: Instant) -> String {
    let seconds = start.elapsed().as_secs_f64();
    format!("{}: {what} of seeds {seeds:?}, {seconds:.0} s", R::NAME)
}

/// Prints how far the run is: on a terminal after each seed, else after a hundred.
fn progress<R: Real>(seed: u64, count: u64, done: &str, start: Instant) {
    let end = if stderr().is_terminal() { "\r" } else { "\n" };
    if stderr().is_terminal() || seed % 100 == 99 {
        let rate = count as f64 / start.elapsed().as_secs_f64();
        eprint!(
            "{}: seed {seed} done, {} thousand {done}, {rate:.0} a second{end}",
            R::NAME,
            count / 1000
        );
        let _ = stderr().flush();
    }
}
