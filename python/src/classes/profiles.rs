//! The profiles.

use std::sync::Arc;

use atraj::{Boundary, Error, Poly, Saturation};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use super::Real;
use crate::motion::{Arrays, Motion, Request, at, bell_fields, trap_fields};
use crate::values::{error, named, to_extremes, to_findings, to_state};
use crate::why::{no_polynomial, no_profile};

/// Adds the classes to a module.
pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Profile>()?;
    module.add_class::<Bell>()?;
    module.add_class::<Trap>()?;
    module.add_class::<Poly3>()?;
    module.add_class::<Poly5>()?;
    module.add_class::<Poly7>()
}

/// A planned motion of one axis: what all profiles have in common.
///
/// Times are in seconds since the start of the motion. Positions have any unit of length or angle, and the other quantities
/// follow from it: m, m/s, m/s², m/s³.
///
/// An array of times has any strides, alignment, byte order and type of real number. The mask of a masked array is not looked at.
#[pyclass(module = "atraj", frozen, subclass)]
pub struct Profile {
    motion: Arc<dyn Motion<Real>>,
    /// Duration, s.
    #[pyo3(get)]
    t: Real,
}

impl Profile {
    /// The base of a profile that lasts `t`, s.
    pub fn new(motion: impl Motion<Real> + 'static, t: Real) -> PyClassInitializer<Self> {
        Self::shared(Arc::new(motion), t)
    }

    /// The base of a profile that keeps its motion too.
    pub fn shared(motion: Arc<dyn Motion<Real>>, t: Real) -> PyClassInitializer<Self> {
        PyClassInitializer::from(Self { motion, t })
    }

    /// Duration, s.
    pub fn lasts(&self) -> Real {
        self.t
    }
}

#[pymethods]
impl Profile {
    /// Position at `time`, s: a float, or an array for an array of times. Before the start it is the initial one, after the
    /// end the final one, but a polynomial goes on.
    fn position<'py>(&self, time: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        at(time, |x| self.motion.position(x))
    }

    /// Velocity at `time`, s: a float, or an array for an array of times.
    fn velocity<'py>(&self, time: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        at(time, |x| self.motion.velocity(x))
    }

    /// Acceleration at `time`, s: a float, or an array for an array of times.
    fn acceleration<'py>(&self, time: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        at(time, |x| self.motion.acceleration(x))
    }

    /// Jerk at `time`, s: a float, or an array for an array of times. The jerk of a trapezoid is NaN, for its acceleration
    /// jumps, and the jerk of a shaped move too, for a shaper gives none.
    fn jerk<'py>(&self, time: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        at(time, |x| self.motion.jerk(x))
    }

    /// The `State` at `time`, s: where another plan starts.
    fn state_at<'py>(&self, py: Python<'py>, time: Real) -> PyResult<Bound<'py, PyAny>> {
        to_state(py, self.motion.state_at(time))
    }

    /// The `Extremes`: the lowest and the highest position, velocity and acceleration between 0 and `t`. ValueError for a shaped move, whose
    /// extremes only `sample` can tell.
    fn extremes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let extremes = self.motion.extremes(self.t);
        let unknown = || error("the extremes of a shaped move are not known: sample it");
        to_extremes(py, extremes.ok_or_else(unknown)?)
    }

    /// `Samples`: times, positions, velocities, accelerations and jerks, with the bits of the single calls.
    ///
    /// Sample `k` belongs to the time `start + k*dt`, s. `dt` alone samples until the end is reached, `n` alone takes `n` samples
    /// evenly from the start to the end. With `out`, a `Samples` of arrays, nothing is allocated, which saves most of the time of a long
    /// sweep: each array is filled, and None leaves a quantity out. ValueError, before anything is written, if an array of `out` is not
    /// contiguous or not aligned. ValueError for more than 2147483647 samples.
    ///
    /// >>> import atraj
    /// >>> move = atraj.Bell(30, 10, 5, 0, 10)
    /// >>> t, p, v, a, j = move.sample(0.5)
    /// >>> p.round(3)
    /// array([ 0.   ,  0.602,  2.917,  5.417,  7.917,  9.815, 10.   ])
    /// >>> move.sample(n=3).v
    /// array([0., 5., 0.])
    #[pyo3(signature = (dt=None, *, n=None, start=0.0, out=None))]
    fn sample<'py>(
        &self, py: Python<'py>, dt: Option<Real>, n: Option<usize>, start: Real, out: Option<Arrays<'py, Real>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        Request { dt, n, start, out }.sample(py, &*self.motion, self.t)
    }

    /// Draws position, velocity, acceleration and jerk over time, and returns the figure. Needs matplotlib.
    ///
    /// `limits` are drawn as dashed lines. The labels have the `unit` of the position, "m" or "deg" for example, and the others that follow
    /// from it. `label` names the motion, which begins at the time `offset`, s. `axes`, the axes of a figure, draws over what is there, so
    /// motions lie over each other:
    ///
    /// >>> import atraj
    /// >>> figure = atraj.Bell(30, 10, 5, 0, 10).plot(label="double-S", unit="m") # doctest: +SKIP
    /// >>> atraj.Trap(5, 10, -10, 0, 10).plot(axes=figure.axes, label="trapezoid") # doctest: +SKIP
    #[pyo3(signature = (*, axes=None, limits=None, unit=None, label=None, offset=0.0))]
    fn plot<'py>(
        slf: &Bound<'py, Self>, axes: Option<Bound<'py, PyAny>>, limits: Option<Bound<'py, PyAny>>, unit: Option<&str>,
        label: Option<&str>, offset: f64,
    ) -> PyResult<Bound<'py, PyAny>> {
        let plot = slf.py().import("atraj._plot")?.getattr("plot")?;
        plot.call1((slf, axes, limits, unit, label, offset))
    }

    /// Equal are motions of one class with the same numbers.
    fn __eq__(slf: &Bound<'_, Self>, other: &Bound<'_, PyAny>) -> PyResult<bool> {
        match other.cast_exact::<Self>().or_else(|_| other.cast::<Self>()) {
            Ok(other) if slf.get_type().is(other.get_type()) => Self::parts(slf)?.1.eq(Self::parts(other)?.1),
            _ => Ok(false),
        }
    }

    fn __hash__(slf: &Bound<'_, Self>) -> PyResult<isize> {
        Self::parts(slf)?.1.hash()
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let (method, arguments) = Self::parts(slf)?;
        rebuilding(slf.as_any(), method, arguments)
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: Bound<'_, PyAny>) -> Py<Self> {
        slf
    }

    fn __repr__(slf: &Bound<'_, Self>) -> PyResult<String> {
        let class = slf.get_type();
        let (method, arguments) = Self::parts(slf)?;
        if !method.starts_with('_') {
            return Ok(format!("{}.{method}{arguments}", class.fully_qualified_name()?).replace(",))", "))"));
        }
        let Self { motion, t } = slf.get();
        let (from, to) = (motion.position(0.0), motion.position(*t));
        Ok(format!("<{} from {from} to {to} in {t} s>", class.name()?))
    }
}

