//! Do the Rust API and the original agree in fifty million random calls per real type?

use oracle::liba::{Original, Report, run_seed};
use support::{Ours, test_both_reals};

fn fifty_million_calls<R: Original>() {
    let seeds = 0..50;
    let mut total = Report::default();
    for seed in seeds.clone() {
        total.add(run_seed::<R>(&Ours, &R::ORIGINAL, seed));
    }
    println!("{}: seeds {seeds:?}: {total}", R::NAME);
    total.assert_same();
    assert!(total.calls >= 50_000_000);
    assert!(total.endless > 0, "no infinite acceleration among the moves");
    assert_eq!(total.most_rounds, R::MOST_ROUNDS, "rounds of the longest search");
}

test_both_reals!(fifty_million_calls);
