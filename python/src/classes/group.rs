//! Several axes that follow one plan after another, tick by tick.

use std::mem;
use std::sync::{Mutex, PoisonError};

use atraj::machine::{self, GroupPlanner};
use atraj::online::{Limits, Move as Planned};
use atraj::{Error, Findings, State};
use elsa::sync::FrozenVec;
use pyo3::prelude::*;
use pyo3::types::PyList;
use self_cell::{MutBorrow, self_cell};

use super::Real;
use super::axes::{ANYWHERE, Axes, are_as_long};
use crate::values::{GivenLimits, GivenState, error, to_findings, to_state};
use crate::why::{each_alone, no_part};

/// Adds the class to a module.
pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Group>()
}

/// What a group of the library borrows. Paths and positions stay until the group goes.
struct Memory {
    states: Vec<State<Real>>,
    moves: Vec<Planned<Real>>,
    paths: FrozenVec<Vec<Planned<Real>>>,
    positions: FrozenVec<Vec<Real>>,
}

struct Borrowed<'a> {
    group: machine::Group<'a, Real>,
    paths: &'a FrozenVec<Vec<Planned<Real>>>,
    positions: &'a FrozenVec<Vec<Real>>,
}

self_cell!(
    struct Owned {
        owner: MutBorrow<Memory>,
        #[not_covariant]
        dependent: Borrowed,
    }
);

/// Several axes that follow one plan after another, as a machine does: in each cycle of a control loop `tick` gives the next setpoints, and
/// between two ticks another motion may be planned.
///
/// `Group(period, states)` has an axis for each of the `states`, and a tick every `period`, s. A plan starts from the states that the axes will
/// have after `lead` ticks, and all axes take it over together, in this tick. No axis exceeds its limits, and nothing jumps. Each plan returns
/// `Findings`, or ValueError says why it is refused, and the motion goes on. A group keeps the moves of its paths as long as it lives.
///
/// >>> import atraj
/// >>> limits = [atraj.Limits(jerk=20, acceleration=4, velocity=1)] * 2
/// >>> planned = [atraj.Limits(jerk=17, acceleration=3.4, velocity=0.85)] * 2 # with a reserve for holds
/// >>> cell = atraj.Group(0.002, [0, 0])
/// >>> found = cell.line(planned, [0.8, 0.4])
/// >>> for _ in range(300):
/// ...     states = cell.tick()
/// >>> found = cell.rate(limits, 0) # feed hold
/// >>> while not cell.done:
/// ...     states = cell.tick()
/// >>> [state.velocity for state in states]
/// [0.0, 0.0]
/// >>> found = cell.rate(limits, 1) # and on
/// >>> while not cell.done:
/// ...     states = cell.tick()
/// >>> [state.position for state in states]
/// [0.8, 0.4]
#[pyclass(module = "atraj")]
pub struct Group {
    /// A lock, because Python may hold the object in any thread. Nobody waits for it.
    owned: Mutex<Owned>,
    now: Vec<State<Real>>,
    /// Whether the motion is at its end.
    is_at_end: bool,
    /// Whether a plan waits for its tick.
    waits: bool,
}

