//! Gives a moving axis a new target, behind it. The axis brakes, turns round and arrives at rest; its velocity never jumps.
//! A controller asks for a setpoint every millisecond; this program prints one in 500.
//!
//! ```sh
//! cargo run --example retarget
//! ```

use atraj::State;
use atraj::claraty::{Target, Trajectory};

const PERIOD: f64 = 0.001; // s

fn main() {
    // To 10 m at 2 m/s, speeding up and braking at 4 m/s².
    let far = Target {
        position: 10.0,
        velocity: 2.0,
        acceleration: 4.0,
        deceleration: 4.0,
    };
    let mut axis = Trajectory::default();
    let (mut point, mut change, mut tick) = (State::default(), 0.0, 0);
    let mut now = 0.0; // the caller reads the clock, and tells every method the time
    axis.set(far.into(), now).expect("numbers in range");
    axis.start(now);
    while axis.is_started() {
        let before = point.velocity;
        if tick == 2000 {
            let position = 1.0;
            axis.set(Target { position, ..far }.into(), now)
                .expect("numbers in range");
            axis.start(now);
        }
        point = axis.setpoint(now);
        change = f64::max(change, (point.velocity - before).abs());
        if tick % 500 == 0 {
            let time = f64::from(tick) * PERIOD;
            println!(
                "{time:.1} s: {:.4} m, {:.4} m/s",
                point.position, point.velocity
            );
        }
        now += PERIOD;
        tick += 1;
    }
    let position = point.position;
    println!(
        "at rest at {position:.4} m; the velocity changed by at most {change:.4} m/s per period"
    );
    assert!(position == 1.0 && point.velocity == 0.0 && change < 0.0041);
}
