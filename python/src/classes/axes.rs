//! Several axes: what their motions have in common, and moves that arrive together.

use atraj::axes;
use atraj::online::{Limits, Move as Motion};
use atraj::{Error, Findings, State};
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};

use super::Real;
use super::online::Move;
use super::profiles::rebuilding;
use crate::motion::{Planned, Request, Rows};
use crate::values::{GivenLimits, GivenState, error, to_findings, to_state};
use crate::why::{each_alone, no_move};

/// Adds the classes and the functions to a module.
pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Axes>()?;
    module.add_class::<Moves>()?;
    module.add_function(wrap_pyfunction!(synchronise, module)?)?;
    module.add_function(wrap_pyfunction!(synchronise_within, module)?)?;
    module.add_function(wrap_pyfunction!(line, module)?)?;
    module.add_function(wrap_pyfunction!(line_stop, module)?)
}

/// The lowest and the highest position of an axis that may be anywhere.
pub const ANYWHERE: [Real; 2] = [Real::NEG_INFINITY, Real::INFINITY];

/// So many times are evaluated for one axis after the other: their rows stay in the cache.
const BLOCK: usize = 512;

/// A planned motion of several axes: what `Moves` and `Path` have in common.
///
/// Times are in seconds since the start of the motion. A result has one number for each axis, and an array of times gives one such row for
/// each time. Before the start the axes are at the start. After the end each of them moves on with the acceleration of the end: an axis that
/// ends at rest stays.
#[pyclass(module = "atraj", frozen, subclass)]
pub struct Axes {
    /// The motions of each section, one for each axis.
    pub sections: Vec<Vec<Motion<Real>>>,
    /// When each section begins, and when the last one ends, s.
    pub times: Vec<Real>,
    pub findings: Findings,
}

impl Axes {
    /// The motion through these sections, each of them with as many axes, at least one.
    pub fn new(sections: Vec<Vec<Motion<Real>>>, findings: Findings) -> Self {
        let mut times = vec![0.0];
        let mut passed = 0.0;
        for section in &sections {
            passed += section[0].t;
            times.push(passed);
        }
        Self { sections, times, findings }
    }

    /// Duration, s.
    pub fn lasts(&self) -> Real {
        self.times[self.sections.len()]
    }

    /// The limits of the axes, an item for each.
    pub fn limits(&self, given: &[GivenLimits<Real>]) -> PyResult<Vec<Limits<Real>>> {
        let axes = self.axes();
        if given.len() != axes {
            let count = given.len();
            return Err(error(&format!("limits has {count} items, and moves {axes} axes")));
        }
        let limits: Vec<_> = given.iter().map(|limits| limits.0).collect();
        let rest = [State::at(0.0); 2];
        each_alone(limits.iter().map(|&limits| (limits, rest, ANYWHERE)))?;
        Ok(limits)
    }

    /// The section at the time `x`, s. A NaN is at the end, as for one axis.
    fn section(&self, x: Real) -> usize {
        let begun = self.times.partition_point(|start| x.is_nan() || *start <= x);
        begun.saturating_sub(1).min(self.sections.len() - 1)
    }

    /// The time since the start of the section at the time `x`, s.
    fn since(&self, section: usize, x: Real) -> Real {
        let is_over = section > 0 && (x.is_nan() || self.lasts() <= x);
        // The sum of the durations is rounded, and the end is where the last section ends.
        if is_over { self.sections[section][0].t + (x - self.lasts()) } else { x - self.times[section] }
    }

    /// Writes a row of the values of all axes for each of the times, s. Times that follow each other in one section share the search for it.
    fn fill(&self, times: &[Real], rows: &mut [Real], value: impl Fn(&Motion<Real>, Real) -> Real) {
        let axes = self.axes();
        let (mut times, mut rows) = (times, rows);
        while let Some(&first) = times.first() {
            let section = self.section(first);
            let lasting = self.times[section]..self.times[section + 1];
            let inside = times.iter().take(BLOCK).take_while(|x| lasting.contains(x)).count();
            let since = |x| if inside > 0 { x - lasting.start } else { self.since(section, x) };
            let (here, later) = times.split_at(inside.max(1));
            let (now, then) = rows.split_at_mut(axes * here.len());
            for (axis, motion) in self.sections[section].iter().enumerate() {
                for (row, &x) in now.chunks_exact_mut(axes).zip(here) {
                    row[axis] = value(motion, since(x));
                }
            }
            (times, rows) = (later, then);
        }
    }

