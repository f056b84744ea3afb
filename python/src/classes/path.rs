//! Waypoints without stops.

use atraj::axes::{
    Contour, improve_path, limit_feed, path_deviation, path_moves, path_size, path_size_near, plan_contour, plan_path,
    plan_path_near,
};
use atraj::online::{Limits, Move, Phase};
use atraj::{Findings, State};
use numpy::PyArray1;
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};

use super::Real;
use super::axes::{ANYWHERE, Axes, Moves, place};
use super::profiles::rebuilding;
use crate::motion::Rows;
use crate::values::{GivenLimits, GivenState, error, limits_numbers, state_numbers, to_phase};
use crate::why::each_alone;

/// Adds the class and the function to a module.
pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Path>()?;
    module.add_function(wrap_pyfunction!(path, module)?)
}

/// A motion of several axes through waypoints, without stops between them unless an axis must turn there: what `path` plans.
/// It is a sequence of the `Moves` of its sections.
#[pyclass(module = "atraj", frozen, extends = Axes, sequence)]
pub struct Path {
    /// The states of all axes, point by point.
    states: Vec<State<Real>>,
    /// Those of the axes, or of the axes section by section.
    limits: Vec<Limits<Real>>,
}

/// What is planned: `plan_path`, `plan_path_near` or `improve_path`.
enum Plan {
    Through,
    Near(Vec<Real>),
    Improved,
}

/// Working memory of this size.
fn work(size: Option<usize>, sections: usize) -> PyResult<Vec<Real>> {
    let mut work = Vec::new();
    size.and_then(|size| work.try_reserve_exact(size).ok().map(|()| work.resize(size, 0.0)))
        .ok_or_else(|| PyMemoryError::new_err(format!("no memory for {sections} sections")))?;
    Ok(work)
}

impl Plan {
    fn run(
        &self, axes: usize, states: &mut [State<Real>], durations: &mut [Real], limits: &[Limits<Real>], steps: u32,
    ) -> PyResult<Findings> {
        let sections = durations.len();
        let size = if let Self::Near(_) = self { path_size_near } else { path_size };
        let work = &mut work(size(axes, sections), sections)?;
        let planned = match self {
            Self::Through => plan_path(states, durations, limits, axes, steps, work),
            Self::Near(tolerances) => plan_path_near(states, durations, limits, tolerances, axes, steps, work),
            Self::Improved => improve_path(states, durations, limits, axes, steps, work),
        };
        planned.map_err(|why| error(&why.to_string()))
    }
}

/// The library plans no longer path.
const MOST_SECTIONS: usize = 65_536;

impl Path {
    fn plan(
        py: Python<'_>, plan: &Plan, axes: usize, mut states: Vec<State<Real>>, mut durations: Vec<Real>,
        limits: Vec<Limits<Real>>, steps: u32,
    ) -> PyResult<Py<Self>> {
        let findings = plan.run(axes, &mut states, &mut durations, &limits, steps)?;
        Self::of(py, axes, states, &durations, limits, findings)
    }

    /// The path through these points that stays near its lines, with up to 16 times as many sections, and 256.
    fn contour(
        py: Python<'_>, axes: usize, mut states: Vec<State<Real>>, limits: &[Limits<Real>], within: Real, steps: u32,
    ) -> PyResult<Py<Self>> {
        let sections = states.len() / axes - 1;
        let room = (16 * sections + 256).min(MOST_SECTIONS);
        let mut work = work(path_size(axes, room), room)?;
        states.resize(axes * (room + 1), State::at(0.0));
        let (mut moves, mut durations) = (vec![Move::default(); axes * room], vec![0.0; room]);
        let mut places = vec![0; sections + 1];
        let path = Contour { moves: &mut moves, states: &mut states, durations: &mut durations, places: &mut places };
        let findings = plan_contour(path, limits, within, axes, steps, &mut work).map_err(|why| match why {
            atraj::Error::Position => error("the path leaves its lines farther than the contour allows"),
            _ => error(&format!("contour: {why}")),
        })?;
        durations.truncate(places[sections]);
        states.truncate(axes * (durations.len() + 1));
        let has_zones = limits.len() > axes;
        let zones = places.windows(2).zip(limits.chunks(axes)).flat_map(|(ends, zone)| zone.repeat(ends[1] - ends[0]));
        let limits = if has_zones { zones.collect() } else { limits.to_vec() };
        Self::of(py, axes, states, &durations, limits, findings)
    }

