//! The arm of example 12 flies by its waypoints: each joint may be 5 degrees off its point above the part, and 15
//! degrees on the way home; at the part it is exact. This program prints one setpoint in 50 of a clock of 4 ms: the positions, then the
//! velocities. Then it prints where each point is passed, and how much time the zones save.
//!
//! ```sh
//! cargo run --example 24_zones
//! ```

use atraj::State;
use atraj::axes::{path_moves, path_size_near, plan_path, plan_path_near};
use atraj::online::{Error, Limits, Move};

const CYCLE: f64 = 0.004; // s
const POINTS: [[f64; 6]; 5] = [
    [0.0, -90.0, 90.0, 0.0, 0.0, 0.0],     // degrees
    [30.0, -60.0, 70.0, 0.0, -40.0, 90.0], // above the part
    [30.0, -50.0, 75.0, 0.0, -55.0, 90.0], // at the part
    [-45.0, -70.0, 80.0, 20.0, -30.0, -90.0],
    [0.0, -90.0, 90.0, 0.0, 0.0, 0.0], // home
];
const TOLERANCES: [f64; 3] = [5.0, 0.0, 15.0];

fn main() -> Result<(), Error> {
    let large = Limits::symmetric(4000.0, 500.0, 120.0);
    let small = Limits::symmetric(9000.0, 1000.0, 250.0);
    let limits = [large, large, large, small, small, small];
    let points: Vec<_> = POINTS.iter().flatten().map(|&position| State::at(position)).collect();
    let mut work = vec![0.0; path_size_near(6, 4).expect("a short path")];
    let mut durations = [0.0; POINTS.len() - 1];
    plan_path(&mut points.clone(), &mut durations, &limits, 6, 0, &mut work)?;
    let exact: f64 = durations.iter().sum();
    let mut states = points.clone();
    let tolerances = TOLERANCES.map(|tolerance| [tolerance; 6]);
    plan_path_near(&mut states, &mut durations, &limits, tolerances.as_flattened(), 6, 0, &mut work)?;
    let mut moves = [[Move::default(); 6]; POINTS.len() - 1];
    path_moves(moves.as_flattened_mut(), &limits, &states, &durations, 6)?;
    println!("Arm through zones: six joints fly by above the part, and are exact at it");
    println!("joints 1 to 3 within 120 deg/s");
    println!("joints 4 to 6 within 250 deg/s");
    let (mut start, mut tick) = (0.0, 0);
    for (k, axes) in (1..).zip(&moves) {
        while f64::from(tick) * CYCLE < start + durations[k - 1] {
            let now = f64::from(tick) * CYCLE;
            if tick % 50 == 0 {
                let text = |number: f64| format!("{number:.2}");
                let positions = axes.map(|axis| text(axis.position(now - start))).join(" ");
                let velocities = axes.map(|axis| text(axis.velocity(now - start))).join(" ");
                println!("{now:.3} s: {positions} deg, {velocities} deg/s");
            }
            tick += 1;
        }
        start += durations[k - 1];
        let passed = states[6 * k..].iter().zip(POINTS[k]);
        let off = passed.map(|(state, point)| (state.position - point).abs()).fold(0.0, f64::max);
        println!("{start:.3} s -> point {k}, {off:.2} deg off");
        assert!(off <= TOLERANCES.get(k - 1).copied().unwrap_or(0.0));
    }
    let saved = 100.0 * (1.0 - start / exact);
    println!("{exact:.3} s through the points, {start:.3} s through the zones: {saved:.0} % saved");
    assert!(start < exact);
    Ok(())
}
