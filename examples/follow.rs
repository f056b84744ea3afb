//! Plans a move and follows it: 10 m from rest to rest, within a jerk of 30 m/s³, an acceleration of 10 m/s² and a velocity
//! of 5 m/s. A controller tells its drive every setpoint; this program prints one in 250.
//!
//! ```sh
//! cargo run --example follow
//! ```

use atraj::{Bell, Boundary};

const PERIOD: f64 = 0.001; // s

fn main() {
    let ends = Boundary::rest_to_rest(0.0, 10.0);
    let axis = Bell::new(30.0, 10.0, 5.0, ends).expect("the limits allow no such move");
    let mut within = true;
    let mut tick = 0;
    while f64::from(tick) * PERIOD < axis.t {
        let x = f64::from(tick) * PERIOD;
        let (position, velocity) = (axis.position(x), axis.velocity(x));
        within &= (0.0..=5.0).contains(&velocity);
        if tick % 250 == 0 {
            println!("{x:.3} s: {position:.4} m, {velocity:.4} m/s");
        }
        tick += 1;
    }
    println!("{:.3} s: arrived at {:.4} m", axis.t, axis.position(axis.t));
    println!("within the velocity: {}", if within { "yes" } else { "no" });
    assert!(within);
}
