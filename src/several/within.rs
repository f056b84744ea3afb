//! Several axes in the same time, each between two positions.
//!
//! A motion that cruises stays between the positions between which the fastest one stays: see `docs/planner.md`, "Between two positions". So
//! an axis with time to spare leaves them in a blend at most, or where its fastest move turns at a position.

use super::axis::{Task, checked, next_duration, stretch, takes};
use super::cycle::Cycle;
use super::sync::{fastest, shortest_duration};
use crate::findings::{Error, Findings};
use crate::interval::rounding::of_formula;
use crate::limits::Limits;
use crate::online::turn::{Turns, free};
use crate::online::{Move, are_in_order};
use crate::real::Real;
use crate::state::State;

/// How often the delay doubles until every axis has time to stop on its way: the duration is at most a 4,096th of this delay, or twice the
/// least delay, too long.
const DOUBLINGS: u32 = 12;

/// Plans all axes for the same duration, as [`synchronise`](super::synchronise) does, and lets each of them stay between two positions until
/// its end, up to 128 ulps. `positions` are the lowest position of each axis and the highest ones. An infinite position is no limit.
///
/// An axis that would leave its positions on a slower way makes its fastest move and waits, or it stops, waits and goes, or it is slower
/// between its turns at the positions. Where none is possible, all axes take longer.
///
/// [`Error::Position`] if no move of an axis stays between its positions, as [`Move::within`] says. It returns the other findings and errors of
/// [`synchronise`](super::synchronise) and [`Move::within`]. On an error no axis is written.
///
/// ```
/// use atraj::axes::synchronise_within;
/// use atraj::online::{Limits, Move, State};
/// let limits = [Limits::symmetric(30.0, 10.0, 5.0); 2];
/// let (from, to) = ([State::at(0.0); 2], [State::at(10.0), State::at(-1.0)]);
/// let mut axes = [Move::default(); 2];
/// synchronise_within(&mut axes, &limits, &from, &to, [&[0.0, -1.0], &[10.0, 1.0]], 0.0, 0.0)?;
/// assert_eq!(axes[0].t, axes[1].t);
/// # Ok::<(), atraj::Error>(())
/// ```
pub fn synchronise_within<R: Real>(
    axes: &mut [Move<R>], limits: &[Limits<R>], from: &[State<R>], to: &[State<R>], positions: [&[R]; 2], duration: R,
    cycle: R,
) -> Result<Findings, Error> {
    let cycle = Cycle::new(duration, cycle)?;
    let tasks = checked(axes.len(), limits, from, to)?;
    let [lowest, highest] = positions;
    Error::Axes.unless(lowest.len() == axes.len() && highest.len() == axes.len())?;
    let bounds = lowest.iter().zip(highest);
    bounds.clone().try_for_each(|(&lowest, &highest)| are_in_order(lowest, highest))?;
    let within = tasks.clone().zip(bounds).map(|(task, (&lowest, &highest))| Within { task, lowest, highest });
    let free = shortest_duration(&cycle, duration, tasks)?;
    // In the next tick of a loop its plan may have a smaller rounding error. So half of it is left, if it can be.
    let t = match duration_inside(&cycle, free, R::HALF, within.clone()) {
        Err(Error::Position) => duration_inside(&cycle, free, R::ONE, within.clone()),
        found => found,
    }?;
    let mut found = Findings::default();
    for (within, axis) in within.zip(axes) {
        within.plan(axis, t, R::ONE)?;
        found |= within.task.problem().findings(axis);
    }
    Ok(found)
}

/// Whether a plan of the duration `t`, which is possible, keeps each axis between its positions, up to a part of its rounding error.
#[inline(never)] // for its stack
fn all_inside<'a, R: Real + 'a>(t: R, part: R, mut axes: impl Iterator<Item = Within<'a, R>>) -> Result<bool, Error> {
    let mut axis = Move::default();
    match axes.try_for_each(|within| within.plan(&mut axis, t, part)) {
        Err(Error::Position) => Ok(false),
        planned => planned.map(|()| true),
    }
}

/// A duration from `free` on in which every axis can stay between its positions, up to a part of the rounding error of its plan, s. It is `free`
/// or nearly the shortest one.
fn duration_inside<'a, R: Real + 'a>(
    cycle: &Cycle<R>, free: R, part: R, axes: impl ExactSizeIterator<Item = Within<'a, R>> + Clone,
) -> Result<R, Error> {
    if all_inside(free, part, axes.clone())? {
        return Ok(free);
    }
    let slowest = axes.clone().try_fold(free, |slowest, axis| Ok(slowest.at_least(axis.shortest()?)))?;
    let t = after_delay(cycle, slowest, part, axes.clone())?;
    // The delay is coarse. So an axis may have a shorter duration that all can take.
    let durations = axes.clone().map(|axis| axis.shortest().unwrap_or(t));
    Ok(cycle.earlier(t, slowest, durations, |t| {
        axes.clone().all(|axis| axis.takes(t)) && all_inside(t, part, axes.clone()) == Ok(true)
    }))
}

