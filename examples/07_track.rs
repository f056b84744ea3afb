//! Follows a sensor: a hand moves a knob to and fro and once jerks it, and the sensor adds up to 1 mm of noise. Every millisecond the
//! axis plans again, from its state to the newest value. The plan keeps a jerk of 200 m/s³, an acceleration of 10 m/s² and a velocity
//! of 1 m/s whatever the sensor says. This program prints one setpoint in 250.
//!
//! ```sh
//! cargo run --example 07_track
//! ```

use atraj::State;
use atraj::online::{Error, Limits, Move};

const PERIOD: f64 = 0.001; // s

/// The value of the sensor at the time `t`, m.
fn sensor(t: f64, seed: &mut u32) -> f64 {
    *seed = seed.wrapping_mul(1664525).wrapping_add(1013904223);
    let jump = if t < 1.5 { 0.0 } else { 0.3 };
    0.3 * (2.0 * t).sin() + jump + 0.002 * (f64::from(*seed) / 4294967296.0 - 0.5)
}

fn main() -> Result<(), Error> {
    let limits = Limits::symmetric(200.0, 10.0, 1.0);
    let (mut now, mut axis, mut seed) = (State::at(0.0), Move::default(), 1);
    println!("Following a sensor: noise of 1 mm, a jump at 1.5 s, and a plan every millisecond");
    println!("within 1 m/s, 10 m/s^2, 200 m/s^3");
    for tick in 0..=3000 {
        let time = f64::from(tick) * PERIOD;
        let knob = sensor(time, &mut seed);
        if tick % 250 == 0 {
            let (p, v, a) = (now.position, now.velocity, now.acceleration);
            println!("{time:.3} s: {p:.4} m, {v:.4} m/s, {a:.4} m/s^2, sensor {knob:.4} m");
        }
        axis.plan(&limits, now, State::at(knob))?;
        now = axis.state_at(PERIOD); // one period later, the next plan starts here
    }
    Ok(())
}
