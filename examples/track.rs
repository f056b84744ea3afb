//! Follows a sensor: a hand moves a knob to and fro, and the sensor adds up to 1 mm of noise. Every millisecond the axis plans again,
//! from its state to the newest value. The plan keeps a jerk of 200 m/s³, an acceleration of 10 m/s² and a velocity of 1 m/s
//! whatever the sensor says. This program prints one setpoint in 250.
//!
//! ```sh
//! cargo run --example track
//! ```

use atraj::State;
use atraj::online::{Limits, Move};

const PERIOD: f64 = 0.001; // s

/// The value of the sensor at the time `t`, m.
fn sensor(t: f64, seed: &mut u32) -> f64 {
    *seed = seed.wrapping_mul(1664525).wrapping_add(1013904223);
    0.3 * (2.0 * t).sin() + 0.002 * (f64::from(*seed) / 4294967296.0 - 0.5)
}

fn main() {
    let limits = Limits::symmetric(200.0, 10.0, 1.0);
    let (mut now, mut axis, mut seed) = (State::at(0.0), Move::default(), 1);
    let (mut farthest, mut fastest, mut acceleration_step) = (0.0, 0.0, 0.0);
    for tick in 0..=3000 {
        let time = f64::from(tick) * PERIOD;
        let target = State::at(sensor(time, &mut seed));
        let before = now;
        if tick % 250 == 0 {
            println!(
                "{time:.3} s: sensor {:.4} m, axis {:.4} m, {:.4} m/s",
                target.position, now.position, now.velocity
            );
        }
        axis.plan(&limits, now, target).expect("numbers");
        now = axis.state_at(PERIOD); // one period later, the next plan starts here
        farthest = f64::max(farthest, (target.position - now.position).abs());
        fastest = f64::max(fastest, now.velocity.abs());
        acceleration_step = f64::max(
            acceleration_step,
            (now.acceleration - before.acceleration).abs(),
        );
    }
    println!("at most {farthest:.4} m behind the sensor, at most {fastest:.4} m/s");
    println!("from one setpoint to the next at most {acceleration_step:.4} m/s^2");
    // The limits and a rounding.
    assert!(farthest < 0.1 && fastest < 1.000001 && acceleration_step < 0.200001);
}
