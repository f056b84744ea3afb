//! Are the examples of Biagotti & Melchiorri, *Trajectory Planning for Automatic Machines and Robots*, section 3.4, met to the digits printed there?

use approx::assert_abs_diff_eq;
use atraj::{Bell, Boundary};

/// All four examples move from 0 to 10 with a jerk of 30 and an acceleration of 10 at most.
fn example(velocity: f64, v0: f64, v1: f64) -> Bell<f64> {
    let boundary = Boundary { p0: 0.0, p1: 10.0, v0, v1 };
    Bell::new(30.0, 10.0, velocity, boundary).expect("the book gives a solution")
}

#[test]
fn example_3_9() {
    let bell = example(5.0, 1.0, 0.0);
    assert_abs_diff_eq!(bell.ta, 0.7333, epsilon = 5e-5);
    assert_abs_diff_eq!(bell.tv, 1.1433, epsilon = 5e-5);
    assert_abs_diff_eq!(bell.td, 0.8333, epsilon = 5e-5);
    assert_abs_diff_eq!(bell.taj, 0.3333, epsilon = 5e-5);
    assert_abs_diff_eq!(bell.tdj, 0.3333, epsilon = 5e-5);
    assert_abs_diff_eq!(bell.t, 2.71, epsilon = 5e-3);
}

#[test]
fn example_3_10() {
    let bell = example(10.0, 1.0, 0.0);
    assert_abs_diff_eq!(bell.ta, 1.0747, epsilon = 5e-5);
    assert_eq!(bell.tv, 0.0);
    assert_abs_diff_eq!(bell.td, 1.1747, epsilon = 5e-5);
    assert_abs_diff_eq!(bell.taj, 0.3333, epsilon = 5e-5);
    assert_abs_diff_eq!(bell.vm, 8.4136, epsilon = 5e-4);
    assert_abs_diff_eq!(bell.t, 2.2494, epsilon = 5e-5);
}

#[test]
fn example_3_11() {
    // The book stops its search at 1.9384 s. The original searches on and finds a shorter move.
    let bell = example(10.0, 7.0, 0.0);
    assert_abs_diff_eq!(bell.t, 1.9331, epsilon = 5e-5);
    assert!(bell.t < 1.9384);
}

#[test]
fn example_3_12() {
    let bell = example(10.0, 7.5, 0.0);
    assert_eq!(bell.ta, 0.0);
    assert_eq!(bell.tv, 0.0);
    assert_abs_diff_eq!(bell.td, 2.6667, epsilon = 5e-5);
    assert_abs_diff_eq!(bell.tdj, 0.0973, epsilon = 5e-5);
    assert_abs_diff_eq!(bell.t, 2.6667, epsilon = 5e-5);
}
