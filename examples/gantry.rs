//! Moves the three axes of a gantry, each with limits of its own, twice: so that they arrive together, and on a straight line. The
//! clock of the drives ticks every millisecond, and both moves end on a tick. The z axis is the fastest and has the shortest way, so
//! it must not hurry.
//!
//! ```sh
//! cargo run --example gantry
//! ```

use atraj::State;
use atraj::axes::{line, synchronise};
use atraj::online::{Limits, Move};

const CYCLE: f64 = 0.001; // s
const FROM: [f64; 3] = [0.0, 0.0, 0.1]; // m
const TO: [f64; 3] = [0.8, 0.5, 0.3];

/// How far the gantry is off the straight line from its start to its end.
fn off_line(p: [f64; 3]) -> f64 {
    let (mut along, mut length, mut off) = (0.0, 0.0, 0.0);
    for i in 0..3 {
        let way = TO[i] - FROM[i];
        along += (p[i] - FROM[i]) * way;
        length += way * way;
    }
    for i in 0..3 {
        off += (p[i] - FROM[i] - along / length * (TO[i] - FROM[i])).powi(2);
    }
    f64::sqrt(off)
}

/// Prints a move. The result is how far the gantry leaves the line.
fn follow(name: &str, axes: &[Move<f64>; 3]) -> f64 {
    let t = axes[0].t;
    let ticks = (t / CYCLE).round() as u32;
    let at = |tick| axes.map(|axis| axis.position(f64::from(tick) * CYCLE));
    let mut farthest = 0.0;
    println!("{name}: {t:.3} s");
    for tick in 0..=ticks {
        let p @ [x, y, z] = at(tick);
        farthest = f64::max(farthest, off_line(p));
        if tick % 200 == 0 {
            let now = f64::from(tick) * CYCLE;
            println!("  {now:.1} s: x {x:.4} m, y {y:.4} m, z {z:.4} m");
        }
    }
    assert!(axes.iter().all(|axis| axis.t == t) && at(ticks) == TO);
    println!("  off the line by at most {farthest:.4} m");
    farthest
}

fn main() {
    // Jerk, acceleration, velocity.
    let limits = [
        Limits::symmetric(20.0, 4.0, 1.0),
        Limits::symmetric(10.0, 2.0, 0.8),
        Limits::symmetric(80.0, 8.0, 2.0),
    ];
    let (from, to) = (FROM.map(State::at), TO.map(State::at));
    let mut axes = [Move::default(); 3];
    synchronise(&mut axes, &limits, &from, &to, 0.0, CYCLE).expect("numbers");
    let beside = follow("synchronised", &axes);
    line(&mut axes, &limits, &from, &to, 0.0, CYCLE).expect("numbers");
    let on_line = follow("on a straight line", &axes);
    assert!(beside < 1.0 && on_line < 1e-15); // a rounding
}
