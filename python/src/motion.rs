//! What every profile does, for both real types: evaluation at a time or at an array of times, and sampling.

use atraj::online::{Move, Phase};
use atraj::{Bell, Extremes, Findings, Poly, Real, State, Trap};
use numpy::{
    Element, PyArray1, PyArrayDyn, PyReadonlyArrayDyn, PyReadwriteArray1, PyReadwriteArrayDyn, PyUntypedArray,
    PyUntypedArrayMethods,
};
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::values::{error, named, phase_numbers};

/// A real type of the library and of NumPy.
pub trait Number: Real + Element + Into<f64> + for<'a, 'py> FromPyObject<'a, 'py> + 'static {}

impl Number for f32 {}
impl Number for f64 {}

/// A planned motion. Times `x` are in seconds since its start.
pub trait Motion<R>: Send + Sync {
    fn position(&self, x: R) -> R;
    fn velocity(&self, x: R) -> R;
    fn acceleration(&self, x: R) -> R;
    /// NaN if the acceleration jumps.
    fn jerk(&self, x: R) -> R;
    fn state_at(&self, x: R) -> State<R>;
    /// The lowest and the highest state of the motion, which lasts `t`, s. None if they are not known.
    fn extremes(&self, t: R) -> Option<Extremes<R>>;
    /// Fills each output to its end; an output may be empty.
    fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; 4]);
    /// The method of the class that makes this motion again, which lasts `t`, s, and the arguments of the method. The name of a method that
    /// is for copies alone begins with `_`.
    fn parts<'py>(&self, py: Python<'py>, t: R) -> PyResult<Parts<'py>>;
}

/// What makes an object again: the name of a method of its class, and its arguments.
pub type Parts<'py> = (&'static str, Bound<'py, PyTuple>);

/// Methods that the library has under these names.
macro_rules! delegate {
    ($($name:ident)+) => {
        $(fn $name(&self, x: R) -> R {
            self.$name(x)
        })+
        fn state_at(&self, x: R) -> State<R> {
            self.state_at(x)
        }
    };
}

impl<R: Number> Motion<R> for Bell<R> {
    delegate!(position velocity acceleration jerk);
    fn extremes(&self, _: R) -> Option<Extremes<R>> {
        Some(self.extremes())
    }
    fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; 4]) {
        self.sample_into(x0, dt, outputs);
    }
    fn parts<'py>(&self, py: Python<'py>, _: R) -> PyResult<Parts<'py>> {
        one_tuple("from_fields", py, &bell_fields(self))
    }
}

/// The fields in the order of liba's struct.
#[rustfmt::skip]
pub fn bell_fields<R: Number>(bell: &Bell<R>) -> [f64; 14] {
    let Bell { t, tv, ta, td, taj, tdj, p0, p1, v0, v1, vm, jm, am, dm } = *bell;
    [t, tv, ta, td, taj, tdj, p0, p1, v0, v1, vm, jm, am, dm].map(R::into)
}

impl<R: Number> Motion<R> for Trap<R> {
    delegate!(position velocity acceleration);
    fn jerk(&self, _: R) -> R {
        R::NAN
    }
    fn extremes(&self, _: R) -> Option<Extremes<R>> {
        Some(self.extremes())
    }
    fn sample_into(&self, x0: R, dt: R, [p, v, a, j]: [&mut [R]; 4]) {
        self.sample_into(x0, dt, [p, v, a]);
        j.fill(R::NAN);
    }
    fn parts<'py>(&self, py: Python<'py>, _: R) -> PyResult<Parts<'py>> {
        one_tuple("from_fields", py, &trap_fields(self))
    }
}

/// The fields in the order of liba's struct.
#[rustfmt::skip]
pub fn trap_fields<R: Number>(trap: &Trap<R>) -> [f64; 12] {
    let Trap { t, p0, p1, v0, v1, vc, ta, cruise_end, pa, pd, a0, a1 } = *trap;
    [t, p0, p1, v0, v1, vc, ta, cruise_end, pa, pd, a0, a1].map(R::into)
}

fn one_tuple<'py>(method: &'static str, py: Python<'py>, numbers: &[f64]) -> PyResult<Parts<'py>> {
    Ok((method, (PyTuple::new(py, numbers)?,).into_pyobject(py)?))
}