impl Profile {
    fn parts<'py>(slf: &Bound<'py, Self>) -> PyResult<(&'static str, Bound<'py, PyTuple>)> {
        let Self { motion, t } = slf.get();
        motion.parts(slf.py(), *t)
    }
}

/// How `pickle` makes an object again: by a method of its class.
pub fn rebuilding<'py>(
    object: &Bound<'py, PyAny>, method: &str, arguments: Bound<'py, PyTuple>,
) -> PyResult<Bound<'py, PyAny>> {
    let rebuild = object.py().import("atraj.values")?.getattr("_rebuild")?;
    let arguments = (object.get_type(), method, arguments);
    Ok((rebuild, arguments).into_pyobject(object.py())?.into_any())
}

/// Double-S: jerk, acceleration and velocity are limited.
///
/// `Bell(jerk, acceleration, velocity, p0, p1, v0=0, v1=0)` plans as liba's `a_trajbell_gen`, to the last bit, from the position
/// `p0` to `p1` and from the velocity `v0` to `v1`. The signs of the limits are ignored, and velocities beyond the limit are
/// limited to it. A ValueError says that there is no such move; `Bell.fastest` plans where liba fails. With
/// `newest_saturation=True` velocities are limited as liba does since 2025: a NaN stays NaN, and a zero keeps its sign.
///
/// `fields` carry liba's names. For a move towards smaller positions `vm`, `jm`, `am` and `dm` hold in the mirrored axis.
///
/// >>> import atraj
/// >>> move = atraj.Bell(jerk=30, acceleration=10, velocity=5, p0=0, p1=10)
/// >>> move.t, move.position(1.0)
/// (2.833333333333333, 2.916666666666667)
#[pyclass(module = "atraj", frozen, extends = Profile)]
pub struct Bell(pub atraj::Bell<Real>);

impl Bell {
    fn of(bell: atraj::Bell<Real>) -> PyClassInitializer<Self> {
        Profile::new(bell, bell.t).add_subclass(Self(bell))
    }

