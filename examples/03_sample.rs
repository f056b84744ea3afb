//! Samples a whole move into arrays, in one call: 1001 positions, velocities and accelerations of a trapezoid at even times from
//! the start to the end. This program prints one sample in 100.
//!
//! ```sh
//! cargo run --example 03_sample
//! ```

use atraj::{Boundary, Error, Trap};

fn main() -> Result<(), Error> {
    let ends = Boundary::rest_to_rest(0.0, 10.0);
    let axis = Trap::new(5.0, 4.0, -8.0, ends)?;
    let step = axis.t / 1000.0;
    let [mut position, mut velocity, mut acceleration] = [[0.0; 1001]; 3];
    let count = axis.sample_into(0.0, step, [&mut position, &mut velocity, &mut acceleration]);

    let mut same = count == position.len();
    println!("Trapezoid with cruise: 10 m from rest to rest, sampled in one call");
    println!("within 5 m/s, +4 m/s^2, -8 m/s^2");
    for k in 0..count {
        let x = k as f64 * step;
        let (p, v, a) = (position[k], velocity[k], acceleration[k]);
        if k % 100 == 0 {
            println!("{x:.4} s: {p:.4} m, {v:.4} m/s, {a:.4} m/s^2");
        }
        same &= p == axis.position(x);
    }
    let answer = if same { "yes" } else { "no" };
    println!("the same positions as from single calls: {answer}");
    assert!(same);
    Ok(())
}