    /// Writes position, velocity, acceleration and jerk of all axes into an array each: a row for each of the times, s.
    fn fill_all(&self, times: &[Real], arrays: &mut [&mut [Real]]) {
        let axes = self.axes();
        for (k, &x) in times.iter().enumerate() {
            let section = self.section(x);
            let since = self.since(section, x);
            for (axis, motion) in self.sections[section].iter().enumerate() {
                for (rows, number) in arrays.iter_mut().zip(motion.state(since)) {
                    rows[k * axes + axis] = number;
                }
            }
        }
    }
}

/// The place in a sequence of `count` items, from its end on if it is negative. `names` are those of one item and of several.
pub fn place(index: isize, count: usize, names: [&str; 2]) -> PyResult<usize> {
    let from_start = if index < 0 { index + count as isize } else { index };
    let [one, several] = names;
    let none = || PyIndexError::new_err(format!("{one} {index} of {count} {several}"));
    usize::try_from(from_start).ok().filter(|&place| place < count).ok_or_else(none)
}

impl Rows<Real> for Axes {
    fn axes(&self) -> usize {
        self.sections[0].len()
    }

    fn quantities(&self, x: Real, axis: usize) -> [Real; 4] {
        let section = self.section(x);
        self.sections[section][axis].state(self.since(section, x))
    }

    fn write(&self, times: &[Real], quantity: Option<usize>, arrays: &mut [&mut [Real]]) {
        match (quantity, arrays) {
            (Some(0), [rows]) => self.fill(times, rows, Motion::position),
            (Some(1), [rows]) => self.fill(times, rows, Motion::velocity),
            (Some(2), [rows]) => self.fill(times, rows, Motion::acceleration),
            (Some(_), [rows]) => self.fill(times, rows, Motion::jerk),
            (_, arrays) => self.fill_all(times, arrays),
        }
    }
}

#[pymethods]
impl Axes {
    /// Duration, s.
    #[getter]
    fn t(&self) -> Real {
        self.lasts()
    }