    fn refused(why: Error, jerk: Real, acceleration: Real, velocity: Real, boundary: Boundary<Real>) -> PyErr {
        let limits = [("jerk", jerk), ("acceleration", acceleration), ("velocity", velocity)];
        no_profile(why, limits, boundary, None)
    }
}

#[pymethods]
impl Bell {
    #[new]
    #[pyo3(signature = (jerk, acceleration, velocity, p0, p1, v0=0.0, v1=0.0, *, newest_saturation=false))]
    #[allow(clippy::too_many_arguments)]
    fn new(
        jerk: Real, acceleration: Real, velocity: Real, p0: Real, p1: Real, v0: Real, v1: Real, newest_saturation: bool,
    ) -> PyResult<PyClassInitializer<Self>> {
        let boundary = Boundary { p0, p1, v0, v1 };
        let saturation = saturation(newest_saturation);
        let bell = atraj::Bell::new_saturated(jerk, acceleration, velocity, boundary, saturation);
        Ok(Self::of(bell.map_err(|why| Self::refused(why, jerk, acceleration, velocity, boundary))?))
    }

    /// The fastest move within the limits, which never fails: a target behind, or too near to stop, is reached by turning.
    ///
    /// An infinite limit is no limit. A jerk, or both accelerations, are finite. ValueError if a limit is 0, an argument is no
    /// number, or a position is infinite.
    ///
    /// >>> import atraj
    /// >>> atraj.Bell.fastest(30, 10, 5, p0=0, p1=0.1, v0=2).t # 0.1 m to go at 2 m/s
    /// 1.015182383138908
    #[staticmethod]
    #[pyo3(signature = (jerk, acceleration, velocity, p0, p1, v0=0.0, v1=0.0))]
    #[allow(clippy::too_many_arguments)]
    fn fastest(
        py: Python<'_>, jerk: Real, acceleration: Real, velocity: Real, p0: Real, p1: Real, v0: Real, v1: Real,
    ) -> PyResult<Py<Self>> {
        let boundary = Boundary { p0, p1, v0, v1 };
        let bell = atraj::Bell::fastest(jerk, acceleration, velocity, boundary);
        Py::new(py, Self::of(bell.map_err(|why| Self::refused(why, jerk, acceleration, velocity, boundary))?))
    }

    /// The move with these `BellFields`, whoever planned it: a log of a drive, or liba. Nothing is checked here; `check` does.
    #[staticmethod]
    #[rustfmt::skip]
    fn from_fields(py: Python<'_>, fields: [Real; 14]) -> PyResult<Py<Self>> {
        let [t, tv, ta, td, taj, tdj, p0, p1, v0, v1, vm, jm, am, dm] = fields;
        let bell = atraj::Bell { t, tv, ta, td, taj, tdj, p0, p1, v0, v1, vm, jm, am, dm };
        Py::new(py, Self::of(bell))
    }

    /// The `BellFields`: what liba's struct holds.
    #[getter]
    fn fields<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        named(py, "BellFields", PyTuple::new(py, bell_fields(&self.0))?)
    }

    /// The `Findings` of the move within these limits: empty if the move keeps them, does not jump and does not overshoot.
    /// ValueError if a field is not finite, or a limit is not a number.
    ///
    /// >>> import atraj
    /// >>> move = atraj.Bell(30, 2.5, 10, p0=0, p1=10, v0=7.5) # liba's plan forgets the limit of the acceleration
    /// >>> move.check(30, 2.5, 10)
    /// <Findings.EXCEEDS_ACCELERATION: 2>
    fn check<'py>(
        &self, py: Python<'py>, jerk: Real, acceleration: Real, velocity: Real,
    ) -> PyResult<Bound<'py, PyAny>> {
        let found = self.0.check(jerk, acceleration, velocity);
        to_findings(py, found.map_err(|why| error(&why.to_string()))?)
    }
}

/// Trapezoid: acceleration and velocity are limited.
///
/// `Trap(velocity, ac, de, p0, p1, v0=0, v1=0)` plans as liba's `a_trajtrap_gen`, to the last bit. `ac` and `de` are signed: a
/// forward move has `ac > 0` and `de < 0`, a backward one the opposite. A final velocity out of reach is replaced by the one that is
/// reached. Otherwise as `Bell`.
///
/// >>> import atraj
/// >>> move = atraj.Trap(velocity=5, ac=4, de=-2, p0=0, p1=50)
/// >>> move.t, move.velocity(5)
/// (11.875, 5.0)
#[pyclass(module = "atraj", frozen, extends = Profile)]
pub struct Trap(atraj::Trap<Real>);

impl Trap {
    fn of(trap: atraj::Trap<Real>) -> PyClassInitializer<Self> {
        Profile::new(trap, trap.t).add_subclass(Self(trap))
    }

