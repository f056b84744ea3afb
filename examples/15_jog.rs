//! Jogs between two soft stops: while a key is pressed the axis runs, and when the key is released the axis stops. A jog is a plan to the
//! soft stop with the jog's speed as the limit of the velocity. So the axis brakes in time and stands at the stop, however long the key
//! is pressed. The main loop reads the keys and plans; a timer interrupt asks for a setpoint every millisecond. The axis keeps a jerk of
//! 30 m/s³, an acceleration of 3 m/s² and a velocity of 0.5 m/s. This program prints one setpoint in 250.
//!
//! ```sh
//! cargo run --example 15_jog
//! ```

use atraj::State;
use atraj::machine::Axis;
use atraj::online::{Error, Limits};

const PERIOD: f64 = 0.001; // s
const LEAD: u32 = 4; // ticks that a plan takes, and one more

fn main() -> Result<(), Error> {
    let limits = Limits::symmetric(30.0, 3.0, 0.5);
    let (lowest, highest) = (State::at(-0.2), State::at(1.0)); // m
    let mut axis = Axis::new(PERIOD, State::at(0.0))?;
    let (mut planner, mut ticker) = axis.split();
    println!("Jogging between soft stops: up and let go, up to the stop, down to the other one");
    println!("within -0.2 m, +1 m, 0.5 m/s, 3 m/s^2, 30 m/s^3");
    for tick in 0..=7000 {
        let time = f64::from(tick) * PERIOD;
        // The main loop: a key is pressed or released.
        if tick == 200 || tick == 1600 {
            println!("{time:.3} s -> up");
            planner.go(&limits, highest, LEAD)?;
        }
        if tick == 1000 {
            println!("1.000 s -> let go");
            planner.stop(&limits, LEAD)?;
        }
        if tick == 3600 {
            println!("3.600 s -> down");
            planner.go(&limits, lowest, LEAD)?;
        }
        // The interrupt.
        let now = ticker.tick();
        if tick % 250 == 0 {
            let (p, v, a) = (now.position, now.velocity, now.acceleration);
            println!("{time:.3} s: {p:.4} m, {v:.4} m/s, {a:.4} m/s^2");
        }
    }
    Ok(())
}