    /// The `Findings` of the plan: what any axis does.
    #[getter]
    fn findings<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_findings(py, self.findings)
    }

    /// Positions at `time`, s.
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

    /// The `State` of each axis at `time`, s: where another plan starts.
    fn state_at<'py>(&self, py: Python<'py>, time: Real) -> PyResult<Bound<'py, PyList>> {
        let section = self.section(time);
        let since = self.since(section, time);
        let states = self.sections[section].iter().map(|motion| to_state(py, motion.state_at(since)));
        PyList::new(py, states.collect::<PyResult<Vec<_>>>()?)
    }

    /// `Samples`: times, and a row of positions, velocities, accelerations and jerks for each time.
    ///
    /// Sample `k` belongs to the time `start + k*dt`, s. `dt` alone samples until the end is reached, `n` alone takes `n` samples
    /// evenly from the start to the end. ValueError for more than 2147483647 samples.
    ///
    /// >>> import atraj
    /// >>> limits = [atraj.Limits(jerk=30, acceleration=10, velocity=5)] * 2
    /// >>> atraj.path(limits, [[0, 0], [3, 1], [4, 5]]).sample(0.01).p.shape
    /// (226, 2)
    #[pyo3(signature = (dt=None, *, n=None, start=0.0))]
    fn sample<'py>(
        &self, py: Python<'py>, dt: Option<Real>, n: Option<usize>, start: Real,
    ) -> PyResult<Bound<'py, PyAny>> {
        let out = None;
        Rows::sample(self, py, Request { dt, n, start, out }, self.lasts())
    }

    /// Draws position, velocity, acceleration and jerk of all axes over time, in a colour each, and returns the figure. Needs matplotlib.
    ///
    /// With `plane=(0, 1)` it draws the axes 0 and 1 in their plane, on equal scales, in the place of the motion over time. `limits`, an item
    /// for each axis, are drawn as dashed lines in the colours of the axes. The labels have the `unit` of the positions, and `labels` names
    /// the axes. `axes`, the axes of a figure, draws over what is there. The motion begins at the time `offset`, s.
    #[pyo3(signature = (*, axes=None, limits=None, unit=None, labels=None, plane=None, offset=0.0))]
    fn plot<'py>(
        slf: &Bound<'py, Self>, axes: Option<Bound<'py, PyAny>>, limits: Option<Bound<'py, PyAny>>, unit: Option<&str>,
        labels: Option<Bound<'py, PyAny>>, plane: Option<(usize, usize)>, offset: f64,
    ) -> PyResult<Bound<'py, PyAny>> {
        let plot = slf.py().import("atraj._plot")?.getattr("plot_axes")?;
        plot.call1((slf, axes, limits, unit, labels, plane, offset))
    }

    /// Equal are motions of one class with the same numbers.
    fn __eq__(slf: &Bound<'_, Self>, other: &Bound<'_, PyAny>) -> PyResult<bool> {
        if !slf.get_type().is(other.get_type()) {
            return Ok(false);
        }
        let [ours, theirs] = [slf.as_any(), other].map(|motion| motion.call_method0("__reduce__"));
        ours?.get_item(1)?.eq(theirs?.get_item(1)?)
    }

    fn __hash__(&self) -> PyResult<isize> {
        Ok(self.lasts().to_bits() as isize)
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}

/// Moves of several axes that arrive together: what `synchronise`, `synchronise_within`, `line` and `line_stop` plan. It is a sequence of a
/// `Move` for each axis.
#[pyclass(module = "atraj", frozen, extends = Axes, sequence)]
pub struct Moves;

impl Moves {
    pub fn of(axes: Vec<Motion<Real>>, findings: Findings) -> PyClassInitializer<Self> {
        PyClassInitializer::from(Axes::new(vec![axes], findings)).add_subclass(Self)
    }

    fn all<'py>(slf: &Bound<'py, Self>) -> PyResult<Vec<Py<Move>>> {
        let Axes { sections, findings, .. } = slf.as_super().get();
        let planned = |&motion: &Motion<Real>| {
            let findings = *findings;
            Move::of(slf.py(), Planned { motion, findings })
        };
        sections[0].iter().map(planned).collect()
    }
}

#[pymethods]
impl Moves {
    fn __len__(slf: &Bound<'_, Self>) -> usize {
        slf.as_super().get().axes()
    }

    fn __getitem__(slf: &Bound<'_, Self>, axis: isize) -> PyResult<Py<Move>> {
        let axis = place(axis, Self::__len__(slf), ["axis", "axes"])?;
        Ok(Self::all(slf)?.swap_remove(axis))
    }

    fn __iter__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        Ok(PyList::new(slf.py(), Self::all(slf)?)?.try_iter()?.into_any())
    }

    /// What a copy is made of.
    #[staticmethod]
    fn _from_moves(py: Python<'_>, moves: Vec<Bound<'_, Move>>) -> PyResult<Py<Self>> {
        let planned: Vec<Planned<Real>> = moves.iter().map(|axis| *axis.get().0).collect();
        let first = planned.first().ok_or_else(|| error("there is no axis"))?;
        let findings = first.findings;
        let axes = planned.iter().map(|planned| planned.motion).collect();
        Py::new(py, Self::of(axes, findings))
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let moves = PyTuple::new(slf.py(), Self::all(slf)?)?;
        rebuilding(slf.as_any(), "_from_moves", PyTuple::new(slf.py(), [moves])?)
    }

    fn __repr__(slf: &Bound<'_, Self>) -> String {
        let (axes, t) = (Self::__len__(slf), slf.as_super().get().lasts());
        format!("<Moves of {axes} axes in {t} s>")
    }
}

