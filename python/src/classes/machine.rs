//! What a control loop holds: the clock of a path, the shaper of a move and the steps of a motor.

use atraj::machine::{self, ShaperKind};
use atraj::online::Limits;
use atraj::{Error, Extremes, State};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};

use super::Real;
use super::axes::Axes;
use super::online::Move;
use super::profiles::{Bell, Profile, rebuilding};
use crate::motion::{Motion, Parts, Request, Rows};
use crate::values::{GivenLimits, error, limits_numbers, named, to_findings, to_state};
use crate::why::{NUMBER, no_part};

/// Adds the classes to a module.
pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Shaper>()?;
    module.add_class::<Shaped>()?;
    module.add_class::<Steps>()?;
    module.add_class::<Clock>()
}

/// The kinds in the order of `ShaperKind`, which are the numbers of C.
const KINDS: [ShaperKind; 5] = [ShaperKind::Zv, ShaperKind::Zvd, ShaperKind::Mzv, ShaperKind::Ei, ShaperKind::Ei2];

/// A frequency of a load that a shaper leaves at rest: kind, frequency, Hz, and damping.
type Frequency = (u8, Real, Real);

/// An input shaper: a mean of a move at several times, which leaves little vibration at its frequencies.
///
/// `Shaper(kind, frequency, damping=0)` is for a load that swings with this frequency, Hz, and this damping, a part of the critical one.
/// A shaper never changes: `add` gives another one. `shape` gives the shaped motion, which keeps every limit of the move, starts and ends where
/// the move does, and takes `duration` longer. ValueError says which number is wrong, or that there are more than 16 impulses.
///
/// >>> import atraj
/// >>> move = atraj.Move.plan(atraj.Limits(jerk=1000, acceleration=4, velocity=1), 0, 0.5)
/// >>> shaper = atraj.Shaper(atraj.ShaperKind.ZVD, 5).add(atraj.ShaperKind.ZV, 12.5) # 5 Hz and 12.5 Hz
/// >>> round(shaper.duration, 3)
/// 0.24
/// >>> shaped = shaper.shape(move)
/// >>> shaped.t == move.t + shaper.duration, shaped.position(shaped.t)
/// (True, 0.5)
#[pyclass(module = "atraj", frozen)]
#[derive(Clone)]
pub struct Shaper {
    inner: machine::Shaper<Real>,
    smoothing: Real,
    frequencies: Vec<Frequency>,
}

impl Shaper {
    fn and(mut self, (kind, frequency, damping): Frequency) -> PyResult<Self> {
        let Some(&of_kind) = KINDS.get(kind as usize) else {
            return Err(error("a kind is a member of atraj.ShaperKind"));
        };
        let added = self.inner.add(of_kind, frequency, damping);
        added.map_err(|why| {
            let is_frequency = frequency > 0.0 && frequency.is_finite();
            let is_damping = (0.0..1.0).contains(&damping);
            let numbers = [
                ("frequency", frequency, is_frequency, "is not a number above 0, Hz"),
                ("damping", damping, is_damping, "is not from 0 to below 1"),
            ];
            match why {
                Error::Limits if is_damping => error("the shaper has more than 16 impulses"),
                _ => no_part(why, &numbers),
            }
        })?;
        self.frequencies.push((kind, frequency, damping));
        Ok(self)
    }
}

#[pymethods]
impl Shaper {
    #[new]
    #[pyo3(signature = (kind, frequency, damping=0.0))]
    fn new(kind: u8, frequency: Real, damping: Real) -> PyResult<Self> {
        Self::smooth(0.0)?.and((kind, frequency, damping))
    }

    /// A shaper without a frequency: the motion becomes its mean over this time, s. So its acceleration changes evenly, and the derivative of
    /// its jerk is at most twice the limit of the jerk, divided by the time. A time of 0 changes nothing. ValueError if the time is negative or
    /// not finite.
    #[staticmethod]
    fn smooth(time: Real) -> PyResult<Self> {
        let smoothed = machine::Shaper::smooth(time);
        let numbers = [("time", time, false, "is not a time from 0 on")];
        Ok(Self { inner: smoothed.map_err(|why| no_part(why, &numbers))?, smoothing: time, frequencies: Vec::new() })
    }

