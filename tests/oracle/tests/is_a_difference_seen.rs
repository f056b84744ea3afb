//! Does the comparison see a difference, and does it compare two libraries?

use oracle::liba::faults::Fault;
use oracle::liba::{OURS, Original, Report, run_seed};
use std::collections::HashSet;
use support::test_both_reals;

#[test]
fn three_libraries_are_linked() {
    let (theirs, floats) = (<f64 as Original>::ORIGINAL, <f32 as Original>::ORIGINAL);
    let addresses = [
        [theirs.bell as usize, floats.bell as usize, OURS.bell as usize],
        [theirs.trap as usize, floats.trap as usize, OURS.trap as usize],
        [theirs.poly7 as usize, floats.poly7 as usize, OURS.poly7 as usize],
    ]
    .concat();
    assert_eq!(addresses.iter().collect::<HashSet<_>>().len(), addresses.len());
}

/// `do_random_moves_agree` asks whether nothing differs without a fault.
fn every_fault_is_caught<R: Original>() {
    for fault in Fault::ALL {
        let report = run_seed::<R>(&fault, &R::ORIGINAL, 0);
        assert!(report.differing > 0, "{fault:?} in {} went unseen", R::NAME);
        assert!(!report.examples.is_empty());
    }
}

#[test]
#[should_panic(expected = "nothing was compared")]
fn an_empty_run_is_no_proof() {
    Report::default().assert_same();
}

test_both_reals!(every_fault_is_caught);
