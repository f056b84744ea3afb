//! Plans while the axis moves: at 0.7 s the axis gets a target behind it, at 1.8 s it is told to stop. Each plan starts from the
//! state of the plan before, so neither velocity nor acceleration jumps. The axis keeps a jerk of 30 m/s³, an acceleration of
//! 10 m/s² and a velocity of 5 m/s. A controller tells its drive every setpoint; this program prints one in 200.
//!
//! ```sh
//! cargo run --example jog
//! ```

use atraj::State;
use atraj::online::{Limits, Move};

const PERIOD: f64 = 0.001; // s

fn main() {
    let limits = Limits::symmetric(30.0, 10.0, 5.0);
    let [ahead, behind] = [State::at(10.0), State::at(-2.0)];
    let (mut now, mut axis, mut start) = (State::at(0.0), Move::default(), 0);
    let (mut velocity_step, mut acceleration_step) = (0.0, 0.0);
    axis.plan(&limits, now, ahead).expect("numbers");
    for tick in 0..=3000 {
        let before = now;
        now = axis.state_at(f64::from(tick - start) * PERIOD);
        velocity_step = f64::max(velocity_step, (now.velocity - before.velocity).abs());
        acceleration_step = f64::max(
            acceleration_step,
            (now.acceleration - before.acceleration).abs(),
        );
        if tick % 200 == 0 {
            println!(
                "{:.3} s: {:.4} m, {:.4} m/s, {:.4} m/s^2",
                f64::from(tick) * PERIOD,
                now.position,
                now.velocity,
                now.acceleration
            );
        }
        if tick == 700 {
            axis.plan(&limits, now, behind).expect("numbers");
            start = tick;
        }
        if tick == 1800 {
            axis.stop(&limits, now).expect("numbers");
            start = tick;
        }
    }
    println!(
        "from one setpoint to the next at most {velocity_step:.4} m/s, {acceleration_step:.4} m/s^2"
    );
    assert!(now.velocity == 0.0 && now.acceleration == 0.0);
    // The limits times the period, and a rounding.
    assert!(velocity_step < 0.010001 && acceleration_step < 0.030001);
}
