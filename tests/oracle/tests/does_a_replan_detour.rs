//! Does a move that is planned anew in every cycle take longer than it was planned first, or make a step?

use oracle::judge::replan::{Replans, retarget};
use support::Real;

const MOVES: u64 = 4_000;
const TARGETS: u32 = 1_000;

fn replans_take_no_longer<R: Real>() {
    let replans = Replans::of_seed::<R>(0, MOVES);
    println!("{}: {replans:#?}", R::NAME);
    assert_eq!((replans.moves, replans.refused), (MOVES, 0));
    assert!(!replans.has_too_many_bad(), "see the examples above");
}

#[test]
fn replans_take_no_longer_f64() {
    replans_take_no_longer::<f64>();
}

#[test]
fn replans_take_no_longer_f32() {
    replans_take_no_longer::<f32>();
}

#[test]
fn retargets_make_no_step() {
    for seed in 0..10 {
        retarget::<f64>(seed, TARGETS).expect("no step");
        retarget::<f32>(seed, TARGETS).expect("no step");
    }
}
