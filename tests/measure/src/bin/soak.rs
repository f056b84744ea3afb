//! `soak <what> <first seed> <seeds> <file>`: a portion of random cases per seed and real type. `calls`: a million calls against the
//! original. `plans`: a million motions without acceleration at their ends against the reference solver. `moves`: a quarter of a million moves from
//! any state to any state. `axes`: ten thousand sets of axes that move together. `paths`: a thousand paths through waypoints. `programs`: a
//! thousand programs of calls to a group.
//!
//! After each seed the file holds what was done: `what,seeds,count,faults,an hour`. So a run may be stopped at any time.

use oracle::judge::axes::several::Together;
use oracle::judge::axes::{self, SETS_PER_SEED};
use oracle::judge::path::{self, Chains, Paths};
use oracle::judge::{Fastest, MOVES_PER_SEED, PROFILES_PER_SEED, Problems, Tallies, group};
use oracle::liba::{Original, Report, run_seed};
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use std::time::Instant;
use support::{Ours, Random};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [what, first, seeds, file] = &arguments[..] else {
        panic!("soak <what> <first seed> <seeds> <file>");
    };
    let number = |text: &str| text.parse::<u64>().expect("a number");
    let (first, seeds) = (number(first), number(seeds));
    let mut soaks = [soak::<f64>(what), soak::<f32>(what)];
    let mut found = [Found::default(), Found::default()];
    let start = Instant::now();
    for seed in first..first + seeds {
        found = soaks.each_mut().map(|add| add(seed));
        let [count, faults] = [0, 1].map(|k| found.iter().map(|found| found.counts[k]).sum::<u64>());
        let an_hour = count as f64 / start.elapsed().as_secs_f64() * 3600.0;
        let row = format!("{what},{first}..{},{count},{faults},{an_hour:.0}\n", seed + 1);
        fs::write(file, &row).expect("a file to write to");
        eprint!("{row}");
    }
    for (name, found) in ["double", "float"].iter().zip(&found) {
        println!("{name}: {what} of seeds {first}..{}\n{}", first + seeds, found.text);
    }
    let is_clean = found.iter().all(|found| found.counts[0] > 0 && found.counts[1] == 0);
    ExitCode::from(u8::from(!is_clean))
}

#[derive(Default)]
struct Found {
    counts: [u64; 2], // the cases so far, and those that are wrong
    text: String,
}

type Soak = Box<dyn FnMut(u64) -> Found>; // adds the cases of a seed

fn soak<R: Original>(what: &str) -> Soak {
    match what {
        "calls" => calls::<R>(),
        "plans" => judged(|seed| Tallies::of_seed::<R>(&Fastest, Problems::of_profiles, seed, PROFILES_PER_SEED)),
        "moves" => judged(|seed| Tallies::of_seed::<R>(&Fastest, Problems::new, seed, MOVES_PER_SEED)),
        "axes" => judged(|seed| axes::of_seed::<R>(&Together, seed, SETS_PER_SEED)),
        "paths" => cases(paths_of_seed::<R>),
        "programs" => cases(programs_of_seed::<R>),
        _ => panic!("{what} does not exist: it is calls, plans, moves, axes, paths or programs"),
    }
}

fn calls<R: Original>() -> Soak {
    let mut report = Report::default();
    Box::new(move |seed| {
        report.add(run_seed::<R>(&Ours, &R::ORIGINAL, seed));
        let examples = report.examples[..report.examples.len().min(10)].join("\n");
        Found { counts: [report.calls, report.differing], text: format!("{report}\n{examples}") }
    })
}

fn judged(of_seed: fn(u64) -> Tallies) -> Soak {
    let mut tallies = Tallies::default();
    Box::new(move |seed| {
        tallies.add(&of_seed(seed));
        let total = tallies.total();
        Found { counts: [total.problems, total.bad()], text: tallies.to_string() }
    })
}

const CASES_PER_SEED: u64 = 1000;

fn cases(of_seed: fn(u64) -> Vec<String>) -> Soak {
    let (mut cases, mut bad) = (0, Vec::new());
    Box::new(move |seed| {
        bad.extend(of_seed(seed));
        cases += CASES_PER_SEED;
        let text = format!("{} of {cases} are bad\n{}", bad.len(), bad.join("\n"));
        Found { counts: [cases, bad.len() as u64], text }
    })
}

/// What is wrong with the paths through waypoints of a seed.
fn paths_of_seed<R: Original>(seed: u64) -> Vec<String> {
    let (mut chains, mut random) = (Chains::new(seed), Random::seeded(seed));
    let judged = (0..CASES_PER_SEED).filter_map(|k| {
        let chain = chains.draw::<R>();
        let what = path::judge(&Paths, &chain, &mut random).err()?;
        Some(format!("seed {seed}, path {k}, {:?}: {what}", chain.family))
    });
    judged.collect()
}

/// What is wrong with the programs of a seed. Standard error has the message of each.
fn programs_of_seed<R: Original>(seed: u64) -> Vec<String> {
    let mut random = Random::seeded(seed);
    let judged = (0..CASES_PER_SEED).filter_map(|k| {
        let run = AssertUnwindSafe(|| group::program::<R>(&mut random, &mut group::Counts::default()));
        catch_unwind(run).err().map(|_| format!("seed {seed}, program {k}"))
    });
    judged.collect()
}
