//! Is the fastest motion right: never refused, never wrong, never longer than the reference solver's? Per real type two million double-S,
//! trapezoids and moves without acceleration at their ends, and half a million moves from any state to any state.

use oracle::judge::{Fastest, MOVES_PER_SEED, PROFILES_PER_SEED, Problems, Tallies};
use oracle::liba::Original;
use support::test_both_reals;

const SEEDS: u64 = if support::BRIEF { 1 } else { 2 };

fn right<R: Original>(sequence: fn(u64) -> Problems<R>, problems: usize) {
    Tallies::assert_good(R::NAME, SEEDS, problems, |seed, count| Tallies::of_seed(&Fastest, sequence, seed, count));
}

fn profiles<R: Original>() {
    right::<R>(Problems::of_profiles, PROFILES_PER_SEED);
}

fn moves<R: Original>() {
    right::<R>(Problems::new, MOVES_PER_SEED);
}

test_both_reals!(profiles, moves);
