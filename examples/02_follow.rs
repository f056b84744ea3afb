//! Plans a move and follows it: 10 m, within a jerk of 30 m/s³, an acceleration of 10 m/s² and a velocity of 5 m/s. The axis
//! moves at 1 m/s at the start and rests at the end. A controller sends every setpoint to its drive; this program prints one in 250.
//!
//! ```sh
//! cargo run --example 02_follow
//! ```

use atraj::{Bell, Boundary, Error};

const PERIOD: f64 = 0.001; // s

fn main() -> Result<(), Error> {
    let ends = Boundary { v0: 1.0, ..Boundary::rest_to_rest(0.0, 10.0) };
    let axis = Bell::new(30.0, 10.0, 5.0, ends)?;
    println!("Double-S with cruise: 10 m, from 1 m/s to rest");
    println!("within 5 m/s, 10 m/s^2, 30 m/s^3");
    for tick in (0..=(axis.t / PERIOD) as u32).step_by(250) {
        let x = f64::from(tick) * PERIOD;
        let [p, v, a, j] = axis.state(x);
        println!("{x:.3} s: {p:.4} m, {v:.4} m/s, {a:.4} m/s^2, {j:.4} m/s^3");
    }
    let end = axis.position(axis.t);
    println!("arrives at {end:.4} m after {:.3} s", axis.t);
    Ok(())
}
