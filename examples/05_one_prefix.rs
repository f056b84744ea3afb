//! One word further: 6 m to go, at 7.5 m/s, with an acceleration of 2.5 m/s² at most. This is too near to stop. The plan of
//! `Bell::new`, in C `a_trajbell_gen`, breaks the limit. `Bell::fastest`, in C `atraj_bell_gen`, takes the same arguments, and its
//! plan passes the target and comes back. The same methods evaluate both plans. This program prints one setpoint in 1000.
//!
//! ```sh
//! cargo run --example 05_one_prefix
//! ```

use atraj::{Bell, Boundary, Error, Findings};

const PERIOD: f64 = 0.001; // s

fn setpoint(axis: &Bell<f64>, x: f64) -> String {
    let [p, v, a, _] = axis.state(x);
    format!("{p:.4} m, {v:.4} m/s, {a:.4} m/s^2")
}

fn judge(axis: &Bell<f64>) -> Result<&'static str, Error> {
    let found = axis.check(30.0, 2.5, 10.0)?;
    let broken = found.contains(Findings::EXCEEDS_ACCELERATION);
    Ok(["keeps the limit", "breaks the limit"][usize::from(broken)])
}

fn main() -> Result<(), Error> {
    let ends = Boundary { v0: 7.5, ..Boundary::rest_to_rest(0.0, 6.0) };
    let liba = Bell::new(30.0, 2.5, 10.0, ends)?;
    let ours = Bell::fastest(30.0, 2.5, 10.0, ends)?;
    println!("Too near to stop: 6 m to go at 7.5 m/s");
    println!("within 10 m/s, 2.5 m/s^2, 30 m/s^3");
    for tick in (0..=(ours.t / PERIOD) as u32).step_by(1000) {
        let x = f64::from(tick) * PERIOD;
        println!("{x:.3} s: {}, a_trajbell_gen {}", setpoint(&ours, x), setpoint(&liba, x));
    }
    println!("a_trajbell_gen {}, atraj_bell_gen {}", judge(&liba)?, judge(&ours)?);
    Ok(())
}
