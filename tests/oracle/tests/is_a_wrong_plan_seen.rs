//! Does the judge of the fastest plans see a wrong plan?

use oracle::abi::Original;
use oracle::faults::PlanFault;
use oracle::judge::{Fastest, Tallies, Tally};

const PROBLEMS: usize = 20_000;

fn judged<R: Original>(fault: PlanFault) -> Tally {
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

fn every_fault_is_seen<R: Original>() {
    for fault in PlanFault::ALL {
        let tally = judged::<R>(fault);
        let seen = match fault {
            PlanFault::Refuses => tally.refused,
            PlanFault::Lengthened => tally.longer,
            PlanFault::Shortened => tally.shorter,
            _ => tally.wrong,
        };
        // Many moves have nothing for a fault to spoil: they last no time, or reach no limit.
        let few = match fault {
            PlanFault::Refuses | PlanFault::AboveTheLimit => 50,
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
