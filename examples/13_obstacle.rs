//! Moves the two axes of a gantry round an obstacle, by way of two points next to it: without stops, and with a stop at each point. Each
//! axis has limits of its own. This program prints one setpoint in 100 of a clock of 1 ms, and which part of its limits an axis uses.
//!
//! ```sh
//! cargo run --example 13_obstacle
//! ```

use atraj::State;
use atraj::axes::{path_moves, path_size, plan_path, synchronise};
use atraj::online::{Error, Limits, Move};

const CYCLE: f64 = 0.001; // s
const LEFT: f64 = 0.4; // the obstacle stands at y = 0, m
const RIGHT: f64 = 0.6;
const TOP: f64 = 0.3;
const POINTS: [[f64; 2]; 4] = [[0.0, 0.0], [0.36, 0.32], [0.64, 0.32], [1.0, 0.0]];

/// Prints a setpoint: positions, velocities, accelerations.
fn print(time: f64, [x, y]: [State<f64>; 2]) {
    print!("{time:.3} s: x {:.4} m, y {:.4} m, ", x.position, y.position);
    print!("{:.4} {:.4} m/s, ", x.velocity, y.velocity);
    println!("{:.4} {:.4} m/s^2", x.acceleration, y.acceleration);
}

/// Prints a path. The result is its duration, s.
fn follow(name: &str, limits: &[Limits<f64>; 2], moves: &[[Move<f64>; 2]; 3]) -> f64 {
    let (mut start, mut tick) = (0.0, 0);
    let (mut v, mut a) = ([0.0_f64; 2], [0.0_f64; 2]);
    println!("{name}:");
    for (k, axes) in moves.iter().enumerate() {
        if k > 0 {
            println!("{start:.3} s -> point {k}");
        }
        while f64::from(tick) * CYCLE < start + axes[0].t {
            let time = f64::from(tick) * CYCLE;
            let now = axes.map(|axis| axis.state_at(time - start));
            if tick % 100 == 0 {
                print(time, now);
            }
            let [x, y] = now.map(|state| state.position);
            assert!(!(x > LEFT && x < RIGHT && y < TOP), "hits the obstacle");
            for i in 0..2 {
                v[i] = v[i].max(now[i].velocity.abs() / limits[i].vmax);
                a[i] = a[i].max(now[i].acceleration.abs() / limits[i].amax);
            }
            tick += 1;
        }
        start += axes[0].t;
    }
    print(start, POINTS[3].map(State::at));
    for (i, name) in ["x", "y"].into_iter().enumerate() {
        let Limits { vmax, amax, .. } = limits[i];
        let (speed, rate) = (100.0 * v[i], 100.0 * a[i]);
        println!("{name} uses {speed:.0} % of {vmax} m/s and {rate:.0} % of {amax} m/s^2");
        assert!(v[i] <= 1.0 + 1e-12 && a[i] <= 1.0 + 1e-12); // a rounding
    }
    start
}

fn main() -> Result<(), Error> {
    let limits = [Limits::symmetric(40.0, 4.0, 1.0), Limits::symmetric(20.0, 2.0, 0.8)];
    let positions = POINTS.iter().flatten();
    let mut states: Vec<_> = positions.map(|&position| State::at(position)).collect();
    let mut durations = [0.0; 3];
    println!("Round an obstacle: a gantry passes two points next to it without stops");
    println!("x within 1 m/s, 4 m/s^2\ny within 0.8 m/s, 2 m/s^2");
    println!("obstacle:\n0 s: x {LEFT} m, y 0 m\n0 s: x {LEFT} m, y {TOP} m");
    println!("0 s: x {RIGHT} m, y {TOP} m\n0 s: x {RIGHT} m, y 0 m");
    let mut moves = [[Move::default(); 2]; 3];
    for (axes, points) in moves.iter_mut().zip(POINTS.windows(2)) {
        let (from, to) = (points[0].map(State::at), points[1].map(State::at));
        synchronise(axes, &limits, &from, &to, 0.0, 0.0)?;
    }
    let stopping = follow("with stops", &limits, &moves);
    let mut work = vec![0.0; path_size(2, 3).expect("a short path")];
    plan_path(&mut states, &mut durations, &limits, 2, 0, &mut work)?;
    path_moves(moves.as_flattened_mut(), &limits, &states, &durations, 2)?;
    let passing = follow("without stops", &limits, &moves);
    println!("{stopping:.3} s with stops, {passing:.3} s without");
    assert!(passing < stopping);
    Ok(())
}
