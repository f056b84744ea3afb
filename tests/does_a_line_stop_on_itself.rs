//! Do axes that stop on a straight line stay on the line, within the limits of each, as fast as the lead can?

use support::prelude::*;

const LINES: usize = 10_000;

fn stops_stay_on_the_line<R: Real>() {
    let mut random = Random::seeded(5);
    let (epsilon, zero) = (R::MACHINE_EPSILON.widen(), R::ZERO);
    for number in 0..LINES {
        let n = 1 + random.below(6);
        let limits: Vec<Limits<R>> = (0..n).map(|_| online::limits(&mut random)).collect();
        let mut ends = || -> Vec<State<R>> {
            (0..n).map(|_| State::at(R::of(random.sign() * random.magnitude(-1.0, 1.0)))).collect()
        };
        let (from, to) = (ends(), ends());
        let mut axes = online::straight(&limits, &from, &to);
        let x = R::of(axes[0].t.widen() * random.between(-0.1, 1.1));
        let now: Vec<State<R>> = axes.iter().map(|axis| axis.state_at(x)).collect();
        let speeds: Vec<f64> = axes.iter().map(online::fastest).collect();
        line_stop(&mut axes, &limits, x).expect("a stop");
        let t = axes[0].t.widen();
        let way = |k: usize| to[k].position.widen() - from[k].position.widen();
        let lead = (0..n).max_by(|&i, &k| way(i).abs().total_cmp(&way(k).abs())).expect("an axis");
        for (i, axis) in axes.iter().enumerate() {
            let begin = axis.state_at(zero);
            let off = (begin.velocity.widen() - now[i].velocity.widen()).abs();
            let goes_on = begin.position == now[i].position && off <= 64.0 * epsilon * speeds[i];
            assert!(axis.t == axes[0].t && goes_on, "line {number}, axis {i}: {begin:?} {:?}", now[i]);
            let end = axis.state_at(axis.t);
            assert!(end.velocity == zero && end.acceleration == zero, "line {number}, axis {i}");
            let found = axis.check(&limits[i]).expect("numbers");
            assert!(found.is_empty(), "line {number}, axis {i}: {found:?} {axis:?}");
            for _ in 0..8 {
                let z = R::of(t * random.between(0.0, 1.0));
                let part = |k: usize| axes[k].position(z).widen() - from[k].position.widen();
                let off = part(i) - part(lead) * way(i) / way(lead);
                let positions = [from[i], to[i], from[lead]].map(|state| state.position.widen().abs());
                let size = positions.iter().sum::<f64>() + way(lead).abs();
                assert!(off.abs() <= 64.0 * epsilon * size, "line {number}, axis {i}: {off:e}");
            }
        }
        // Nothing stops sooner on the line: one axis alone is bound to its limits.
        if n == 1 {
            let stop = online::stop(&limits[0], now[0]);
            assert!((stop.t.widen() - t).abs() <= 64.0 * epsilon * t, "line {number}: {t} {:?}", stop.t);
        }
    }
}

