//! Several axes in the same time.

use super::axis::{Axis, checked, is_ordinary, may_slip, next_of_plan, stretch};
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
    for (ends, axis) in ends.clone().zip(axes.iter_mut()) {
        let problem = problem(ends);
        problem.write(axis, &problem.fastest())?;
        found |= problem.outside();
        slowest = slowest.at_least(axis.t);
    }
    let planned = ends.clone().zip(axes.iter());
    let t = cycle.until_possible(
        planned.clone().count(),
        slowest,
        |t| {
            let next = |(ends, axis)| next_of_plan(axis, &|| problem(ends), t);
            planned.clone().map(next).fold(t, R::at_least)
        },
        |t, is_detour| {
            // An axis that would have to hurry is asked first. It says no at once.
            let hurry = planned.clone().filter(|(_, axis)| axis.t > t);
            let others = planned.clone().filter(|(_, axis)| axis.t <= t);
            let mut axes = hurry.chain(others);
            axes.all(|(ends, axis)| may_slip(axis, &problem(ends), t, is_detour))
        },
    )?;
    for (ends, axis) in ends.zip(axes) {
        stretch(axis, &|| problem(ends), t)?;
        found |= axis.turn_findings();
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
    let planned = |(limits, (&from, &to)): Axis<R>| {
        let mut axis = Move::default();
        axis.plan(limits, from, to).map(|_| axis)
    };
    let mut slowest = duration;
    for ends in axes.clone() {
        slowest = slowest.at_least(planned(ends)?.t);
    }
    let t = cycle.until_possible(
        axes.clone().count(),
        slowest,
        |t| {
            let next =
                |ends| planned(ends).map_or(t, |axis| next_of_plan(&axis, &|| problem(ends), t));
            axes.clone().map(next).fold(t, R::at_least)
        },
        |t, is_detour| {
            axes.clone().all(|ends| {
                planned(ends).is_ok_and(|axis| may_slip(&axis, &problem(ends), t, is_detour))
            })
        },
    )?;
    for ends in axes {
        stretch(&mut planned(ends)?, &|| problem(ends), t)?;
    }
    Ok(())
}

fn problem<R: Real>((limits, (&from, &to)): Axis<R>) -> Problem<R> {
    Problem::new(limits, from, to)
}