    /// This shaper for another frequency of the load too, as a new shaper. The impulses of both are multiplied.
    #[pyo3(signature = (kind, frequency, damping=0.0))]
    fn add(&self, kind: u8, frequency: Real, damping: Real) -> PyResult<Self> {
        self.clone().and((kind, frequency, damping))
    }

    /// How much longer a shaped move takes, s.
    #[getter]
    fn duration(&self) -> Real {
        self.inner.duration()
    }

    /// The shaped motion of a `Move` or a `Bell`, as a `Shaped`. TypeError for another motion.
    fn shape(slf: &Bound<'_, Self>, r#move: &Bound<'_, Profile>) -> PyResult<Py<Shaped>> {
        let of = if let Ok(planned) = r#move.cast::<Move>() {
            Unshaped::Move(Box::new(planned.get().0.motion))
        } else if let Ok(bell) = r#move.cast::<Bell>() {
            Unshaped::Bell(bell.get().0)
        } else {
            let name = r#move.get_type().name()?;
            return Err(PyTypeError::new_err(format!("a Move or a Bell can be shaped, and this is a {name}")));
        };
        let shaper = slf.get().inner;
        let t = r#move.get().lasts() + shaper.duration();
        let made_of = (slf.clone().into_any().unbind(), r#move.clone().into_any().unbind());
        let base = Profile::new(ShapedMotion { shaper, of, made_of }, t);
        Py::new(slf.py(), base.add_subclass(Shaped))
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.smoothing == other.smoothing && self.frequencies == other.frequencies
    }

    fn __hash__(&self) -> isize {
        self.inner.duration().to_bits() as isize
    }

    /// What a copy is made of.
    #[staticmethod]
    fn _from_frequencies(smoothing: Real, frequencies: Vec<Frequency>) -> PyResult<Self> {
        let none = Self::smooth(smoothing)?;
        frequencies.into_iter().try_fold(none, Self::and)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let Self { smoothing, frequencies, .. } = slf.get();
        let frequencies = PyTuple::new(slf.py(), frequencies.clone())?;
        let arguments = (*smoothing, frequencies).into_pyobject(slf.py())?;
        rebuilding(slf.as_any(), "_from_frequencies", arguments)
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: Bound<'_, PyAny>) -> Py<Self> {
        slf
    }

    fn __repr__(slf: &Bound<'_, Self>) -> PyResult<String> {
        let Self { smoothing, frequencies, .. } = slf.get();
        let module = slf.get_type().module()?;
        let mut frequencies = frequencies.iter().map(|(kind, frequency, damping)| {
            let name = named(slf.py(), "ShaperKind", (*kind,))?.getattr("name")?;
            PyResult::Ok(format!("(atraj.ShaperKind.{name}, {frequency:?}, {damping:?})"))
        });
        let mut text = match (*smoothing, frequencies.next()) {
            (0.0, Some(first)) => format!("{module}.Shaper{}", first?),
            (_, first) => {
                let added = first.transpose()?.map(|first| format!(".add{first}"));
                format!("{module}.Shaper.smooth({smoothing:?}){}", added.unwrap_or_default())
            }
        };
        for other in frequencies {
            text += &format!(".add{}", other?);
        }
        Ok(text)
    }
}

/// A shaped move: what `Shaper.shape` gives. Its jerk is NaN, because a shaper gives none, in C and Rust too. It keeps the limits of the
/// move's jerk.
#[pyclass(module = "atraj", frozen, extends = Profile)]
pub struct Shaped;

