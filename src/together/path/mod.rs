//! Way points without stops: several axes pass given points at the same times, and stop nowhere unless they must.
//!
//! `docs/path.md` has the theory. `border` says how far an axis gets in a section, `barrier` what the steps make small, `elimination` solves for
//! one step, `steps` takes them. `start` and `warm` find the plan before the first step.

mod barrier;
mod bend;
mod border;
mod bounds;
mod chain;
mod elimination;
mod memory;
mod start;
mod steps;
mod warm;

use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::real::Real;
use crate::state::State;
use chain::{Chain, Request};
use steps::Steps;

/// How many numbers [`plan_path`] and [`improve_path`] need to work with: `axes (28 sections - 12) + sections (sections + 12)`. `None` if there is no axis or no
/// section, or more than 4,096 of them.
pub fn path_size(axes: usize, sections: usize) -> Option<usize> {
    memory::size(axes, sections)
}

/// Plans a path through way points: the velocities and accelerations at the way points, and the durations of the sections between them. No section
/// is impossible, and the path is not longer than one that stops at every point.
///
/// `states` has a state for each axis, point by point: one point more than `durations` has sections. Every position is given, and the first and
/// the last state; the states between are written, and the durations, s. A start outside the limits comes inside in the first section.
/// `limits` has an entry for each axis, or for each axis section by section. `steps` bounds the work, and at most 1024 are taken; 0: as many as
/// the path needs, at most 48. `work` has [`path_size`] numbers, whatever they are.
///
/// [`synchronise`](crate::axes::synchronise) makes the motions of section `k`, with `durations[k]` as the least duration. A point whose state is
/// given splits a path into two.
///
/// Returns [`Findings::STARTS_OUTSIDE`] if an axis starts outside its limits, and [`Findings::ENDS_LEAVING`] if an axis is bound to leave them
/// after the end. [`Error::Axes`] if the lengths do not fit together; [`Error::Target`] also if points repeat at an end at which an axis is bound
/// to leave its limits; the others as for [`synchronise`](crate::axes::synchronise). On an error nothing but `work` is written.
///
/// ```
/// use atraj::axes::{path_size, plan_path, synchronise};
/// use atraj::online::{Limits, Move, State};
/// let limits = [Limits::symmetric(30.0, 10.0, 5.0); 2];
/// // From (0, 0) by way of (3, 1) to (4, 5).
/// let mut states = [0.0, 0.0, 3.0, 1.0, 4.0, 5.0].map(State::at);
/// let mut durations = [0.0; 2];
/// let mut work = vec![0.0; path_size(2, 2).expect("two axes")];
/// plan_path(&mut states, &mut durations, &limits, 0, &mut work)?;
/// assert!(states[2].velocity > 3.0);
/// let mut section = [Move::default(); 2];
/// let [from, by, to] = [&states[0..2], &states[2..4], &states[4..6]];
/// synchronise(&mut section, &limits, from, by, durations[0], 0.0)?;
/// synchronise(&mut section, &limits, by, to, durations[1], 0.0)?;
/// assert_eq!(section[1].position(durations[1]), 5.0);
/// # Ok::<(), atraj::Error>(())
/// ```
pub fn plan_path<R: Real>(
    states: &mut [State<R>],
    durations: &mut [R],
    limits: &[Limits<R>],
    steps: u32,
    work: &mut [R],
) -> Result<Findings, Error> {
    let request = Request::of(states, durations, limits)?;
    let mut chain = Chain::of(request, work)?;
    let steps = Steps::of(steps, chain.sections);
    chain.plan(steps)?;
    Ok(chain.done()?.write(states, durations))
}

/// Improves a path that [`plan_path`] has planned, or this function. Call it as long as there is time: a path gets no longer, and is possible after
/// every call.
///
/// A path may change between two calls. Drop sections that are passed. Begin with the state under way, and with what is left of the duration of
/// its section. Append points at rest, with sections of the duration 0: they are stretched until they are possible. If the states and durations
/// are impossible otherwise, the path is planned anew. It takes the arguments and returns the findings and errors of [`plan_path`]; [`Error::NotFinite`] also
/// if a state between is not made of numbers, [`Error::Duration`] if a duration is negative, infinite or not a number.
pub fn improve_path<R: Real>(
    states: &mut [State<R>],
    durations: &mut [R],
    limits: &[Limits<R>],
    steps: u32,
    work: &mut [R],
) -> Result<Findings, Error> {
    let request = Request::of(states, durations, limits)?;
    let mut chain = Chain::of(request, work)?;
    let steps = Steps::of(steps, chain.sections);
    chain.improve(durations, steps)?;
    Ok(chain.done()?.write(states, durations))
}

impl<'a, R: Real> Request<'a, R> {
    fn of(states: &'a [State<R>], durations: &[R], limits: &'a [Limits<R>]) -> Result<Self, Error> {
        let sections = durations.len();
        // There is a limit for each axis, or for each axis in every section.
        let every = states.len().wrapping_sub(limits.len());
        let fits = |axes: &usize| {
            path_size(*axes, sections).is_some() && states.len() == axes * (sections + 1)
        };
        let has_limits = |axes: &usize| limits.len() == *axes || limits.len() == axes * sections;
        let mut candidates = [limits.len(), every].into_iter().filter(fits);
        let axes = candidates.find(has_limits).ok_or(Error::Axes)?;
        let request = Self {
            axes,
            sections,
            states,
            limits,
        };
        request.check()?;
        Ok(request)
    }
}

impl<R: Real> Chain<'_, '_, R> {
    fn plan(&mut self, steps: Steps) -> Result<(), Error> {
        let stopping = self.stop_everywhere()?;
        if self.sections > 1 {
            self.roll()?;
            if self.come_inside() {
                self.shorten(steps, 0);
            }
            self.promise()?;
            let is_shorter = self.duration() < stopping;
            if !is_shorter {
                self.stop_everywhere()?;
            }
        }
        Ok(())
    }
}
