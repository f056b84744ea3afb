//! Way points without stops.

use atraj::axes::{improve_path, path_size, plan_path, synchronise};
use atraj::online::{Limits, Move};
use atraj::{Findings, State};
use numpy::{PyArray1, PyReadonlyArrayDyn, PyReadwriteArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use super::Real;
use crate::motion::{Request, empty, in_rows};
use crate::values::{
    LimitsTuple, StateTuple, error, from_limits, from_state, named, no_move, to_state,
};

/// Adds the class and the function to a module.
pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Path>()?;
    module.add_function(wrap_pyfunction!(path, module)?)
}

/// A motion of several axes through way points, without stops between them unless an axis must turn there: what `path` plans.
///
/// A time is in seconds since the start. A result has one number for each axis, and an array of times one such row for each time.
#[pyclass(frozen)]
pub struct Path {
    axes: usize,
    /// The motions of each section, one for each axis.
    sections: Vec<Vec<Move<Real>>>,
    /// When each point is passed, s.
    times: Vec<Real>,
    findings: Findings,
    /// The states of all axes, point by point.
    states: Vec<State<Real>>,
    /// Those of the axes, or of the axes section by section.
    limits: Vec<Limits<Real>>,
}

/// A quantity of a motion at a time.
type Quantity = fn(&Move<Real>, Real) -> Real;
const QUANTITIES: [Quantity; 4] = [
    Move::position,
    Move::velocity,
    Move::acceleration,
    Move::jerk,
];

/// `plan_path` or `improve_path`.
type Planner = fn(
    &mut [State<Real>],
    &mut [Real],
    &[Limits<Real>],
    u32,
    &mut [Real],
) -> Result<Findings, atraj::Error>;

impl Path {
    fn plan(
        planner: Planner,
        axes: usize,
        mut states: Vec<State<Real>>,
        mut durations: Vec<Real>,
        limits: Vec<Limits<Real>>,
        steps: u32,
    ) -> PyResult<Self> {
        let sections = durations.len();
        let mut work = Vec::new();
        path_size(axes, sections)
            .and_then(|size| {
                work.try_reserve_exact(size)
                    .ok()
                    .map(|()| work.resize(size, 0.0))
            })
            .ok_or_else(|| PyMemoryError::new_err(format!("no memory for {sections} sections")))?;
        let findings =
            planner(&mut states, &mut durations, &limits, steps, &mut work).map_err(no_move)?;
        let mut path = Self {
            axes,
            sections: Vec::new(),
            times: vec![0.0],
            findings,
            states,
            limits,
        };
        let mut passed = 0.0;
        for (section, duration) in durations.into_iter().enumerate() {
            let mut motions = vec![Move::default(); axes];
            let [from, to] =
                [section, section + 1].map(|point| &path.states[point * axes..(point + 1) * axes]);
            let zone = if path.limits.len() == axes {
                0
            } else {
                section
            };
            let limits = &path.limits[zone * axes..(zone + 1) * axes];
            synchronise(&mut motions, limits, from, to, duration, 0.0).map_err(no_move)?;
            passed += motions[0].t;
            path.times.push(passed);
            path.sections.push(motions);
        }
        Ok(path)
    }

    /// The motions at the time `x`, s, and the time since the start of their section, s.
    fn at(&self, x: Real) -> (&[Move<Real>], Real) {
        let begun = self.times.partition_point(|&start| start <= x);
        let section = begun.saturating_sub(1).min(self.sections.len() - 1);
        let motions = &self.sections[section];
        let is_over = begun == self.times.len();
        (
            motions,
            if is_over {
                motions[0].t
            } else {
                x - self.times[section]
            },
        )
    }

    /// A quantity of all axes at a time, s, or at each of an array of times.
    fn values<'py>(
        &self,
        times: &Bound<'py, PyAny>,
        quantity: Quantity,
    ) -> PyResult<Bound<'py, PyAny>> {
        let times: PyReadonlyArrayDyn<Real> = in_rows(times)?;
        let shape = times.shape().iter().copied().chain([self.axes]);
        let rows = empty::<Real>(
            times.py(),
            PyTuple::new(times.py(), shape.collect::<Vec<_>>())?,
        )?;
        let mut numbers: PyReadwriteArrayDyn<Real> = rows.extract()?;
        let rows_of_axes = numbers.as_slice_mut()?.chunks_exact_mut(self.axes);
        for (row, &x) in rows_of_axes.zip(times.as_slice()?) {
            let (motions, x) = self.at(x);
            for (number, motion) in row.iter_mut().zip(motions) {
                *number = quantity(motion, x);
            }
        }
        Ok(rows)
    }
}

