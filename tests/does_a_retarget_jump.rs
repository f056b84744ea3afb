//! Do position, velocity or acceleration of an axis jump when it gets another plan in mid-motion?

use atraj::State;
use atraj::online::{Limits, Move};
use support::{Random, Real, online};

const PERIOD: f64 = 1.0 / 1024.0; // s
const RETARGETS: usize = 1000;

/// Position, velocity and acceleration.
fn values<R: Real>(state: State<R>) -> [f64; 3] {
    [state.position, state.velocity, state.acceleration].map(R::widen)
}

/// The largest numbers that positions, velocities and accelerations of a move are computed from.
fn sizes<R: Real>(planned: &Move<R>) -> [f64; 3] {
    let reached = planned.extremes();
    let [low, high] = [reached.lowest, reached.highest].map(values);
    let [p, v, a] = std::array::from_fn(|i| f64::max(low[i].abs(), high[i].abs()));
    let t = planned.t.widen();
    [p + v * t, v + a * t.min(1.0), a]
}

/// A setpoint follows the one before: no quantity has changed by more than its limited derivative allows in a period.
fn assert_no_step<R: Real>(limits: &Limits<R>, sizes: [f64; 3], before: State<R>, now: State<R>) {
    let [p0, v0, a0] = values(before);
    let [p1, v1, a1] = values(now);
    let rounding = sizes.map(|size| 16.0 * R::MACHINE_EPSILON.widen() * size);
    let within = |low: R, high: R, step: f64, rounding: f64| {
        let least = low.widen() * PERIOD - rounding;
        let most = high.widen() * PERIOD + rounding;
        step >= least && step <= most
    };
    let &Limits {
        vmax,
        vmin,
        amax,
        amin,
        jmax,
        jmin,
    } = limits;
    let smooth = within(vmin, vmax, p1 - p0, rounding[0])
        && within(amin, amax, v1 - v0, rounding[1])
        && within(jmin, jmax, a1 - a0, rounding[2]);
    // A jump of the position inside this limit: the position goes the way of the velocity.
    let bend = (jmax.widen() - jmin.widen()) * PERIOD * PERIOD * PERIOD;
    let way = 0.5 * (v0 + v1) * PERIOD - p1 + p0;
    assert!(
        smooth && way.abs() <= bend + rounding[0],
        "from {before:?} to {now:?} within {limits:?}"
    );
}

/// One run: a setpoint every period, and a plan at random times.
fn run<R: Real>(random: &mut Random, limits: &Limits<R>) {
    let mut now = State::at(R::of(0.0));
    let mut planned = Move::default();
    for number in 0..RETARGETS {
        let target = online::inside(random, limits);
        let part = State {
            velocity: R::of(0.5) * target.velocity,
            acceleration: R::of(0.0),
            ..target
        };
        let result = match random.below(8) {
            0 => planned.stop(limits, now),
            1 => planned.reach(limits, now, target.velocity, target.acceleration),
            2 => planned.meet(limits, now, part),
            _ => planned.plan(limits, now, target),
        };
        assert!(result.is_ok(), "{number}: {result:?} {limits:?} {now:?}");
        let sizes = sizes(&planned);
        // A few periods, or many. After the end the axis must be at rest to stay where it is.
        let most = random.pick(&[2, 50, 1000]);
        let ticks = 1 + random.below(most);
        for tick in 1..=ticks {
            let x = R::of(tick as f64 * PERIOD);
            if x > planned.t {
                break;
            }
            let next = planned.state_at(x);
            assert_no_step(limits, sizes, now, next);
            now = next;
        }
    }
}

fn runs<R: Real>() {
    let mut random = Random::seeded(1);
    run(
        &mut random,
        &Limits::symmetric(R::of(30.0), R::of(10.0), R::of(5.0)),
    );
    for _ in 0..20 {
        let limits = online::limits::<R>(&mut random);
        run(&mut random, &limits);
    }
}

#[test]
fn a_thousand_f64() {
    runs::<f64>();
}

#[test]
fn a_thousand_f32() {
    runs::<f32>();
}
