//! What do the judge of plans and the planner of the fastest moves say of the original's plans for moving ends?

use atraj::{Bell, Boundary, Findings};
use oracle::liba::Original;
use support::profiles::bell;
use support::{Family, Implementation, Random, Real, online, test_both_reals};

const MOVES: u64 = 1_000_000;

#[derive(Debug, Default)]
struct Counts {
    refused: u64,
    too_steep: u64,
    steepest: f64,
    longer: u64,
    longest: f64,
}

fn arguments<R: Real>(random: &mut Random) -> [R; 7] {
    let ranges = [(1.0, 100.0), (1.0, 20.0), (0.5, 10.0), (-10.0, 10.0)];
    let [jm, am, vm, p1] = ranges.map(|(lo, hi)| random.between(lo, hi));
    let [v0, v1] = [(); 2].map(|()| vm * random.between(-1.0, 1.0));
    [jm, am, vm, 0.0, p1, v0, v1].map(R::of)
}

fn count<R: Original>() -> Counts {
    let mut random = Random::seeded(7);
    let mut counts = Counts::default();
    for _ in 0..MOVES {
        let arguments = arguments::<R>(&mut random);
        let [jm, am, vm, p0, p1, v0, v1] = arguments;
        let mut fields = [R::ZERO; 14];
        let fastest = Bell::fastest(jm, am, vm, Boundary { p0, p1, v0, v1 }).expect("numbers");
        assert!(fastest.check(jm, am, vm).expect("numbers").bits() & 15 == 0, "{arguments:?}");
        if R::ORIGINAL.plan(Family::Bell, &arguments, &mut fields) == R::ZERO {
            counts.refused += 1;
            continue;
        }
        let plan = bell(&fields);
        let Ok(found) = plan.check(jm, am, vm) else { continue };
        if found.contains(Findings::EXCEEDS_ACCELERATION) {
            counts.too_steep += 1;
            let [_, _, steepest] = online::largest(plan.extremes());
            counts.steepest = counts.steepest.max(steepest / am.widen());
        } else if found.bits() & 15 == 0 {
            let factor = plan.t.widen() / fastest.t.widen();
            counts.longer += u64::from(factor > 1.001);
            counts.longest = counts.longest.max(factor);
        }
    }
    counts
}

fn the_judge_sees_it<R: Original>() {
    let counts = count::<R>();
    assert!(counts.refused > MOVES / 100, "{counts:?}");
    assert!(counts.too_steep > MOVES / 100 && counts.steepest > 2.0, "{counts:?}");
    assert!(counts.longer > MOVES / 100 && counts.longest > 2.0, "{counts:?}");
}

test_both_reals!(the_judge_sees_it);
