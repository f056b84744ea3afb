//! Are the examples of Biagotti & Melchiorri, *Trajectory Planning for Automatic Machines and Robots*, section 3.4, met to the digits printed there?

use approx::assert_abs_diff_eq;
use atraj::{Bell, Boundary};

/// All four examples move from 0 to 10 with a jerk of 30 and an acceleration of 10 at most.
fn example(velocity: f64, v0: f64, v1: f64) -> Bell<f64> {
    Bell::new(30.0, 10.0, velocity, Boundary { p0: 0.0, p1: 10.0, v0, v1 }).expect("the book gives a solution")
}

/// Each number of a plan, as the book prints it.
#[track_caller]
fn assert_printed(numbers: &[(f64, f64)]) {
    for &(number, printed) in numbers {
        assert_abs_diff_eq!(number, printed, epsilon = 5e-5);
    }
}

#[test]
fn example_3_9() {
    let Bell { ta, tv, td, taj, tdj, t, .. } = example(5.0, 1.0, 0.0);
    assert_printed(&[(ta, 0.7333), (tv, 1.1433), (td, 0.8333), (taj, 0.3333), (tdj, 0.3333)]);
    assert_abs_diff_eq!(t, 2.71, epsilon = 5e-3);
}

#[test]
fn example_3_10() {
    let Bell { ta, tv, td, taj, t, vm, .. } = example(10.0, 1.0, 0.0);
    assert_printed(&[(ta, 1.0747), (td, 1.1747), (taj, 0.3333), (t, 2.2494)]);
    assert_eq!(tv, 0.0);
    assert_abs_diff_eq!(vm, 8.4136, epsilon = 5e-4);
}

/// The book stops its search at 1.9384 s. The original searches on and finds a shorter move.
#[test]
fn example_3_11() {
    assert_printed(&[(example(10.0, 7.0, 0.0).t, 1.9331)]);
}

#[test]
fn example_3_12() {
    let Bell { ta, tv, td, tdj, t, .. } = example(10.0, 7.5, 0.0);
    assert_eq!([ta, tv], [0.0; 2]);
    assert_printed(&[(td, 2.6667), (tdj, 0.0973), (t, 2.6667)]);
}
