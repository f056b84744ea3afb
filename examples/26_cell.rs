//! A cell of two axes: the main loop plans, and the interrupt ticks. The axes move on a line. An operator presses the pause button, goes on at
//! half the speed, sends the axes elsewhere in mid-motion, and opens the door. Then they go home. A plan takes over four ticks after the call.
//! Here one loop is main loop and interrupt. This program prints one setpoint in 125 of a clock of 2 ms: positions, velocities, accelerations.
//!
//! ```sh
//! cargo run --example 26_cell
//! ```

use atraj::State;
use atraj::machine::{Group, GroupPlanner, Tick};
use atraj::online::{Error, Limits, Move};

const CYCLE: f64 = 0.002; // s
const AXES: usize = 2;
const LEAD: u32 = 4;

fn command(cell: &mut GroupPlanner<f64>, tick: u32) -> Result<(), Error> {
    // Jerk, acceleration, velocity.
    let limits = [Limits::symmetric(20.0, 4.0, 1.0); AXES];
    let planned = [Limits::symmetric(0.85 * 20.0, 0.85 * 4.0, 0.85 * 1.0); AXES];
    let [part, bin, home] = [[0.8, 0.4], [0.2, 0.5], [0.0, 0.0]].map(|positions| positions.map(State::at)); // m
    let (what, done) = match tick {
        0 => ("line to the part", cell.line(&planned, &part, LEAD)),
        250 => ("feed hold", cell.rate(&limits, 0.0, LEAD)),
        600 => ("override 50 %", cell.rate(&limits, 0.5, LEAD)),
        900 => ("to the bin", cell.sync(&planned, &bin, LEAD)),
        1000 => ("stop", cell.stop(&limits, LEAD)),
        1500 => ("line home", cell.line(&planned, &home, LEAD)),
        _ => return Ok(()),
    };
    println!("{:.3} s -> {what}", f64::from(tick) * CYCLE);
    done.map(|_| ())
}

fn main() -> Result<(), Error> {
    let (mut states, mut room, mut now) = ([State::at(0.0); AXES], [Move::default(); 3 * AXES], [State::at(0.0); AXES]);
    let mut cell = Group::new(CYCLE, &mut states, &mut room)?;
    let (mut planner, mut ticker) = cell.split();
    println!("Working in a cell: hold, override, retarget, stop");
    println!("within 1 m/s, 4 m/s^2");
    let (mut tick, mut event) = (0, Tick::default());
    while tick < 1500 || !event.ends {
        event = ticker.tick(&mut now); // the interrupt
        command(&mut planner, tick)?; // the main loop
        if tick % 125 == 0 {
            let [
                State { position: p, velocity: v, acceleration: a },
                State { position: p1, velocity: v1, acceleration: a1 },
            ] = now;
            println!("{:.3} s: {p:.4} {p1:.4} m, {v:.4} {v1:.4} m/s, {a:.4} {a1:.4} m/s^2", f64::from(tick) * CYCLE);
        }
        tick += 1;
    }
    println!("home at {:.4} {:.4} m", now[0].position, now[1].position);
    Ok(())
}
