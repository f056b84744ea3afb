//! Are requests refused for which there is no move, each with its reason, and is the move left as it was?

use atraj::online::{Error, Limits, Move, State};
use oracle::judge::problem::{Problem, beyond_legal, widened};
use oracle::judge::problems::Problems;
use support::{Random, Real};

const PROBLEMS: usize = 20_000;

/// A target a little more than legal.
fn illegal<R: Real>(problem: &Problem<R>, random: &mut Random) -> Option<State<R>> {
    let [vmax, vmin, amax, amin, jmax, jmin] = widened(&problem.limits);
    let a = random.between(amin.max(-1e6), amax.min(1e6));
    let more = 1.0 + random.magnitude(-4.0, 1.0);
    let (v, a) = match random.below(4) {
        0 => (vmax * more, 0.0),
        1 => (vmin * more, 0.0),
        2 => (0.0, random.pick(&[amax, amin]) * more),
        _ => (
            random.pick(&[vmax + 0.5 * a * a / jmin, vmin + 0.5 * a * a / jmax]) * more,
            a,
        ),
    };
    let to = State {
        position: problem.to.position,
        velocity: R::of(v),
        acceleration: R::of(a),
    };
    let rounding = 64.0 * R::MACHINE_EPSILON.widen() * (v.abs() + vmax.min(-vmin));
    let sure = beyond_legal(&problem.limits, to) > rounding;
    (sure && v.is_finite() && a.is_finite()).then_some(to)
}

fn illegal_targets<R: Real>() {
    let mut random = Random::seeded(3);
    let mut refused = 0;
    for problem in Problems::<R>::new(3).take(PROBLEMS) {
        let Some(to) = illegal(&problem, &mut random) else {
            continue;
        };
        let Problem { limits, from, .. } = problem;
        let mut planned = Move::default();
        let plan = planned.plan(&limits, from, to);
        assert_eq!(
            plan.err(),
            Some(Error::Target),
            "{limits:?} {from:?} {to:?}"
        );
        let reach = planned.reach(&limits, from, to.velocity, to.acceleration);
        assert_eq!(
            reach.err(),
            Some(Error::Target),
            "{limits:?} {from:?} {to:?}"
        );
        assert_eq!(planned, Move::default());
        refused += 1;
    }
    assert!(refused * 4 > PROBLEMS);
}

#[test]
fn illegal_targets_are_refused() {
    illegal_targets::<f64>();
    illegal_targets::<f32>();
}

/// The limits with one of them replaced.
fn with_limit(limits: &Limits<f64>, index: usize, limit: f64) -> Limits<f64> {
    let mut all = widened(limits);
    all[index] = limit;
    let [vmax, vmin, amax, amin, jmax, jmin] = all;
    Limits {
        vmax,
        vmin,
        amax,
        amin,
        jmax,
        jmin,
    }
}

#[test]
fn bad_limits_are_refused() {
    let good = Limits::symmetric(3.0, 2.0, 1.0);
    let plan = |limits: &Limits<f64>| {
        Move::default()
            .plan(limits, State::at(0.0), State::at(1.0))
            .err()
    };
    assert_eq!(plan(&good), None);
    for (index, limit) in widened(&good).into_iter().enumerate() {
        assert_eq!(plan(&with_limit(&good, index, 0.0)), Some(Error::Limits));
        assert_eq!(plan(&with_limit(&good, index, -limit)), Some(Error::Limits));
        assert_eq!(
            plan(&with_limit(&good, index, f64::NAN)),
            Some(Error::NotFinite)
        );
        assert_eq!(plan(&with_limit(&good, index, limit * f64::INFINITY)), None);
    }
    let free = Limits::symmetric(f64::INFINITY, f64::INFINITY, 1.0);
    assert_eq!(plan(&free), Some(Error::Limits));
}

#[test]
fn states_that_are_not_finite_are_refused() {
    let limits = Limits::symmetric(3.0, 2.0, 1.0);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let good = State::at(0.0);
        for state in [
            State {
                position: bad,
                ..good
            },
            State {
                velocity: bad,
                ..good
            },
            State {
                acceleration: bad,
                ..good
            },
        ] {
            let mut planned = Move::default();
            assert_eq!(
                planned.plan(&limits, state, good).err(),
                Some(Error::NotFinite)
            );
            assert_eq!(
                planned.plan(&limits, good, state).err(),
                Some(Error::NotFinite)
            );
            assert_eq!(
                planned.meet(&limits, state, good).err(),
                Some(Error::NotFinite)
            );
            assert_eq!(
                planned.meet(&limits, good, state).err(),
                Some(Error::NotFinite)
            );
            assert_eq!(planned.stop(&limits, state).err(), Some(Error::NotFinite));
        }
    }
}
