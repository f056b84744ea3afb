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
    let start = Instant::now();
    for seed in first..first + seeds {
        soaks.iter_mut().for_each(|soak| soak.run(seed));
        let [count, faults] = [0, 1].map(|k| soaks.iter().map(|soak| soak.found()[k]).sum::<u64>());
        let an_hour = count as f64 / start.elapsed().as_secs_f64() * 3600.0;
        let row = format!("{what},{first}..{},{count},{faults},{an_hour:.0}\n", seed + 1);
        fs::write(file, &row).expect("a file to write to");
        eprint!("{row}");
    }
    for (name, soak) in ["double", "float"].iter().zip(&soaks) {
        println!("{name}: {what} of seeds {first}..{}\n{}", first + seeds, soak.show());
    }
    let is_clean = soaks.iter().map(|soak| soak.found()).all(|[count, faults]| count > 0 && faults == 0);
    ExitCode::from(u8::from(!is_clean))
}

/// One kind of cases in one real type, and what was found in them.
trait Soak {
    fn run(&mut self, seed: u64); // adds the cases of a seed
    fn found(&self) -> [u64; 2]; // the cases so far, and those that are wrong
    fn show(&self) -> String;
}

fn soak<R: Original>(what: &str) -> Box<dyn Soak> {
    let judged = |of_seed| Box::new(Judged { tallies: Tallies::default(), of_seed });
    match what {
        "calls" => {
            Box::new(Calls { report: Report::default(), of_seed: |seed| run_seed::<R>(&Ours, &R::ORIGINAL, seed) })
        }
        "plans" => judged(|seed| Tallies::of_seed::<R>(&Fastest, Problems::of_profiles, seed, PROFILES_PER_SEED)),
        "moves" => judged(|seed| Tallies::of_seed::<R>(&Fastest, Problems::new, seed, MOVES_PER_SEED)),
        "axes" => judged(|seed| axes::of_seed::<R>(&Together, seed, SETS_PER_SEED)),
        "paths" => Box::new(Cases { cases: 0, bad: Vec::new(), of_seed: paths_of_seed::<R> }),
        "programs" => Box::new(Cases { cases: 0, bad: Vec::new(), of_seed: programs_of_seed::<R> }),
        _ => panic!("{what} does not exist: it is calls, plans, moves, axes, paths or programs"),
    }
}

struct Calls {
    report: Report,
    of_seed: fn(u64) -> Report,
}

impl Soak for Calls {
    fn run(&mut self, seed: u64) {
        self.report.add((self.of_seed)(seed));
    }

    fn found(&self) -> [u64; 2] {
        [self.report.calls, self.report.differing]
    }

    fn show(&self) -> String {
        format!("{}\n{}", self.report, self.report.examples[..self.report.examples.len().min(10)].join("\n"))
    }
}

struct Judged {
    tallies: Tallies,
    of_seed: fn(u64) -> Tallies,
}

impl Soak for Judged {
    fn run(&mut self, seed: u64) {
        self.tallies.add(&(self.of_seed)(seed));
    }

    fn found(&self) -> [u64; 2] {
        let total = self.tallies.total();
        [total.problems, total.bad()]
    }

    fn show(&self) -> String {
        self.tallies.to_string()
    }
}

struct Cases {
    cases: u64,
    bad: Vec<String>,
    of_seed: fn(u64) -> Vec<String>,
}

const CASES_PER_SEED: u64 = 1000;

impl Soak for Cases {
    fn run(&mut self, seed: u64) {
        self.bad.extend((self.of_seed)(seed));
        self.cases += CASES_PER_SEED;
    }

    fn found(&self) -> [u64; 2] {
        [self.cases, self.bad.len() as u64]
    }

    fn show(&self) -> String {
        format!("{} of {} are bad\n{}", self.bad.len(), self.cases, self.bad.join("\n"))
    }
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