impl<R: Number, const N: usize> Motion<R> for Poly<R, N> {
    delegate!(position velocity acceleration jerk);
    fn extremes(&self, t: R) -> Option<Extremes<R>> {
        Some(self.extremes(t))
    }
    fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; 4]) {
        self.sample_into(x0, dt, outputs);
    }
    fn parts<'py>(&self, py: Python<'py>, t: R) -> PyResult<Parts<'py>> {
        let (t, c): (f64, [f64; N]) = (t.into(), self.c.map(R::into));
        let arguments = (t, PyTuple::new(py, c)?);
        Ok(("from_coefficients", arguments.into_pyobject(py)?))
    }
}

/// A move with what its plan found.
#[derive(Clone, Copy, Default)]
pub struct Planned<R: Real> {
    pub motion: Move<R>,
    pub findings: Findings,
}

impl<R: Number> Motion<R> for Planned<R> {
    fn position(&self, x: R) -> R {
        self.motion.position(x)
    }
    fn velocity(&self, x: R) -> R {
        self.motion.velocity(x)
    }
    fn acceleration(&self, x: R) -> R {
        self.motion.acceleration(x)
    }
    fn jerk(&self, x: R) -> R {
        self.motion.jerk(x)
    }
    fn state_at(&self, x: R) -> State<R> {
        self.motion.state_at(x)
    }
    fn extremes(&self, _: R) -> Option<Extremes<R>> {
        Some(self.motion.extremes())
    }
    fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; 4]) {
        self.motion.sample_into(x0, dt, outputs);
    }
    fn parts<'py>(&self, py: Python<'py>, _: R) -> PyResult<Parts<'py>> {
        let (t, phases) = move_parts(&self.motion);
        let phases = phases.into_iter().map(|phase| PyTuple::new(py, phase));
        let phases = PyTuple::new(py, phases.collect::<PyResult<Vec<_>>>()?)?;
        let arguments = (t, self.findings.bits(), phases);
        Ok(("_from_phases", arguments.into_pyobject(py)?))
    }
}

/// Duration, s, and the phases of a move, with the end as the last one.
pub fn move_parts<R: Number>(motion: &Move<R>) -> (f64, Vec<[f64; 6]>) {
    let used = motion.phase.iter().take(motion.count as usize + 1);
    let phases = used.map(|&phase| phase_numbers(phase)).collect();
    (motion.t.into(), phases)
}

/// The move of its parts.
pub fn move_from_parts<R: Number>(t: R, phases: &[[R; 6]]) -> PyResult<Move<R>> {
    let mut motion = Move::default();
    let Some(count) = phases.len().checked_sub(1).filter(|_| phases.len() <= motion.phase.len()) else {
        return Err(error("a move has 0 to 15 phases, and its end"));
    };
    motion.t = t;
    motion.count = count as u32;
    for (to, from) in motion.phase.iter_mut().zip(phases) {
        let [start, duration, position, velocity, acceleration, jerk] = *from;
        *to = Phase { start, duration, position, velocity, acceleration, jerk };
    }
    Ok(motion)
}

/// The values at a time, or at each of an array of times, s.
pub fn at<'py, R: Number>(times: &Bound<'py, PyAny>, value: impl Fn(R) -> R) -> PyResult<Bound<'py, PyAny>> {
    let py = times.py();
    if let Some(x) = one_time(times) {
        let y: f64 = value(x).into();
        return y.into_bound_py_any(py);
    }
    let times = in_rows(times)?;
    let values = times.as_array().mapv(value);
    Ok(PyArrayDyn::from_owned_array(py, values).into_any())
}

/// The time, s, if it is a number and no array.
fn one_time<R: Number>(times: &Bound<'_, PyAny>) -> Option<R> {
    let is_array = times.is_instance_of::<PyUntypedArray>();
    (!is_array).then(|| times.extract().ok()).flatten()
}

