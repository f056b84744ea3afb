//! Is the fastest move right: never refused, never wrong, never longer than the referee's, in a million moves per real type?

use oracle::online::judge::{Fastest, PROBLEMS_PER_SEED, Tallies};
use std::time::Instant;
use support::Real;

const SEEDS: u64 = 4;

fn a_million_moves<R: Real>() {
    let start = Instant::now();
    let mut tallies = Tallies::default();
    for seed in 0..SEEDS {
        tallies.add(Tallies::of_seed::<R>(&Fastest, seed, PROBLEMS_PER_SEED));
    }
    let seconds = start.elapsed().as_secs_f64();
    println!("{}: seeds 0..{SEEDS}, {seconds:.0} s\n{tallies}", R::NAME);
    let total = tallies.total();
    assert_eq!(total.moves, SEEDS * PROBLEMS_PER_SEED as u64);
    assert_eq!(total.bad(), 0, "see the examples above");
}

#[test]
fn f64() {
    a_million_moves::<f64>();
}

#[test]
fn f32() {
    a_million_moves::<f32>();
}
