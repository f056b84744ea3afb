//! A liba program, moved to this crate. It prints every digit, and every digit is the same with either crate.
//!
//! In `Cargo.toml`, `atraj` takes the place of `liba`:
//!
//! ```toml
//! [dependencies]
//! atraj = { path = "…" } # was: liba = "0.1.15"
//! ```
//!
//! In the program, a constructor takes the place of `new` and `gen`, and the methods have whole words for names:
//!
//! | with `liba` | with `atraj` |
//! |---|---|
//! | `let mut axis = liba::trajbell::new();` `axis.gen(jm, am, vm, p0, p1, v0, v1)` | `Bell::new(jm, am, vm, Boundary { p0, p1, v0, v1 })` |
//! | `axis.pos(x)` `vel` `acc` `jer` | `axis.position(x)` `velocity` `acceleration` `jerk` |
//!
//! ```sh
//! cargo run --example 01_relink
//! ```

use atraj::{Bell, Boundary, Error};

fn main() -> Result<(), Error> {
    let ends = Boundary { v0: 1.0, ..Boundary::rest_to_rest(0.0, 10.0) };
    let axis = Bell::new(30.0, 10.0, 10.0, ends)?;
    println!("Relinked: a double-S without cruise, every digit as from liba");
    println!("within 10 m/s, 10 m/s^2, 30 m/s^3");
    // Of 1000 setpoints, one in 250 is printed.
    for i in (0..=1000).step_by(250) {
        let x = axis.t / 1000.0 * f64::from(i);
        let [p, v, a, j] = axis.state(x);
        println!("{x:.17} s: {p:.17} m, {v:.17} m/s, {a:.17} m/s^2, {j:.17} m/s^3");
    }
    Ok(())
}
