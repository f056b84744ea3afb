//! Does an axis follow a signal nearer than the follower of rsruckig does, with less jerk?

use atraj::State;
use atraj::online::{Limits, Move};
use rsruckig::prelude::*;

const TICK: f64 = 1e-3; // s
const TICKS: u32 = 8_000;
const FIRST: u32 = 2_000; // the first two seconds, in which an axis comes to the signal
const LIMITS: [f64; 3] = [150.0, 15.0, 3.0]; // jerk, acceleration and velocity

fn signal(tick: u32) -> [f64; 3] {
    let (sin, cos) = (2.0 * f64::from(tick) * TICK).sin_cos();
    [sin, 2.0 * cos, -4.0 * sin]
}

/// The largest distance from the signal, and the root of the mean square of the jerk. `next` takes the signal and gives the state one tick later.
fn follow(mut next: impl FnMut([f64; 3]) -> [f64; 3]) -> [f64; 2] {
    let (mut error, mut squares, mut before) = (0.0_f64, 0.0, [0.0; 3]);
    for tick in 0..TICKS {
        let now = next(signal(tick));
        if tick >= FIRST {
            error = error.max((now[0] - signal(tick + 1)[0]).abs());
            squares += ((now[2] - before[2]) / TICK).powi(2);
        }
        before = now;
    }
    [error, (squares / f64::from(TICKS - FIRST)).sqrt()]
}

fn ours(horizon: f64) -> [f64; 2] {
    let [j, a, v] = LIMITS;
    let limits = Limits::symmetric(j, a, v);
    let (mut axis, mut now) = (Move::default(), State::at(0.0));
    follow(|[position, velocity, acceleration]| {
        let signal = State { position, velocity, acceleration };
        axis.track(&limits, now, signal, 0.0, horizon).expect("a plan");
        now = axis.state_at(TICK);
        [now.position, now.velocity, now.acceleration]
    })
}

fn theirs() -> [f64; 2] {
    let mut follower = Trackig::<1, IgnoreErrorHandler>::new(None, TICK);
    let (mut input, mut output) = (InputParameter::<1>::new(None), OutputParameter::<1>::new(None));
    let mut target = TargetState::<1>::new(None);
    let [j, a, v] = LIMITS;
    (input.max_jerk[0], input.max_acceleration[0], input.max_velocity[0]) = (j, a, v);
    follow(|[p, v, a]| {
        (target.position[0], target.velocity[0], target.acceleration[0]) = (p, v, a);
        follower.update(&target, &input, &mut output).expect("a step");
        output.pass_to_input(&mut input);
        [output.new_position[0], output.new_velocity[0], output.new_acceleration[0]]
    })
}

#[test]
fn ours_is_nearer() {
    let [their_error, their_jerk] = theirs();
    println!("rsruckig: error {their_error:.1e}, jerk {their_jerk:.1}");
    for horizon in [0.01, 0.03, 0.06, 0.1] {
        let [error, jerk] = ours(horizon);
        println!("horizon {horizon}: error {error:.1e}, jerk {jerk:.2}");
        assert!(error * 50.0 < their_error && jerk < their_jerk);
    }
}
