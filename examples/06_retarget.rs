//! Plans while the axis moves: at 0.7 s the axis gets a target behind it, at 1.8 s it must stop. Each plan starts from the
//! state of the plan before, so neither velocity nor acceleration jumps. The axis keeps a jerk of 30 m/s³, an acceleration of
//! 10 m/s² and a velocity of 5 m/s. A controller sends every setpoint to its drive; this program prints one in 200.
//!
//! ```sh
//! cargo run --example 06_retarget
//! ```

use atraj::State;
use atraj::online::{Error, Limits, Move};

const PERIOD: f64 = 0.001; // s

fn main() -> Result<(), Error> {
    let limits = Limits::symmetric(30.0, 10.0, 5.0);
    let [ahead, behind] = [State::at(10.0), State::at(-2.0)];
    let (mut axis, mut start) = (Move::default(), 0);
    axis.plan(&limits, State::at(0.0), ahead)?;
    println!("Retargeted and stopped: to 10 m, at 0.7 s to -2 m, at 1.8 s to a stop");
    println!("within 5 m/s, 10 m/s^2, 30 m/s^3");
    for tick in 0..=3000 {
        let (time, x) = (f64::from(tick) * PERIOD, f64::from(tick - start) * PERIOD);
        let now = axis.state_at(x);
        if tick % 200 == 0 {
            let [p, v, a, j] = axis.state(x);
            println!("{time:.3} s: {p:.4} m, {v:.4} m/s, {a:.4} m/s^2, {j:.4} m/s^3");
        }
        if tick == 700 {
            println!("0.700 s -> to -2 m");
            axis.plan(&limits, now, behind)?;
            start = tick;
        }
        if tick == 1800 {
            println!("1.800 s -> stop");
            axis.stop(&limits, now)?;
            start = tick;
        }
    }
    Ok(())
}
