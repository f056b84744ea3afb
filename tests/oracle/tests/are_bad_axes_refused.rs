//! Are bad requests for several axes refused, and is nothing written then?

use atraj::Findings;
use atraj::axes::{line, synchronise};
use atraj::online::{Error, Limits, Move, State};
use oracle::online::axes::problems::{Set, Sets};
use support::{Random, Real};

type Plan<R> =
    fn(&mut [Move<R>], &[Limits<R>], &[State<R>], &[State<R>], R, R) -> Result<Findings, Error>;

/// The planner returns this error and writes nothing.
fn refuses<R: Real>(plan: Plan<R>, set: &Set<R>, error: Error) {
    let (limits, from, to) = set.columns();
    let mut written = Move::default();
    let planned = written.plan(
        &Limits::symmetric(R::of(3.0), R::of(2.0), R::of(1.0)),
        State::at(R::of(0.0)),
        State::at(R::of(1.0)),
    );
    assert!(planned.is_ok());
    let mut axes = vec![written; from.len()];
    let returned = plan(&mut axes, &limits, &from, &to, set.duration, set.cycle);
    assert_eq!(returned.err(), Some(error), "{}", set.show());
    assert!(axes.iter().all(|axis| *axis == written), "{}", set.show());
}

fn bad_numbers<R: Real>() {
    let mut random = Random::seeded(1);
    let sets = Sets::<R>::on_lines(1).take(1_000);
    for set in sets {
        let k = random.below(set.axes.len());
        let [nan, infinity, below] = [f64::NAN, f64::INFINITY, -1.0].map(R::of);
        for plan in [synchronise::<R> as Plan<R>, line::<R>] {
            for bad in [nan, infinity, below] {
                refuses(
                    plan,
                    &Set {
                        duration: bad,
                        ..set.clone()
                    },
                    Error::Duration,
                );
                refuses(
                    plan,
                    &Set {
                        cycle: bad,
                        ..set.clone()
                    },
                    Error::Duration,
                );
            }
            let mut changed = set.clone();
            changed.axes[k].from.position = nan;
            refuses(plan, &changed, Error::NotFinite);
            let mut changed = set.clone();
            changed.axes[k].to.velocity = infinity;
            refuses(plan, &changed, Error::NotFinite);
            let mut changed = set.clone();
            changed.axes[k].limits.amax = R::of(0.0);
            refuses(plan, &changed, Error::Limits);
            let mut changed = set.clone();
            let vmax = changed.axes[k].limits.vmax;
            changed.axes[k].to.velocity = vmax + vmax;
            if vmax.widen().is_finite() {
                refuses(plan, &changed, Error::Target);
            }
            refuses(
                plan,
                &Set {
                    axes: Vec::new(),
                    ..set.clone()
                },
                Error::Axes,
            );
        }
    }
}

/// A start that is beside the line by more than 64 roundings.
fn beside_the_line<R: Real>() {
    let mut random = Random::seeded(2);
    for mut set in Sets::<R>::on_lines(2).take(4_000) {
        let k = random.below(set.axes.len());
        let moves = |axis: usize| set.axes[axis].from.position != set.axes[axis].to.position;
        let has_other = (0..set.axes.len()).any(|axis| axis != k && moves(axis));
        if !has_other {
            continue;
        }
        let from = &mut set.axes[k].from;
        let quantity = if random.one_in(2) {
            &mut from.velocity
        } else {
            &mut from.acceleration
        };
        let more = if quantity.widen() == 0.0 { 1.0 } else { 0.0 };
        *quantity = R::of(quantity.widen() * (1.0 + 1e4 * R::MACHINE_EPSILON.widen()) + more);
        refuses(line, &set, Error::Line);
    }
}

/// The second axis is beyond the range of the real type, the first is not.
fn beyond_the_range<R: Real>() {
    let huge = R::of(f64::exp2(0.7 * f64::from(R::EXPONENTS.1)));
    let limits = [Limits::symmetric(R::ONE, R::ONE, R::ONE); 2];
    let (still, fast) = (
        State::at(R::ZERO),
        State {
            velocity: huge,
            ..State::at(R::ZERO)
        },
    );
    let mut axes = [Move::default(); 2];
    let returned = synchronise(
        &mut axes,
        &limits,
        &[still, fast],
        &[State::at(R::ONE); 2],
        R::ZERO,
        R::ZERO,
    );
    assert_eq!(returned.err(), Some(Error::NotFinite));
    assert_eq!(axes, [Move::default(); 2]);
    // What an axis without limits could do in a long time is beyond the range. What it does is not, if it starts at rest.
    let limits = [Limits::symmetric(R::ONE, R::INFINITY, R::INFINITY)];
    let long = R::of(f64::exp2(0.95 * f64::from(R::EXPONENTS.1)));
    let mut axes = [Move::default()];
    let to = [State::at(R::ONE)];
    let moving = State {
        velocity: R::of(f64::exp2(0.1 * f64::from(R::EXPONENTS.1))),
        ..still
    };
    let returned = synchronise(&mut axes, &limits, &[moving], &to, long, R::ZERO);
    assert_eq!(returned.err(), Some(Error::NotFinite));
    assert_eq!(axes, [Move::default()]);
    let returned = synchronise(&mut axes, &limits, &[still], &to, long, R::ZERO);
    assert!(returned.is_ok());
    assert!(axes[0].t == long && axes[0].state_at(long) == to[0]);
}

fn lengths<R: Real>() {
    let limits = [Limits::symmetric(R::ONE, R::ONE, R::ONE); 3];
    let states = [State::at(R::ZERO); 3];
    for plan in [synchronise::<R> as Plan<R>, line::<R>] {
        for [a, l, f, t] in [
            [2, 3, 3, 3],
            [3, 2, 3, 3],
            [3, 3, 2, 3],
            [3, 3, 3, 2],
            [0, 0, 0, 0],
        ] {
            let mut axes = vec![Move::default(); a];
            let returned = plan(
                &mut axes,
                &limits[..l],
                &states[..f],
                &states[..t],
                R::ZERO,
                R::ZERO,
            );
            assert_eq!(returned.err(), Some(Error::Axes));
        }
    }
}

#[test]
fn bad_axes_are_refused() {
    bad_numbers::<f64>();
    bad_numbers::<f32>();
    lengths::<f64>();
    lengths::<f32>();
}

#[test]
fn axes_beside_the_line_are_refused() {
    beside_the_line::<f64>();
    beside_the_line::<f32>();
}

#[test]
fn axes_beyond_the_range_are_refused() {
    beyond_the_range::<f64>();
    beyond_the_range::<f32>();
}