/// Moves of several axes that arrive together: the shortest duration that is possible for each axis, is at least `duration`, s, and is
/// a multiple of `cycle`, s (0: any). An item of `limits`, `start` and `end` belongs to one axis. ValueError as for one axis.
///
/// >>> import atraj
/// >>> limits = [atraj.Limits(jerk=30, acceleration=10, velocity=5), atraj.Limits(jerk=60, acceleration=20, velocity=5)]
/// >>> moves = atraj.synchronise(limits, [0, 0], [10, -1])
/// >>> moves.position(moves.t)
/// array([10., -1.])
/// >>> x, y = moves
/// >>> x.t == y.t == moves.t
/// True
#[pyfunction]
#[pyo3(signature = (limits, start, end, *, duration=0.0, cycle=0.0))]
pub fn synchronise(
    py: Python<'_>, limits: Vec<GivenLimits<Real>>, start: Vec<GivenState<Real>>, end: Vec<GivenState<Real>>,
    duration: Real, cycle: Real,
) -> PyResult<Py<Moves>> {
    let (ends, times) = ([&start[..], &end], [duration, cycle]);
    let anywhere = |_| ANYWHERE;
    together(py, &limits, ends, anywhere, times, |moves, limits, ends| {
        let [start, end] = ends;
        axes::synchronise(moves, limits, start, end, duration, cycle)
    })
}

/// Moves of several axes that arrive together, as `synchronise` plans them, but each axis stays between two positions until its end: its
/// items of `lowest` and `highest`, where `-inf` and `inf` are no limits.
///
/// An axis that would leave its positions on a slower way makes its fastest move and waits, or it stops, waits and goes, or it is slower
/// between its turns at the positions. ValueError as for `Move.within`.
///
/// >>> import atraj
/// >>> limits = [atraj.Limits(jerk=30, acceleration=10, velocity=5)] * 2
/// >>> start, end = [0, (9, 2)], [10, 8] # y turns
/// >>> x, y = atraj.synchronise(limits, start, end)
/// >>> round(y.extremes().highest.position, 4)
/// 9.4912
/// >>> x, y = atraj.synchronise_within(limits, start, end, lowest=[0, 0], highest=[10, 9.49])
/// >>> round(y.extremes().highest.position, 4)
/// 9.487
#[pyfunction]
#[pyo3(signature = (limits, start, end, lowest, highest, *, duration=0.0, cycle=0.0))]
#[allow(clippy::too_many_arguments)]
pub fn synchronise_within(
    py: Python<'_>, limits: Vec<GivenLimits<Real>>, start: Vec<GivenState<Real>>, end: Vec<GivenState<Real>>,
    lowest: Vec<Real>, highest: Vec<Real>, duration: Real, cycle: Real,
) -> PyResult<Py<Moves>> {
    are_as_long(&[("limits", limits.len()), ("lowest", lowest.len()), ("highest", highest.len())])?;
    let (ends, times) = ([&start[..], &end], [duration, cycle]);
    let between = |axis: usize| [lowest[axis], highest[axis]];
    together(py, &limits, ends, between, times, |moves, limits, ends| {
        let ([start, end], positions) = (ends, [&lowest[..], &highest]);
        axes::synchronise_within(moves, limits, start, end, positions, duration, cycle)
    })
}

/// Moves of several axes on the straight line from their start to their end: the fastest motion on it that lasts at least `duration`,
/// s, and a multiple of `cycle`, s (0: any). ValueError also if velocities and accelerations do not point along the line.
///
/// >>> import atraj
/// >>> limits = [atraj.Limits(jerk=20, acceleration=4, velocity=1), atraj.Limits(jerk=10, acceleration=2, velocity=0.8)]
/// >>> x, y = atraj.line(limits, [0, 0], [0.8, 0.4], cycle=0.001)
/// >>> abs(x.position(0.5) - 2 * y.position(0.5)) < 1e-15
/// True
#[pyfunction]
#[pyo3(signature = (limits, start, end, *, duration=0.0, cycle=0.0))]
pub fn line(
    py: Python<'_>, limits: Vec<GivenLimits<Real>>, start: Vec<GivenState<Real>>, end: Vec<GivenState<Real>>,
    duration: Real, cycle: Real,
) -> PyResult<Py<Moves>> {
    let (ends, times) = ([&start[..], &end], [duration, cycle]);
    let anywhere = |_| ANYWHERE;
    together(py, &limits, ends, anywhere, times, |moves, limits, ends| {
        let [start, end] = ends;
        axes::line(moves, limits, start, end, duration, cycle)
    })
}

