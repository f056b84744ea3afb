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
//! cargo run --example relink
//! ```

use atraj::{Bell, Boundary};

fn main() {
    let ends = Boundary {
        p0: 0.0,
        p1: 10.0,
        v0: 1.0,
        v1: 0.0,
    };
    let axis = Bell::new(30.0, 10.0, 10.0, ends).expect("the limits allow no such move");
    let x = axis.t / 3.0;
    println!("duration     {:.17} s", axis.t);
    println!("position     {:.17} m", axis.position(x));
    println!("velocity     {:.17} m/s", axis.velocity(x));
    println!("acceleration {:.17} m/s^2", axis.acceleration(x));
    println!("jerk         {:.17} m/s^3", axis.jerk(x));
}