#[pymethods]
impl Shaped {
    /// What a copy is made of.
    #[staticmethod]
    fn _of(shaper: &Bound<'_, Shaper>, r#move: &Bound<'_, Profile>) -> PyResult<Py<Self>> {
        Shaper::shape(shaper, r#move)
    }
}

enum Unshaped {
    Move(Box<atraj::online::Move<Real>>),
    Bell(atraj::Bell<Real>),
}

struct ShapedMotion {
    shaper: machine::Shaper<Real>,
    of: Unshaped,
    made_of: (Py<PyAny>, Py<PyAny>),
}

impl Motion<Real> for ShapedMotion {
    fn position(&self, x: Real) -> Real {
        self.state_at(x).position
    }
    fn velocity(&self, x: Real) -> Real {
        self.state_at(x).velocity
    }
    fn acceleration(&self, x: Real) -> Real {
        self.state_at(x).acceleration
    }
    fn jerk(&self, _: Real) -> Real {
        Real::NAN
    }
    fn state_at(&self, x: Real) -> State<Real> {
        match &self.of {
            Unshaped::Move(motion) => self.shaper.state(motion, x),
            Unshaped::Bell(bell) => self.shaper.bell_state(bell, x),
        }
    }
    fn extremes(&self, _: Real) -> Option<Extremes<Real>> {
        None
    }
    fn sample_into(&self, x0: Real, dt: Real, [p, v, a, j]: [&mut [Real]; 4]) {
        let longest = p.len().max(v.len()).max(a.len());
        for k in 0..longest {
            let state = self.state_at(x0 + k as Real * dt);
            let quantities = [state.position, state.velocity, state.acceleration];
            for (array, quantity) in [&mut *p, &mut *v, &mut *a].into_iter().zip(quantities) {
                if let Some(number) = array.get_mut(k) {
                    *number = quantity;
                }
            }
        }
        j.fill(Real::NAN);
    }
    fn parts<'py>(&self, py: Python<'py>, _: Real) -> PyResult<Parts<'py>> {
        let (shaper, of) = &self.made_of;
        Ok(("_of", (shaper, of).into_pyobject(py)?))
    }
}

/// The steps of a motor that follows a move: an iterator over each `Step`, with its time, s, and its direction, 1 or -1.
///
/// `Steps(move, offset, step)`: line `k` is the position `offset + k*step`. The motor stands at the line `count` while the axis is between this
/// line and the next one. With an offset of half a step the motor is never farther than half a step from the axis. No step is lost, whatever is
/// rounded. ValueError if `step` is not above 0, a number is not finite, or a position is too many steps away from the offset.
///
/// >>> import atraj
/// >>> move = atraj.Move.plan(atraj.Limits(jerk=3000, acceleration=200, velocity=50), 0, 10) # mm
/// >>> steps = atraj.Steps(move, offset=0.00625, step=0.0125) # 80 steps per mm
/// >>> pulses = list(steps)
/// >>> pulses[0].direction, len(pulses), steps.count
/// (1, 800, 799)
#[pyclass(module = "atraj")]
pub struct Steps {
    inner: machine::Steps<Real>,
    of: Py<Move>,
    offset: Real,
    step: Real,
    /// The line at the start of the move, and how many steps of the move are taken.
    first: i32,
    taken: usize,
}

const TOO_FAR: &str = "a position is too many steps away from the offset";