/// The moves that `plan` writes. ValueError names the first axis that cannot be planned alone, else a time.
fn together(
    py: Python<'_>, limits: &[GivenLimits<Real>], [start, end]: [&[GivenState<Real>]; 2],
    positions: impl Fn(usize) -> [Real; 2], [duration, cycle]: [Real; 2],
    plan: impl FnOnce(&mut [Motion<Real>], &[Limits<Real>], [&[State<Real>]; 2]) -> Result<Findings, Error>,
) -> PyResult<Py<Moves>> {
    are_as_long(&[("limits", limits.len()), ("start", start.len()), ("end", end.len())])?;
    let limits: Vec<_> = limits.iter().map(|limits| limits.0).collect();
    let [start, end] = [start, end].map(|states| states.iter().map(|s| s.0).collect::<Vec<_>>());
    let mut moves = vec![Motion::default(); limits.len()];
    let findings = plan(&mut moves, &limits, [&start, &end]).map_err(|why| {
        let asked = |axis: usize| (limits[axis], [start[axis], end[axis]], positions(axis));
        let any = Limits::symmetric(1.0, 1.0, 1.0);
        let times = [("duration", duration), ("cycle", cycle)];
        match each_alone((0..limits.len()).map(asked)) {
            Err(refused) => refused,
            Ok(()) if why == Error::Axes => error("there is no axis: limits, start and end are empty"),
            Ok(()) => no_move(why, "", &any, &[], &times),
        }
    })?;
    Py::new(py, Moves::of(moves, findings))
}

/// ValueError if the lists, each with its name, have different lengths.
pub fn are_as_long(lists: &[(&str, usize)]) -> PyResult<()> {
    if lists.iter().all(|(_, length)| *length == lists[0].1) {
        return Ok(());
    }
    let lengths = lists.iter().map(|(name, length)| format!("{name} {length}"));
    let lengths = lengths.collect::<Vec<_>>().join(", ");
    Err(error(&format!("the lists have different lengths: {lengths}")))
}

/// Moves that stop on the straight line of `moves`, from their `time` on, s: a feed hold. The stop begins at its time 0.
///
/// It is the fastest stop on the line within `limits`, an item for each axis, so no reserve is needed. `moves` are those of `line`, or others
/// on one straight line: ValueError if they are not.
///
/// >>> import atraj
/// >>> limits = [atraj.Limits(jerk=20, acceleration=4, velocity=1), atraj.Limits(jerk=10, acceleration=2, velocity=0.8)]
/// >>> moves = atraj.line(limits, [0, 0], [0.8, 0.4])
/// >>> x, y = stop = atraj.line_stop(limits, moves, 0.5) # the button is pressed at 0.5 s
/// >>> stop.velocity(stop.t)
/// array([0., 0.])
/// >>> abs(x.position(stop.t) - 2 * y.position(stop.t)) < 1e-15
/// True
#[pyfunction]
pub fn line_stop(
    py: Python<'_>, limits: Vec<GivenLimits<Real>>, moves: &Bound<'_, Moves>, time: Real,
) -> PyResult<Py<Moves>> {
    let planned = moves.as_super().get();
    let limits = planned.limits(&limits)?;
    let mut moves = planned.sections[0].clone();
    let stopped = axes::line_stop(&mut moves, &limits, time);
    let findings = stopped.map_err(|why| match why {
        Error::Line => error("the moves are not on one straight line"),
        _ => error(&why.to_string()),
    })?;
    Py::new(py, Moves::of(moves, findings))
}
