//! Two axes follow points that arrive while they move, 20 each second; the drives take a setpoint every millisecond. The axes pass the
//! points without stops, and 6 points are known at the start. The plan ends at rest at the newest point, so the axes can stop if no point
//! follows. A new point is appended, and 8 steps improve the plan after the current section. This program prints one setpoint in 50:
//! the positions, then the velocities and accelerations.
//!
//! ```sh
//! cargo run --example 14_horizon
//! ```

use atraj::State;
use atraj::axes::{improve_path, path_moves, path_size, plan_path};
use atraj::online::{Error, Limits, Move};

const CYCLE: f64 = 0.001; // s
const POINTS: u32 = 60;
const AHEAD: u32 = 6;
const PERIOD: u32 = 50;
const STEPS: u32 = 8;

/// A point of a slalom: 20 mm further, and 40 mm to each side.
fn slalom(k: u32) -> [State<f64>; 2] {
    let u = f64::from(k % 20) / 20.0;
    let side = if k / 20 % 2 == 1 { -0.16 } else { 0.16 };
    [0.02 * f64::from(k), side * u * (1.0 - u)].map(State::at)
}

/// The motions of the first section of the plan.
fn begin(limits: &[Limits<f64>], states: &[State<f64>], durations: &[f64]) -> Result<[Move<f64>; 2], Error> {
    let mut axes = [Move::default(); 2];
    path_moves(&mut axes, limits, &states[..4], &durations[..1], 2)?;
    Ok(axes)
}

fn main() -> Result<(), Error> {
    // y has time to spare: a lower jerk keeps its acceleration smooth.
    let limits = [100.0, 20.0].map(|jerk| Limits::symmetric(jerk, 8.0, 0.42));
    println!("Receding horizon: two axes pass points that arrive while they move");
    println!("within 0.42 m/s, 8 m/s^2");
    // The plan. Its first section is under way.
    let mut states: Vec<_> = (0..=AHEAD).flat_map(slalom).collect();
    let mut durations = vec![0.0; AHEAD as usize];
    let mut work = vec![0.0; path_size(2, 12).expect("a short path")];
    plan_path(&mut states, &mut durations, &limits, 2, 0, &mut work)?;
    let mut axes = begin(&limits, &states, &durations)?;
    let (mut start, mut tick, mut fed) = (0.0, 0, AHEAD + 1);
    let (mut longest, mut slowest) = (0, f64::INFINITY);
    while !durations.is_empty() {
        let now = f64::from(tick) * CYCLE;
        let [x, y] = axes.map(|axis| axis.state_at(now - start));
        for State { velocity, acceleration, .. } in [x, y] {
            assert!(velocity.abs() <= 0.42 + 1e-9 && acceleration.abs() <= 8.0 + 1e-9); // a rounding
        }
        if tick % 50 == 0 {
            let positions = format!("{:.4} {:.4} m", x.position, y.position);
            let velocities = format!("{:.4} {:.4} m/s", x.velocity, y.velocity);
            let accelerations = format!("{:.4} {:.4} m/s^2", x.acceleration, y.acceleration);
            println!("{now:.3} s: {positions}, {velocities}, {accelerations}");
        }
        if tick > 300 && fed <= POINTS {
            slowest = slowest.min(x.velocity);
        }
        if tick % PERIOD == PERIOD - 1 && fed <= POINTS {
            states.extend(slalom(fed));
            durations.push(0.0);
            fed += 1;
            improve_path(&mut states[2..], &mut durations[1..], &limits, 2, STEPS, &mut work)?;
            longest = longest.max(durations.len());
        }
        if now + CYCLE >= start + axes[0].t {
            start += axes[0].t;
            states.drain(..2);
            durations.remove(0);
            if !durations.is_empty() {
                axes = begin(&limits, &states, &durations)?;
            }
        }
        tick += 1;
    }
    println!("at most {longest} sections ahead, at least {slowest:.2} m/s along the slalom");
    assert!(slowest > 0.3 && states == slalom(POINTS));
    Ok(())
}
