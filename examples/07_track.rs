//! Follows a sensor: a hand moves a knob back and forth and once jerks it. The sensor adds up to 1 mm of noise to the position and up to 1 cm/s
//! to the velocity. Every millisecond the axis plans so as to be at the knob 0.1 s later, within a jerk of 200 m/s³, an acceleration
//! of 10 m/s² and a velocity of 1 m/s. The horizon of 0.1 s smooths the noise: the jerk of the motion stays far below its limit. After
//! the jump the axis meets the knob as fast as it can. This program prints one setpoint in 250.
//!
//! ```sh
//! cargo run --example 07_track
//! ```

use atraj::State;
use atraj::online::{Error, Limits, Move};

const PERIOD: f64 = 0.001; // s
const HORIZON: f64 = 0.1; // s

/// A number from -1 to 1.
fn noise(seed: &mut u32) -> f64 {
    *seed = seed.wrapping_mul(1664525).wrapping_add(1013904223);
    2.0 * (f64::from(*seed) / 4294967296.0) - 1.0
}

/// What the sensor measures at the time `t`: a position, m, and a velocity, m/s.
fn sensor(t: f64, seed: &mut u32) -> State<f64> {
    let jump = if t < 1.5 { 0.0 } else { 0.3 };
    State {
        position: 0.3 * (2.0 * t).sin() + jump + 0.001 * noise(seed),
        velocity: 0.6 * (2.0 * t).cos() + 0.01 * noise(seed),
        acceleration: 0.0,
    }
}

fn main() -> Result<(), Error> {
    let limits = Limits::symmetric(200.0, 10.0, 1.0);
    let (mut now, mut axis, mut seed) = (State::at(0.0), Move::default(), 1);
    println!("Following a sensor: noise of 1 mm and 1 cm/s, a jump at 1.5 s, a plan every millisecond");
    println!("within 1 m/s, 10 m/s^2, 200 m/s^3");
    for tick in 0..=3000 {
        let time = f64::from(tick) * PERIOD;
        let knob = sensor(time, &mut seed);
        if tick % 250 == 0 {
            let (p, v, a) = (now.position, now.velocity, now.acceleration);
            println!("{time:.3} s: {p:.4} m, {v:.4} m/s, {a:.4} m/s^2, sensor {:.4} m", knob.position);
        }
        axis.track(&limits, now, knob, 0.0, HORIZON)?;
        now = axis.state_at(PERIOD); // one period later, the next plan starts here
    }
    Ok(())
}
