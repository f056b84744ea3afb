//! Does an axis that waits for slower ones move slowly, instead of moving fast and standing still, and does it cruise at one velocity where this
//! is possible? `tests/oracle` judges all else.

use support::prelude::*;

const SETS: usize = 20_000;
const MOST_AXES: usize = 6;

/// From rest to rest, with equal jerks, an axis is no faster than twice its mean velocity.
fn from_rest_to_rest<R: Real>() {
    let mut random = Random::seeded(7);
    for _ in 0..SETS {
        let count = 1 + random.below(MOST_AXES);
        let any = (0..count).map(|_| online::limits::<R>(&mut random));
        let limits: Vec<_> = any.map(|limits| Limits { jmin: -limits.jmax, ..limits }).collect();
        let mut state = |_| State::at(R::of(random.sign() * random.magnitude(-2.0, 1.5)));
        let [from, to] = [(); 2].map(|()| (0..count).map(&mut state).collect::<Vec<_>>());
        let axes = online::together(&limits, &from, &to, R::of(random.pick(&[0.0, 0.01, 1.0, 100.0])));
        for ((axis, from), to) in axes.iter().zip(&from).zip(&to) {
            let distance = (to.position.widen() - from.position.widen()).abs();
            let rounding = 1.0 + 64.0 * R::MACHINE_EPSILON.widen();
            let covered = axis.t.widen() * online::fastest(axis);
            assert!(covered <= 2.0 * distance * rounding, "{axis:?} to {to:?} within {limits:?}");
        }
    }
}

/// From rest to rest, an axis with time to spare makes its fastest move in slow motion, whatever the limits are.
fn in_slow_motion<R: Real>() {
    let mut random = Random::seeded(9);
    for _ in 0..SETS / 10 {
        let limits = online::limits::<R>(&mut random);
        let [from, to] = [(); 2].map(|()| State::at(R::of(random.sign() * random.magnitude(-2.0, 1.5))));
        let fastest = online::plan(&limits, from, to);
        let axes = online::together(&[limits], &[from], &[to], fastest.t * R::of(1.0 + random.magnitude(-2.0, 3.0)));
        let size = from.position.widen().abs() + to.position.widen().abs();
        for _ in 0..8 {
            let part = R::of(random.unit());
            let [slow, fast] = [&axes[0], &fastest].map(|axis| axis.position(part * axis.t).widen());
            let most = 64.0 * R::MACHINE_EPSILON.widen() * size;
            assert!((slow - fast).abs() <= most, "{slow} instead of {fast}: {limits:?} {from:?} {to:?}");
        }
    }
}

/// The ramp to the velocity `v`, in binary64: its duration and its displacement.
fn ramp(limits: &Limits<f64>, from: State<f64>, v: f64) -> Option<[f64; 2]> {
    let mut ramp = Move::default();
    ramp.reach(limits, from, v, 0.0).ok()?;
    Some([ramp.t, ramp.state_at(ramp.t).position - from.position])
}

/// Velocity and duration of the cruise that leads from start to end in the time `t`, if there is one. Halving finds the velocity.
fn cruise(limits: &Limits<f64>, from: State<f64>, to: State<f64>, t: f64) -> Option<[f64; 2]> {
    // Mirrored and in the other order of time, an axis keeps its velocity and its jerk.
    let back = Limits { amax: -limits.amin, amin: -limits.amax, ..*limits };
    let end = State { acceleration: -to.acceleration, ..to };
    let way = to.position - from.position;
    let (mut low, mut high) = (limits.vmin, limits.vmax);
    let mut found = None;
    for _ in 0..100 {
        let v = 0.5 * (low + high);
        let ([t0, h0], [t1, h1]) = (ramp(limits, from, v)?, ramp(&back, end, v)?);
        let lasts = t - t0 - t1;
        let lacks = way - (h0 + v * lasts + h1);
        (low, high) = if lacks > 0.0 { (v, high) } else { (low, v) };
        let is_near = lacks.abs() <= 1e-12 * (way.abs() + v.abs() * t);
        found = (is_near && lasts > 1e-3 * t).then_some([v, lasts]);
    }
    found
}

/// In motion, an axis with time to spare cruises at one velocity, where this is possible.
fn in_motion<R: Real>() {
    let mut random = Random::seeded(8);
    let mut cruises = 0;
    for _ in 0..SETS / 10 {
        let limits = online::limits::<R>(&mut random);
        let ends = [(); 2].map(|()| online::inside(&mut random, &limits));
        let [from, to] = ends;
        let is_at_rest = |state: State<R>| state == State::at(state.position);
        let duration = online::plan(&limits, from, to).t * R::of(1.0 + random.magnitude(-2.0, 1.0));
        let axis = online::together(&[limits], &[from], &[to], duration)[0];
        let widened = online::limits_of(online::numbers_of(&limits).map(R::widen));
        let [start, end] = ends.map(|end| online::state_of::<f64>(online::numbers_of_state(end)));
        if is_at_rest(from) && is_at_rest(to) || axis.t != duration {
            continue;
        }
        let Some([v, lasts]) = cruise(&widened, start, end, duration.widen()) else { continue };
        let rounding = R::MACHINE_EPSILON.widen().sqrt();
        let is_cruise = |phase: &Phase<R>| {
            phase.acceleration == R::ZERO
                && phase.jerk == R::ZERO
                && (phase.velocity.widen() - v).abs() <= rounding * (widened.vmax - widened.vmin)
                && (phase.duration.widen() - lasts).abs() <= rounding * duration.widen()
        };
        assert!(axis.phases().iter().any(is_cruise), "no cruise at {v} for {lasts} s: {axis:?} within {limits:?}");
        cruises += 1;
    }
    assert!(cruises > SETS / 40, "{cruises}");
}

test_both_reals!(from_rest_to_rest, in_slow_motion, in_motion);
