//! Moves of one axis from any state to any state.

use std::sync::Arc;

use atraj::{Error, Findings, State};
use pyo3::prelude::*;

use super::Real;
use super::profiles::Profile;
use crate::motion::{Planned, move_from_parts};
use crate::values::{GivenLimits, GivenState, error, to_findings, to_phase};
use crate::why::no_move;

/// Adds the class to a module.
pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Move>()
}

/// A move from any state to any state, planned in motion: phases of constant jerk.
///
/// `Move.plan`, `within`, `reach`, `stop`, `meet` and `track` plan one axis, `synchronise` and `line` several. A move never changes: when the
/// target changes, plan again from `state_at` of this moment. After its end the axis moves on with the acceleration of the end.
///
/// A state is a `State`, up to three numbers in its order, or a position at rest; limits are a `Limits` or six numbers in its order. ValueError
/// says which number is NaN or infinite, which limit is 0 or has the wrong sign, or what is outside the limits.
///
/// >>> import atraj
/// >>> limits = atraj.Limits(jerk=30, acceleration=10, velocity=5)
/// >>> move = atraj.Move.plan(limits, 0, 10)
/// >>> other = atraj.Move.plan(limits, move.state_at(0.7), -2) # in mid-motion, another target
/// >>> other.position(other.t), other.findings
/// (-2.0, <Findings.OVERSHOOTS: 16>)
#[pyclass(module = "atraj", frozen, extends = Profile)]
pub struct Move(pub Arc<Planned<Real>>);

impl Move {
    /// The move that `plan` writes. The names and the numbers are for the error.
    fn planned(
        py: Python<'_>, limits: &GivenLimits<Real>, states: &[(&str, GivenState<Real>)], others: &[(&str, Real)],
        plan: impl FnOnce(&mut atraj::online::Move<Real>) -> Result<Findings, Error>,
    ) -> PyResult<Py<Self>> {
        let mut planned = Arc::new(Planned::default());
        // Nobody shares it yet. The plan is written where it stays, because a move is large.
        let Some(Planned { motion, findings }) = Arc::get_mut(&mut planned) else {
            return Err(error("the move is shared"));
        };
        *findings = plan(motion).map_err(|why| {
            let states: Vec<_> = states.iter().map(|(name, state)| (*name, state.0)).collect();
            no_move(why, "", &limits.0, &states, others)
        })?;
        Self::share(py, planned)
    }

    pub fn of(py: Python<'_>, planned: Planned<Real>) -> PyResult<Py<Self>> {
        Self::share(py, Arc::new(planned))
    }

    fn share(py: Python<'_>, planned: Arc<Planned<Real>>) -> PyResult<Py<Self>> {
        let base = Profile::shared(planned.clone(), planned.motion.t);
        Py::new(py, base.add_subclass(Self(planned)))
    }
}

#[pymethods]
impl Move {
    /// The fastest motion from the state `start` to the state `end`.
    ///
    /// A start outside the limits returns within them in minimum time. The end may be behind, or nearer than the stopping distance.
    #[staticmethod]
    fn plan(
        py: Python<'_>, limits: GivenLimits<Real>, start: GivenState<Real>, end: GivenState<Real>,
    ) -> PyResult<Py<Self>> {
        let states = [("start", start), ("end", end)];
        Self::planned(py, &limits, &states, &[], |axis| axis.plan(&limits.0, start.0, end.0))
    }

    /// The fastest motion from the state `start` to the state `end`, if it stays between two positions until its end; `-inf` and `inf` are no
    /// limits. ValueError also if the motion leaves the positions: then the axis cannot stop between them, or the state `end` cannot be
    /// reached from rest between them.
    #[staticmethod]
    fn within(
        py: Python<'_>, limits: GivenLimits<Real>, start: GivenState<Real>, end: GivenState<Real>, lowest: Real,
        highest: Real,
    ) -> PyResult<Py<Self>> {
        let states = [("start", start), ("end", end)];
        let positions = [("lowest", lowest), ("highest", highest)];
        Self::planned(py, &limits, &states, &positions, |axis| axis.within(&limits.0, start.0, end.0, lowest, highest))
    }