    /// The path through these states, each section of which lasts as long.
    fn of(
        py: Python<'_>, axes: usize, states: Vec<State<Real>>, durations: &[Real], limits: Vec<Limits<Real>>,
        findings: Findings,
    ) -> PyResult<Py<Self>> {
        let mut moves = vec![Move::default(); axes * durations.len()];
        path_moves(&mut moves, &limits, &states, durations, axes).map_err(|why| error(&why.to_string()))?;
        let sections = moves.chunks(axes).map(<[_]>::to_vec).collect();
        let base = PyClassInitializer::from(Axes::new(sections, findings));
        Py::new(py, base.add_subclass(Self { states, limits }))
    }

    fn section(slf: &Bound<'_, Self>, section: usize) -> PyResult<Py<Moves>> {
        let Axes { sections, findings, .. } = slf.as_super().get();
        Py::new(slf.py(), Moves::of(sections[section].clone(), *findings))
    }
}

#[pymethods]
impl Path {
    /// The times at which the points are passed, s, from 0 to `t`.
    #[getter]
    fn times<'py>(slf: &Bound<'py, Self>) -> Bound<'py, PyArray1<Real>> {
        PyArray1::from_slice(slf.py(), &slf.as_super().get().times)
    }

    /// How far the path leaves the straight lines between its points, in the space of all axes: the largest distance, or up to 1 % more.
    ///
    /// >>> import atraj
    /// >>> limits = [atraj.Limits(jerk=30, acceleration=10, velocity=5)] * 2
    /// >>> round(atraj.path(limits, [[0, 0], [3, 1], [4, 5]]).deviation, 2)
    /// 0.82
    #[getter]
    fn deviation(slf: &Bound<'_, Self>) -> Real {
        let axes = slf.as_super().get();
        path_deviation(&axes.sections.concat(), axes.axes())
    }

    /// For each axis its phases of constant jerk, in order of time, each a `Phase`. Their starts are times of the path, s.
    ///
    /// >>> import atraj
    /// >>> limits = [atraj.Limits(jerk=30, acceleration=10, velocity=5)] * 2
    /// >>> x, y = atraj.path(limits, [[0, 0], [3, 1], [4, 5]]).phases
    /// >>> y[-1].jerk
    /// 30.0
    #[getter]
    fn phases<'py>(slf: &Bound<'py, Self>) -> PyResult<Vec<Vec<Bound<'py, PyAny>>>> {
        let axes = slf.as_super().get();
        let sections = || axes.sections.iter().zip(&axes.times);
        let of_axis = |axis: usize| {
            let phases = sections().flat_map(move |(moves, begun)| {
                let used = moves[axis].phase.iter().take(moves[axis].count as usize);
                used.map(move |phase| to_phase(slf.py(), Phase { start: begun + phase.start, ..*phase }))
            });
            phases.collect()
        };
        (0..axes.axes()).map(of_axis).collect()
    }

    fn __len__(slf: &Bound<'_, Self>) -> usize {
        slf.as_super().get().sections.len()
    }

    fn __getitem__(slf: &Bound<'_, Self>, section: isize) -> PyResult<Py<Moves>> {
        Self::section(slf, place(section, Self::__len__(slf), ["section", "sections"])?)
    }

    fn __iter__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let sections = (0..Self::__len__(slf)).map(|section| Self::section(slf, section));
        Ok(PyList::new(slf.py(), sections.collect::<PyResult<Vec<_>>>()?)?.try_iter()?.into_any())
    }

    /// A path through the same points that is not longer, from at most `steps` steps (0: as many as the path needs, at most 48).
    ///
    /// >>> import atraj
    /// >>> limits = [atraj.Limits(jerk=30, acceleration=10, velocity=5)] * 2
    /// >>> hasty = atraj.path(limits, [[0, 0], [3, 1], [4, 5]], steps=4)
    /// >>> hasty.improve().t < hasty.t
    /// True
    #[pyo3(signature = (*, steps=0))]
    fn improve(slf: &Bound<'_, Self>, steps: u32) -> PyResult<Py<Self>> {
        let (Self { states, limits }, axes) = (slf.get(), slf.as_super().get());
        let durations = durations(axes);
        let (states, limits) = (states.clone(), limits.clone());
        Self::plan(slf.py(), &Plan::Improved, axes.axes(), states, durations, limits, steps)
    }

    /// What a copy is made of. Each section is planned again from the same numbers, so it has the same bits.
    #[staticmethod]
    fn _from_sections(
        py: Python<'_>, states: Vec<GivenState<Real>>, durations: Vec<Real>, limits: Vec<GivenLimits<Real>>,
        findings: u8,
    ) -> PyResult<Py<Self>> {
        let points = durations.len() + 1;
        let axes = states.len() / points;
        let zones = if limits.len() == axes { 1 } else { durations.len() };
        if points == 1 || axes == 0 || states.len() != axes * points || limits.len() != axes * zones {
            return Err(error("a path has at least two points and one axis"));
        }
        let states = states.iter().map(|state| state.0).collect();
        let limits = limits.iter().map(|limits| limits.0).collect();
        Self::of(py, axes, states, &durations, limits, Findings::from_bits(findings))
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let (Self { states, limits }, axes) = (slf.get(), slf.as_super().get());
        let py = slf.py();
        let states = states.iter().map(|&state| state_numbers(state));
        let limits = limits.iter().map(|&limits| PyTuple::new(py, limits_numbers(limits)));
        let limits = limits.collect::<PyResult<Vec<_>>>()?;
        let arguments = (
            PyTuple::new(py, states.collect::<Vec<_>>())?,
            PyTuple::new(py, durations(axes))?,
            PyTuple::new(py, limits)?,
            axes.findings.bits(),
        );
        rebuilding(slf.as_any(), "_from_sections", arguments.into_pyobject(py)?)
    }

    fn __repr__(slf: &Bound<'_, Self>) -> String {
        let axes = slf.as_super().get();
        let (count, points, t) = (axes.axes(), axes.times.len(), axes.lasts());
        format!("<Path of {count} axes through {points} points in {t} s>")
    }
}

