//! Finds home on a switch. The axis runs fast until the switch closes, runs back until it opens, and runs slowly onto it again. Where it
//! closes now is known to a hundredth of a millimetre, because the axis was slow. Then the axis goes to its home, 0.1 m from the switch. Each
//! change of direction is one plan from the present motion. The main loop reads the switch and plans; a timer interrupt asks for a
//! setpoint every millisecond. The axis keeps a jerk of 50 m/s³, an acceleration of 2 m/s² and a velocity of 0.2 m/s. This program
//! prints one setpoint in 250.
//!
//! ```sh
//! cargo run --example 16_homing
//! ```

use atraj::State;
use atraj::machine::Axis;
use atraj::online::{Error, Limits};

const PERIOD: f64 = 0.001; // s
const LEAD: u32 = 4; // ticks that a plan takes, and one more

enum Step {
    Fast,
    Back,
    Slow,
    Home,
}

/// The switch of the machine.
fn is_closed(position: f64) -> bool {
    position <= -0.31273
}

fn main() -> Result<(), Error> {
    let limits = Limits::symmetric(50.0, 2.0, 0.2);
    let (mut now, mut step) = (State::at(0.0), Step::Fast);
    let mut axis = Axis::new(PERIOD, now)?;
    let (mut planner, mut ticker) = axis.split();
    println!("Homing on a switch: fast onto it, back, slowly onto it, and home, 0.1 m away");
    println!("within 0.2 m/s, 2 m/s^2, 50 m/s^3");
    planner.reach(&limits, -0.2, 0.0, LEAD)?;
    for tick in 0..=3200 {
        let time = f64::from(tick) * PERIOD;
        // The main loop: the switch has closed or opened.
        match (&step, is_closed(now.position)) {
            (Step::Fast, true) => {
                println!("{time:.3} s -> back");
                planner.reach(&limits, 0.05, 0.0, LEAD)?;
                step = Step::Back;
            }
            (Step::Back, false) => {
                println!("{time:.3} s -> slow");
                planner.reach(&limits, -0.01, 0.0, LEAD)?;
                step = Step::Slow;
            }
            (Step::Slow, true) => {
                println!("{time:.3} s -> home");
                println!("the switch is at {:.5} m", now.position);
                planner.go(&limits, State::at(now.position + 0.1), LEAD)?;
                step = Step::Home;
            }
            _ => {}
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