    /// The fastest motion from the state `start` to a velocity and an acceleration; the position is free.
    #[staticmethod]
    #[pyo3(signature = (limits, start, velocity, acceleration=0.0))]
    fn reach(
        py: Python<'_>, limits: GivenLimits<Real>, start: GivenState<Real>, velocity: Real, acceleration: Real,
    ) -> PyResult<Py<Self>> {
        let end = State { position: 0.0, velocity, acceleration };
        let states = [("start", start), ("end", GivenState(end))];
        Self::planned(py, &limits, &states, &[], |axis| axis.reach(&limits.0, start.0, velocity, acceleration))
    }

    /// The fastest stop from the state `start`; the position is free.
    #[staticmethod]
    fn stop(py: Python<'_>, limits: GivenLimits<Real>, start: GivenState<Real>) -> PyResult<Py<Self>> {
        let states = [("start", start), ("end", GivenState(State::at(0.0)))];
        Self::planned(py, &limits, &states, &[], |axis| axis.stop(&limits.0, start.0))
    }

    /// The fastest motion from the state `start` to a target that moves on at its velocity. The move ends at the target, at
    /// `target.position + t * target.velocity`. The target must not accelerate.
    #[staticmethod]
    fn meet(
        py: Python<'_>, limits: GivenLimits<Real>, start: GivenState<Real>, target: GivenState<Real>,
    ) -> PyResult<Py<Self>> {
        let states = [("start", start), ("target", target)];
        Self::planned(py, &limits, &states, &[], |axis| axis.meet(&limits.0, start.0, target.0))
    }

    /// The next moments of an axis that follows `signal`, a state, with its `jerk`, 0 if nobody knows it: call it in every tick. Where the axis
    /// can be next to the signal after the time `horizon`, s, it gets there in just this time. Else it chases the signal as fast as it can.
    #[staticmethod]
    fn track(
        py: Python<'_>, limits: GivenLimits<Real>, start: GivenState<Real>, signal: GivenState<Real>, jerk: Real,
        horizon: Real,
    ) -> PyResult<Py<Self>> {
        let states = [("start", start), ("signal", signal)];
        Self::planned(py, &limits, &states, &[("jerk", jerk), ("horizon", horizon)], |axis| {
            axis.track(&limits.0, start.0, signal.0, jerk, horizon)
        })
    }

    /// What is wrong with the move against `limits`, a `Findings`: what it exceeds, whether it jumps. It reads the phases alone.
    fn check<'py>(&self, py: Python<'py>, limits: GivenLimits<Real>) -> PyResult<Bound<'py, PyAny>> {
        let found = self.0.motion.check(&limits.0);
        to_findings(py, found.map_err(|why| no_move(why, "", &limits.0, &[], &[]))?)
    }

    /// The first time from 0 to `t` at which the axis is at `position`, s; None if it never is.
    fn time_at(&self, position: Real) -> Option<Real> {
        self.0.motion.time_at(position)
    }

    /// The `Findings` of the plan: of OVERSHOOTS, STARTS_OUTSIDE and ENDS_LEAVING any or none. For several axes it is what any of them does.
    #[getter]
    fn findings<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_findings(py, self.0.findings)
    }

    /// The phases of constant jerk in order of time, each a `Phase`.
    #[getter]
    fn phases<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let motion = &self.0.motion;
        let used = motion.phase.iter().take(motion.count as usize);
        used.map(|&phase| to_phase(py, phase)).collect()
    }

    /// What a copy is made of.
    #[staticmethod]
    fn _from_phases(py: Python<'_>, t: Real, findings: u8, phases: Vec<[Real; 6]>) -> PyResult<Py<Self>> {
        let motion = move_from_parts(t, &phases)?;
        let findings = Findings::from_bits(findings);
        Self::of(py, Planned { motion, findings })
    }
}
