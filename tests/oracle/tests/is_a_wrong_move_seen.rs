//! Does the judge of the moves from any state to any state see a wrong move?

use oracle::online::faults::Fault;
use oracle::online::judge::{Fastest, Tallies, Tally};
use support::Real;

const PROBLEMS: usize = 4_300;

fn judged<R: Real>(fault: Fault) -> Tally {
    let tally = Tallies::of_seed::<R>(&fault, 0, PROBLEMS).total();
    println!(
        "{} {fault:?}: {} refused, {} wrong, {} longer, {} shorter of {} moves",
        R::NAME,
        tally.refused,
        tally.wrong,
        tally.longer,
        tally.shorter,
        tally.moves
    );
    tally
}

fn every_fault_is_seen<R: Real>() {
    for fault in Fault::ALL {
        let tally = judged::<R>(fault);
        let seen = match fault {
            Fault::Refuses => tally.refused,
            Fault::Lengthened | Fault::Detour => tally.longer,
            // The motion is wrong, or faster than a motion within the limits.
            Fault::VelocityAboveTheLimit | Fault::AccelerationAboveTheLimit => {
                tally.wrong + tally.shorter
            }
            _ => tally.wrong,
        };
        // Many moves have nothing for a fault to spoil: they reach no limit, start inside or take long.
        let few = match fault {
            Fault::Refuses | Fault::SilentStart | Fault::AbsoluteTime => 10,
            Fault::VelocityAboveTheLimit | Fault::AccelerationAboveTheLimit => 10,
            _ => 4,
        };
        assert!(seen * few >= tally.moves, "{fault:?} in {}", R::NAME);
        assert!(!tally.examples.is_empty());
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

/// If something were wrong without a fault, a seen fault would prove nothing.
#[test]
fn without_a_fault_nothing_is_wrong() {
    for total in [
        Tallies::of_seed::<f64>(&Fastest, 0, PROBLEMS).total(),
        Tallies::of_seed::<f32>(&Fastest, 0, PROBLEMS).total(),
    ] {
        assert_eq!((total.moves, total.bad()), (PROBLEMS as u64, 0));
    }
}
