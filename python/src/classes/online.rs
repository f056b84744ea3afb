//! Moves from any state to any state, for one axis or several.

use atraj::axes;
use atraj::online::Limits;
use atraj::{Error, Findings, State};
use pyo3::prelude::*;

use super::Real;
use super::profiles::Profile;
use crate::values::{LimitsTuple, StateTuple, from_limits, from_state, named, no_move, to_phase};

/// Adds the class and the functions to a module.
pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Move>()?;
    module.add_function(wrap_pyfunction!(synchronise, module)?)?;
    module.add_function(wrap_pyfunction!(line, module)?)
}

/// A move from any state to any state, planned in motion: phases of constant jerk.
///
/// `Move.plan`, `reach`, `stop` and `meet` plan one axis, `synchronise` and `line` several. A move never changes: when the target
/// changes, plan again from `state_at` of this moment. After its end the axis moves on with the acceleration of the end. ValueError if an argument is no number, a limit is 0 or has the wrong sign, or the
/// target is outside the limits.
///
/// >>> import atraj
/// >>> limits = atraj.Limits.symmetric(jerk=30, acceleration=10, velocity=5)
/// >>> move = atraj.Move.plan(limits, atraj.State(0), atraj.State(10))
/// >>> other = atraj.Move.plan(limits, move.state_at(0.7), atraj.State(-2)) # in mid-motion, another target
/// >>> other.position(other.t), other.findings
/// (-2.0, <Findings.OVERSHOOTS: 16>)
#[pyclass(frozen, extends = Profile)]
pub struct Move {
    inner: atraj::online::Move<Real>,
    findings: Findings,
}

impl Move {
    /// The move that `plan` writes.
    fn planned(
        py: Python<'_>,
        plan: impl FnOnce(&mut atraj::online::Move<Real>) -> Result<Findings, Error>,
    ) -> PyResult<Py<Self>> {
        let mut inner = atraj::online::Move::default();
        let findings = plan(&mut inner).map_err(no_move)?;
        Self::of(py, inner, findings)
    }

    fn of(
        py: Python<'_>,
        inner: atraj::online::Move<Real>,
        findings: Findings,
    ) -> PyResult<Py<Self>> {
        let axis = Self { inner, findings };
        Py::new(py, Profile::new(inner, inner.t).add_subclass(axis))
    }
}

#[pymethods]
impl Move {
    /// The fastest motion from the state `start` to the state `end`.
    ///
    /// A start outside the limits comes inside in the fastest way. The end may be behind, or nearer than the way to stop.
    #[staticmethod]
    fn plan(
        py: Python<'_>,
        limits: LimitsTuple<Real>,
        start: StateTuple<Real>,
        end: StateTuple<Real>,
    ) -> PyResult<Py<Self>> {
        let (limits, start, end) = (from_limits(limits), from_state(start), from_state(end));
        Self::planned(py, |axis| axis.plan(&limits, start, end))
    }

    /// The fastest motion from the state `start` to the state `end`, if it stays between two positions until its end; `-inf` and `inf` are no
    /// limits. ValueError also if the motion leaves the positions: then the axis cannot stop between them, or the state `end` cannot be
    /// reached from rest between them.
    #[staticmethod]
    fn within(
        py: Python<'_>,
        limits: LimitsTuple<Real>,
        start: StateTuple<Real>,
        end: StateTuple<Real>,
        lowest: Real,
        highest: Real,
    ) -> PyResult<Py<Self>> {
        let (limits, start, end) = (from_limits(limits), from_state(start), from_state(end));
        Self::planned(py, |axis| axis.within(&limits, start, end, lowest, highest))
    }

    /// The fastest motion from the state `start` to a velocity and an acceleration; the position is free.
    #[staticmethod]
    #[pyo3(signature = (limits, start, velocity, acceleration=0.0))]
    fn reach(
        py: Python<'_>,
        limits: LimitsTuple<Real>,
        start: StateTuple<Real>,
        velocity: Real,
        acceleration: Real,
    ) -> PyResult<Py<Self>> {
        let (limits, start) = (from_limits(limits), from_state(start));
        Self::planned(py, |axis| {
            axis.reach(&limits, start, velocity, acceleration)
        })
    }

    /// The fastest stop from the state `start`; the position is free.
    #[staticmethod]
    fn stop(
        py: Python<'_>,
        limits: LimitsTuple<Real>,
        start: StateTuple<Real>,
    ) -> PyResult<Py<Self>> {
        let (limits, start) = (from_limits(limits), from_state(start));
        Self::planned(py, |axis| axis.stop(&limits, start))
    }

    /// The fastest motion from the state `start` to a target that moves on at its velocity. The move ends beside the target, at
    /// `target.position + t * target.velocity`. The target must not accelerate.
    #[staticmethod]
    fn meet(
        py: Python<'_>,
        limits: LimitsTuple<Real>,
        start: StateTuple<Real>,
        target: StateTuple<Real>,
    ) -> PyResult<Py<Self>> {
        let (limits, start, target) = (from_limits(limits), from_state(start), from_state(target));
        Self::planned(py, |axis| axis.meet(&limits, start, target))
    }

