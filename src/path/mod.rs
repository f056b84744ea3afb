//! Waypoints without stops: several axes pass given points at the same times, and stop nowhere unless they must. `docs/path-theory.md` has the theory.
//! `slack` says what a section can spare, `barrier` what the steps make small, `elimination` solves for one step, `steps` takes them. `start`, `rows`,
//! `curve` and `warm` find the plan before the first step. `moves` makes the motions of a planned path, and `deviation` says how far they
//! leave the straight lines between its points, and `contour` adds points where that is too far. `feed` limits the speed of all axes together.

mod barrier;
mod bend;
mod chain;
mod contour;
mod curve;
mod deviation;
mod elimination;
mod feed;
mod memory;
mod moves;
mod rows;
mod slack;
mod start;
mod steps;
mod warm;

use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::real::Real;
use crate::state::State;
use chain::{Chain, Planned, Request, total};
use steps::NewtonBudget;

pub use contour::{Contour, plan_contour};
pub use deviation::path_deviation;
pub use feed::limit_feed;
pub use moves::path_moves;

/// How many numbers [`plan_path`] and [`improve_path`] need to work with: `sections (axes (4 axes + 38) + 12) - 10 axes`.
/// `None` if there is no axis or no section, or more than 100 axes or 65,536 sections.
pub fn path_size(axes: usize, sections: usize) -> Option<usize> {
    memory::size::<2>(axes, sections)
}

/// Plans a path through waypoints: the velocities and accelerations at the waypoints, and the durations of the sections between them. No section
/// is impossible, and if no point repeats, the path is not longer than one that stops at every point.
///
/// `states` has a state for each of the `axes`, point by point: one point more than `durations` has sections. Every position is given, and the first and
/// the last state; the states between are written, and the durations, s. A start outside the limits returns within them in the first section.
/// `limits` has an entry for each axis, or for each axis section by section. `steps` bounds the work, and at most 1024 are taken; 0: as many as
/// the path needs, at most 48. A start that cannot stop before the next point, or an end that cannot be reached from the last one at rest, takes up to 8
/// times as many more. Where the steps make a path longer than it was before them, all are taken twice. `work` has [`path_size`] numbers.
///
/// [`path_moves`] makes the motions of the sections. A point whose state is given splits a path into two.
///
/// Returns [`Findings::STARTS_OUTSIDE`] if an axis starts outside its limits, and [`Findings::ENDS_LEAVING`] if an axis will unavoidably exceed
/// them after the end. [`Error::Axes`] if the lengths do not fit together; the others as for [`synchronise`](crate::axes::synchronise). On an error
/// nothing but `work` is written.
///
/// ```
/// use atraj::axes::{path_moves, path_size, plan_path};
/// use atraj::online::{Limits, Move, State};
/// let limits = [Limits::symmetric(30.0, 10.0, 5.0); 2];
/// // From (0, 0) by way of (3, 1) to (4, 5).
/// let mut states = [0.0, 0.0, 3.0, 1.0, 4.0, 5.0].map(State::at);
/// let mut durations = [0.0; 2];
/// let mut work = vec![0.0; path_size(2, 2).expect("two axes")];
/// plan_path(&mut states, &mut durations, &limits, 2, 0, &mut work)?;
/// assert!(states[2].velocity > 3.0);
/// let mut moves = [Move::default(); 4];
/// path_moves(&mut moves, &limits, &states, &durations, 2)?;
/// assert_eq!(moves[3].position(durations[1]), 5.0);
/// # Ok::<(), atraj::Error>(())
/// ```
pub fn plan_path<R: Real>(
    states: &mut [State<R>], durations: &mut [R], limits: &[Limits<R>], axes: usize, steps: u32, work: &mut [R],
) -> Result<Findings, Error> {
    let planned = plan(Request::of(states, durations, limits, axes)?, steps, work)?;
    Ok(planned.write(states, durations))
}

fn plan<'w, R: Real>(request: Request<R>, steps: u32, work: &'w mut [R]) -> Result<Planned<'w, R, 2>, Error> {
    let mut chain = Chain::of(request, work)?;
    let budget = NewtonBudget::of(steps, chain.sections);
    chain.plan(budget)?;
    chain.done()
}

/// How many numbers [`plan_path_near`] needs to work with: `sections (axes (9 axes + 60) + 13) - 22 axes`. `None`
/// if there is no axis or no section, or more than 100 axes or 32,768 sections.
pub fn path_size_near(axes: usize, sections: usize) -> Option<usize> {
    memory::size::<3>(axes, sections)
}

/// Plans a path through fly-by zones: each axis passes a waypoint within a tolerance. The path is not longer than the one through the points.
///
/// `tolerances` has a number for each axis and each point between start and end, point by point: the position is at most so far from the given
/// one, and is written too. 0: the point is exact. Points that repeat are one point, with the least of their tolerances. `work` has
/// [`path_size_near`] numbers, and `steps` bounds the work twice: for the path through the points, and from there on. Points whose zones overlap
/// take more steps than there are by default: leave some of them out. The other arguments, the findings and the errors are those of [`plan_path`];
/// [`Error::Limits`] also if a tolerance is negative, [`Error::NotFinite`] if one is infinite or not a number.
///
/// `examples/24_zones.rs` is a program.
pub fn plan_path_near<R: Real>(
    states: &mut [State<R>], durations: &mut [R], limits: &[Limits<R>], tolerances: &[R], axes: usize, steps: u32,
    work: &mut [R],
) -> Result<Findings, Error> {
    path_size_near(axes, durations.len()).filter(|&size| size <= work.len()).ok_or(Error::Axes)?;
    Error::Axes.unless(tolerances.len() == axes * (durations.len() - 1))?;
    for tolerance in tolerances {
        Error::NotFinite.unless(tolerance.is_finite())?;
        Error::Limits.unless(*tolerance >= R::ZERO)?;
    }
    let found = plan_path(states, durations, limits, axes, steps, work)?;
    let request = Request { tolerances, ..Request::of(states, durations, limits, axes)? };
    let mut chain = Chain::<R, 3>::of(request, work)?;
    let budget = NewtonBudget::of(steps, chain.sections);
    let is_shortened = chain.shorten_given(durations, budget) == Ok(true);
    if is_shortened && chain.duration() < total(durations) {
        // The path through the points stays if this one is beyond the range.
        chain.done().map(|planned| planned.write(states, durations)).ok();
    }
    Ok(found)
}

