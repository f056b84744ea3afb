//! CLARAty's trajectory as a Python class. It computes in binary64.

use atraj::claraty::{Kind, Mode, Target, Warnings};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::values::{error, named, to_state};

/// CLARAty's trapezoid: a target, start and stop at any time, and a setpoint whenever the controller asks.
///
/// `now` is a reading of one clock, s, `time.monotonic()` for example. Nothing here reads a clock. `mode` is the `Mode` of the starts and
/// stops: `Mode.CORRECTED` keeps the promise of CLARAty's class, `Mode.LISTING` gives the bits of the published listing. ValueError for
/// another number. Waypoints are in Rust and C only.
///
/// >>> from atraj.claraty import Trajectory
/// >>> axis = Trajectory()
/// >>> axis.set(position=10, velocity=2, acceleration=4, deceleration=4, now=0)
/// >>> axis.start(now=0), axis.duration
/// (<Warnings: 0>, 5.5)
/// >>> axis.setpoint(now=3)
/// State(position=5.5, velocity=2.0, acceleration=0.0)
/// >>> axis.stop(now=3) # brakes from here
/// <Warnings: 0>
/// >>> axis.setpoint(now=3.5).position
/// 6.0
#[pyclass(module = "atraj.claraty")]
pub struct Trajectory(atraj::claraty::Trajectory<'static>);

#[pymethods]
impl Trajectory {
    fn __copy__(&self) -> Self {
        Self(self.0)
    }

    fn __deepcopy__(&self, _memo: Bound<'_, PyAny>) -> Self {
        Self(self.0)
    }

    #[new]
    #[pyo3(signature = (mode=0, *, now=0.0))]
    fn new(mode: u8, now: f64) -> PyResult<Self> {
        Ok(Self(atraj::claraty::Trajectory::new(from_mode(mode)?, now)))
    }

    /// The `Mode` of the following starts and stops. It can be set.
    #[getter]
    fn mode<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        named(py, "Mode", (self.0.mode() as u8,))
    }

    #[setter]
    fn set_mode(&mut self, mode: u8) -> PyResult<()> {
        self.0.set_mode(from_mode(mode)?);
        Ok(())
    }

    /// The `Mode` of the motion under way.
    #[getter]
    fn motion_mode<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        named(py, "Mode", (self.0.motion_mode() as u8,))
    }

    /// Stores where to go next, and the limits on the way, whose signs are ignored. Nothing moves before `start`. ValueError if a
    /// number is larger than 1e60, or is not a number; then the trajectory stays as it was.
    fn set(&mut self, position: f64, velocity: f64, acceleration: f64, deceleration: f64, now: f64) -> PyResult<()> {
        let target = Target { position, velocity, acceleration, deceleration };
        let set = self.0.set(target.into(), now);
        set.map_err(|out_of_range| error(&out_of_range.to_string()))
    }

    /// Sets off with the timer at zero, from the setpoint if a motion is under way, else from rest at 0. The result is the
    /// `Warnings` of the plan.
    fn start<'py>(&mut self, py: Python<'py>, now: f64) -> PyResult<Bound<'py, PyAny>> {
        to_warnings(py, self.0.start(now))
    }

    /// Brakes a motion under way. The result is the `Warnings` of the plan.
    fn stop<'py>(&mut self, py: Python<'py>, now: f64) -> PyResult<Bound<'py, PyAny>> {
        to_warnings(py, self.0.stop(now))
    }

    /// Forgets the motion and sets the timer to zero.
    fn reset(&mut self, now: f64) {
        self.0.reset(now);
    }

    /// Whether a motion is under way: from the start until a setpoint after the end has been read.
    #[getter]
    fn is_started(&self) -> bool {
        self.0.is_started()
    }

    /// Time since the last start, stop or reset, s.
    fn elapsed(&self, now: f64) -> f64 {
        self.0.elapsed(now)
    }

    /// Adds seconds to what the clock shows.
    fn advance_timer_by(&mut self, seconds: f64) {
        self.0.advance_timer_by(seconds);
    }

    /// Another clock, which shows `instead`, replaces the clock that shows `now`. A motion under way goes on where it is.
    fn change_clock(&mut self, now: f64, instead: f64) {
        self.0.change_clock(now, instead);
    }

    /// Time from the start to rest, s; 0 before the first start.
    #[getter]
    fn duration(&self) -> f64 {
        self.0.duration()
    }

    /// The `TrapezoidalProfile` of the last start or stop.
    #[getter]
    fn profile<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let p = self.0.profile();
        let numbers =
            [p.t1, p.t2, p.tf, p.p_at_t1, p.p_at_t2, p.final_position, p.velocity, p.acceleration, p.deceleration];
        named(py, "TrapezoidalProfile", PyTuple::new(py, numbers)?)
    }

    /// Whether the last start or stop cruises at its maximum velocity.
    #[getter]
    fn is_trapezoidal(&self) -> bool {
        self.0.profile().kind == Kind::Trapezoidal
    }

    /// The setpoint now, a `State`. A reading after the end of the motion ends the motion.
    fn setpoint<'py>(&mut self, py: Python<'py>, now: f64) -> PyResult<Bound<'py, PyAny>> {
        to_state(py, self.0.setpoint(now))
    }

    /// The setpoint at the time `t` after the start, s, a `State`. In a motion of the listing a look beyond the end ends the motion.
    fn setpoint_at<'py>(&mut self, py: Python<'py>, t: f64) -> PyResult<Bound<'py, PyAny>> {
        to_state(py, self.0.setpoint_at(t))
    }
}

fn from_mode(mode: u8) -> PyResult<Mode> {
    match mode {
        0 => Ok(Mode::Corrected),
        1 => Ok(Mode::Listing),
        _ => Err(error("a mode is CORRECTED or LISTING")),
    }
}

fn to_warnings(py: Python<'_>, warnings: Warnings) -> PyResult<Bound<'_, PyAny>> {
    named(py, "Warnings", (warnings.bits(),))
}
