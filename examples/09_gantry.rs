//! Moves the two axes of a gantry, each with limits of its own, twice: so that they arrive together, and on a straight line. The clock
//! of the drives ticks every millisecond, and both moves end on a tick. This program prints one setpoint in 200.
//!
//! ```sh
//! cargo run --example 09_gantry
//! ```

use atraj::State;
use atraj::axes::{line, synchronise};
use atraj::online::{Error, Limits, Move};

const CYCLE: f64 = 0.001; // s
const TO: [f64; 2] = [0.8, 0.4]; // m

/// Prints a setpoint: positions, velocities, accelerations.
fn print(time: f64, [x, y]: [State<f64>; 2]) {
    print!("{time:.3} s: x {:.4} m, y {:.4} m, ", x.position, y.position);
    print!("{:.4} {:.4} m/s, ", x.velocity, y.velocity);
    println!("{:.4} {:.4} m/s^2", x.acceleration, y.acceleration);
}

/// Prints a move. The result is how far the gantry leaves the line.
fn follow(name: &str, axes: &[Move<f64>; 2]) -> f64 {
    let t = axes[0].t;
    let ticks = (t / CYCLE).round() as u32;
    let at = |tick| axes.map(|axis| axis.state_at(f64::from(tick) * CYCLE));
    let mut farthest = 0.0;
    println!("{name}");
    for tick in 0..=ticks {
        let [x, y] = at(tick).map(|state| state.position);
        farthest = f64::max(farthest, (TO[0] * y - TO[1] * x).abs() / TO[0].hypot(TO[1]));
        if tick % 200 == 0 {
            print(f64::from(tick) * CYCLE, at(tick));
        }
    }
    print(t, at(ticks));
    println!("off the line by at most {farthest:.4} m");
    assert!(t == axes[1].t && at(ticks).map(|state| state.position) == TO);
    farthest
}

fn main() -> Result<(), Error> {
    // Jerk, acceleration, velocity.
    let limits = [Limits::symmetric(20.0, 4.0, 1.0), Limits::symmetric(5.0, 1.0, 0.6)];
    let (from, to) = ([State::at(0.0); 2], TO.map(State::at));
    let mut axes = [Move::default(); 2];
    println!("Gantry in the plane: two axes arrive together, and stay on a straight line");
    println!("x within 1 m/s, 4 m/s^2\ny within 0.6 m/s, 1 m/s^2");
    synchronise(&mut axes, &limits, &from, &to, 0.0, CYCLE)?;
    let synchronised = follow("synchronised:", &axes);
    line(&mut axes, &limits, &from, &to, 0.0, CYCLE)?;
    let on_line = follow("on a straight line:", &axes);
    assert!(synchronised < 1.0 && on_line < 1e-15); // a rounding
    Ok(())
}
