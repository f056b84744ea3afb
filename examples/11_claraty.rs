//! CLARAty's trapezoid: a controller moves an axis, gives it a target behind it, holds it, and resumes. The axis brakes and turns
//! round; its velocity never jumps. The controller asks for a setpoint every millisecond; this program prints one in 200.
//!
//! ```sh
//! cargo run --example 11_claraty
//! ```

use atraj::State;
use atraj::claraty::{OutOfRange, Target, Trajectory};

const PERIOD: f64 = 0.001; // s

/// The position counts from the place where the axis rested.
fn go_to(axis: &mut Trajectory, position: f64, now: f64) -> Result<(), OutOfRange> {
    let target = Target { position, velocity: 0.5, acceleration: 1.0, deceleration: 0.8 };
    axis.set(target.into(), now)?;
    axis.start(now);
    Ok(())
}

fn main() -> Result<(), OutOfRange> {
    let (mut axis, mut origin, mut point) = (Trajectory::default(), 0.0, State::default());
    let mut now = 0.0; // the caller reads the clock, and passes the time to every method
    println!("Retarget and feed hold: to 0.6 m, at 0.8 s back to 0.1 m, held at 1.6 s, on at 2.4 s");
    println!("within 0.5 m/s, 1 m/s^2, 0.8 m/s^2");
    go_to(&mut axis, 0.6, now)?;
    for tick in 0..=3500 {
        if tick == 800 {
            println!("0.800 s -> to 0.1 m");
            go_to(&mut axis, 0.1, now)?;
        }
        if tick == 1600 {
            println!("1.600 s -> hold");
            axis.stop(now);
        }
        if tick == 2400 {
            println!("2.400 s -> on");
            origin = point.position; // the axis rests here
            go_to(&mut axis, 0.1 - origin, now)?;
        }
        point = axis.setpoint(now);
        point.position += origin;
        if tick % 200 == 0 {
            let (time, [p, v, a]) = (f64::from(tick) * PERIOD, [point.position, point.velocity, point.acceleration]);
            println!("{time:.3} s: {p:.4} m, {v:.4} m/s, {a:.4} m/s^2");
        }
        now += PERIOD;
    }
    Ok(())
}
