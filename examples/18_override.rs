//! Overrides the feed. A knob sets what share of 0.5 m/s the axis may use: each turn of the knob is a plan to the same target within a
//! new limit of the velocity. An axis that is too fast for the new limit returns within it in minimum time. A share of 0 is a hold: the
//! axis stops. The main loop reads the knob and plans; a timer interrupt asks for a setpoint every millisecond. The axis keeps a jerk of
//! 30 m/s³ and an acceleration of 3 m/s². This program prints one setpoint in 250.
//!
//! ```sh
//! cargo run --example 18_override
//! ```

use atraj::State;
use atraj::machine::Axis;
use atraj::online::{Error, Limits};

const PERIOD: f64 = 0.001; // s
const LEAD: u32 = 4; // ticks that a plan takes, and one more
/// When the knob is turned, ticks, and to how much, %.
const TURNS: [(i32, i32); 5] = [(0, 100), (1000, 40), (2200, 120), (3200, 0), (4000, 100)];

fn main() -> Result<(), Error> {
    let target = State::at(2.0); // m
    let mut axis = Axis::new(PERIOD, State::at(0.0))?;
    let (mut planner, mut ticker) = axis.split();
    let mut feed = 0.0; // m/s
    println!("Overriding the feed: 100 %, 40 %, 120 %, a hold, and 100 % again");
    println!("within 0.6 m/s, 3 m/s^2, 30 m/s^3");
    for tick in 0..=6000 {
        let time = f64::from(tick) * PERIOD;
        // The main loop: the knob is turned.
        if let Some((_, percent)) = TURNS.iter().find(|turn| turn.0 == tick) {
            println!("{time:.3} s -> {percent} %");
            feed = 0.5 * f64::from(*percent) / 100.0;
            if feed > 0.0 {
                planner.go(&Limits::symmetric(30.0, 3.0, feed), target, LEAD)?;
            } else {
                planner.stop(&Limits::symmetric(30.0, 3.0, 0.5), LEAD)?; // a limit is never 0
            }
        }
        // The interrupt.
        let now = ticker.tick();
        if tick % 250 == 0 {
            let (p, v, a) = (now.position, now.velocity, now.acceleration);
            println!("{time:.3} s: {p:.4} m, {v:.4} m/s, {a:.4} m/s^2, feed {feed:.4} m/s");
        }
    }
    Ok(())
}
