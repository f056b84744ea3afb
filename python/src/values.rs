//! The named tuples and sets of `atraj/values.py`, and the errors.

use atraj::online::{Limits, Phase};
use atraj::{Error, Extremes, State};
use pyo3::call::PyCallArgs;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::motion::Number;

/// Position, velocity and acceleration: what a `State` unpacks to.
pub type StateTuple<R> = (R, R, R);

/// What a `Limits` unpacks to, in the order of [`Limits`].
pub type LimitsTuple<R> = (R, R, R, R, R, R);

/// An object of the class `name` of `atraj.values`.
pub fn named<'py>(
    py: Python<'py>,
    name: &str,
    arguments: impl PyCallArgs<'py>,
) -> PyResult<Bound<'py, PyAny>> {
    py.import("atraj.values")?.getattr(name)?.call1(arguments)
}

pub fn from_state<R: Number>((position, velocity, acceleration): StateTuple<R>) -> State<R> {
    State {
        position,
        velocity,
        acceleration,
    }
}

#[rustfmt::skip]
pub fn from_limits<R: Number>((vmax, vmin, amax, amin, jmax, jmin): LimitsTuple<R>) -> Limits<R> {
    Limits { vmax, vmin, amax, amin, jmax, jmin }
}

pub fn to_state<R: Number>(py: Python<'_>, state: State<R>) -> PyResult<Bound<'_, PyAny>> {
    let State {
        position,
        velocity,
        acceleration,
    } = state;
    let numbers: StateTuple<f64> = (position.into(), velocity.into(), acceleration.into());
    named(py, "State", numbers)
}

pub fn to_extremes<R: Number>(py: Python<'_>, reached: Extremes<R>) -> PyResult<Bound<'_, PyAny>> {
    let ends = (
        to_state(py, reached.lowest)?,
        to_state(py, reached.highest)?,
    );
    named(py, "Extremes", ends)
}

pub fn to_phase<R: Number>(py: Python<'_>, phase: Phase<R>) -> PyResult<Bound<'_, PyAny>> {
    let Phase {
        start,
        duration,
        position,
        velocity,
        acceleration,
        jerk,
    } = phase;
    let numbers = [start, duration, position, velocity, acceleration, jerk].map(R::into);
    named(py, "Phase", PyTuple::new::<f64, _>(py, numbers)?)
}

/// A `ValueError` that says why.
pub fn error(why: &str) -> PyErr {
    PyValueError::new_err(why.to_owned())
}

/// A `ValueError` that says why there is no move.
pub fn no_move(why: Error) -> PyErr {
    error(&why.to_string())
}
