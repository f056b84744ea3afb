//! Several axes in the same time.

use super::axis::{Task, checked, next_of_plan, stretch, stretch_unasked, takes};
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
    let tasks = checked(axes.len(), limits, from, to)?;
    if !tasks.clone().all(|task| task.is_ordinary(until_tick)) {
        rehearse(&cycle, duration, tasks.clone())?;
    }
    let found = plan_fastest(axes, tasks.clone())?;
    let durations = axes.iter().map(|axis| axis.t);
    let slowest = durations.clone().fold(duration, R::at_least);
    // Most often all axes can arrive on the first tick, and no tick before is near.
    let first = cycle.from(slowest);
    let is_first = cycle.earlier(first, slowest, durations, |_| true) == first;
    let stretches = |(task, axis): (Task<R>, &mut Move<R>)| stretch_unasked(axis, &|| task.problem(), first);
    if !(is_first && tasks.clone().zip(axes.iter_mut()).all(stretches)) {
        if is_first {
            plan_fastest(axes, tasks.clone())?;
        }
        let t = common_duration(&cycle, slowest, tasks.clone().zip(axes.iter()))?;
        tasks.zip(axes.iter_mut()).try_for_each(|(task, axis)| stretch(axis, &|| task.problem(), t))?;
    }
    Ok(axes.iter().fold(found, |found, axis| found | axis.turn_findings()))
}

/// Makes the fastest plan of each axis, and finds what is outside the limits.
#[inline(never)] // for its size
fn plan_fastest<'a, R: Real + 'a>(
    axes: &mut [Move<R>], tasks: impl Iterator<Item = Task<'a, R>>,
) -> Result<Findings, Error> {
    tasks.zip(axes).try_fold(Findings::default(), |found, (task, axis)| {
        let problem = task.problem();
        problem.write(axis, &problem.fastest()).map(|()| found | problem.outside())
    })
}

/// The shortest duration from `slowest` on that all axes can take. Each axis has made its fastest plan.
fn common_duration<'a, R: Real + 'a, M: Borrow<Move<R>>>(
    cycle: &Cycle<R>, slowest: R, planned: impl ExactSizeIterator<Item = (Task<'a, R>, M)> + Clone,
) -> Result<R, Error> {
    let durations = planned.clone().map(|(_, axis)| axis.borrow().t);
    let next = |t, (task, axis): (Task<R>, M)| next_of_plan(axis.borrow(), &|| task.problem(), t);
    let next_of_all = |t: R| planned.clone().fold(t, |latest: R, axis| latest.at_least(next(t, axis)));
    let t = cycle.until_possible(planned.len(), slowest, next_of_all)?;
    let take = |t| planned.clone().all(|(task, axis)| takes(axis.borrow(), &task.problem(), t));
    Ok(cycle.earlier(t, slowest, durations, take))
}

/// Plans extreme axes one by one, to see whether all of them can be planned. So no axis is written on an error.
#[cold]
fn rehearse<'a, R: Real + 'a>(
    cycle: &Cycle<R>, duration: R, mut tasks: impl ExactSizeIterator<Item = Task<'a, R>> + Clone,
) -> Result<(), Error> {
    let t = shortest_duration(cycle, duration, tasks.clone())?;
    tasks.try_for_each(|task| stretch(&mut fastest(task)?, &|| task.problem(), t))
}

/// The duration of the axes, which are planned one by one, and not written.
pub(super) fn shortest_duration<'a, R: Real + 'a>(
    cycle: &Cycle<R>, duration: R, tasks: impl ExactSizeIterator<Item = Task<'a, R>> + Clone,
) -> Result<R, Error> {
    let slowest = tasks.clone().try_fold(duration, |slowest, task| Ok(slowest.at_least(fastest(task)?.t)))?;
    common_duration(cycle, slowest, tasks.map(|task| (task, fastest(task).unwrap_or_default())))
}

#[inline(never)] // for its stack
pub(super) fn fastest<R: Real>(task: Task<R>) -> Result<Move<R>, Error> {
    let mut axis = Move::default();
    let problem = task.problem();
    problem.write(&mut axis, &problem.fastest()).map(|()| axis)
}