fn durations(axes: &Axes) -> Vec<Real> {
    axes.sections.iter().map(|motions| motions[0].t).collect()
}

/// A coordinate of a point: a position or a `State`.
enum Coordinate {
    Position(Real),
    State(State<Real>),
}

impl Coordinate {
    fn of(number: &Bound<'_, PyAny>) -> Option<Self> {
        let state = || number.extract::<GivenState<Real>>();
        let position = number.extract().map(Self::Position);
        position.or_else(|_: PyErr| state().map(|state| Self::State(state.0))).ok()
    }

    fn state(&self) -> State<Real> {
        match *self {
            Self::Position(position) => State::at(position),
            Self::State(state) => state,
        }
    }
}

/// Limits of the axes, or of the axes section by section.
pub enum PathLimits {
    Axes(Vec<GivenLimits<Real>>),
    Sections(Vec<Vec<GivenLimits<Real>>>),
}

impl<'a, 'py> FromPyObject<'a, 'py> for PathLimits {
    type Error = PyErr;

    fn extract(given: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        let sections = |_| given.extract().map(Self::Sections);
        let neither = |_: PyErr| error("limits has a Limits for each axis, or for each section a list of them");
        given.extract().map(Self::Axes).or_else(sections).map_err(neither)
    }
}

/// A feed for all sections, or one for each of them.
#[derive(FromPyObject)]
pub enum Feed {
    All(Real),
    Sections(Vec<Real>),
}

impl Feed {
    /// The limits of each section that keep the feed.
    fn limits(
        self, limits: Vec<Limits<Real>>, states: &[State<Real>], axes: usize, sections: usize,
    ) -> PyResult<Vec<Limits<Real>>> {
        let feeds = match self {
            Self::All(feed) => vec![feed; sections],
            Self::Sections(feeds) => feeds,
        };
        let mut limits = if limits.len() == axes { limits.repeat(sections) } else { limits };
        limit_feed(&mut limits, states, &feeds, axes).map_err(|why| match why {
            atraj::Error::Axes => error("feed has a number, or one for each section"),
            _ => error("a feed is not above 0"),
        })?;
        Ok(limits)
    }
}

/// A number for each axis, or for each point between the first and the last one a list of them.
pub enum Tolerances {
    Axes(Vec<Real>),
    Points(Vec<Vec<Real>>),
}

impl<'a, 'py> FromPyObject<'a, 'py> for Tolerances {
    type Error = PyErr;

    fn extract(given: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        let points = |_| given.extract().map(Self::Points);
        let neither =
            |_: PyErr| error("tolerances has a number for each axis, or for each point between a list of them");
        given.extract().map(Self::Axes).or_else(points).map_err(neither)
    }
}

impl Tolerances {
    /// The tolerances point by point.
    fn of_points(self, axes: usize, between: usize) -> PyResult<Vec<Real>> {
        let points = match self {
            Self::Axes(axes) => vec![axes; between],
            Self::Points(points) => points,
        };
        if points.len() != between {
            let count = points.len();
            return Err(error(&format!(
                "tolerances has {count} lists, and the path {between} points between its ends"
            )));
        }
        for (k, point) in (1..).zip(&points) {
            if point.len() != axes {
                let count = point.len();
                return Err(error(&format!("point {k} has {count} tolerances, and limits {axes} axes")));
            }
            for (axis, tolerance) in point.iter().enumerate() {
                let is_tolerance = *tolerance >= 0.0 && tolerance.is_finite();
                is_tolerance
                    .then_some(())
                    .ok_or_else(|| wrong(k, axis, "the tolerance is negative or no finite number"))?;
            }
        }
        Ok(points.concat())
    }
}