/// Improves a path that [`plan_path`] has planned, or this function. Call it as long as there is time: a path never gets longer, and is possible after
/// every call, except for rounding in the last phase of the first section.
///
/// A path may change between two calls. Drop sections that are passed. Begin with the state under way, and with what is left of the duration of
/// its section. Append points at rest, with sections of the duration 0: they are stretched until they are possible. If the states and durations
/// are impossible otherwise, the path is planned again. It takes the arguments and returns the findings and errors of [`plan_path`]; [`Error::NotFinite`] also
/// if a state between is not made of numbers, [`Error::Duration`] if a duration is negative, infinite or not a number.
pub fn improve_path<R: Real>(
    states: &mut [State<R>], durations: &mut [R], limits: &[Limits<R>], axes: usize, steps: u32, work: &mut [R],
) -> Result<Findings, Error> {
    let (mut found, mut held) = (Findings::default(), 0);
    loop {
        let (more, next) = improve_from(held, states, durations, limits, axes, steps, work)?;
        found |= more;
        if next == 0 {
            return Ok(found);
        }
        // Twice as many sections, so that few rounds are needed, but none that is new. That one is not held.
        let known = durations.iter().skip(next).take_while(|t| **t > R::ZERO).count();
        let most = (next + known).min(durations.len() - 1);
        held = next.max(most.min(2 * held));
    }
}

/// Improves the path from the section `first` on. Gives up to which section nothing changes: if no plan that is slower from the first section on
/// is possible, then what follows it is a path of its own.
fn improve_from<R: Real>(
    first: usize, states: &mut [State<R>], durations: &mut [R], limits: &[Limits<R>], axes: usize, steps: u32,
    work: &mut [R],
) -> Result<(Findings, usize), Error> {
    let whole = Request::of(states, durations, limits, axes)?;
    let zones = if whole.has_zones() { axes } else { 0 };
    let (_, states) = states.split_at_mut_checked(first * axes).ok_or(Error::Axes)?;
    let (_, durations) = durations.split_at_mut_checked(first).ok_or(Error::Axes)?;
    let (_, limits) = limits.split_at_checked(first * zones).ok_or(Error::Axes)?;
    let request = Request::of(states, durations, limits, axes)?;
    let lasts = durations.first().is_some_and(|&t| t > R::ZERO);
    let [start, next] = request.ends(0);
    let mut chain = Chain::of(Request { is_begun: lasts && start != next, ..request }, work)?;
    let budget = NewtonBudget::of(steps, chain.sections);
    if chain.improve(durations, budget, lasts)? {
        Ok((chain.done()?.write(states, durations), 0))
    } else {
        Ok((chain.findings, first + 1 + chain.place(0)))
    }
}

impl<'a, R: Real> Request<'a, R> {
    fn of(states: &'a [State<R>], durations: &[R], limits: &'a [Limits<R>], axes: usize) -> Result<Self, Error> {
        Self::of_parts(states, durations, limits, axes, &[])
    }

    fn of_parts(
        states: &'a [State<R>], durations: &[R], limits: &'a [Limits<R>], axes: usize, parts: &'a [usize],
    ) -> Result<Self, Error> {
        let sections = durations.len();
        path_size(axes, sections).ok_or(Error::Axes)?;
        let zones = parts.len().checked_sub(1).unwrap_or(sections);
        let has_limits = limits.len() == axes || limits.len() == axes * zones;
        Error::Axes.unless(states.len() == axes * (sections + 1) && has_limits)?;
        let request = Self { axes, sections, states, limits, parts, tolerances: &[], is_begun: false };
        request.check()?;
        Ok(request)
    }
}

impl<R: Real> Chain<'_, '_, R> {
    fn plan(&mut self, budget: NewtonBudget) -> Result<(), Error> {
        let passes = self.stop_or_pass()?;
        if self.sections == 1 {
            return Ok(());
        }
        let first = self.duration();
        if self.make_feasible(passes, budget)? && !self.shorten(budget, 0) {
            // Large weights led a start that cannot stop in time to turn back. With a 32nd of them the plan stays near the first one.
            let passes = self.stop_or_pass()?;
            self.make_feasible(passes, budget)?;
            self.shorten(budget, 5);
        }
        self.promise()?;
        let is_shorter = self.duration() < first;
        if !is_shorter {
            // The steps have overwritten the first plan.
            self.stop_or_pass()?;
            self.promise()?;
        }
        // One move is on the limits, where no step can end. So it must save more than the steps leave.
        let most = self.duration() - R::SIXTEENTH * R::SIXTEENTH * self.duration();
        self.keep_plan();
        if self.pass_at_once().is_none() || self.duration() >= most {
            self.swap_plans();
        }
        Ok(())
    }
}
