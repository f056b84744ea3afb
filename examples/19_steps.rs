//! Drives a stepper motor. A step is 1.8 degrees, and the driver wants a pulse for each step: `atraj_move_time_at` returns when the move is at
//! the position of a step. The motor turns by half a revolution and a quarter back, so the direction changes once. It keeps a jerk of
//! 200,000 deg/s³, an acceleration of 10,000 deg/s² and a velocity of 1,000 deg/s. This program prints one pulse in 10, with the velocity
//! since the pulse before.
//!
//! ```sh
//! cargo run --example 19_steps
//! ```

use atraj::State;
use atraj::online::{Error, Limits, Move};

const STEP: f64 = 1.8; // deg

/// Gives the pulses of a move that begins at the time `start`, from one step to another.
fn give_pulses(axis: &Move<f64>, start: f64, from: i32, to: i32) {
    let direction = (to - from).signum();
    let mut last = 0.0; // s
    for count in 1..=(to - from).abs() {
        let step = from + direction * count;
        let position = f64::from(step) * STEP;
        let x = axis.time_at(position).unwrap_or(f64::NAN);
        if step % 10 == 0 {
            let velocity = f64::from(direction) * STEP / (x - last);
            println!("{:.6} s: {position:.1} deg, {velocity:.1} deg/s", start + x);
        }
        last = x;
    }
}

fn main() -> Result<(), Error> {
    let (there, back) = (100, 50); // steps
    let [home, half, quarter] = [0.0, 100.0 * STEP, 50.0 * STEP].map(State::at); // deg
    let limits = Limits::symmetric(200_000.0, 10_000.0, 1_000.0);
    let wait = 0.05; // s
    let mut axis = Move::default();
    println!("Pulses for a stepper motor: half a revolution, and a quarter back");
    println!("within 1000 deg/s");
    axis.plan(&limits, home, half)?;
    println!("0.000 s -> forward");
    give_pulses(&axis, 0.0, 0, there);
    let start = axis.t + wait;
    axis.plan(&limits, half, quarter)?;
    println!("{start:.3} s -> backward");
    give_pulses(&axis, start, there, back);
    Ok(())
}
