//! Many random moves, in portions that belong to a seed.

use crate::comparison::Report;
use crate::moves::Moves;
use support::{Implementation, Real};

/// Calls of each implementation in the moves of a seed. The last move may add a few.
pub const CALLS_PER_SEED: u64 = 1_000_000;

/// All moves of one seed through both.
pub fn run_seed<R: Real>(
    ours: &impl Implementation<R>,
    original: &impl Implementation<R>,
    seed: u64,
) -> Report {
    let mut report = Report::default();
    for case in Moves::<R>::new(seed) {
        report.compare(ours, original, &case);
        if report.calls >= CALLS_PER_SEED {
            break;
        }
    }
    report
}
