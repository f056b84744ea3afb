//! Does the follower of rsruckig stay farther from a signal than ours, with more jerk? `is_a_signal_followed` has the bounds of ours.

use rsruckig::prelude::*;

const TICK: f64 = 1e-3; // s
const TICKS: u32 = 8_000;
const FIRST: u32 = 2_000; // the first two seconds, in which an axis comes to the signal
const HORIZON: f64 = 0.1; // the longest of ours, s

fn signal(tick: u32) -> [f64; 3] {
    let (sin, cos) = (2.0 * f64::from(tick) * TICK).sin_cos();
    [sin, 2.0 * cos, -4.0 * sin]
}

#[test]
fn ours_is_nearer() {
    let mut follower = Trackig::<1, IgnoreErrorHandler>::new(None, TICK);
    let (mut input, mut output) = (InputParameter::<1>::new(None), OutputParameter::<1>::new(None));
    let mut target = TargetState::<1>::new(None);
    (input.max_jerk[0], input.max_acceleration[0], input.max_velocity[0]) = (150.0, 15.0, 3.0);
    let (mut error, mut squares, mut before) = (0.0_f64, 0.0, 0.0);
    for tick in 0..TICKS {
        [target.position[0], target.velocity[0], target.acceleration[0]] = signal(tick);
        follower.update(&target, &input, &mut output).expect("a step");
        output.pass_to_input(&mut input);
        if tick >= FIRST {
            error = error.max((output.new_position[0] - signal(tick + 1)[0]).abs());
            squares += ((output.new_acceleration[0] - before) / TICK).powi(2);
        }
        before = output.new_acceleration[0];
    }
    let jerk = (squares / f64::from(TICKS - FIRST)).sqrt();
    assert!(error > 50.0 * 1.001 * 8.0 * HORIZON.powi(3) / 27.0 && jerk > 5.7, "error {error:.1e}, jerk {jerk:.1}");
}
