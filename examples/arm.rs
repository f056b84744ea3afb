//! An arm with six axes follows way points and stops at each. The axes have limits of their own, arrive at a way point together, and
//! stretch their moves to the slowest axis. The clock of the drives ticks every 4 ms, and every move ends on a tick.
//!
//! ```sh
//! cargo run --example arm
//! ```

use atraj::State;
use atraj::axes::synchronise;
use atraj::online::{Limits, Move};

const CYCLE: f64 = 0.004; // s
const POINTS: [[f64; 6]; 5] = [
    [0.0, -90.0, 90.0, 0.0, 0.0, 0.0], // degrees
    [30.0, -60.0, 70.0, 0.0, -40.0, 90.0],
    [30.0, -50.0, 75.0, 0.0, -55.0, 90.0], // down
    [-45.0, -70.0, 80.0, 20.0, -30.0, -90.0],
    [0.0, -90.0, 90.0, 0.0, 0.0, 0.0], // home
];

fn main() {
    let large = Limits::symmetric(4000.0, 500.0, 120.0);
    let small = Limits::symmetric(9000.0, 1000.0, 250.0);
    let limits = [large, large, large, small, small, small];
    let mut axes = [Move::default(); 6];
    let mut start = 0.0;
    for (leg, points) in POINTS.windows(2).enumerate() {
        let (from, to) = (points[0].map(State::at), points[1].map(State::at));
        synchronise(&mut axes, &limits, &from, &to, 0.0, CYCLE).expect("numbers");
        let t = axes[0].t;
        let ticks = (t / CYCLE).round() as u32;
        println!(
            "way point {} after {:.3} s, {ticks} ticks",
            leg + 1,
            start + t
        );
        for quarter in 1..=4 {
            let x = f64::from(ticks * quarter / 4) * CYCLE;
            print!("  {:.3} s:", start + x);
            for axis in &axes {
                print!(" {:7.2}", axis.position(x));
            }
            println!();
        }
        let ends = axes.map(|axis| axis.state_at(f64::from(ticks) * CYCLE));
        assert!(axes.iter().all(|axis| axis.t == t) && ends == to);
        start += t;
    }
}
