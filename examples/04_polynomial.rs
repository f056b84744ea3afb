//! Moves in a given time: a septic polynomial goes 10 m in 8 s, at rest without acceleration and jerk at both ends. Nothing limits the
//! motion between the ends, so the program computes the extremes of the motion. It prints one setpoint in 500.
//!
//! ```sh
//! cargo run --example 04_polynomial
//! ```

use atraj::{Boundary, Error, Poly7};

const PERIOD: f64 = 0.001; // s

fn main() -> Result<(), Error> {
    let ends = Boundary::rest_to_rest(0.0, 10.0);
    let axis = Poly7::new(8.0, ends, [0.0; 2], [0.0; 2])?;
    println!("Septic polynomial: 10 m in 8 s, without jerk at both ends");
    for tick in (0..=8000).step_by(500) {
        let x = f64::from(tick) * PERIOD;
        let [p, v, a, j] = axis.state(x);
        println!("{x:.3} s: {p:.4} m, {v:.4} m/s, {a:.4} m/s^2, {j:.4} m/s^3");
    }
    let highest = axis.extremes(8.0).highest;
    let (velocity, acceleration) = (highest.velocity, highest.acceleration);
    println!("reaches {velocity:.4} m/s and {acceleration:.4} m/s^2");
    Ok(())
}
