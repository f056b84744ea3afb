//! Several axes in the same time.

use super::axis::{Axis, checked, is_ordinary, next_of_plan, problem, stretch, takes};
use super::cycle::Cycle;
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::online::Move;
use crate::real::Real;
use crate::state::State;
use core::borrow::Borrow;

/// Plans all axes for the same duration: the shortest one that is possible for each, is at least `duration`, and is a multiple of `cycle`
/// (0: any), s. An axis whose fastest move takes as long makes its fastest move. From rest to rest an axis with more time makes its fastest
/// move in slow motion. Any other axis with more time cruises at one velocity, where this is possible.
///
/// An error of any axis is returned, and then no axis is written.
pub fn synchronise<R: Real>(
    axes: &mut [Move<R>], limits: &[Limits<R>], from: &[State<R>], to: &[State<R>], duration: R, cycle: R,
) -> Result<Findings, Error> {
    let until_tick = duration + cycle;
    let cycle = Cycle::new(duration, cycle)?;
    let ends = checked(axes.len(), limits, from, to)?;
    if !ends.clone().all(|ends| is_ordinary(ends, until_tick)) {
        rehearse(&cycle, duration, ends.clone())?;
    }
    let mut found = Findings::default();
    for (ends, axis) in ends.clone().zip(axes.iter_mut()) {
        let problem = problem(ends);
        problem.write(axis, &problem.fastest())?;
        found |= problem.outside();
    }
    let t = common_duration(&cycle, duration, ends.clone().zip(axes.iter()))?;
    for (ends, axis) in ends.zip(axes) {
        stretch(axis, &|| problem(ends), t)?;
        found |= axis.turn_findings();
    }
    Ok(found)
}

/// The shortest duration that all axes can take. Each axis has made its fastest plan.
fn common_duration<'a, R: Real + 'a, M: Borrow<Move<R>>>(
    cycle: &Cycle<R>, duration: R, planned: impl Iterator<Item = (Axis<'a, R>, M)> + Clone,
) -> Result<R, Error> {
    let durations = planned.clone().map(|(_, axis)| axis.borrow().t);
    let slowest = durations.clone().fold(duration, R::at_least);
    let t = cycle.until_possible(planned.clone().count(), slowest, |t| {
        let next = |(ends, axis): (_, M)| next_of_plan(axis.borrow(), &|| problem(ends), t);
        planned.clone().map(next).fold(t, R::at_least)
    })?;
    Ok(cycle.earlier(t, slowest, durations, |t| {
        // Axes that are too slow first: they fail fast.
        for is_slow in [true, false] {
            for (ends, axis) in planned.clone() {
                let axis = axis.borrow();
                if (axis.t > t) == is_slow && !takes(axis, &problem(ends), t) {
                    return false;
                }
            }
        }
        true
    }))
}

/// Plans extreme axes one by one, to see whether all of them can be planned. So no axis is written on an error.
#[cold]
fn rehearse<'a, R: Real + 'a>(
    cycle: &Cycle<R>, duration: R, axes: impl Iterator<Item = Axis<'a, R>> + Clone,
) -> Result<(), Error> {
    let planned = |ends: Axis<R>| {
        let mut axis = Move::default();
        let problem = problem(ends);
        problem.write(&mut axis, &problem.fastest()).map(|()| axis)
    };
    for ends in axes.clone() {
        planned(ends)?;
    }
    let t = common_duration(cycle, duration, axes.clone().map(|ends| (ends, planned(ends).unwrap_or_default())))?;
    for ends in axes {
        stretch(&mut planned(ends)?, &|| problem(ends), t)?;
    }
    Ok(())
}
