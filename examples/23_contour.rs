//! Follows the contour of a part, whose corners are the rows of a CSV file, and leaves the lines between them by 0.02 mm at most. The planner
//! adds points where the path would leave a line too far. This program prints one setpoint in 10 of a clock of 1 ms: the positions and the
//! speed; and how far the path leaves the lines.
//!
//! ```sh
//! cargo run --example 23_contour examples/23_contour.csv
//! ```

use atraj::State;
use atraj::axes::{Contour, path_deviation, path_size, plan_contour};
use atraj::online::{Limits, Move};
use std::error::Error;

const CYCLE: f64 = 0.001; // s
const ROOM: usize = 200;

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).unwrap_or_else(|| "examples/23_contour.csv".into());
    let text = std::fs::read_to_string(file)?;
    let positions = text.lines().skip(1).flat_map(|corner| corner.split(',')); // mm
    let mut states =
        positions.map(|position| Ok(State::at(position.parse()?))).collect::<Result<Vec<_>, Box<dyn Error>>>()?;
    let mut places = vec![0; states.len() / 2];
    states.resize(2 * (ROOM + 1), State::at(0.0));
    let limits = [Limits::symmetric(60000.0, 3000.0, 100.0); 2];
    let (mut moves, mut durations) = (vec![Move::default(); 2 * ROOM], vec![0.0; ROOM]);
    let mut work = vec![0.0; path_size(2, ROOM).ok_or("too long")?];
    let path = Contour { moves: &mut moves, states: &mut states, durations: &mut durations, places: &mut places };
    plan_contour(path, &limits, 0.02, 2, 0, &mut work)?;
    let sections = places[places.len() - 1];
    println!("Contour of a part: its corners come from a CSV file, and the colour is the speed");
    println!("each axis keeps 100 mm/s, 3000 mm/s^2 and 60000 mm/s^3\ncontour:");
    let (mut start, mut tick) = (0.0, 0);
    for (axes, duration) in moves.chunks(2).zip(&durations).take(sections) {
        while f64::from(tick) * CYCLE < start + duration {
            if tick % 10 == 0 {
                let now = f64::from(tick) * CYCLE;
                let [x, y] = [0, 1].map(|axis| axes[axis].state_at(now - start));
                let speed = (x.velocity * x.velocity + y.velocity * y.velocity).sqrt();
                println!("{now:.3} s: {:.3} {:.3} mm, {speed:.2} mm/s", x.position, y.position);
            }
            tick += 1;
        }
        start += duration;
    }
    let end = &states[2 * sections..];
    println!("{start:.3} s: {:.3} {:.3} mm, 0.00 mm/s", end[0].position, end[1].position);
    let deviation = path_deviation(&moves[..2 * sections], 2);
    println!("{} corners, {} points: at most {deviation:.4} mm from the lines", places.len(), sections + 1);
    assert!(deviation <= 0.02);
    Ok(())
}
