//! A load hangs on an axis and swings with 1.2 Hz and 1 % of the critical damping. This program moves the axis by 0.5 m and computes what the load does, with
//! a shaper and without one. The shaper keeps all limits of the move, and takes half a period longer. This program prints one setpoint in 2500 of 0.1 ms.
//!
//! ```sh
//! cargo run --example 21_swing
//! ```

use atraj::State;
use atraj::machine::{Shaper, ShaperKind};
use atraj::online::{Error, Limits, Move};
use std::f64::consts::PI;

const CYCLE: f64 = 0.0001; // s

/// How far the load is ahead of the axis, m, and how fast it gets farther, m/s.
#[derive(Default)]
struct Load {
    p: f64,
    v: f64,
}

impl Load {
    /// The load swings for a cycle, while the axis has this acceleration.
    fn swing(&mut self, acceleration: f64) {
        let (w, damping) = (2.0 * PI * 1.2, 0.01); // 1/s
        self.v += CYCLE * (-acceleration - 2.0 * damping * w * self.v - w * w * self.p);
        self.p += CYCLE * self.v;
    }
}

fn main() -> Result<(), Error> {
    let limits = Limits::symmetric(40.0, 4.0, 1.0); // jerk, acceleration, velocity
    let mut axis = Move::default();
    axis.plan(&limits, State::at(0.0), State::at(0.5))?; // m
    let shaper = Shaper::new(ShaperKind::Zv, 1.2, 0.01)?;
    let end = axis.t + shaper.duration();
    let (mut shaped, mut plain) = (Load::default(), Load::default());
    let (mut most_shaped, mut most_plain) = (0.0, 0.0); // m
    println!("A load that swings: with a shaper, and without one");
    println!("within 1 m/s, 4 m/s^2");
    for tick in 0..=25_000 {
        let x = f64::from(tick) * CYCLE;
        let State { position: p, velocity: v, acceleration: a } = shaper.state(&axis, x);
        if tick % 2500 == 0 {
            let (load, other) = (p + shaped.p, axis.position(x) + plain.p);
            print!("{x:.3} s: {p:.4} m, {v:.4} m/s, {a:.4} m/s^2, ");
            println!("load {load:.4} m, load without a shaper {other:.4} m");
        }
        shaped.swing(a);
        plain.swing(axis.acceleration(x));
        if x > end {
            most_shaped = f64::max(most_shaped, shaped.p.abs());
            most_plain = f64::max(most_plain, plain.p.abs());
        }
    }
    println!("{:.3} s without a shaper, then the load swings by {:.1} mm", axis.t, 1000.0 * most_plain);
    println!("{end:.3} s with a shaper, then the load swings by {:.1} mm", 1000.0 * most_shaped);
    assert!(most_shaped < most_plain / 100.0);
    Ok(())
}