#[pymethods]
impl Steps {
    #[new]
    fn new(r#move: &Bound<'_, Move>, offset: Real, step: Real) -> PyResult<Self> {
        let numbers = [
            ("offset", offset, offset.is_finite(), NUMBER),
            ("step", step, step > 0.0 && step.is_finite(), "is not a number above 0"),
            ("step", step, false, "is too small: a position is too many steps away from the offset"),
        ];
        let inner = machine::Steps::new(&r#move.get().0.motion, offset, step);
        let inner = inner.map_err(|why| no_part(why, &numbers))?;
        Ok(Self { inner, of: r#move.clone().unbind(), offset, step, first: inner.count(), taken: 0 })
    }

    /// The line of the motor.
    #[getter]
    fn count(&self) -> i32 {
        self.inner.count()
    }

    /// Goes on with another move from its start, and keeps the motor where it is. So no step is lost where the moves meet.
    fn follow(&mut self, r#move: &Bound<'_, Move>) -> PyResult<()> {
        self.inner.follow(&r#move.get().0.motion).map_err(|_| error(TOO_FAR))?;
        (self.of, self.first, self.taken) = (r#move.clone().unbind(), self.count(), 0);
        Ok(())
    }

    fn __iter__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __next__<'py>(&mut self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let Some(machine::Step { time, direction }) = self.inner.next(&self.of.get().0.motion) else {
            return Ok(None);
        };
        self.taken += 1;
        named(py, "Step", (time, direction)).map(Some)
    }

    /// To look ahead.
    fn __copy__(&self, py: Python<'_>) -> Self {
        Self { of: self.of.clone_ref(py), ..*self }
    }

    fn __deepcopy__(&self, py: Python<'_>, _memo: Bound<'_, PyAny>) -> Self {
        self.__copy__(py)
    }

    /// What a copy is made of. The motor stands at the line `first`, follows the move, and takes so many steps again.
    #[staticmethod]
    fn _from_taken(r#move: &Bound<'_, Move>, offset: Real, step: Real, first: i32, taken: usize) -> PyResult<Self> {
        let position = State::at(offset + (first as Real + 0.5) * step);
        let mut stands = atraj::online::Move::default();
        let stood = stands.plan(&Limits::symmetric(1.0, 1.0, 1.0), position, position);
        let made = stood.and_then(|_| machine::Steps::new(&stands, offset, step));
        let of = r#move.clone().unbind();
        let mut steps = Self { inner: made.map_err(|why| error(&why.to_string()))?, of, offset, step, first, taken };
        steps.follow(r#move)?;
        for _ in 0..taken {
            steps.inner.next(&r#move.get().0.motion).ok_or_else(|| error("the move has fewer steps"))?;
        }
        steps.taken = taken;
        Ok(steps)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let steps = slf.borrow();
        let arguments = (steps.of.clone_ref(slf.py()), steps.offset, steps.step, steps.first, steps.taken);
        rebuilding(slf.as_any(), "_from_taken", arguments.into_pyobject(slf.py())?)
    }

    fn __repr__(&self) -> String {
        format!("<Steps at line {}>", self.inner.count())
    }
}

/// The clock of several axes: hold, override and reverse on their path.
///
/// `Clock(limits, moves)` runs `Moves` or a `Path` by a time of its own, which runs as planned until `rate` changes it. So the axes never leave
/// their path. The axes have the limits in `limits`, an item for each: those of the plan and a reserve, 10 to 20 % for example, because
/// braking the time costs acceleration and jerk. ValueError says which limit is wrong.
///
/// >>> import atraj
/// >>> planned = [atraj.Limits(jerk=16, acceleration=4, velocity=0.8)] * 2
/// >>> limits = [atraj.Limits(jerk=20, acceleration=5, velocity=1)] * 2
/// >>> clock = atraj.Clock(limits, atraj.synchronise(planned, [0, 0], [0.8, -0.4]))
/// >>> found = clock.rate(0.5, 0) # the button is pressed at 0.5 s
/// >>> held = clock.until
/// >>> bool((clock.velocity(held + 1) == 0).all())
/// True
/// >>> found = clock.rate(held + 2, 1) # and released
/// >>> clock.position(10)
/// array([ 0.8, -0.4])
#[pyclass(module = "atraj")]
pub struct Clock {
    inner: machine::Clock<Real>,
    limits: Vec<Limits<Real>>,
    /// The moves of all axes, section by section.
    moves: Vec<atraj::online::Move<Real>>,
    /// Duration of the path, s.
    t: Real,
    of: Py<Axes>,
    /// Each change of the rate: when, s, and the new rate; or none for a new start of the times.
    changes: Vec<Change>,
}

type Change = (Real, Option<Real>);

impl Clock {
    /// Position, velocity, acceleration and jerk of an axis at the time `x`, s.
    fn state(&self, x: Real, axis: usize) -> [Real; 4] {
        self.inner.state(&self.moves[axis..], self.limits.len(), x)
    }
}

impl Rows<Real> for Clock {
    fn axes(&self) -> usize {
        self.limits.len()
    }

    fn quantities(&self, x: Real, axis: usize) -> [Real; 4] {
        self.state(x, axis)
    }
}

#[pymethods]
impl Clock {
    #[new]
    fn new(limits: Vec<GivenLimits<Real>>, moves: &Bound<'_, Axes>) -> PyResult<Self> {
        Ok(Self {
            inner: machine::Clock::new(),
            limits: moves.get().limits(&limits)?,
            moves: moves.get().sections.concat(),
            t: moves.get().lasts(),
            of: moves.clone().unbind(),
            changes: Vec::new(),
        })
    }

    /// Goes to another rate from `time` on, s, which is not before the last change: 1 as planned, 0 hold, 0.5 half as fast, -1 back along
    /// the path. Until the end of the path, or until its start if the rate is negative, no axis exceeds its limits. `time` may be ahead: until then the
    /// clock goes on as it did. Returns `Findings`: RATE_NOT_REACHED if the path ends before. ValueError if no such change is found, `time` is before
    /// the last change, or a number is not finite; then the clock goes on as it did.
    fn rate<'py>(&mut self, py: Python<'py>, time: Real, rate: Real) -> PyResult<Bound<'py, PyAny>> {
        let changed = self.inner.rate(&self.moves, &self.limits, time, rate);
        let found = changed.map_err(|why| match why {
            Error::Target => error(&format!(
                "no change to the rate {rate} at {time} s keeps the limits: they need a reserve beyond those of the plan"
            )),
            Error::NotFinite => no_part(why, &[
                ("time", time, time.is_finite(), NUMBER),
                ("rate", rate, rate.is_finite(), NUMBER),
            ]),
            Error::Late => error(&format!("time = {time} is before the last change")),
            _ => error(&why.to_string()),
        })?;
        self.changes.push((time, Some(rate)));
        to_findings(py, found)
    }

    /// `time`, s, is 0 from now on. Times of many hours are rounded coarsely.
    fn rebase(&mut self, time: Real) {
        self.inner.rebase(time);
        self.changes.push((time, None));
    }

    /// When the last rate is reached, s; the end of the path if it is not reached.
    #[getter]
    fn until(&self) -> Real {
        self.inner.until()
    }

    /// The time of the path at `time`, s. Until the first change it is `time`.
    fn time(&self, time: Real) -> Real {
        self.inner.time(time)
    }

    /// Positions at `time`, s, or a row of them for each of an array of times.
    fn position<'py>(&self, time: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.rows(time, 0)
    }

    /// Velocities at `time`, s.
    fn velocity<'py>(&self, time: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.rows(time, 1)
    }

    /// Accelerations at `time`, s.
    fn acceleration<'py>(&self, time: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.rows(time, 2)
    }

