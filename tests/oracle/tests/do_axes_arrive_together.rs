//! Do several axes arrive together, as early as they can, or stay on a straight line, in 20,000 sets of axes per real type?

use oracle::judge::axes::faults::Fault;
use oracle::judge::axes::of_seed;
use oracle::judge::axes::together::Together;
use oracle::judge::tally::Tallies;
use oracle::liba::abi::Original;
use std::time::Instant;

const SEEDS: u64 = 4;
const SETS: usize = 5_000;

fn axes_arrive_together<R: Original>() {
    let start = Instant::now();
    let mut tallies = Tallies::default();
    for seed in 0..SEEDS {
        tallies.add(&of_seed::<R>(&Together, seed, SETS));
    }
    let seconds = start.elapsed().as_secs_f64();
    println!("{}: seeds 0..{SEEDS}, {seconds:.0} s\n{tallies}", R::NAME);
    let total = tallies.total();
    assert_eq!(total.problems, SEEDS * SETS as u64);
    assert_eq!(total.bad(), 0, "see the examples above");
}

#[test]
fn f64() {
    axes_arrive_together::<f64>();
}

#[test]
fn f32() {
    axes_arrive_together::<f32>();
}

fn every_fault_is_seen<R: Original>() {
    for fault in Fault::ALL {
        let tally = of_seed::<R>(&fault, 0, 1_000).total();
        let (bad, sets) = (tally.bad(), tally.problems);
        println!("{} {fault:?}: {bad} of {sets} sets seen", R::NAME);
        // Few sets have an axis that waits.
        let few = if matches!(fault, Fault::Waits) {
            50
        } else {
            20
        };
        assert!(bad * few >= sets, "{fault:?} in {}", R::NAME);
    }
}

#[test]
fn every_fault_is_seen_f64() {
    every_fault_is_seen::<f64>();
}

#[test]
fn every_fault_is_seen_f32() {
    every_fault_is_seen::<f32>();
}
