//! Two axes pass waypoints, and an operator turns the override knob and presses the pause button. The axes stay on their path: the clock
//! of the path slows down, holds, and goes on. The path is planned within 85 % of the limits, and the clock has all of them, because braking on
//! a path takes more than the plan. This program prints one setpoint in 125 of a clock of 2 ms: positions, velocities, accelerations.
//!
//! ```sh
//! cargo run --example 20_hold
//! ```

use atraj::State;
use atraj::axes::{path_moves, path_size, plan_path};
use atraj::machine::Clock;
use atraj::online::{Error, Limits, Move};

const CYCLE: f64 = 0.002; // s
const AXES: usize = 2;
const POINTS: [[f64; AXES]; 4] = [[0.0, 0.0], [0.4, 0.3], [0.8, -0.1], [1.2, 0.2]]; // m
const SECTIONS: usize = POINTS.len() - 1;
const EVENTS: [(u32, u32); 3] = [(200, 50), (500, 0), (1000, 100)]; // when, and the knob; 0 is the button

fn main() -> Result<(), Error> {
    // Jerk, acceleration, velocity.
    let limits = [Limits::symmetric(20.0, 4.0, 1.0); AXES];
    let planned = [Limits::symmetric(0.85 * 20.0, 0.85 * 4.0, 0.85 * 1.0); AXES];
    let mut states = POINTS.concat().into_iter().map(State::at).collect::<Vec<_>>();
    let mut durations = [0.0; SECTIONS];
    let mut work = vec![0.0; path_size(AXES, SECTIONS).ok_or(Error::Axes)?];
    plan_path(&mut states, &mut durations, &planned, AXES, 0, &mut work)?;
    let mut path = [Move::default(); SECTIONS * AXES];
    path_moves(&mut path, &planned, &states, &durations, AXES)?;
    let end = path.iter().step_by(AXES).fold(0.0, |sum, axis| sum + axis.t);
    println!("Holding on a path: the knob at 50 %, the pause button, and on");
    println!("within 1 m/s, 4 m/s^2");
    let mut clock = Clock::new();
    for tick in 0.. {
        let x = f64::from(tick) * CYCLE;
        if clock.time(x) >= end {
            break;
        }
        if let Some((_, percent)) = EVENTS.iter().find(|event| event.0 == tick) {
            clock.rate(&path, &limits, x, f64::from(*percent) / 100.0)?;
            println!("{x:.3} s -> {percent} %");
        }
        if tick % 125 == 0 {
            let [[p, v, a, _], [p1, v1, a1, _]] = [0, 1].map(|i| clock.state(&path[i..], AXES, x));
            println!("{x:.3} s: {p:.4} {p1:.4} m, {v:.4} {v1:.4} m/s, {a:.4} {a1:.4} m/s^2");
        }
    }
    println!("planned for {end:.3} s");
    Ok(())
}