#[pymethods]
impl Path {
    /// Duration, s.
    #[getter]
    fn t(&self) -> Real {
        self.times[self.sections.len()]
    }

    /// The times at which the points are passed, s, from 0 to `t`.
    #[getter]
    fn times<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<Real>> {
        PyArray1::from_slice(py, &self.times)
    }

    /// The `Findings` of the plan: STARTS_OUTSIDE or none.
    #[getter]
    fn findings<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        named(py, "Findings", (self.findings.bits(),))
    }

    /// Positions at the time `x`, s. Before the start they are those of the first point, after the end those of the last one.
    fn position<'py>(&self, x: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.values(x, Move::position)
    }

    /// Velocities at the time `x`, s.
    fn velocity<'py>(&self, x: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.values(x, Move::velocity)
    }

    /// Accelerations at the time `x`, s.
    fn acceleration<'py>(&self, x: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.values(x, Move::acceleration)
    }

    /// Jerks at the time `x`, s.
    fn jerk<'py>(&self, x: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.values(x, Move::jerk)
    }

    /// The `State` of each axis at the time `x`, s: where another path starts.
    fn state_at<'py>(&self, py: Python<'py>, x: Real) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let (motions, x) = self.at(x);
        let states = motions.iter().map(|motion| motion.state_at(x));
        states.map(|state| to_state(py, state)).collect()
    }

    /// `Samples`: times, and a row of positions, velocities, accelerations and jerks for each time.
    ///
    /// Sample `k` belongs to the time `start + k*dt`, s. `dt` alone samples until the end is reached, `n` alone takes `n` samples
    /// evenly from the start to the end. ValueError for more than 2147483647 samples.
    ///
    /// >>> import atraj
    /// >>> limits = [atraj.Limits.symmetric(30, 10, 5)] * 2
    /// >>> atraj.path([[0, 0], [3, 1], [4, 5]], limits).sample(0.01).p.shape
    /// (226, 2)
    #[pyo3(signature = (dt=None, *, n=None, start=0.0))]
    fn sample<'py>(
        &self,
        py: Python<'py>,
        dt: Option<Real>,
        n: Option<usize>,
        start: Real,
    ) -> PyResult<Bound<'py, PyAny>> {
        let out = None;
        let times = Request { dt, n, start, out }.times(py, self.t())?;
        let [p, v, a, j] = QUANTITIES.map(|quantity| self.values(&times, quantity));
        named(py, "Samples", (times, p?, v?, a?, j?))
    }

    /// Draws position, velocity, acceleration and jerk of all axes over time, with a dot at each way point, and returns the figure.
    /// Needs matplotlib.
    fn plot<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let py = slf.py();
        py.import("atraj._plot")?.call_method1("plot_path", (slf,))
    }

    /// A path through the same points that is not longer, from at most `steps` steps (0: as many as the path needs, at most 48).
    ///
    /// >>> import atraj
    /// >>> limits = [atraj.Limits.symmetric(30, 10, 5)] * 2
    /// >>> hasty = atraj.path([[0, 0], [3, 1], [4, 5]], limits, steps=4)
    /// >>> hasty.improve().t < hasty.t
    /// True
    #[pyo3(signature = (*, steps=0))]
    fn improve(&self, steps: u32) -> PyResult<Self> {
        let durations = self.sections.iter().map(|motions| motions[0].t).collect();
        let (states, limits) = (self.states.clone(), self.limits.clone());
        Self::plan(improve_path, self.axes, states, durations, limits, steps)
    }

    fn __repr__(&self) -> String {
        let Self { axes, times, .. } = self;
        format!(
            "<Path of {axes} axes through {} points in {} s>",
            times.len(),
            self.t()
        )
    }
}

/// A coordinate of a point: a position or a `State`.
enum Coordinate {
    Position(Real),
    State(State<Real>),
}

impl Coordinate {
    fn of(number: &Bound<'_, PyAny>) -> Option<Self> {
        let state = || number.extract::<StateTuple<Real>>().map(from_state);
        let position = number.extract().map(Self::Position);
        position.or_else(|_| state().map(Self::State)).ok()
    }

    fn state(&self) -> State<Real> {
        match *self {
            Self::Position(position) => State::at(position),
            Self::State(state) => state,
        }
    }
}

