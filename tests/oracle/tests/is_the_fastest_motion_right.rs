//! Is the fastest motion right: never refused, never wrong, never longer than the reference solver's? Per real type four million double-S,
//! trapezoids and moves without acceleration at their ends, and a million moves from any state to any state.

use oracle::judge::planner::Fastest;
use oracle::judge::problems::Problems;
use oracle::judge::tally::{MOVES_PER_SEED, PROFILES_PER_SEED, Tallies};
use oracle::liba::abi::Original;
use std::time::Instant;
use support::test_both_reals;

const SEEDS: u64 = if support::BRIEF { 1 } else { 4 };

fn right<R: Original>(sequence: fn(u64) -> Problems<R>, problems: usize) {
    let start = Instant::now();
    let mut tallies = Tallies::default();
    for seed in 0..SEEDS {
        tallies.add(&Tallies::of_seed(&Fastest, sequence, seed, problems));
    }
    let seconds = start.elapsed().as_secs_f64();
    println!("{}: seeds 0..{SEEDS}, {seconds:.0} s\n{tallies}", R::NAME);
    let total = tallies.total();
    assert_eq!(total.problems, SEEDS * problems as u64);
    assert_eq!(total.bad(), 0, "see the examples above");
}

fn profiles<R: Original>() {
    right::<R>(Problems::of_profiles, PROFILES_PER_SEED);
}

fn moves<R: Original>() {
    right::<R>(Problems::new, MOVES_PER_SEED);
}

test_both_reals!(profiles, moves);
