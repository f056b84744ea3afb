//! Prints an octagon: points, path, clock, shaper and steps work together, as in the firmware of a printer. Two axes and an extruder stay within 0.1 mm of
//! the lines between the points. A pause button holds them on their path and lets them go on. The shapers leave the frame at rest, and the extruder is
//! ahead by its pressure advance. Each motor gets its steps, with a least time between two of them. This program prints one tick in 100 of
//! 1 ms: where the nozzle is, and how fast it and the filament are.
//!
//! ```sh
//! cargo run --example 25_printer
//! ```

use atraj::State;
use atraj::axes::{Contour, path_size, plan_contour};
use atraj::machine::{Clock, Shaper, ShaperKind, ShaperStream, StepStream};
use atraj::online::{Error, Limits, Move};

const TICK: f64 = 0.001; // s
const AXES: usize = 3;
const SECTIONS: usize = 8;
const ROOM: usize = 128;
#[rustfmt::skip]
const CORNERS: [[f64; 2]; SECTIONS + 1] = [
    [5.0, 0.0], [45.0, 0.0], [50.0, 5.0], [50.0, 25.0], [45.0, 30.0], [5.0, 30.0], [0.0, 25.0], [0.0, 5.0], [5.0, 0.0],
]; // mm
const STEPS_PER_MM: [f64; AXES] = [80.0, 80.0, 400.0];

fn main() -> Result<(), Error> {
    let limits = [Limits::symmetric(100_000.0, 3_000.0, 100.0); AXES]; // mm
    let planned = [Limits::symmetric(80_000.0, 2_400.0, 80.0); AXES]; // 20 % are the reserve of the clock
    let mut states = [State::at(0.0); AXES * (ROOM + 1)];
    let mut filament = 0.0;
    for (k, [x, y]) in CORNERS.into_iter().enumerate() {
        let [before_x, before_y] = CORNERS[k.saturating_sub(1)];
        filament += 0.05 * f64::hypot(x - before_x, y - before_y);
        for (i, position) in [x, y, filament].into_iter().enumerate() {
            states[AXES * k + i] = State::at(position);
        }
    }
    let (mut moves, mut durations, mut places) = ([Move::default(); AXES * ROOM], [0.0; ROOM], [0; SECTIONS + 1]);
    let mut work = vec![0.0; path_size(AXES, ROOM).expect("three axes")];
    let contour = Contour { moves: &mut moves, states: &mut states, durations: &mut durations, places: &mut places };
    plan_contour(contour, &planned, 0.1, AXES, 0, &mut work)?;
    let moves = &moves[..AXES * places[SECTIONS]];
    let shapers =
        [Shaper::new(ShaperKind::Mzv, 45.0, 0.1)?, Shaper::new(ShaperKind::Zv, 38.0, 0.1)?, Shaper::smooth(0.02)?];
    let mut lines = shapers.map(|shaper| vec![0.0; shaper.size(TICK).expect("a short shaper")]);
    let mut streams = Vec::new();
    let mut motors = Vec::new();
    for i in 0..AXES {
        streams.push(ShaperStream::new(&shapers[i], TICK, states[i], &mut lines[i])?);
        let mut motor = StepStream::new(1.0 / STEPS_PER_MM[i], TICK, states[i])?;
        motor.wait(2e-6, 20e-6)?;
        motors.push(motor);
    }
    streams[2].advance(0.04)?;
    println!("Printing an octagon: points, path, clock, shaper and steps");
    println!("nozzle:");
    let mut clock = Clock::new();
    let mut pulses = [0; AXES];
    for tick in 0..=3000 {
        let x = f64::from(tick) * TICK;
        let mut now = [State::default(); AXES];
        if tick == 600 || tick == 1200 {
            let (rate, what) = if tick == 600 { (0.0, "pause") } else { (1.0, "go on") };
            clock.rate(moves, &limits, x, rate)?;
            println!("{x:.3} s -> {what}");
        }
        for i in 0..AXES {
            let [position, velocity, acceleration, _] = clock.state(&moves[i..], AXES, x);
            let shaped = streams[i].tick(State { position, velocity, acceleration }, &mut lines[i])?;
            motors[i].tick(shaped)?;
            while let Some(step) = motors[i].next() {
                pulses[i] += step.direction; // a pulse `step.time` after the last tick
            }
            now[i] = shaped;
        }
        if tick % 100 == 0 {
            let [nozzle_x, nozzle_y, filament] = now;
            println!(
                "{x:.3} s: {:.3} {:.3} mm, {:.2} {:.2} mm/s, filament {:.2} mm/s",
                nozzle_x.position, nozzle_y.position, nozzle_x.velocity, nozzle_y.velocity, filament.velocity
            );
        }
    }
    let ([x, y, e], at) = (pulses, [0, 1, 2].map(|i| motors[i].count()));
    println!("{} sections; pulses {x} {y} {e}, motors at {} {} {}", places[SECTIONS], at[0], at[1], at[2]);
    assert_eq!(pulses, [0, 0, (filament * STEPS_PER_MM[2]).round() as i32]);
    Ok(())
}
