//! An arm with six axes follows waypoints and stops at each. The axes have limits of their own, arrive at a waypoint together, and
//! stretch their moves to the slowest axis. The clock of the drives ticks every 4 ms, and every move ends on a tick. This program
//! prints one setpoint in 50: the positions, then the velocities.
//!
//! ```sh
//! cargo run --example 10_arm
//! ```

use atraj::State;
use atraj::axes::synchronise;
use atraj::online::{Error, Limits, Move};

const CYCLE: f64 = 0.004; // s
const POINTS: [[f64; 6]; 5] = [
    [0.0, -90.0, 90.0, 0.0, 0.0, 0.0], // degrees
    [30.0, -60.0, 70.0, 0.0, -40.0, 90.0],
    [30.0, -50.0, 75.0, 0.0, -55.0, 90.0], // down
    [-45.0, -70.0, 80.0, 20.0, -30.0, -90.0],
    [0.0, -90.0, 90.0, 0.0, 0.0, 0.0], // home
];

/// Prints the setpoints of a move that begins at `start`.
fn follow(axes: &[Move<f64>; 6], start: f64) {
    for tick in (0..=(axes[0].t / CYCLE) as u32).step_by(50) {
        let x = f64::from(tick) * CYCLE;
        let text = |number: f64| format!("{number:.2}");
        let positions = axes.map(|axis| text(axis.position(x))).join(" ");
        let velocities = axes.map(|axis| text(axis.velocity(x))).join(" ");
        println!("{:.3} s: {positions} deg, {velocities} deg/s", start + x);
    }
}

fn main() -> Result<(), Error> {
    let large = Limits::symmetric(4000.0, 500.0, 120.0);
    let small = Limits::symmetric(9000.0, 1000.0, 250.0);
    let limits = [large, large, large, small, small, small];
    let (mut axes, mut start) = ([Move::default(); 6], 0.0);
    println!("Arm over waypoints: six joints arrive together at each");
    println!("joints 1 to 3 within 120 deg/s");
    println!("joints 4 to 6 within 250 deg/s");
    for (k, points) in POINTS.windows(2).enumerate() {
        let (from, to) = (points[0].map(State::at), points[1].map(State::at));
        synchronise(&mut axes, &limits, &from, &to, 0.0, CYCLE)?;
        follow(&axes, start);
        let t = axes[0].t;
        start += t;
        println!("{start:.3} s -> point {}", k + 1);
        assert!(axes.iter().all(|axis| axis.t == t) && axes.map(|axis| axis.state_at(t)) == to);
    }
    Ok(())
}
