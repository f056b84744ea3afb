//! What is wrong with the steps of a motor, in 80 bits: `c/steps.c`.

use support::online::{largest, numbers_of_phase};
use support::prelude::*;

unsafe extern "C" {
    fn steps_wrong(
        phases: *const [f64; 6], count: i32, lines: &[f64; 2], first: i64, times: *const f64, directions: *const i32,
        n: i64, samples: i32, roundings: &[f64; 2],
    ) -> i32;
}

const SAMPLES: i32 = 8; // how often the judge looks at each phase, besides the ends and the turns

/// A rounding of a time is one of the whole duration. A position has those of its phases, of the line and of the way in the phase.
const ROUNDINGS: f64 = 8.0;

pub fn all<R: Real>(of: &Move<R>, mut steps: Steps<R>) -> Vec<Step<R>> {
    std::iter::from_fn(|| steps.next(of)).collect()
}

pub fn wrong<R: Real>(of: &Move<R>, lines: [R; 2], first: i32, steps: &[Step<R>]) -> Option<&'static str> {
    // The end too.
    let phases: Vec<_> = of.phase[..=of.phases().len()].iter().map(|p| numbers_of_phase(p).map(R::widen)).collect();
    let times: Vec<f64> = steps.iter().map(|step| step.time.widen()).collect();
    let directions: Vec<i32> = steps.iter().map(|step| step.direction).collect();
    let [far, fast, _] = largest(of.extremes());
    let [offset, step] = lines.map(R::widen);
    let (t, rounding) = (of.t.widen(), ROUNDINGS * R::MACHINE_EPSILON.widen());
    let roundings = [rounding * t, rounding * (far + offset.abs() + fast * t)];
    let (count, n) = (phases.len() as i32, times.len() as i64);
    let (phases, times, directions) = (phases.as_ptr(), times.as_ptr(), directions.as_ptr());
    let lines = [offset, step];
    // SAFETY: each pointer has as many values as the count behind it says.
    match unsafe { steps_wrong(phases, count, &lines, first.into(), times, directions, n, SAMPLES, &roundings) } {
        0 => None,
        1 => Some("a step at another place"),
        2 => Some("a step before the one before"),
        3 => Some("the axis is not where the motor is"),
        _ => Some("a step after the end"),
    }
}
