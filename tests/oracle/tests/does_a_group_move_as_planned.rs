//! Does a group keep its limits, its line and its path, and do its answers hold, whatever the main loop plans, at whatever tick?

use oracle::judge::group::{CALLS, program};
use support::{Random, Real, test_both_reals};

const PROGRAMS: usize = if support::BRIEF { 200 } else { 4_000 };

fn programs<R: Real>() {
    let mut random = Random::seeded(61);
    let mut refused = [0; 3];
    for _ in 0..PROGRAMS {
        program::<R>(&mut random, &mut refused);
    }
    let [lines, paths, rates] = refused;
    println!(
        "{}: {PROGRAMS} programs of {CALLS} calls; refused: {lines} lines in motion, {paths} paths from elsewhere, {rates} rates",
        R::NAME
    );
}

test_both_reals!(programs);
