//! Several axes in the same time.

use super::axis::{checked, shortest, write};
use super::blend::next_duration;
use super::cycle::Cycle;
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::online::Move;
use crate::online::problem::Problem;
use crate::real::Real;
use crate::state::State;

/// Plans all axes for the same duration: the shortest one that is possible for each, is at least `duration`, and is a multiple of `cycle`
/// (0: any), s. An axis whose fastest move takes as long makes its fastest move. An axis with more time moves slowly: from rest to rest no
/// faster than twice its mean velocity, if its jerks are equal.
///
/// An error of any axis is returned, and then no axis is written.
pub fn synchronise<R: Real>(
    axes: &mut [Move<R>],
    limits: &[Limits<R>],
    from: &[State<R>],
    to: &[State<R>],
    duration: R,
    cycle: R,
) -> Result<Findings, Error> {
    let cycle = Cycle::new(duration, cycle)?;
    let ends = checked(axes.len(), limits, from, to)?;
    let problems = || {
        ends.clone()
            .map(|(limits, (&from, &to))| Problem::new(limits, from, to))
    };

    let mut slowest = duration;
    for problem in problems() {
        slowest = slowest.at_least(shortest(&problem)?);
    }
    let t = cycle.until_possible(axes.len(), slowest, |t| {
        problems().fold(t, |latest, problem| {
            latest.at_least(next_duration(&problem, t))
        })
    })?;
    let mut found = Findings::default();
    for (problem, axis) in problems().zip(axes) {
        write(&problem, axis, t)?;
        found |= problem.findings(axis);
    }
    Ok(found)
}
