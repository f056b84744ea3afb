//! What the judge found, counted.

use super::{Planner, Problems, Trial, Verdict};
use crate::liba::Original;
use std::collections::BTreeMap;
use std::fmt::{Display, Formatter, Result as Written};
use std::time::Instant;
use support::{Family, Random};

#[derive(Clone, Debug, Default)]
pub struct Tally {
    name: String,
    pub problems: u64,         // problems
    pub refused: u64,          // plans that are missing
    pub wrong: u64,            // motions that are wrong
    pub longer: u64,           // durations that are longer than the least one
    pub impossible: u64,       // durations that are too short, or in which a target cannot be reached
    pub detours: u64,          // good motions that turn and come again, though a ramp ends within 4 ulps of the target
    pub worst: f64,            // the worst relative error of a duration
    pub examples: Vec<String>, // the first bad problems in words
}

const EXAMPLES: usize = 3; // the bad problems of a kind that are shown

impl Tally {
    pub fn bad(&self) -> u64 {
        self.refused + self.wrong + self.longer + self.impossible
    }

    /// Counts what the judge says of a problem, which `show` puts into words if it is bad.
    pub fn note(&mut self, verdict: &Verdict, show: impl FnOnce() -> String) {
        self.problems += 1;
        match verdict {
            Verdict::Good { error, detour } => {
                self.worst = self.worst.max(*error);
                self.detours += u64::from(*detour);
                return;
            }
            Verdict::Refused(_) => self.refused += 1,
            Verdict::Wrong(_) => self.wrong += 1,
            Verdict::Longer(factor) => {
                self.longer += 1;
                self.worst = self.worst.max(factor - 1.0);
            }
            Verdict::Shorter(factor) => {
                self.impossible += 1;
                self.worst = self.worst.max(factor - 1.0);
            }
            Verdict::Impossible => self.impossible += 1,
        }
        if self.examples.len() < EXAMPLES {
            self.examples.push(format!("{verdict:?}: {}", show()));
        }
    }

    fn add(&mut self, other: &Self) {
        self.problems += other.problems;
        self.refused += other.refused;
        self.wrong += other.wrong;
        self.longer += other.longer;
        self.impossible += other.impossible;
        self.detours += other.detours;
        self.worst = self.worst.max(other.worst);
        self.examples.extend(other.examples.iter().cloned());
        self.examples.truncate(EXAMPLES);
    }
}

/// Problems of profiles that a seed stands for in long runs: a third each of double-S, trapezoids and moves.
pub const PROFILES_PER_SEED: usize = 1_000_000;
/// Problems of moves from any state to any state that a seed stands for in long runs.
pub const MOVES_PER_SEED: usize = 250_000;

#[derive(Clone, Debug, Default)]
pub struct Tallies {
    of: BTreeMap<[usize; 2], Tally>,
}

impl Tallies {
    pub fn of_seed<R: Original>(
        planner: &impl Planner<R>, sequence: fn(u64) -> Problems<R>, seed: u64, problems: usize,
    ) -> Self {
        let mut tallies = Self::default();
        let mut random = Random::seeded(!seed);
        for problem in sequence(seed).take(problems) {
            let profile = problem.request.profile();
            let group = profile.map_or("move", Family::name);
            let key = [profile.map_or(2, |family| family as usize), problem.kind as usize];
            let tally = tallies.row(key, || format!("{group} {:?}", problem.kind));
            let trial = Trial::new(problem);
            let verdict = trial.judge(planner, &mut random);
            tally.note(&verdict, || trial.simple_example(planner, &verdict));
        }
        tallies
    }

    /// Counts `problems` of each of these seeds, prints what was found, and asserts that nothing is bad.
    pub fn assert_good(real: &str, seeds: u64, problems: usize, of_seed: impl Fn(u64, usize) -> Self) {
        let start = Instant::now();
        let mut tallies = Self::default();
        (0..seeds).for_each(|seed| tallies.add(&of_seed(seed, problems)));
        println!("{real}: seeds 0..{seeds}, {:.0} s\n{tallies}", start.elapsed().as_secs_f64());
        let total = tallies.total();
        assert_eq!((total.problems, total.bad()), (seeds * problems as u64, 0), "see the examples above");
    }

    pub fn row(&mut self, key: [usize; 2], name: impl FnOnce() -> String) -> &mut Tally {
        self.of.entry(key).or_insert_with(|| Tally { name: name(), ..Tally::default() })
    }

    pub fn add(&mut self, other: &Self) {
        for (key, tally) in &other.of {
            self.row(*key, || tally.name.clone()).add(tally);
        }
    }

    pub fn total(&self) -> Tally {
        sum(self.of.values())
    }

    /// The sum over the kinds of this group: 0 for double-S, 1 for trapezoids, 2 for moves.
    pub fn total_of(&self, group: usize) -> Tally {
        sum(self.of.range([group, 0]..[group + 1, 0]).map(|(_, tally)| tally))
    }
}

fn sum<'a>(tallies: impl Iterator<Item = &'a Tally>) -> Tally {
    let mut total = Tally { name: "total".into(), ..Tally::default() };
    tallies.for_each(|tally| total.add(tally));
    total
}

impl Display for Tallies {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        writeln!(
            f,
            "{:<26} {:>9} {:>7} {:>7} {:>7} {:>10} {:>7} {:>8}",
            "kind", "problems", "refused", "wrong", "longer", "impossible", "detours", "worst"
        )?;
        for tally in self.of.values().chain([&self.total()]) {
            let Tally { name, problems, refused, wrong, longer, impossible, detours, worst, .. } = tally;
            writeln!(
                f,
                "{name:<26} {problems:>9} {refused:>7} {wrong:>7} {longer:>7} {impossible:>10} {detours:>7} {worst:>8.1e}"
            )?;
        }
        for example in self.of.values().flat_map(|tally| &tally.examples) {
            writeln!(f, "{example}")?;
        }
        Ok(())
    }
}