/// Limits of the axes, or of the axes section by section.
#[derive(FromPyObject)]
pub enum PathLimits {
    Axes(Vec<LimitsTuple<Real>>),
    Sections(Vec<Vec<LimitsTuple<Real>>>),
}

/// A fast path of several axes through points, which all axes pass at the same times. They stop nowhere between the first point and
/// the last one unless they must.
///
/// A point has a position for each axis, and `limits` has an item for each axis, or for each section a list of them. The path starts and ends at rest; the first and the last
/// point may have a `State` in the place of a position. The planner takes at most `steps` steps (0: as many as the path needs, at most 48).
/// ValueError says which point or axis is wrong.
///
/// >>> import atraj
/// >>> limits = [atraj.Limits.symmetric(30, 10, 5)] * 2
/// >>> path = atraj.path([[0, 0], [3, 1], [4, 5]], limits)
/// >>> path.position(path.times)
/// array([[0., 0.],
///        [3., 1.],
///        [4., 5.]])
/// >>> bool((path.velocity(path.times[1]) > 1).all())
/// True
#[pyfunction]
#[pyo3(signature = (points, limits, *, steps=0))]
pub fn path(points: Vec<Vec<Bound<'_, PyAny>>>, limits: PathLimits, steps: u32) -> PyResult<Path> {
    let points = coordinates(&points)?;
    let sections = points.len().saturating_sub(1);
    let zones = match limits {
        PathLimits::Axes(limits) => vec![limits],
        PathLimits::Sections(zones) if zones.len() == sections => zones,
        PathLimits::Sections(zones) => {
            let count = zones.len();
            return Err(error(&format!(
                "limits has {count} lists, and the path {sections} sections"
            )));
        }
    };
    let zones: Vec<Vec<_>> = zones
        .into_iter()
        .map(|limits| limits.into_iter().map(from_limits).collect())
        .collect();
    for (k, limits) in zones.iter().enumerate() {
        check(&points, limits, k + 1 == zones.len())?;
    }
    let axes = zones.first().map_or(0, Vec::len);
    let states = points.iter().flatten().map(Coordinate::state).collect();
    let durations = vec![0.0; sections];
    Path::plan(plan_path, axes, states, durations, zones.concat(), steps)
}

fn coordinates(points: &[Vec<Bound<'_, PyAny>>]) -> PyResult<Vec<Vec<Coordinate>>> {
    let point = |(k, numbers): (usize, &Vec<Bound<'_, PyAny>>)| {
        let numbers = numbers.iter().enumerate();
        let coordinates = numbers.map(|(axis, number)| {
            Coordinate::of(number).ok_or_else(|| wrong(k, axis, "neither a number nor a state"))
        });
        coordinates.collect()
    };
    points.iter().enumerate().map(point).collect()
}

/// A `ValueError` about a coordinate.
fn wrong(point: usize, axis: usize, why: &str) -> PyErr {
    error(&format!("point {point}, axis {axis}: {why}"))
}

/// A `ValueError` that names the point or the axis, if there is no path. The path ends within its last limits.
fn check(points: &[Vec<Coordinate>], limits: &[Limits<Real>], are_last: bool) -> PyResult<()> {
    let [first, between @ .., last] = points else {
        return Err(error("a path has at least two points"));
    };
    if limits.is_empty() {
        return Err(error("there is no axis: limits is empty"));
    }
    for (k, point) in points.iter().enumerate() {
        if point.len() != limits.len() {
            let [has, axes] = [point.len(), limits.len()];
            return Err(error(&format!(
                "point {k} has {has} coordinates, and limits {axes} axes"
            )));
        }
    }
    for (axis, limits) in limits.iter().enumerate() {
        let mut end = last[axis].state();
        if !are_last {
            end = State::at(end.position);
        }
        let plan = Move::default().plan(limits, first[axis].state(), end);
        plan.map_err(|why| error(&format!("axis {axis}: {why}")))?;
    }
    for (k, point) in (1..).zip(between) {
        for (axis, coordinate) in point.iter().enumerate() {
            let why = match coordinate {
                Coordinate::Position(position) if position.is_finite() => continue,
                Coordinate::Position(_) => atraj::Error::NotFinite.to_string(),
                Coordinate::State(_) => "only the first and the last point have states".into(),
            };
            return Err(wrong(k, axis, &why));
        }
    }
    Ok(())
}