    /// The motion of one tick of an axis that follows `signal`, a state: call it in every tick. Where the axis can be beside the signal after
    /// the time `horizon`, s, it gets there in just this time. Else it meets the signal as fast as it can.
    #[staticmethod]
    fn track(
        py: Python<'_>,
        limits: LimitsTuple<Real>,
        start: StateTuple<Real>,
        signal: StateTuple<Real>,
        horizon: Real,
    ) -> PyResult<Py<Self>> {
        let (limits, start, signal) = (from_limits(limits), from_state(start), from_state(signal));
        Self::planned(py, |axis| axis.track(&limits, start, signal, horizon))
    }

    /// What is wrong with the move against `limits`, a `Findings`: what it exceeds, whether it jumps. It reads the phases alone.
    fn check<'py>(
        &self,
        py: Python<'py>,
        limits: LimitsTuple<Real>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let found = self.inner.check(&from_limits(limits)).map_err(no_move)?;
        named(py, "Findings", (found.bits(),))
    }

    /// The first time from 0 to `t` at which the axis is at `position`, s; None if it never is.
    fn time_at(&self, position: Real) -> Option<Real> {
        self.inner.time_at(position)
    }

    /// The `Findings` of the plan: of OVERSHOOTS, STARTS_OUTSIDE and ENDS_LEAVING any or none. For several axes it is what any of them does.
    #[getter]
    fn findings<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        named(py, "Findings", (self.findings.bits(),))
    }

    /// The phases of constant jerk in order of time, each a `Phase`.
    #[getter]
    fn phases<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let used = self.inner.phase.iter().take(self.inner.count as usize);
        used.map(|&phase| to_phase(py, phase)).collect()
    }
}

type Plan = fn(
    &mut [atraj::online::Move<Real>],
    &[Limits<Real>],
    &[State<Real>],
    &[State<Real>],
    Real,
    Real,
) -> Result<Findings, Error>;

/// Moves of several axes that arrive together: the shortest duration that is possible for each axis, is at least `duration`, s, and is
/// a multiple of `cycle`, s (0: any). An item of `limits`, `start` and `end` belongs to one axis. ValueError as for one axis.
///
/// >>> import atraj
/// >>> limits = [atraj.Limits.symmetric(30, 10, 5), atraj.Limits.symmetric(60, 20, 5)]
/// >>> x, y = atraj.synchronise(limits, [atraj.State(0), atraj.State(0)], [atraj.State(10), atraj.State(-1)])
/// >>> x.t == y.t
/// True
#[pyfunction]
#[pyo3(signature = (limits, start, end, *, duration=0.0, cycle=0.0))]
pub fn synchronise(
    py: Python<'_>,
    limits: Vec<LimitsTuple<Real>>,
    start: Vec<StateTuple<Real>>,
    end: Vec<StateTuple<Real>>,
    duration: Real,
    cycle: Real,
) -> PyResult<Vec<Py<Move>>> {
    together(
        py,
        axes::synchronise,
        limits,
        [start, end],
        [duration, cycle],
    )
}

/// Moves of several axes on the straight line from their start to their end: the fastest motion on it that lasts at least `duration`,
/// s, and a multiple of `cycle`, s (0: any). ValueError also if velocities and accelerations do not point along the line.
///
/// >>> import atraj
/// >>> limits = [atraj.Limits.symmetric(20, 4, 1), atraj.Limits.symmetric(10, 2, 0.8)]
/// >>> x, y = atraj.line(limits, [(0, 0, 0), (0, 0, 0)], [(0.8, 0, 0), (0.4, 0, 0)], cycle=0.001)
/// >>> abs(x.position(0.5) - 2 * y.position(0.5)) < 1e-15
/// True
#[pyfunction]
#[pyo3(signature = (limits, start, end, *, duration=0.0, cycle=0.0))]
pub fn line(
    py: Python<'_>,
    limits: Vec<LimitsTuple<Real>>,
    start: Vec<StateTuple<Real>>,
    end: Vec<StateTuple<Real>>,
    duration: Real,
    cycle: Real,
) -> PyResult<Vec<Py<Move>>> {
    together(py, axes::line, limits, [start, end], [duration, cycle])
}

fn together(
    py: Python<'_>,
    plan: Plan,
    limits: Vec<LimitsTuple<Real>>,
    ends: [Vec<StateTuple<Real>>; 2],
    [duration, cycle]: [Real; 2],
) -> PyResult<Vec<Py<Move>>> {
    let limits: Vec<_> = limits.into_iter().map(from_limits).collect();
    let [start, end] = ends.map(|states| states.into_iter().map(from_state).collect::<Vec<_>>());
    let mut axes = vec![atraj::online::Move::default(); limits.len()];
    let findings = plan(&mut axes, &limits, &start, &end, duration, cycle).map_err(no_move)?;
    axes.into_iter()
        .map(|axis| Move::of(py, axis, findings))
        .collect()
}
