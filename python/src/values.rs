//! The named tuples and sets of `atraj/values.py`: from Python, to Python, and the errors.

use atraj::Findings;
use atraj::online::{Limits, Phase};
use atraj::{Extremes, State};
use pyo3::call::PyCallArgs;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyFloat, PyInt, PyTuple, PyType};

use crate::motion::Number;

/// A state that Python gives: a `State`, up to three numbers in its order, or a position at rest.
#[derive(Clone, Copy)]
pub struct GivenState<R>(pub State<R>);

impl<'a, 'py, R: Number> FromPyObject<'a, 'py> for GivenState<R> {
    type Error = PyErr;

    fn extract(given: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        // The usual forms first, without an error of Python on the way.
        if given.is_exact_instance_of::<PyFloat>() || given.is_exact_instance_of::<PyInt>() {
            return Ok(Self(State::at(number(given)?)));
        }
        if let Ok(tuple) = given.cast::<PyTuple>() {
            if tuple.len() == 3 {
                return Ok(Self(from_numbers(given.extract()?)));
            }
        } else if given.len().is_err() {
            return Ok(Self(State::at(number(given)?)));
        }
        match *numbers(given)? {
            [position] => Ok(Self(State::at(position))),
            [position, velocity] => Ok(Self(from_numbers((position, velocity, R::ZERO)))),
            [position, velocity, acceleration] => Ok(Self(from_numbers((position, velocity, acceleration)))),
            ref others => Err(error(&format!(
                "a state is a position, a velocity and an acceleration, and here are {} numbers",
                others.len()
            ))),
        }
    }
}

/// Limits that Python gives: a `Limits`, or six numbers in its order.
#[derive(Clone, Copy)]
pub struct GivenLimits<R>(pub Limits<R>);

impl<'a, 'py, R: Number> FromPyObject<'a, 'py> for GivenLimits<R> {
    type Error = PyErr;

    #[rustfmt::skip]
    fn extract(given: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        if given.cast::<PyTuple>().is_ok_and(|tuple| tuple.len() == 6) {
            let (vmax, vmin, amax, amin, jmax, jmin) = given.extract()?;
            return Ok(Self(Limits { vmax, vmin, amax, amin, jmax, jmin }));
        }
        match *numbers(given)? {
            [vmax, vmin, amax, amin, jmax, jmin] => Ok(Self(Limits { vmax, vmin, amax, amin, jmax, jmin })),
            ref others => Err(error(&format!(
                "limits are the six numbers of atraj.Limits, and here are {}", others.len()
            ))),
        }
    }
}

fn number<R: Number>(given: Borrowed<'_, '_, PyAny>) -> PyResult<R> {
    given.extract().map_err(Into::into)
}

/// The numbers of a list, a tuple or an array.
fn numbers<R: Number>(given: Borrowed<'_, '_, PyAny>) -> PyResult<Vec<R>> {
    given.try_iter()?.map(|item| number(item?.as_borrowed())).collect()
}

fn from_numbers<R>((position, velocity, acceleration): (R, R, R)) -> State<R> {
    State { position, velocity, acceleration }
}

/// An object of the class `name` of `atraj.values`.
pub fn named<'py>(py: Python<'py>, name: &str, arguments: impl PyCallArgs<'py>) -> PyResult<Bound<'py, PyAny>> {
    py.import("atraj.values")?.getattr(name)?.call1(arguments)
}

/// A control loop asks for a state in every cycle, so this is the quick way to a named tuple: its class is looked up once, and no code of
/// Python runs.
pub fn to_state<R: Number>(py: Python<'_>, state: State<R>) -> PyResult<Bound<'_, PyAny>> {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    static NEW: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    let class = CLASS.import(py, "atraj.values", "State")?;
    let new = NEW.get_or_try_init(py, || {
        let new = py.get_type::<PyTuple>().getattr("__new__")?;
        PyResult::Ok(new.unbind())
    })?;
    new.bind(py).call1((class, state_numbers(state)))
}

pub fn state_numbers<R: Number>(state: State<R>) -> (f64, f64, f64) {
    let State { position, velocity, acceleration } = state;
    (position.into(), velocity.into(), acceleration.into())
}

#[rustfmt::skip]
pub fn limits_numbers<R: Number>(limits: Limits<R>) -> [f64; 6] {
    let Limits { vmax, vmin, amax, amin, jmax, jmin } = limits;
    [vmax, vmin, amax, amin, jmax, jmin].map(R::into)
}

#[rustfmt::skip]
pub fn phase_numbers<R: Number>(phase: Phase<R>) -> [f64; 6] {
    let Phase { start, duration, position, velocity, acceleration, jerk } = phase;
    [start, duration, position, velocity, acceleration, jerk].map(R::into)
}

pub fn to_extremes<R: Number>(py: Python<'_>, reached: Extremes<R>) -> PyResult<Bound<'_, PyAny>> {
    let ends = (to_state(py, reached.lowest)?, to_state(py, reached.highest)?);
    named(py, "Extremes", ends)
}

pub fn to_phase<R: Number>(py: Python<'_>, phase: Phase<R>) -> PyResult<Bound<'_, PyAny>> {
    named(py, "Phase", PyTuple::new(py, phase_numbers(phase))?)
}

pub fn to_findings(py: Python<'_>, findings: Findings) -> PyResult<Bound<'_, PyAny>> {
    named(py, "Findings", (findings.bits(),))
}

/// A `ValueError` that says why.
pub fn error(why: &str) -> PyErr {
    PyValueError::new_err(why.to_owned())
}
