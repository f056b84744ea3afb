//! Prints the bits of a few moves, as move.c and move.cpp do. The argument is the real type.

use atraj::{Bell, Boundary, Poly7, Real, Trap};
use std::ops::{Div, Neg};

fn main() {
    match std::env::args().nth(1).as_deref() {
        Some("double") => moves::<f64>(),
        Some("float") => moves::<f32>(),
        other => panic!("{other:?} is not a real type"),
    }
}

fn moves<R>()
where
    R: Real + Copy + Default + From<u8> + Into<f64> + Div<Output = R> + Neg<Output = R>,
{
    let r = R::from;
    let boundary = |p1, v0| Boundary { p0: r(0), p1: r(p1), v0: r(v0), v1: r(0) };

    let bell = Bell::new(r(30), r(10), r(5), boundary(1, 0)).expect("this move exists");
    show("bell duration", bell.t);
    show("bell position", bell.position(r(3) / r(10)));
    show("bell jerk", bell.jerk(r(3) / r(10)));

    let trap = Trap::new(r(5), r(4), -r(3), boundary(50, 0)).expect("this move exists");
    show("trap duration", trap.t);
    show("trap velocity", trap.velocity(r(7) / r(10)));

    let poly = Poly7::new(r(3), boundary(10, 1), [r(0); 2], [r(0); 2]).expect("this move exists");
    show("poly7 acceleration", poly.acceleration(r(9) / r(10)));
}

fn show(name: &str, value: impl Into<f64>) {
    println!("{name} {:016x}", value.into().to_bits());
}