    /// Jerks at `time`, s.
    fn jerk<'py>(&self, time: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.rows(time, 3)
    }

    /// The `State` of each axis at `time`, s.
    fn state_at<'py>(&self, py: Python<'py>, time: Real) -> PyResult<Bound<'py, PyList>> {
        let states = (0..self.axes()).map(|axis| {
            let [position, velocity, acceleration, _] = self.state(time, axis);
            to_state(py, State { position, velocity, acceleration })
        });
        PyList::new(py, states.collect::<PyResult<Vec<_>>>()?)
    }

    /// `Samples` as of `Moves`, with the time `start + k*dt`, s. A clock that holds never ends, so `n` is needed.
    #[pyo3(signature = (dt, *, n, start=0.0))]
    fn sample<'py>(&self, py: Python<'py>, dt: Real, n: usize, start: Real) -> PyResult<Bound<'py, PyAny>> {
        let (dt, n, out) = (Some(dt), Some(n), None);
        Rows::sample(self, py, Request { dt, n, start, out }, self.t)
    }

    /// To try a change.
    fn __copy__(&self, py: Python<'_>) -> Self {
        let Self { inner, ref limits, ref moves, t, ref of, ref changes } = *self;
        let (limits, moves, changes) = (limits.clone(), moves.clone(), changes.clone());
        Self { inner, limits, moves, t, of: of.clone_ref(py), changes }
    }

    fn __deepcopy__(&self, py: Python<'_>, _memo: Bound<'_, PyAny>) -> Self {
        self.__copy__(py)
    }

    /// What a copy is made of: the changes, made again.
    #[staticmethod]
    fn _from_changes(
        py: Python<'_>, limits: Vec<GivenLimits<Real>>, moves: &Bound<'_, Axes>, changes: Vec<Change>,
    ) -> PyResult<Self> {
        let mut clock = Self::new(limits, moves)?;
        for (x, rate) in changes {
            match rate {
                Some(rate) => drop(clock.rate(py, x, rate)?),
                None => clock.rebase(x),
            }
        }
        Ok(clock)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let (py, clock) = (slf.py(), slf.borrow());
        let limits = clock.limits.iter().map(|&limits| PyTuple::new(py, limits_numbers(limits)));
        let limits = limits.collect::<PyResult<Vec<_>>>()?;
        let arguments = (PyTuple::new(py, limits)?, clock.of.clone_ref(py), clock.changes.clone());
        rebuilding(slf.as_any(), "_from_changes", arguments.into_pyobject(py)?)
    }

    fn __repr__(&self) -> String {
        let (axes, until) = (self.axes(), self.inner.until());
        format!("<Clock of {axes} axes, whose last rate is reached at {until} s>")
    }
}