    fn refused(why: Error, velocity: Real, [ac, de]: [Real; 2], boundary: Boundary<Real>) -> PyErr {
        let limits = [("velocity", velocity), ("ac", ac), ("de", de)];
        no_profile(why, limits, boundary, Some([ac, de]))
    }
}

#[pymethods]
impl Trap {
    #[new]
    #[pyo3(signature = (velocity, ac, de, p0, p1, v0=0.0, v1=0.0, *, newest_saturation=false))]
    #[allow(clippy::too_many_arguments)]
    fn new(
        velocity: Real, ac: Real, de: Real, p0: Real, p1: Real, v0: Real, v1: Real, newest_saturation: bool,
    ) -> PyResult<PyClassInitializer<Self>> {
        let boundary = Boundary { p0, p1, v0, v1 };
        let saturation = saturation(newest_saturation);
        let trap = atraj::Trap::new_saturated(velocity, ac, de, boundary, saturation);
        Ok(Self::of(trap.map_err(|why| Self::refused(why, velocity, [ac, de], boundary))?))
    }

    /// The fastest move within the limits, which never fails: a target behind, or too near to stop, is reached by turning.
    ///
    /// One of `ac` and `de` is positive, the other negative. ValueError if not, if the velocity is 0, an argument is NaN or infinite, or
    /// a position is infinite.
    #[staticmethod]
    #[pyo3(signature = (velocity, ac, de, p0, p1, v0=0.0, v1=0.0))]
    #[allow(clippy::too_many_arguments)]
    fn fastest(
        py: Python<'_>, velocity: Real, ac: Real, de: Real, p0: Real, p1: Real, v0: Real, v1: Real,
    ) -> PyResult<Py<Self>> {
        let boundary = Boundary { p0, p1, v0, v1 };
        let trap = atraj::Trap::fastest(velocity, ac, de, boundary);
        Py::new(py, Self::of(trap.map_err(|why| Self::refused(why, velocity, [ac, de], boundary))?))
    }

    /// The move with these `TrapFields`, whoever planned it: a log of a drive, or liba. Nothing is checked here; `check` does.
    #[staticmethod]
    #[rustfmt::skip]
    fn from_fields(py: Python<'_>, fields: [Real; 12]) -> PyResult<Py<Self>> {
        let [t, p0, p1, v0, v1, vc, ta, td, pa, pd, ac, de] = fields;
        let trap = atraj::Trap { t, p0, p1, v0, v1, vc, ta, cruise_end: td, pa, pd, a0: ac, a1: de };
        Py::new(py, Self::of(trap))
    }

    /// The `TrapFields`: what liba's struct holds.
    #[getter]
    fn fields<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        named(py, "TrapFields", PyTuple::new(py, trap_fields(&self.0))?)
    }

    /// The `Findings` of the move within these limits: empty if the move keeps them, does not jump and does not overshoot.
    /// ValueError if a field is not finite, a limit is not a number, or both accelerations have one sign.
    fn check<'py>(&self, py: Python<'py>, velocity: Real, ac: Real, de: Real) -> PyResult<Bound<'py, PyAny>> {
        let found = self.0.check(velocity, ac, de);
        to_findings(py, found.map_err(|why| error(&why.to_string()))?)
    }
}

/// Cubic: position and velocity are given at both ends.
///
/// `Poly3(t, p0, p1, v0=0, v1=0)` takes `t`, s, with the bits of liba's `a_trajpoly3_gen`. ValueError if a coefficient is not finite.
///
/// >>> import atraj
/// >>> cubic = atraj.Poly3(8, p0=0, p1=10)
/// >>> cubic.position(4), cubic.velocity(8)
/// (5.0, 0.0)
#[pyclass(module = "atraj", frozen, extends = Profile)]
pub struct Poly3(atraj::Poly3<Real>);

/// Quintic: position, velocity and acceleration are given at both ends.
///
/// `Poly5(t, p0, p1, v0=0, v1=0, a0=0, a1=0)` takes `t`, s, with the bits of liba's `a_trajpoly5_gen`. ValueError if a coefficient
/// is not finite.
#[pyclass(module = "atraj", frozen, extends = Profile)]
pub struct Poly5(atraj::Poly5<Real>);

/// Septic: position, velocity, acceleration and jerk are given at both ends.
///
/// `Poly7(t, p0, p1, v0=0, v1=0, a0=0, a1=0, j0=0, j1=0)` takes `t`, s, with the bits of liba's `a_trajpoly7_gen`. ValueError if a
/// coefficient is not finite.
#[pyclass(module = "atraj", frozen, extends = Profile)]
pub struct Poly7(atraj::Poly7<Real>);