/// The numbers as an aligned array of `R` in C order, which NumPy copies if it must. The crate `numpy` divides strides by the size of
/// an item, so it reads a field of a packed record at wrong addresses.
pub fn in_rows<'py, R: Number>(numbers: &Bound<'py, PyAny>) -> PyResult<PyReadonlyArrayDyn<'py, R>> {
    const ALIGNED_IN_C_ORDER: &str = "AC";
    if let Ok(array) = numbers.extract::<PyReadonlyArrayDyn<'py, R>>() {
        if array.is_aligned() && array.is_c_contiguous() {
            return Ok(array);
        }
    }
    let py = numbers.py();
    if py.import("numpy")?.getattr("iscomplexobj")?.call1((numbers,))?.extract()? {
        return Err(PyTypeError::new_err("the numbers are complex"));
    }
    let require = py.import("numpy")?.getattr("require")?;
    let array = require.call1((numbers, R::get_dtype(py), ALIGNED_IN_C_ORDER))?;
    array.extract()
}

/// Times, positions, velocities, accelerations and jerks; an array may be left out.
pub type Arrays<'py, R> = [Option<PyReadwriteArray1<'py, R>>; 5];

/// What the caller of `sample` wants.
pub struct Request<'py, R: Number> {
    /// From one sample to the next, s.
    pub dt: Option<R>,
    /// Number of samples.
    pub n: Option<usize>,
    /// Time of the first sample, s.
    pub start: R,
    /// Where to write.
    pub out: Option<Arrays<'py, R>>,
}

impl<'py, R: Number> Request<'py, R> {
    /// The most samples that the library takes.
    const MOST: usize = i32::MAX as usize;

