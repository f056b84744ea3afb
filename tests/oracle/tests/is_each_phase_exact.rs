//! In exact arithmetic: does each motion begin at its start, end at its target, keep the limits and go as far as its time allows? Two thousand
//! of every function that plans, in each real type; `cargo run -p measure --bin exact` asks a million.

use oracle::judge::Request;
use oracle::judge::exact::Row;
use oracle::judge::faults::Fault;
use oracle::liba::Original;
use support::test_both_reals;

const MOTIONS: usize = 2_000;

fn each_motion_is_exact<R: Original>() {
    for row in Row::of_every_kind::<R>(MOTIONS) {
        println!("{row}");
        assert!(row.is_clean(), "{row:?}");
    }
}

fn every_fault_is_seen<R: Original>() {
    use Fault::{AbsoluteTime, Direction, DroppedPhase, Refuses, SilentEnd, SilentStart};
    let changes_no_motion = [AbsoluteTime, Direction, DroppedPhase, Refuses, SilentEnd, SilentStart];
    for fault in Fault::ALL.into_iter().filter(|fault| !changes_no_motion.contains(fault)) {
        let row = Row::of_request::<R>(&fault, Request::Plan, 500);
        assert!(!row.is_clean(), "{fault:?}: {row:?}");
    }
}

test_both_reals!(each_motion_is_exact, every_fault_is_seen);
