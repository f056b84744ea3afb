//! Many random moves, in portions that belong to a seed.

use crate::comparison::Report;
use crate::family::Implementation;
use crate::moves::Moves;
use crate::real::OracleReal;

/// Calls of each implementation that a seed stands for; a few more where the last move goes beyond.
pub const CALLS_PER_SEED: u64 = 1_000_000;

/// All moves of one seed through both.
pub fn run_seed<R: OracleReal>(
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