/// The way is so short compared with the positions that roundings hide its direction, and the velocities tell it. The stop was refused.
fn a_tiny_way_is_no_reason_to_refuse<R: Real>() {
    let mut random = Random::seeded(7);
    for number in 0..LINES {
        let limits = online::limits::<R>(&mut random);
        let limits = [limits; 3].map(|limits| Limits::symmetric(limits.jmax, limits.amax, limits.vmax));
        let speed = random.unit() * limits[0].vmax.widen();
        let way = 1e3 * R::MACHINE_EPSILON.widen() * speed;
        let shares = [1.0, random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
        let offsets = [(); 3].map(|()| random.between(-10.0, 10.0) * speed);
        let state = |k: usize, way: f64| online::state_of([offsets[k] + shares[k] * way, shares[k] * speed, 0.0]);
        let ends = [0.0, way].map(|way| [0, 1, 2].map(|k| state(k, way)));
        let mut axes = online::straight(&limits, &ends[0], &ends[1]);
        let x = R::of(axes[0].t.widen() * random.unit());
        let now: Vec<_> = axes.iter().map(|axis| axis.state_at(x)).collect();
        let stopped = line_stop(&mut axes, &limits, x);
        assert!(stopped.is_ok(), "line {number}: {stopped:?} {now:?}");
        for (axis, now) in axes.iter().zip(&now) {
            let off = (axis.state_at(R::ZERO).velocity - now.velocity).widen().abs();
            assert!(off <= 1e-3 * speed, "line {number}: {off} of {speed}");
            assert_eq!(axis.state_at(axis.t).velocity, R::ZERO, "line {number}");
        }
    }
}

/// The second axis begins with a velocity that is a rounding of what its acceleration takes away. The line is planned without it.
fn a_rounding_at_the_start_is_no_reason_to_refuse<R: Real>() {
    let limits = [online::symmetric(30.0, 10.0, 5.0); 2];
    let from = [[0.0, 0.0, 1.0], [0.0, R::MACHINE_EPSILON.widen(), 0.5]].map(online::state_of);
    let to = [4.0, 2.0].map(|position| State::at(R::of(position)));
    let mut axes = online::straight(&limits, &from, &to);
    line_stop(&mut axes, &limits, R::of(0.5)).expect("a stop");
    assert!(axes.iter().all(|axis| axis.state_at(axis.t).velocity == R::ZERO));
}

fn nonsense_is_refused<R: Real>() {
    let [zero, half] = [0.0, 0.5].map(R::of);
    let limits = [30.0, 60.0].map(|j| online::symmetric(j, 10.0, 5.0));
    let mut axes = online::straight(&limits, &[State::at(zero); 2], &[10.0, -3.0].map(|p| State::at(R::of(p))));
    let before = axes.clone();
    let no_limits = [limits[0], Limits { vmax: zero, ..limits[1] }];
    assert_eq!(line_stop::<R>(&mut [], &[], half), Err(Error::Axes));
    assert_eq!(line_stop(&mut axes, &limits[..1], half), Err(Error::Axes));
    assert_eq!(line_stop(&mut axes, &no_limits, half), Err(Error::Limits));
    let other = online::plan(&limits[0], State::at(zero), State::at(R::of(9.0)));
    let mut faster = axes[1];
    for phase in &mut faster.phase {
        phase.velocity = phase.velocity + half;
    }
    for other in [other, faster] {
        let mut bent = [axes[0], other];
        assert_eq!(line_stop(&mut bent, &limits, half), Err(Error::Line));
        assert_eq!((&axes, bent), (&before, [before[0], other]));
    }
    // Moves without a duration have no states but those of their ends.
    for (axis, acceleration) in axes.iter_mut().zip([zero, half]) {
        let here = State { velocity: half, acceleration, ..State::at(zero) };
        axis.plan(&limits[0], here, here).expect("a plan");
    }
    assert_eq!(line_stop(&mut axes, &limits, zero), Err(Error::Line));
}

/// Axes that stand have no direction, and stop where they are.
fn axes_that_stand_stay<R: Real>() {
    let [zero, half] = [0.0, 0.5].map(R::of);
    let limits = [online::symmetric(30.0, 10.0, 5.0); 2];
    let here = [2.0, -3.0].map(|p| State::at(R::of(p)));
    let mut axes = online::straight(&limits, &here, &here);
    line_stop(&mut axes, &limits, half).expect("a stop");
    assert!(axes.iter().zip(here).all(|(axis, here)| axis.t == zero && axis.state_at(half) == here));
}

/// No axis has an acceleration, and the first one stands: the second one leads.
fn a_cruise_stops_on_its_line<R: Real>() {
    let [zero, one, two] = [0.0, 1.0, 2.0].map(R::of);
    let limits = [online::symmetric(30.0, 10.0, 5.0); 2];
    let moving = |position| State { velocity: one, ..State::at(position) };
    let (from, to) = ([State::at(zero), moving(zero)], [State::at(zero), moving(two)]);
    let mut axes = online::straight(&[limits[0], Limits { vmax: one, ..limits[1] }], &from, &to);
    assert!(axes.iter().all(|axis| axis.phases().iter().all(|phase| phase.jerk == zero)));
    line_stop(&mut axes, &limits, one).expect("a stop");
    let end = |axis: &Move<R>| axis.state_at(axis.t);
    assert!(axes[1].t > zero && end(&axes[0]) == from[0] && end(&axes[1]).velocity == zero, "{axes:?}");
}

/// Behind its end a line goes on, at last beyond the largest number: an axis stopped at an infinite position.
fn a_stop_beyond_all_numbers_is_refused<R: Real>() {
    let [zero, one, three] = [0.0, 1.0, 3.0].map(R::of);
    let limits = [online::symmetric(30.0, 10.0, 5.0); 2];
    let state = |position, velocity| State { position, velocity, acceleration: zero };
    let from = [State::at(zero); 2];
    let mut axes = online::straight(&limits, &from, &[state(one, one), state(three, three)]);
    let before = axes.clone();
    assert_eq!(line_stop(&mut axes, &limits, R::of(f64::from(R::EXPONENTS.1).exp2())), Err(Error::NotFinite));
    assert_eq!(axes, before);
}

test_both_reals!(
    stops_stay_on_the_line, a_tiny_way_is_no_reason_to_refuse, a_rounding_at_the_start_is_no_reason_to_refuse,
    nonsense_is_refused, axes_that_stand_stay, a_cruise_stops_on_its_line, a_stop_beyond_all_numbers_is_refused
);