/// The duration after the first delay of `slowest` with which every axis can stay between its positions, s: none, the least one, or one that doubles.
fn after_delay<'a, R: Real + 'a>(
    cycle: &Cycle<R>, slowest: R, part: R, axes: impl ExactSizeIterator<Item = Within<'a, R>> + Clone,
) -> Result<R, Error> {
    let next = |t: R| axes.clone().map(|axis| next_duration(&axis.task.problem(), t)).fold(t, R::at_least);
    let mut delay = R::ZERO;
    for _ in 0..=DOUBLINGS + 1 {
        let t = cycle.until_possible(axes.len(), slowest + delay, next)?;
        if all_inside(t, part, axes.clone())? {
            return Ok(t);
        }
        delay = if delay > R::ZERO { delay + delay } else { least_delay(slowest, axes.clone())? };
    }
    Err(Error::Position)
}

/// The first delay to try, s. After all doublings every axis has time to stop on its way.
fn least_delay<'a, R: Real + 'a>(shortest: R, axes: impl Iterator<Item = Within<'a, R>>) -> Result<R, Error> {
    let mut latest = shortest;
    for axis in axes {
        latest = latest.at_least(axis.with_a_stop()?);
    }
    Ok((latest - shortest + of_formula(latest)) / R::from_index(1 << DOUBLINGS))
}

#[derive(Clone, Copy)]
struct Within<'a, R> {
    task: Task<'a, R>,
    lowest: R,
    highest: R,
}

impl<R: Real> Within<'_, R> {
    /// The duration of the fastest move, s.
    #[inline(never)] // for its stack
    fn shortest(&self) -> Result<R, Error> {
        let Task { limits, from: &from, to: &to } = self.task;
        let mut axis = Move::default();
        axis.within(limits, from, to, self.lowest, self.highest).map(|_| axis.t)
    }

    /// Whether the axis can take the duration `t`, if it may leave the positions.
    fn takes(&self, t: R) -> bool {
        fastest(self.task).is_ok_and(|plan| takes(&plan, &self.task.problem(), t))
    }

    /// Plans the move of the duration `t`, which is possible. [`Error::Position`] if none is found between the positions, up to a part of its rounding error.
    fn plan(&self, axis: &mut Move<R>, t: R, part: R) -> Result<(), Error> {
        let Task { limits, from: &from, to: &to } = self.task;
        axis.plan(limits, from, to)?;
        stretch(axis, &|| self.task.problem(), t)?;
        // A plan that leaves them by a rounding error now may leave them by more in the next tick of a loop. So one that waits or turns is better.
        if axis.turns_outside(self.lowest, self.highest, R::SIXTEENTH * axis.rounding()) {
            let mut inside = Move::default();
            if self.plan_wait(&mut inside, t).or_else(|_| self.plan_between_turns(&mut inside, t)).is_ok() {
                *axis = inside;
            }
        }
        Error::Position.unless(!axis.leaves(self.lowest, self.highest, part))
    }

    /// Plans the move that waits. [`Error::Position`] if it has no time to wait, or leaves the positions.
    #[cold]
    fn plan_wait(&self, axis: &mut Move<R>, t: R) -> Result<(), Error> {
        let mut after = Move::default();
        self.plan_around_wait([axis, &mut after])?;
        let until = t - after.t;
        Error::Position.unless(axis.t <= until)?;
        axis.wait_until(until);
        Error::Position.unless(axis.t >= until)?; // else no phase is left for the wait
        axis.append(&after)?;
        axis.end_at(t);
        Error::Position.unless(!axis.leaves(self.lowest, self.highest, R::ONE))
    }

    /// Plans the move of the duration `t` that is slower between its turns. [`Error::Position`] if none stays between the positions.
    #[cold]
    fn plan_between_turns(&self, axis: &mut Move<R>, t: R) -> Result<(), Error> {
        let Task { limits, from: &from, to: &to } = self.task;
        let turns = Turns::of(limits, from, to, [self.lowest, self.highest])?;
        for part in [R::SIXTEENTH, R::ONE] {
            for turns in Turns::ways(&turns) {
                if self.turn(axis, turns, t).is_ok() && !axis.leaves(self.lowest, self.highest, part) {
                    return Ok(());
                }
            }
        }
        Err(Error::Position)
    }

    #[inline(never)] // for its stack
    fn turn(&self, axis: &mut Move<R>, turns: [&[State<R>]; 2], t: R) -> Result<(), Error> {
        let (limits, [from, to]) = (self.task.limits, free(turns));
        let task = Task { limits, from: &from, to: &to };
        let mut between = Move::default();
        between.plan(limits, from, to)?;
        axis.turn(limits, turns, &between)?;
        let left = t - (axis.t - between.t);
        Error::Position.unless(takes(&between, &task.problem(), left))?;
        stretch(&mut between, &|| task.problem(), left)?;
        axis.turn(limits, turns, &between)?;
        axis.end_at(t);
        Ok(())
    }

    /// Plans the moves before and after a wait: at the target, or where the fastest stop ends.
    fn plan_around_wait(&self, [before, after]: [&mut Move<R>; 2]) -> Result<(), Error> {
        let Task { limits, from: &from, to: &to } = self.task;
        if to.is_at_rest() {
            before.within(limits, from, to, self.lowest, self.highest)?;
            after.stay(to);
        } else {
            before.stop_within(limits, from, [self.lowest, self.highest])?;
            after.within(limits, State::at(before.end().position), to, self.lowest, self.highest)?;
        }
        Ok(())
    }

    /// The duration of the moves before and after a wait, s.
    #[cold]
    fn with_a_stop(&self) -> Result<R, Error> {
        let (mut before, mut after) = (Move::default(), Move::default());
        self.plan_around_wait([&mut before, &mut after]).map(|()| before.t + after.t)
    }
}
