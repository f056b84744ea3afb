//! Several axes in the same time.

use super::axis::{Axis, checked, is_ordinary, next_duration, stretch};
use super::cycle::Cycle;
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::online::Move;
use crate::online::problem::Problem;
use crate::real::Real;
use crate::state::State;

/// Plans all axes for the same duration: the shortest one that is possible for each, is at least `duration`, and is a multiple of `cycle`
/// (0: any), s. An axis whose fastest move takes as long makes its fastest move. From rest to rest an axis with more time makes its fastest
/// move in slow motion. Any other axis with more time cruises at one velocity, where this is possible.
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
    let until_tick = duration + cycle;
    let cycle = Cycle::new(duration, cycle)?;
    let ends = checked(axes.len(), limits, from, to)?;
    if !ends.clone().all(|ends| is_ordinary(ends, until_tick)) {
        rehearse(&cycle, duration, ends.clone())?;
    }
    let mut found = Findings::default();
    let mut slowest = duration;
    for ((limits, (&from, &to)), axis) in ends.clone().zip(axes.iter_mut()) {
        let problem = Problem::new(limits, from, to);
        problem.write(axis, &problem.fastest())?;
        found |= problem.outside();
        slowest = slowest.at_least(axis.t);
    }
    let t = common_duration(&cycle, slowest, ends.clone())?;
    for (ends, axis) in ends.zip(axes) {
        stretch(axis, t, ends)?;
        found |= Findings::OVERSHOOTS.when(axis.overshoots());
    }
    Ok(found)
}

/// Plans extreme axes one by one, to see whether all of them can be planned. So no axis is written on an error.
#[cold]
fn rehearse<'a, R: Real + 'a>(
    cycle: &Cycle<R>,
    duration: R,
    axes: impl Iterator<Item = Axis<'a, R>> + Clone,
) -> Result<(), Error> {
    let mut axis = Move::default();
    let mut slowest = duration;
    for (limits, (&from, &to)) in axes.clone() {
        axis.plan(limits, from, to)?;
        slowest = slowest.at_least(axis.t);
    }
    let t = common_duration(cycle, slowest, axes.clone())?;
    for ends @ (limits, (&from, &to)) in axes {
        axis.plan(limits, from, to)?;
        stretch(&mut axis, t, ends)?;
    }
    Ok(())
}

/// The shortest duration that is possible for every axis, after the fastest plans, s.
fn common_duration<'a, R: Real + 'a>(
    cycle: &Cycle<R>,
    slowest: R,
    axes: impl Iterator<Item = Axis<'a, R>> + Clone,
) -> Result<R, Error> {
    cycle.until_possible(axes.clone().count(), slowest, |t| {
        let next = axes.clone().map(|ends| next_duration(ends, t));
        next.fold(t, R::at_least)
    })
}
