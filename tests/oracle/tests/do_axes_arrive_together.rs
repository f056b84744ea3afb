//! Do several axes arrive together, as early as they can, or stay on a straight line, in 20,000 sets of axes per real type?

use oracle::online::axes::faults::Fault;
use oracle::online::axes::judge::{Tallies, Together};
use std::time::Instant;
use support::Real;

const SEEDS: u64 = 4;
const SETS: usize = 5_000;

fn axes_arrive_together<R: Real>() {
    let start = Instant::now();
    let mut tallies = Tallies::default();
    for seed in 0..SEEDS {
        tallies.add(Tallies::of_seed::<R>(&Together, seed, SETS));
    }
    let seconds = start.elapsed().as_secs_f64();
    println!("{}: seeds 0..{SEEDS}, {seconds:.0} s\n{tallies}", R::NAME);
    let total = tallies.total();
    assert_eq!(total.sets, SEEDS * SETS as u64);
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

fn every_fault_is_seen<R: Real>() {
    for fault in Fault::ALL {
        let tally = Tallies::of_seed::<R>(&fault, 0, 1_000).total();
        println!(
            "{} {fault:?}: {} refused, {} wrong, {} longer, {} impossible of {} sets",
            R::NAME,
            tally.refused,
            tally.wrong,
            tally.longer,
            tally.impossible,
            tally.sets
        );
        // Few sets have an axis that waits.
        let few = if matches!(fault, Fault::Waits) {
            50
        } else {
            20
        };
        assert!(tally.bad() * few >= tally.sets, "{fault:?} in {}", R::NAME);
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