impl Poly3 {
    fn of(poly: atraj::Poly3<Real>, t: Real) -> PyClassInitializer<Self> {
        Profile::new(poly, t).add_subclass(Self(poly))
    }
}

#[pymethods]
impl Poly3 {
    #[new]
    #[pyo3(signature = (t, p0, p1, v0=0.0, v1=0.0))]
    fn new(t: Real, p0: Real, p1: Real, v0: Real, v1: Real) -> PyResult<PyClassInitializer<Self>> {
        let poly = atraj::Poly3::new(t, Boundary { p0, p1, v0, v1 });
        let ends = [("p0", p0), ("p1", p1), ("v0", v0), ("v1", v1)];
        let poly = poly.map_err(|why| no_polynomial(why, t, &ends))?;
        Ok(Self::of(poly, t))
    }

    /// The polynomial of duration `t`, s, with these coefficients `c`, finite or not.
    #[staticmethod]
    fn from_coefficients(py: Python<'_>, t: Real, c: [Real; 4]) -> PyResult<Py<Self>> {
        Py::new(py, Self::of(Poly { c }, t))
    }

    /// Coefficients of the position in ascending powers of time.
    #[getter]
    fn c(&self) -> (Real, Real, Real, Real) {
        self.0.c.into()
    }
}

impl Poly5 {
    fn of(poly: atraj::Poly5<Real>, t: Real) -> PyClassInitializer<Self> {
        Profile::new(poly, t).add_subclass(Self(poly))
    }
}

#[pymethods]
impl Poly5 {
    #[new]
    #[pyo3(signature = (t, p0, p1, v0=0.0, v1=0.0, a0=0.0, a1=0.0))]
    fn new(t: Real, p0: Real, p1: Real, v0: Real, v1: Real, a0: Real, a1: Real) -> PyResult<PyClassInitializer<Self>> {
        let boundary = Boundary { p0, p1, v0, v1 };
        let poly = atraj::Poly5::new(t, boundary, [a0, a1]);
        let ends = [("p0", p0), ("p1", p1), ("v0", v0), ("v1", v1), ("a0", a0), ("a1", a1)];
        let poly = poly.map_err(|why| no_polynomial(why, t, &ends))?;
        Ok(Self::of(poly, t))
    }

    /// The polynomial of duration `t`, s, with these coefficients `c`, finite or not.
    #[staticmethod]
    fn from_coefficients(py: Python<'_>, t: Real, c: [Real; 6]) -> PyResult<Py<Self>> {
        Py::new(py, Self::of(Poly { c }, t))
    }

    /// Coefficients of the position in ascending powers of time.
    #[getter]
    fn c(&self) -> (Real, Real, Real, Real, Real, Real) {
        self.0.c.into()
    }
}

impl Poly7 {
    fn of(poly: atraj::Poly7<Real>, t: Real) -> PyClassInitializer<Self> {
        Profile::new(poly, t).add_subclass(Self(poly))
    }
}

#[pymethods]
impl Poly7 {
    #[new]
    #[pyo3(signature = (t, p0, p1, v0=0.0, v1=0.0, a0=0.0, a1=0.0, j0=0.0, j1=0.0))]
    #[allow(clippy::too_many_arguments)]
    fn new(
        t: Real, p0: Real, p1: Real, v0: Real, v1: Real, a0: Real, a1: Real, j0: Real, j1: Real,
    ) -> PyResult<PyClassInitializer<Self>> {
        let boundary = Boundary { p0, p1, v0, v1 };
        let poly = atraj::Poly7::new(t, boundary, [a0, a1], [j0, j1]);
        let ends = [("p0", p0), ("p1", p1), ("v0", v0), ("v1", v1), ("a0", a0), ("a1", a1), ("j0", j0), ("j1", j1)];
        let poly = poly.map_err(|why| no_polynomial(why, t, &ends))?;
        Ok(Self::of(poly, t))
    }

    /// The polynomial of duration `t`, s, with these coefficients `c`, finite or not.
    #[staticmethod]
    fn from_coefficients(py: Python<'_>, t: Real, c: [Real; 8]) -> PyResult<Py<Self>> {
        Py::new(py, Self::of(Poly { c }, t))
    }

    /// Coefficients of the position in ascending powers of time.
    #[getter]
    fn c(&self) -> (Real, Real, Real, Real, Real, Real, Real, Real) {
        self.0.c.into()
    }
}

fn saturation(newest: bool) -> Saturation {
    if newest { Saturation::Numbers } else { Saturation::Everything }
}
