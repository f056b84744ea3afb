//! The arm of example 10 passes its waypoints without stops. The planner finds the velocities and accelerations at the points, and how
//! long each section takes; `path_moves` makes the motions. This program prints one setpoint in 50 of a clock of 4 ms:
//! the positions, then the velocities. Then it prints how much time a stop at every point would cost.
//!
//! ```sh
//! cargo run --example 12_waypoints
//! ```

use atraj::State;
use atraj::axes::{path_moves, path_size, plan_path, synchronise};
use atraj::online::{Error, Limits, Move};

const CYCLE: f64 = 0.004; // s
const POINTS: [[f64; 6]; 5] = [
    [0.0, -90.0, 90.0, 0.0, 0.0, 0.0], // degrees
    [30.0, -60.0, 70.0, 0.0, -40.0, 90.0],
    [30.0, -50.0, 75.0, 0.0, -55.0, 90.0], // down
    [-45.0, -70.0, 80.0, 20.0, -30.0, -90.0],
    [0.0, -90.0, 90.0, 0.0, 0.0, 0.0], // home
];

/// Prints the setpoints of a section that begins at `start`, from this tick on. The result is the first tick after the section.
fn follow(axes: &[Move<f64>; 6], start: f64, first: u32) -> u32 {
    let mut tick = first;
    while f64::from(tick) * CYCLE < start + axes[0].t {
        let now = f64::from(tick) * CYCLE;
        if tick % 50 == 0 {
            let text = |number: f64| format!("{number:.2}");
            let positions = axes.map(|axis| text(axis.position(now - start))).join(" ");
            let velocities = axes.map(|axis| text(axis.velocity(now - start))).join(" ");
            println!("{now:.3} s: {positions} deg, {velocities} deg/s");
        }
        tick += 1;
    }
    tick
}

fn main() -> Result<(), Error> {
    let large = Limits::symmetric(4000.0, 500.0, 120.0);
    let small = Limits::symmetric(9000.0, 1000.0, 250.0);
    let limits = [large, large, large, small, small, small];
    let (mut moves, mut stopping) = ([[Move::default(); 6]; POINTS.len() - 1], 0.0);
    for (axes, points) in moves.iter_mut().zip(POINTS.windows(2)) {
        let (from, to) = (points[0].map(State::at), points[1].map(State::at));
        synchronise(axes, &limits, &from, &to, 0.0, 0.0)?;
        stopping += axes[0].t;
    }
    let positions = POINTS.iter().flatten();
    let mut states: Vec<_> = positions.map(|&position| State::at(position)).collect();
    let mut durations = [0.0; POINTS.len() - 1];
    let mut work = vec![0.0; path_size(6, durations.len()).expect("a short path")];
    plan_path(&mut states, &mut durations, &limits, 6, 0, &mut work)?;
    path_moves(moves.as_flattened_mut(), &limits, &states, &durations, 6)?;
    println!("Arm through waypoints: six joints pass each together and do not stop");
    println!("joints 1 to 3 within 120 deg/s");
    println!("joints 4 to 6 within 250 deg/s");
    let (mut start, mut tick) = (0.0, 0);
    for (k, axes) in (1..).zip(&moves) {
        tick = follow(axes, start, tick);
        start += axes[0].t;
        println!("{start:.3} s -> point {k}");
        assert_eq!(axes.map(|axis| axis.position(axis.t)), POINTS[k]);
    }
    let saved = 100.0 * (1.0 - start / stopping);
    println!("{stopping:.3} s with a stop at every point, {start:.3} s without: {saved:.0} % saved");
    Ok(())
}
