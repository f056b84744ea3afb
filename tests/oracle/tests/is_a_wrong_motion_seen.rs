//! Does the judge see a wrong motion of each planner: a double-S, a trapezoid, a move?

use oracle::judge::faults::Fault;
use oracle::judge::{Problems, Request, Tallies, Tally};
use oracle::liba::Original;
use support::test_both_reals;

const OF_PROFILES: usize = 7_500;
const OF_MOVES: usize = 4_400;

fn seen(fault: Fault, tally: &Tally) -> u64 {
    match fault {
        Fault::Refuses => tally.refused,
        Fault::Lengthened | Fault::Detour => tally.longer,
        // The motion is wrong, or faster than a motion within the limits.
        Fault::VelocityAboveTheLimit | Fault::AccelerationAboveTheLimit | Fault::JerkAboveTheLimit => {
            tally.wrong + tally.impossible
        }
        _ => tally.wrong,
    }
}

/// `is_the_fastest_motion_right` asks whether nothing is wrong without a fault, in these problems and more.
fn every_fault_is_seen<R: Original>() {
    for fault in Fault::ALL {
        let profiles = Tallies::of_seed::<R>(&fault, Problems::of_profiles, 0, OF_PROFILES);
        let moves = Tallies::of_seed::<R>(&fault, Problems::new, 0, OF_MOVES);
        let [bells, traps] = [profiles.total_of(0), profiles.total_of(1)];
        let requests = [Request::Bell, Request::Trap, Request::Plan];
        for (request, tally) in requests.into_iter().zip([bells, traps, moves.total()]) {
            if !fault.is_possible_in(request) {
                continue;
            }
            let (seen, all) = (seen(fault, &tally), tally.problems);
            // Many motions have nothing for a fault to spoil: they reach no limit, start inside, take no time or a long one.
            let few = match fault {
                Fault::Refuses if request.profile().is_some() => 50,
                Fault::Refuses | Fault::SilentStart | Fault::AbsoluteTime => 10,
                Fault::VelocityAboveTheLimit | Fault::AccelerationAboveTheLimit => 10,
                Fault::SilentEnd => 100,
                _ => 4,
            };
            assert!(seen * few >= all, "{fault:?} of {request:?} in {}: {seen} of {all} seen", R::NAME);
            assert!(!tally.examples.is_empty());
        }
    }
}

test_both_reals!(every_fault_is_seen);
