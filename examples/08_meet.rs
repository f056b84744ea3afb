//! Meets a part on a conveyor, tracks the part, and goes home at 1.6 s. At 0.4 s the belt gets faster, so the axis plans
//! again. The axis keeps a jerk of 50 m/s³, an acceleration of 5 m/s² and a velocity of 2 m/s. A controller sends its drive
//! every setpoint; this program prints one in 200.
//!
//! ```sh
//! cargo run --example 08_meet
//! ```

use atraj::State;
use atraj::online::{Error, Limits, Move};

const PERIOD: f64 = 0.001; // s

fn main() -> Result<(), Error> {
    let limits = Limits::symmetric(50.0, 5.0, 2.0);
    let home = State::at(0.0);
    // The belt does not accelerate.
    let mut part = State { velocity: 0.4, ..State::at(0.5) };
    let (mut axis, mut start, mut goes_home) = (Move::default(), 0, false);
    axis.meet(&limits, home, part)?;
    println!("Meeting a part on a conveyor: the belt gets faster, the axis tracks the part and goes home");
    println!("within 2 m/s, 5 m/s^2, 50 m/s^3");
    for tick in 0..=3000 {
        let (time, x) = (f64::from(tick) * PERIOD, f64::from(tick - start) * PERIOD);
        let now = if goes_home || x < axis.t {
            axis.state_at(x)
        } else {
            part // the move has ended at the part, and the part moves on
        };
        if tick % 200 == 0 {
            let (p, v, a) = (now.position, now.velocity, now.acceleration);
            print!("{time:.3} s: {p:.4} m, {v:.4} m/s, {a:.4} m/s^2, ");
            println!("part {:.4} m, {:.4} m/s", part.position, part.velocity);
        }
        if tick == 400 {
            println!("0.400 s -> faster belt");
            part.velocity = 0.6;
            axis.meet(&limits, now, part)?;
            start = tick;
        }
        if tick == 1600 {
            println!("1.600 s -> home");
            axis.plan(&limits, now, home)?;
            start = tick;
            goes_home = true;
        }
        part.position += part.velocity * PERIOD;
    }
    Ok(())
}