/// A fast path of several axes through points, which all axes pass at the same times. They stop nowhere between the first point and
/// the last one unless they must.
///
/// A point has a position for each axis, and `limits` has an item for each axis, or for each section a list of them. The path starts and ends
/// at rest; the first and the last point may have a `State` in the place of a position. The planner takes at most `steps` steps (0: as many
/// as the path needs, at most 48). ValueError says which point or axis is wrong.
///
/// With `tolerances` the path passes the points between the first and the last one within fly-by zones: a number for each axis says how far its
/// position may be from the given one, for all points or in a list for each of them. The path is not longer than the one through the points.
///
/// With `contour` the path stays so near the straight lines between its points: points are added where it would leave them farther. With both,
/// these are the lines between the points that it passes. `feed` is the highest speed of all axes together, or a list of one for each section.
///
/// >>> import atraj
/// >>> limits = [atraj.Limits(jerk=30, acceleration=10, velocity=5)] * 2
/// >>> path = atraj.path(limits, [[0, 0], [3, 1], [4, 5]])
/// >>> path.position(path.times)
/// array([[0., 0.],
///        [3., 1.],
///        [4., 5.]])
/// >>> bool((path.velocity(path.times[1]) > 1).all())
/// True
/// >>> near = atraj.path(limits, [[0, 0], [3, 1], [4, 5]], tolerances=[0, 0.1])
/// >>> bool(near.t < path.t)
/// True
/// >>> part = atraj.path(limits, [[0, 0], [3, 1], [4, 5]], contour=0.01, feed=2)
/// >>> bool(part.deviation <= 0.01 and part.t > path.t)
/// True
#[pyfunction]
#[pyo3(signature = (limits, points, *, tolerances=None, contour=None, feed=None, steps=0))]
pub fn path(
    py: Python<'_>, limits: PathLimits, points: Vec<Vec<Bound<'_, PyAny>>>, tolerances: Option<Tolerances>,
    contour: Option<Real>, feed: Option<Feed>, steps: u32,
) -> PyResult<Py<Path>> {
    let points = coordinates(&points)?;
    let sections = points.len().saturating_sub(1);
    let zones = match limits {
        PathLimits::Axes(limits) => vec![limits],
        PathLimits::Sections(zones) if zones.len() == sections => zones,
        PathLimits::Sections(zones) => {
            let count = zones.len();
            return Err(error(&format!("limits has {count} lists, and the path {sections} sections")));
        }
    };
    let zones: Vec<Vec<_>> =
        zones.into_iter().map(|limits| limits.into_iter().map(|limits| limits.0).collect()).collect();
    for (k, limits) in zones.iter().enumerate() {
        check(&points, limits, k + 1 == zones.len())?;
    }
    let axes = zones.first().map_or(0, Vec::len);
    let mut states: Vec<_> = points.iter().flatten().map(Coordinate::state).collect();
    let mut limits = zones.concat();
    if let Some(feed) = feed {
        limits = feed.limits(limits, &states, axes, sections)?;
    }
    let mut durations = vec![0.0; sections];
    let plan = match tolerances {
        Some(tolerances) => Plan::Near(tolerances.of_points(axes, sections - 1)?),
        None => Plan::Through,
    };
    let Some(within) = contour else {
        return Path::plan(py, &plan, axes, states, durations, limits, steps);
    };
    if let Plan::Near(_) = plan {
        plan.run(axes, &mut states, &mut durations, &limits, steps)?;
    }
    Path::contour(py, axes, states, &limits, within, steps)
}

fn coordinates(points: &[Vec<Bound<'_, PyAny>>]) -> PyResult<Vec<Vec<Coordinate>>> {
    let point = |(k, numbers): (usize, &Vec<Bound<'_, PyAny>>)| {
        let numbers = numbers.iter().enumerate();
        let coordinates = numbers
            .map(|(axis, number)| Coordinate::of(number).ok_or_else(|| wrong(k, axis, "neither a number nor a state")));
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
            return Err(error(&format!("point {k} has {has} coordinates, and limits {axes} axes")));
        }
    }
    let ends = first.iter().zip(last).map(|(first, last)| {
        let [start, end] = [first, last].map(Coordinate::state);
        let at_rest = State::at(end.position);
        [start, if are_last { end } else { at_rest }]
    });
    let axes = limits.iter().zip(ends);
    each_alone(axes.map(|(&limits, ends)| (limits, ends, ANYWHERE)))?;
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
