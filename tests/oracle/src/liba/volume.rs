//! Many random moves, in portions that belong to a seed.

use super::moves::Moves;
use super::{Case, Report};
use support::{Implementation, Real};

/// Calls of each implementation in the moves of a seed. The last move may add a few.
pub const CALLS_PER_SEED: u64 = 1_000_000;

pub fn run_seed<R: Real>(ours: &impl Implementation<R>, original: &impl Implementation<R>, seed: u64) -> Report {
    run_seed_of(ours, original, seed, |_| true)
}

pub fn run_seed_of<R: Real>(
    ours: &impl Implementation<R>, original: &impl Implementation<R>, seed: u64, wanted: impl Fn(&Case<R>) -> bool,
) -> Report {
    let mut report = Report::default();
    for case in Moves::<R>::new(seed).filter(wanted) {
        report.compare(ours, original, &case);
        if report.calls >= CALLS_PER_SEED {
            break;
        }
    }
    report
}
