//! Drives two stepper motors together. Both have 80 steps for a millimetre. `Steps::next` returns the time of the next step of each motor, and the earlier
//! one is next: a timer would be set to it. The motors move by 40 mm and by 12.5 mm in the same time. This program prints one pulse in 400, and where
//! both motors are then.
//!
//! ```sh
//! cargo run --example 22_two_steppers
//! ```

use atraj::State;
use atraj::axes::synchronise;
use atraj::machine::Steps;
use atraj::online::{Error, Limits, Move};

const STEP: f64 = 0.0125; // mm

fn main() -> Result<(), Error> {
    let limits = [Limits::symmetric(20_000.0, 1_000.0, 100.0); 2]; // jerk, acceleration, velocity
    let (from, to) = ([State::at(0.0); 2], [40.0, -12.5].map(State::at)); // mm
    let mut axes = [Move::default(); 2];
    synchronise(&mut axes, &limits, &from, &to, 0.0, 0.0)?;
    let mut steps = [Steps::new(&axes[0], -STEP / 2.0, STEP)?, Steps::new(&axes[1], -STEP / 2.0, STEP)?];
    let mut next = [0, 1].map(|i| steps[i].next(&axes[i]));
    let (mut places, mut last) = ([0; 2], [None; 2]);
    let (mut shortest, mut pulses) = (f64::INFINITY, 0); // s
    println!("Pulses for two stepper motors: 40 mm and -12.5 mm in the same time");
    let is_first = |next: &[Option<atraj::machine::Step<f64>>; 2]| match next {
        [Some(x), Some(y)] => x.time <= y.time,
        [x, _] => x.is_some(),
    };
    loop {
        let i = usize::from(!is_first(&next));
        let Some(step) = next[i] else {
            break;
        };
        places[i] += step.direction;
        if let Some(last) = last[i] {
            shortest = f64::min(shortest, step.time - last);
        }
        last[i] = Some(step.time);
        pulses += 1;
        if pulses % 400 == 0 {
            let [x, y] = places.map(|place| f64::from(place) * STEP);
            println!("{:.6} s: {x:.4} {y:.4} mm", step.time);
        }
        next[i] = steps[i].next(&axes[i]);
    }
    let [x, y] = places;
    println!("{x} and {y} steps in {:.3} s, up to {:.0} steps/s", axes[0].t, 1.0 / shortest);
    assert_eq!(places, [3200, -1000]);
    Ok(())
}
