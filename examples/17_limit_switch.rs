//! Stops on a limit switch. A host sends the axis too far. When the axis passes the switch, it stops as hard as its drive can: the stop
//! has limits of its own, which are wider than those of the work. Then the axis goes back to its range. The main loop reads the switch
//! and plans; a timer interrupt asks for a setpoint every millisecond. The work keeps a jerk of 30 m/s³, an acceleration of 3 m/s² and a
//! velocity of 1 m/s, the stop a jerk of 500 m/s³ and an acceleration of 15 m/s². This program prints one setpoint in 250.
//!
//! ```sh
//! cargo run --example 17_limit_switch
//! ```

use atraj::State;
use atraj::machine::Axis;
use atraj::online::{Error, Limits};

const PERIOD: f64 = 0.001; // s
const LEAD: u32 = 4; // ticks that a plan takes, and one more

fn main() -> Result<(), Error> {
    let at_switch = 0.8; // m
    let work = Limits::symmetric(30.0, 3.0, 1.0);
    let hardest = Limits::symmetric(500.0, 15.0, 1.0);
    let (mut now, mut has_passed) = (State::at(0.0), false);
    let mut axis = Axis::new(PERIOD, now)?;
    let (mut planner, mut ticker) = axis.split();
    println!("Stopping on a limit switch: a target too far, a stop with limits of its own, and back");
    println!("within 1 m/s");
    println!("work within 3 m/s^2, 30 m/s^3");
    println!("stop within 15 m/s^2, 500 m/s^3");
    println!("the switch is at 0.8 m");
    planner.go(&work, State::at(2.0), LEAD)?;
    for tick in 0..=3000 {
        let time = f64::from(tick) * PERIOD;
        // The main loop: the switch closes. Later the axis is sent back.
        if !has_passed && now.position >= at_switch {
            println!("{time:.3} s -> stop");
            planner.stop(&hardest, LEAD)?;
            has_passed = true;
        }
        if tick == 2000 {
            println!("2.000 s -> back");
            println!("{:.4} m past the switch", now.position - at_switch);
            planner.go(&work, State::at(0.7), LEAD)?;
        }
        // The interrupt.
        now = ticker.tick();
        if tick % 250 == 0 {
            let (p, v, a) = (now.position, now.velocity, now.acceleration);
            println!("{time:.3} s: {p:.4} m, {v:.4} m/s, {a:.4} m/s^2");
        }
    }
    Ok(())
}
