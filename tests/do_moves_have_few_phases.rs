//! Do moves have few phases, and none that is shorter than a few ulps of the duration? How many axes that arrive together need the mean of
//! two motions, which has more phases?

use support::online::state_of;
use support::prelude::*;

const SETS: u32 = 20_000;
const AXES: usize = 3;

/// The way inside the limits has two phases; a motion on the border, or one that cruises, has seven.
const FEW: usize = 9;

/// At rest, or moving with an acceleration at both ends. The start may be outside the limits.
fn axis<R: Real>(random: &mut Random) -> (Limits<R>, State<R>, State<R>) {
    let [j, a, v] = [(10.0, 50.0), (4.0, 12.0), (2.0, 6.0)].map(|(lo, hi)| random.between(lo, hi));
    let limits = online::symmetric(j, a, v);
    let is_at_rest = random.one_in(4);
    let mut state = |most: f64| {
        let mut part = || {
            if is_at_rest { 0.0 } else { random.between(-most, most) }
        };
        let acceleration = part() * a.min((j * v).sqrt());
        let velocity = part() * (v - acceleration * acceleration / (2.0 * j));
        state_of([random.between(-10.0, 10.0), velocity, acceleration])
    };
    (limits, state(1.2), state(0.9))
}

/// Phase 0 is the start, and lasts no time.
fn phases<R: Real>(planned: &Move<R>) -> usize {
    planned.phases().len() - 1
}

/// Whether a phase is shorter than 4 ulps of the duration.
fn has_sliver<R: Real>(planned: &Move<R>) -> bool {
    let short = 4.0 * R::MACHINE_EPSILON.widen() * planned.t.widen();
    let mut phases = planned.phases().iter().skip(1);
    phases.any(|phase| phase.duration.widen() < short)
}

/// Of 60,000 plans 13 had a sliver, of as many from a state of their own motion 1,809, and of as many axes that arrive together 19.
/// Now 2 of the replans and 2 of the axes have one, in binary32: in so slow a motion its velocity shows.
fn few_and_none_is_a_sliver<R: Real>() {
    const ONE_SLIVER_OF: u32 = 20_000;
    let mut random = Random::seeded(1);
    let (mut axes_by_phases, mut slivers) = ([0_u32; 16], [0_u32; 3]);
    for _ in 0..SETS {
        let axes = [(); AXES].map(|()| axis::<R>(&mut random));
        for (limits, from, to) in axes {
            let planned = online::plan(&limits, from, to);
            assert!(phases(&planned) <= FEW, "{limits:?} {from:?} {to:?}");
            let replanned = online::plan(&limits, planned.state_at(R::of(random.unit()) * planned.t), to);
            slivers[0] += u32::from(has_sliver(&planned));
            slivers[1] += u32::from(has_sliver(&replanned));
        }
        let limits = axes.map(|(limits, ..)| limits);
        let (from, to) = (axes.map(|(_, from, _)| from), axes.map(|(.., to)| to));
        for planned in &online::together(&limits, &from, &to, R::ZERO) {
            axes_by_phases[phases(planned)] += 1;
            slivers[2] += u32::from(has_sliver(planned));
        }
    }
    let means: u32 = axes_by_phases[FEW + 1..].iter().sum();
    let all = SETS * AXES as u32;
    println!("axes by number of phases: {axes_by_phases:?}; {means} of {all} need a mean");
    assert_eq!(axes_by_phases.iter().sum::<u32>(), all);
    // A mean is needed only just above the fastest duration.
    assert!(means > 0 && means * 1000 < all, "{means} of {all}");
    assert!(slivers.iter().all(|count| count * ONE_SLIVER_OF <= all), "{slivers:?} of {all}");
}

test_both_reals!(few_and_none_is_a_sliver);