impl Group {
    fn act<T>(&mut self, act: impl for<'a> FnOnce(&mut Borrowed<'a>) -> T) -> T {
        let owned = self.owned.get_mut().unwrap_or_else(PoisonError::into_inner);
        owned.with_dependent_mut(|_, borrowed| act(borrowed))
    }

    /// `targets` are those of the axes, if they have some, else 0 at rest: with them each axis is asked alone why nothing is planned.
    fn plan<'py>(
        &mut self, py: Python<'py>, limits: &[GivenLimits<Real>], targets: &[State<Real>], lead: u32,
        plan: impl for<'a> FnOnce(&mut Borrowed<'a>, &[Limits<Real>]) -> Result<Findings, Error>, why_not: &str,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (count, axes) = (limits.len(), self.now.len());
        if count != axes {
            return Err(error(&format!("limits has {count} items, and the group {axes} axes")));
        }
        let limits: Vec<_> = limits.iter().map(|limits| limits.0).collect();
        let found = self.act(|borrowed| plan(borrowed, &limits)).map_err(|why| {
            let asked = limits.iter().zip(targets);
            let alone = each_alone(asked.map(|(&limits, &target)| (limits, [State::at(0.0), target], ANYWHERE)));
            alone.err().unwrap_or_else(|| match why {
                Error::Late => error(&format!("lead = {lead} is not a number of ticks from 1 to 134,217,727")),
                Error::Target => error(why_not),
                _ => error(&why.to_string()),
            })
        })?;
        self.waits = true;
        to_findings(py, found)
    }

    fn at_0(&self) -> Vec<State<Real>> {
        vec![State::at(0.0); self.now.len()]
    }

    fn go_to<'py>(
        &mut self, py: Python<'py>, limits: &[GivenLimits<Real>], targets: &[GivenState<Real>], lead: u32,
        plan: impl FnOnce(&mut GroupPlanner<'_, '_, Real>, &[Limits<Real>], &[State<Real>]) -> Result<Findings, Error>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (count, axes) = (targets.len(), self.now.len());
        if count != axes {
            return Err(error(&format!("targets has {count} items, and the group {axes} axes")));
        }
        let targets: Vec<_> = targets.iter().map(|target| target.0).collect();
        let planned = |borrowed: &mut Borrowed<'_>, limits: &[_]| plan(&mut borrowed.group.split().0, limits, &targets);
        self.plan(py, limits, &targets, lead, planned, "the axes cannot move to the targets")
    }
}

#[pymethods]
impl Group {
    #[new]
    fn new(period: Real, states: Vec<GivenState<Real>>) -> PyResult<Self> {
        let now: Vec<_> = states.iter().map(|state| state.0).collect();
        let moves = vec![Planned::default(); 3 * now.len()];
        let memory = Memory { states: now.clone(), moves, paths: FrozenVec::new(), positions: FrozenVec::new() };
        let owned = Owned::try_new(MutBorrow::new(memory), |memory| {
            let Memory { states, moves, paths, positions } = memory.borrow_mut();
            Ok(Borrowed { group: machine::Group::new(period, states, moves)?, paths, positions })
        });
        let owned = owned.map_err(|why| match why {
            Error::Axes => error("there is no axis: states is empty"),
            Error::Duration => no_part(why, &[("period", period, false, "is not a time above 0")]),
            _ => error(&format!("states: {why}")),
        })?;
        Ok(Self { owned: Mutex::new(owned), now, is_at_end: true, waits: false })
    }

