//! Does the search without cruise, which passes over plain rounds, give the bits of the literal search?
//!
//! The moves are made so that a round of the search is a near tie, or so that it lies near a bound of the short cut.

use std::array;
use support::{Family, Implementation, Ours, Random, Real, reference, test_both_reals};

const MOVES: u32 = 300_000;

trait Range: Real {
    /// Powers of two that bring an argument to an end of the range, or to a bound of the short cut.
    const EXTREMES: [i32; 6];
    const UNITS: i32; // the highest power of two that a unit of time and length changes by
}
impl Range for f32 {
    const EXTREMES: [i32; 6] = [-140, -110, -22, 23, 46, 100];
    const UNITS: i32 = 75;
}
impl Range for f64 {
    const EXTREMES: [i32; 6] = [-1060, -900, -51, 52, 104, 900];
    const UNITS: i32 = 550;
}

/// Any significand, a small fraction or a power of two, up to `2^exponent`.
fn magnitude(random: &mut Random, exponent: i32) -> f64 {
    let scale = 2f64.powi(random.below(2 * exponent as usize) as i32 - exponent);
    match random.below(4) {
        0 => (1 + random.below(16)) as f64 / 4.0,
        1 => scale,
        _ => random.between(1.0, 2.0) * scale,
    }
}

fn velocity(random: &mut Random, vm: f64) -> f64 {
    match random.below(4) {
        0 => 0.0,
        1 => vm * (random.below(9) as f64 / 4.0 - 1.0),
        _ => vm * random.between(-1.0, 1.0),
    }
}

/// `jm am vm p0 p1 v0 v1` of a near tie: at one of the trial accelerations of the search, the distance differs from the
/// distance of a tie by a relative difference from 1 down to nothing.
fn near_tie(random: &mut Random) -> [f64; 7] {
    let jm = magnitude(random, 8);
    let am = magnitude(random, 8);
    let vm = magnitude(random, 8);
    let v0 = velocity(random, vm);
    let v1 = match random.below(4) {
        0 => v0,
        1 => v0 * (1.0 + magnitude(random, 40)),
        _ => velocity(random, vm),
    };
    let trial = am * (1 + random.below(32)) as f64 / 2f64.powi(5 + random.below(6) as i32);
    let (s, w, k) = (v0 + v1, (v0 - v1).abs(), trial * trial / jm);
    let twice_p_trial = if random.one_in(2) { w * s - w * k } else { w * s + k * (4.0 * k + 4.0 * s + 3.0 * w) };
    let off = 2f64.powi(-(random.below(60) as i32)) * random.pick(&[-1.0, 0.0, 1.0]);
    let p = twice_p_trial / (2.0 * trial) * (1.0 + off);
    // A short way does not cruise anyway. A longer one needs a high `vm` for that.
    let vm = if random.one_in(2) { vm } else { 1e6 * vm };
    let p0 = random.pick(&[0.0, 0.0, 1.0, -p]);
    [jm, am, vm, p0, p0 + p, v0, v1]
}

/// A near tie, some of them moved to an end of the range, made backward or given a special argument.
fn arguments<R: Range>(random: &mut Random) -> [R; 7] {
    let exponents = exponents::<R>(random);
    let near_tie = near_tie(random);
    let mut arguments = array::from_fn(|i| scaled(near_tie[i], exponents[i]));
    if random.one_in(16) {
        arguments[random.below(7)] = random.pick(&R::SPECIAL);
    }
    if random.one_in(4) {
        for argument in &mut arguments[3..] {
            *argument = -*argument;
        }
    }
    arguments
}

fn exponents<R: Range>(random: &mut Random) -> [i32; 7] {
    let extreme = random.pick(&R::EXTREMES) + random.below(12) as i32;
    let unit = random.below(2 * R::UNITS as usize) as i32 - R::UNITS;
    let odd = random.below(7);
    match random.below(6) {
        // Another unit of length and time. Squares of velocities come near overflow or underflow, `am` does not.
        0 => [-1, 0, 1, 2, 2, 1, 1].map(|power| power * unit),
        1 => [extreme; 7],
        2 => array::from_fn(|index| if index == odd { extreme } else { 0 }),
        _ => [0; 7],
    }
}

/// `x * 2^exponent`, in two steps, as the factor alone may be out of range.
fn scaled<R: Real>(x: f64, exponent: i32) -> R {
    let half = exponent / 2;
    R::of(x * 2f64.powi(half) * 2f64.powi(exponent - half))
}

fn same_bits_as_the_literal_search<R: Range>() {
    let mut random = Random(1);
    let mut long = 0;
    for _ in 0..MOVES {
        let arguments = arguments::<R>(&mut random);
        let mut ours = [R::ZERO; Family::Bell.fields().len()];
        let mut literal = ours;
        let duration = Ours.plan(Family::Bell, &arguments, &mut ours);
        let plan = reference::plan(&arguments, &mut literal);
        long += u32::from(plan.rounds > 3);

        let written = Family::Bell.fields().iter().zip(ours.into_iter().zip(literal));
        for (name, (ours, literal)) in written.chain([(&"duration", (duration, plan.duration))]) {
            let (shown, wanted) = (ours.show(), literal.show());
            assert!(ours.same(literal), "{name}: {shown} is not {wanted} of {arguments:?}, {} rounds", plan.rounds);
        }
    }
    assert!(long > MOVES / 10, "only {long} searches longer than 3 rounds");
}

test_both_reals!(same_bits_as_the_literal_search);