    /// Samples a motion that lasts `t`, s. The result is a `Samples`.
    pub fn sample(self, py: Python<'py>, motion: &dyn Motion<R>, t: R) -> PyResult<Bound<'py, PyAny>> {
        let n = self.count(t)?;
        let dt = self.dt.unwrap_or_else(|| self.spread(t, n));
        let mut arrays = match self.out {
            Some(arrays) => arrays,
            None => fresh(py, n)?,
        };
        fill(motion, self.start, dt, &mut arrays)?;
        let arrays = arrays.map(|array| array.map(|array| array.as_any().clone()));
        named(py, "Samples", PyTuple::new(py, arrays)?)
    }

    /// The times of the samples of a motion that lasts `t`, s.
    pub fn times(&self, py: Python<'py>, t: R) -> PyResult<Bound<'py, PyAny>> {
        let n = self.count(t)?;
        let mut times: PyReadwriteArray1<R> = empty::<R>(py, n)?.extract()?;
        let dt = self.dt.unwrap_or_else(|| self.spread(t, n));
        write_times(times.as_slice_mut()?, self.start, dt);
        Ok(times.as_any().clone())
    }

    /// Number of samples: the given one, the length of the arrays, or as many as reach the end of the motion.
    fn count(&self, t: R) -> PyResult<usize> {
        let lengths = self.out.iter().flatten().flatten().map(|array| array.len());
        let mut counts = lengths.chain(self.n);
        let n = match (counts.next(), self.dt) {
            (Some(n), _) => n,
            (None, Some(dt)) => self.count_to(t, dt)?,
            (None, None) => return Err(error("sample needs dt, n or out")),
        };
        if counts.any(|other| other != n) {
            return Err(error("the arrays of out, and n, differ in length"));
        }
        if n > Self::MOST {
            return Err(error(&format!("more than {} samples", Self::MOST)));
        }
        Ok(n)
    }

    /// As many samples as reach `t`, s.
    fn count_to(&self, t: R, dt: R) -> PyResult<usize> {
        let steps: f64 = ((t - self.start) / dt).into();
        if !(dt > R::ZERO && steps.is_finite()) {
            return Err(error("dt must be above 0, and the start finite"));
        }
        Ok((steps.ceil() as usize).saturating_add(1))
    }

    /// The distance of `n` samples from the start to `t`, s.
    fn spread(&self, t: R, n: usize) -> R {
        let steps = n.saturating_sub(1).clamp(1, Self::MOST);
        (t - self.start) / R::from_index(steps as i32)
    }
}

/// What several axes do: at each time `x`, s, a row with a number for each axis.
pub trait Rows<R> {
    /// Number of axes.
    fn axes(&self) -> usize;
    /// Position, velocity, acceleration and jerk of an axis.
    fn quantities(&self, x: R, axis: usize) -> [R; 4];

    /// Writes a quantity, or all four into an array each, of all axes: a row for each of the times, s.
    fn write(&self, times: &[R], quantity: Option<usize>, arrays: &mut [&mut [R]])
    where
        R: Number,
    {
        for (k, &x) in times.iter().enumerate() {
            for axis in 0..self.axes() {
                let numbers = self.quantities(x, axis);
                for (rows, number) in arrays.iter_mut().zip(&numbers[quantity.unwrap_or(0)..]) {
                    rows[k * self.axes() + axis] = *number;
                }
            }
        }
    }

    /// A quantity of all axes at a time, s, or at each of an array of times.
    fn rows<'py>(&self, times: &Bound<'py, PyAny>, quantity: usize) -> PyResult<Bound<'py, PyAny>>
    where
        R: Number,
    {
        if let Some(x) = one_time(times) {
            let mut row = vec![R::ZERO; self.axes()];
            self.write(&[x], Some(quantity), &mut [&mut row]);
            return Ok(PyArray1::from_vec(times.py(), row).into_any());
        }
        let [rows] = self.some_rows(times, Some(quantity))?;
        Ok(rows)
    }

    /// A quantity, or all four, of all axes at a time, s, or at each of an array of times: `N` arrays.
    fn some_rows<'py, const N: usize>(
        &self, times: &Bound<'py, PyAny>, quantity: Option<usize>,
    ) -> PyResult<[Bound<'py, PyAny>; N]>
    where
        R: Number,
    {
        let py = times.py();
        let times: PyReadonlyArrayDyn<R> = in_rows(times)?;
        let shape = times.shape().iter().copied().chain([self.axes()]);
        let shape = PyTuple::new(py, shape.collect::<Vec<_>>())?;
        let mut arrays = Vec::new();
        for _ in 0..N {
            arrays.push(empty::<R>(py, shape.clone())?);
        }
        let numbers = arrays.iter().map(|array| array.extract());
        let mut numbers: Vec<PyReadwriteArrayDyn<R>> = numbers.collect::<Result<_, _>>()?;
        let mut slices = Vec::new();
        for array in &mut numbers {
            slices.push(array.as_slice_mut()?);
        }
        self.write(times.as_slice()?, quantity, &mut slices);
        arrays.try_into().map_err(|_| error("a quantity has no array"))
    }

    /// `Samples` with rows, of a motion that lasts `t`, s.
    fn sample<'py>(&self, py: Python<'py>, request: Request<'py, R>, t: R) -> PyResult<Bound<'py, PyAny>>
    where
        R: Number,
    {
        let times = request.times(py, t)?;
        let [p, v, a, j] = self.some_rows(&times, None)?;
        named(py, "Samples", (times, p, v, a, j))
    }
}

/// Arrays for `n` samples.
fn fresh<R: Number>(py: Python<'_>, n: usize) -> PyResult<Arrays<'_, R>> {
    let mut arrays = Arrays::default();
    for array in &mut arrays {
        *array = Some(empty::<R>(py, n)?.extract()?);
    }
    Ok(arrays)
}

/// An array of this shape. NumPy allocates it, and raises MemoryError if it cannot.
pub fn empty<'py, R: Number>(py: Python<'py>, shape: impl IntoPyObject<'py>) -> PyResult<Bound<'py, PyAny>> {
    let empty = py.import("numpy")?.getattr("empty")?;
    empty.call1((shape, R::get_dtype(py)))
}

fn fill<R: Number>(motion: &dyn Motion<R>, x0: R, dt: R, arrays: &mut Arrays<R>) -> PyResult<()> {
    let [t, p, v, a, j] = arrays;
    let [t, p, v, a, j] = [slice(t)?, slice(p)?, slice(v)?, slice(a)?, slice(j)?];
    write_times(t, x0, dt);
    motion.sample_into(x0, dt, [p, v, a, j]);
    Ok(())
}

fn write_times<R: Number>(times: &mut [R], x0: R, dt: R) {
    for (k, t) in (0..).zip(times) {
        *t = x0 + R::from_index(k) * dt;
    }
}

/// The numbers of an array; none if the array is left out.
fn slice<'a, R: Number>(array: &'a mut Option<PyReadwriteArray1<'_, R>>) -> PyResult<&'a mut [R]> {
    let Some(array) = array else {
        return Ok(&mut []);
    };
    let slice = array.as_slice_mut();
    slice.map_err(|_| error("the arrays of out must be contiguous and aligned"))
}
