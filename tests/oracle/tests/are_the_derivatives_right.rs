//! Are the derivatives of a border, by which a path takes its steps, those of the reference solver's differences in 80 bits?
//!
//! The border is no part of the interface, so its source is compiled here.

#![allow(dead_code, missing_docs, unexpected_cfgs, unused_imports)]

#[path = "../../../src/findings.rs"]
mod findings;
#[path = "../../../src/limits.rs"]
mod limits;
#[path = "../../../src/real/mod.rs"]
mod real;
#[path = "../../../src/state.rs"]
mod state;

mod roots {
    /// The larger root of `x² + 2 p x + q`.
    pub fn larger_root<R: crate::real::Real>(p: R, q: R) -> R {
        (p * p - q).sqrt() - p
    }
}

#[path = "../../../src/interval"]
mod interval {
    pub mod border;
    pub mod derivatives;
    pub mod profile;
    pub mod ramp;
    pub mod rounding;
}

use interval::border::Border;
use interval::derivatives::Derivatives;
use limits::Limits;
use oracle::judge::solver::Motion;
use support::Random;

/// The slack of the upper or the lower border with its derivatives, if a motion has this duration.
fn derivatives(limits: [f64; 6], [v0, a0, v1, a1]: [f64; 4], t: f64, lower: bool) -> Option<([f64; 5], [f64; 15])> {
    let [vmax, vmin, amax, amin, jmax, jmin] = limits;
    let upper = Border::between([[v0, a0], [v1, a1]], &Limits { vmax, vmin, amax, amin, jmax, jmin });
    let (border, sign) = if lower { (upper.mirrored(), -1.0) } else { (upper, 1.0) };
    let Derivatives { first, second } = border.derivatives(&border.farthest_of_feasible_ends(t)?, sign);
    Some((first, second))
}

/// No hold, the top holds, the bottom holds, both hold; then cruises: no ramp holds, the second one, the first one, both.
const SHAPES: usize = 8;
const COUNT: usize = 2_000; // borders of each shape

/// The largest errors in each shape, as parts of the largest derivative, with so many borders.
fn errors(
    derivatives: impl Fn([f64; 6], [f64; 4], f64, bool) -> Option<([f64; 5], [f64; 15])>,
) -> [(usize, f64, f64); SHAPES] {
    let mut random = Random::seeded(1);
    let mut errors = [(0, 0.0, 0.0); SHAPES];
    while errors.iter().any(|(count, ..)| *count < COUNT) {
        let limits = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0].map(|x| x * random.magnitude(-0.5, 0.5));
        let [vmax, vmin, amax, amin, jmax, jmin] = limits;
        let [v0, v1] = [0; 2].map(|_| random.between(vmin, vmax));
        let [a0, a1] = [0; 2].map(|_| random.between(amin, amax));
        // The velocity was within its limits before the end.
        let before = v1 - a1 * a1 / 2.0 / if a1 > 0.0 { jmax } else { jmin };
        if before > vmax || before < vmin {
            continue;
        }
        let t = random.magnitude(-0.5, 1.0);
        let lower = random.below(2) == 1;
        let motion = Motion { limits, start: [0.0, v0, a0], target: [0.0, v1, a1], frame: 0.0 };
        let Some((shape, first, second)) = motion.derivatives(t, lower) else { continue };
        // Near a fall of no length the higher derivatives are so large that differences err.
        let largest = |all: &[f64]| all.iter().fold(0.1, |most: f64, x| most.max(x.abs()));
        if largest(&second) > 30.0 {
            continue;
        }
        let (ours, twice) = derivatives(limits, [v0, a0, v1, a1], t, lower).expect("a motion");
        let error = |ours: &[f64], theirs: &[f64]| {
            ours.iter().zip(theirs).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max) / largest(theirs)
        };
        let (count, most, most_twice) = &mut errors[shape];
        *count += 1;
        *most = error(&ours, &first).max(*most);
        *most_twice = error(&twice, &second).max(*most_twice);
    }
    errors
}

#[test]
fn derivatives_are_those_of_differences() {
    for (shape, (count, first, second)) in errors(derivatives).into_iter().enumerate() {
        assert!(first < 1e-9 && second < 1e-7, "shape {shape}: {count} borders, {first:.1e} {second:.1e}");
    }
}

#[test]
fn a_wrong_derivative_is_seen() {
    let faulty = |limits, ends, t, lower| {
        let (first, mut second) = derivatives(limits, ends, t, lower)?;
        second[7] += 1e-5;
        Some((first, second))
    };
    assert!(errors(faulty).iter().all(|(_, _, second)| *second > 1e-7));
}
