//! Does an axis that waits for slower ones move slowly, instead of moving fast and standing still? `tests/oracle` judges all else.

use atraj::State;
use atraj::axes::synchronise;
use atraj::online::{Limits, Move};
use support::{Random, Real, online, test_both_reals};

const SETS: usize = 20_000;
const MOST_AXES: usize = 6;

/// From rest to rest, with equal jerks, an axis is no faster than twice its mean velocity.
fn from_rest_to_rest<R: Real>() {
    let mut random = Random::seeded(7);
    for _ in 0..SETS {
        let count = 1 + random.below(MOST_AXES);
        let limits: Vec<_> = (0..count)
            .map(|_| {
                let limits = online::limits::<R>(&mut random);
                let jmin = -limits.jmax;
                Limits { jmin, ..limits }
            })
            .collect();
        let mut ends = || State::at(R::of(random.sign() * random.magnitude(-2.0, 1.5)));
        let from: Vec<_> = (0..count).map(|_| ends()).collect();
        let to: Vec<_> = (0..count).map(|_| ends()).collect();
        let duration = R::of(random.pick(&[0.0, 0.01, 1.0, 100.0]));
        let mut axes = vec![Move::default(); count];
        let planned = synchronise(&mut axes, &limits, &from, &to, duration, R::of(0.0));
        assert!(planned.is_ok(), "{planned:?}: {limits:?} {from:?} {to:?}");
        for ((axis, from), to) in axes.iter().zip(&from).zip(&to) {
            let distance = (to.position.widen() - from.position.widen()).abs();
            let reached = axis.extremes();
            let fastest = f64::max(
                reached.highest.velocity.widen(),
                -reached.lowest.velocity.widen(),
            );
            let rounding = 1.0 + 64.0 * R::MACHINE_EPSILON.widen();
            let covered = axis.t.widen() * fastest;
            assert!(
                covered <= 2.0 * distance * rounding,
                "{axis:?} to {to:?} within {limits:?}"
            );
        }
    }
}

test_both_reals!(from_rest_to_rest);
