//! Does a move go on after its end with the acceleration of the end, so that the state at any time is the start of another plan?

use approx::assert_abs_diff_eq;
use support::prelude::*;

const MOVES: usize = 2_000;

/// Every time after the end, some of them far, has the state of an axis with a constant acceleration.
fn with_the_final_acceleration<R: Real>() {
    let mut random = Random::seeded(1);
    for _ in 0..MOVES {
        let (_, _, planned) = online::planned::<R>(&mut random);
        let end = planned.state_at(planned.t);
        for later in [0.01, 1.0, 100.0] {
            let x = planned.t + R::of(later);
            let passed = x.widen() - planned.t.widen();
            let [p, v, a] = online::numbers_of_state(end);
            let [position, velocity, acceleration, jerk] = planned.state(x).map(R::widen);
            let (speed, few) = (v.abs() + a.abs() * passed, 4.0 * R::MACHINE_EPSILON.widen());
            let way = p.abs() + speed * passed;
            assert_abs_diff_eq!(position, p + v * passed + 0.5 * a * passed * passed, epsilon = few * way);
            assert_abs_diff_eq!(velocity, v + a * passed, epsilon = few * speed);
            assert_eq!((acceleration, jerk), (a, 0.0));
        }
    }
}

/// Before the start the axis is at the start. What is no time is at the end, and an end at rest lasts for ever.
fn from_the_start<R: Real>() {
    let mut random = Random::seeded(2);
    for _ in 0..MOVES {
        let (_, _, planned) = online::planned::<R>(&mut random);
        let [start, end] = [R::ZERO, planned.t].map(|x| planned.state(x));
        if planned.t > R::ZERO {
            for x in [-0.0, -1.0, -1e30, f64::NEG_INFINITY] {
                assert_eq!(planned.state(R::of(x))[..3], start[..3]);
            }
        }
        for x in [f64::NAN, f64::INFINITY] {
            assert_eq!(planned.state(R::of(x)), end);
        }
        if end[1..3] == [R::ZERO; 2] {
            for later in [1e-3, 1.0, 1e30] {
                assert_eq!(planned.state(planned.t + R::of(later)), end);
            }
        }
    }
}

/// A jog is stopped long after it got its velocity, and a retarget long after a moving end begins where the axis is.
fn another_plan_begins_there<R: Real>() {
    let limits = online::symmetric(30.0, 10.0, 5.0);
    let mut axis = Move::default();
    assert!(axis.reach(&limits, State::at(R::ZERO), R::of(2.0), R::ZERO).is_ok());
    let now = axis.state_at(axis.t + R::of(3.0));
    assert_eq!((now.velocity, now.acceleration), (R::of(2.0), R::ZERO));
    let mut stop = Move::default();
    assert_eq!(stop.stop(&limits, now).map(|found| found.bits()), Ok(0));
    assert_eq!(stop.state_at(R::ZERO), now);
    assert!(stop.position(stop.t) > now.position);
}

test_both_reals!(with_the_final_acceleration, from_the_start, another_plan_begins_there);
