//! Meets a part on a conveyor, rides beside the part, and goes home at 1.6 s. At 0.4 s the belt gets faster, so the axis plans
//! again. The axis keeps a jerk of 50 m/s³, an acceleration of 5 m/s² and a velocity of 2 m/s. A controller tells its drive
//! every setpoint; this program prints one in 200.
//!
//! ```sh
//! cargo run --example meet
//! ```

use atraj::State;
use atraj::online::{Limits, Move};

const PERIOD: f64 = 0.001; // s

fn main() {
    let limits = Limits::symmetric(50.0, 5.0, 2.0);
    let home = State::at(0.0);
    // The belt does not accelerate.
    let mut part = State {
        velocity: 0.4,
        ..State::at(0.5)
    };
    let (mut now, mut axis, mut start) = (home, Move::default(), 0);
    let (mut goes_home, mut ridden) = (false, 0);
    let (mut position_step, mut velocity_step, mut acceleration_step) = (0.0, 0.0, 0.0);
    axis.meet(&limits, now, part).expect("slower than the axis");
    for tick in 0..=3000 {
        let x = f64::from(tick - start) * PERIOD;
        let before = now;
        now = if goes_home || x < axis.t {
            axis.state_at(x)
        } else {
            ridden += 1;
            part // the move has ended beside the part, and the part moves on
        };
        let grow = |step: &mut f64, change: f64| *step = step.max(change.abs());
        grow(&mut position_step, now.position - before.position);
        grow(&mut velocity_step, now.velocity - before.velocity);
        grow(
            &mut acceleration_step,
            now.acceleration - before.acceleration,
        );
        if tick % 200 == 0 {
            println!(
                "{:.1} s: part {:.4} m, axis {:.4} m, {:.4} m/s",
                f64::from(tick) * PERIOD,
                part.position,
                now.position,
                now.velocity
            );
        }
        if tick == 400 {
            part.velocity = 0.6;
            axis.meet(&limits, now, part).expect("slower than the axis");
            start = tick;
        }
        if tick == 1600 {
            axis.plan(&limits, now, home).expect("numbers");
            start = tick;
            goes_home = true;
        }
        part.position += part.velocity * PERIOD;
    }
    println!("beside the part for {:.3} s", f64::from(ridden) * PERIOD);
    println!(
        "from one setpoint to the next at most {position_step:.4} m, {velocity_step:.4} m/s, {acceleration_step:.4} m/s^2"
    );
    assert!(ridden > 0 && now.position == 0.0 && now.velocity == 0.0);
    // The limits times the period, and a rounding.
    assert!(position_step < 0.002001 && velocity_step < 0.005001 && acceleration_step < 0.050001);
}