    /// The next setpoints: a `State` for each axis. Call it once in each cycle.
    fn tick<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let mut now = mem::take(&mut self.now);
        let event = self.act(|borrowed| borrowed.group.split().1.tick(&mut now));
        self.now = now;
        self.is_at_end = event.ends || self.is_at_end && !event.begins;
        self.waits = self.waits && !event.begins;
        let states = self.now.iter().map(|&state| to_state(py, state));
        PyList::new(py, states.collect::<PyResult<Vec<_>>>()?)
    }

    /// Whether the motion is at its end, at the targets or in a hold, and no plan waits for its tick.
    #[getter]
    fn done(&self) -> bool {
        self.is_at_end && !self.waits
    }

    /// Keeps each motion that is planned from now on between the positions: `lowest` and `highest` have an item for each axis, and `-inf` and `inf`
    /// are no limits. ValueError if the lowest is not below the highest. An axis that cannot stop between them stops as fast as it can.
    fn within(&mut self, lowest: Vec<Real>, highest: Vec<Real>) -> PyResult<()> {
        are_as_long(&[("lowest", lowest.len()), ("highest", highest.len()), ("the group", self.now.len())])?;
        for (axis, (low, high)) in lowest.iter().zip(&highest).enumerate() {
            if low.partial_cmp(high).is_none_or(|order| order.is_ge()) {
                return Err(error(&format!("axis {axis}: lowest = {low} is not below highest = {high}")));
            }
        }
        let kept = self.act(|borrowed| {
            let positions = [lowest, highest].map(|list| borrowed.positions.push_get(list));
            borrowed.group.split().0.within(positions)
        });
        kept.map_err(|why| error(&why.to_string()))
    }

    /// Each axis goes to its state by its fastest move. `limits` and `targets` have an item for each axis.
    #[pyo3(signature = (limits, targets, *, lead=1))]
    fn go<'py>(
        &mut self, py: Python<'py>, limits: Vec<GivenLimits<Real>>, targets: Vec<GivenState<Real>>, lead: u32,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.go_to(py, &limits, &targets, lead, |planner, limits, targets| planner.go(limits, targets, lead))
    }

    /// As `go`, but all axes arrive in the same tick.
    #[pyo3(signature = (limits, targets, *, lead=1))]
    fn synchronise<'py>(
        &mut self, py: Python<'py>, limits: Vec<GivenLimits<Real>>, targets: Vec<GivenState<Real>>, lead: u32,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.go_to(py, &limits, &targets, lead, |planner, limits, targets| planner.sync(limits, targets, lead))
    }

    /// As `go`, but on the straight line to the targets.
    #[pyo3(signature = (limits, targets, *, lead=1))]
    fn line<'py>(
        &mut self, py: Python<'py>, limits: Vec<GivenLimits<Real>>, targets: Vec<GivenState<Real>>, lead: u32,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.go_to(py, &limits, &targets, lead, |planner, limits, targets| planner.line(limits, targets, lead))
    }

    /// Follows a `Path` or `Moves` from their time `begun` on, s. The axes must be there: another path may take over while the axes move, if it
    /// has their states at this time.
    #[pyo3(signature = (limits, path, *, begun=0.0, lead=1))]
    fn path<'py>(
        &mut self, py: Python<'py>, limits: Vec<GivenLimits<Real>>, path: &Bound<'py, Axes>, begun: Real, lead: u32,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (count, axes) = (path.get().sections[0].len(), self.now.len());
        if count != axes {
            return Err(error(&format!("the path has {count} axes, and the group {axes}")));
        }
        let moves = path.get().sections.concat();
        let follow = |borrowed: &mut Borrowed<'_>, limits: &[_]| {
            let moves = borrowed.paths.push_get(moves);
            borrowed.group.split().0.path(limits, moves, begun, lead)
        };
        self.plan(py, &limits, &self.at_0(), lead, follow, "the axes are not on the path at this time")
    }

    /// Goes to another rate on the line or path: 1 as planned, 0 hold, 0.5 half as fast, -1 back. `limits` are those of the plan and a reserve.
    /// Where the axes rest, before a motion or after it, a hold has nothing to do, and 1 is RATE_NOT_REACHED.
    #[pyo3(signature = (limits, rate, *, lead=1))]
    fn rate<'py>(
        &mut self, py: Python<'py>, limits: Vec<GivenLimits<Real>>, rate: Real, lead: u32,
    ) -> PyResult<Bound<'py, PyAny>> {
        let why_not = "no change to this rate keeps the limits, which need a reserve beyond those of the plan; or the axes move each for itself";
        let change = |borrowed: &mut Borrowed<'_>, limits: &[_]| borrowed.group.split().0.rate(limits, rate, lead);
        self.plan(py, &limits, &self.at_0(), lead, change, why_not)
    }

    /// Stops on the line or path where that is not much slower, else each axis at once.
    #[pyo3(signature = (limits, *, lead=1))]
    fn stop<'py>(&mut self, py: Python<'py>, limits: Vec<GivenLimits<Real>>, lead: u32) -> PyResult<Bound<'py, PyAny>> {
        let stop = |borrowed: &mut Borrowed<'_>, limits: &[_]| borrowed.group.split().0.stop(limits, lead);
        self.plan(py, &limits, &self.at_0(), lead, stop, "the axes cannot stop")
    }

    fn __len__(&self) -> usize {
        self.now.len()
    }

    fn __repr__(&self) -> String {
        format!("<Group of {} axes>", self.now.len())
    }
}
