//! Samples a whole move into arrays, in one call: 101 positions, velocities and accelerations at even times from the start
//! to the end. Jerk is not wanted, so its array is empty.
//!
//! ```sh
//! cargo run --example sample
//! ```

use atraj::{Bell, Boundary};

fn main() {
    let ends = Boundary::rest_to_rest(0.0, 10.0);
    let axis = Bell::new(30.0, 10.0, 5.0, ends).expect("the limits allow no such move");
    let step = axis.t / 100.0;
    let [mut position, mut velocity, mut acceleration] = [[0.0_f64; 101]; 3];
    let outputs = [&mut position[..], &mut velocity, &mut acceleration, &mut []];
    let count = axis.sample_into(0.0, step, outputs);

    let same = (0..101_u32)
        .zip(position)
        .all(|(k, p)| p == axis.position(f64::from(k) * step));
    println!("{count} samples, {step:.4} s apart");
    println!("from {:.4} m to {:.4} m", position[0], position[count - 1]);
    let [fastest, hardest] =
        [velocity, acceleration].map(|all| all.into_iter().fold(0.0, f64::max));
    println!("at most {fastest:.4} m/s and {hardest:.4} m/s^2");
    println!(
        "the same positions as from single calls: {}",
        if same { "yes" } else { "no" }
    );
    assert!(same);
}
