//! What every profile does, for both real types: evaluation at a time or at an array of times, and sampling.

use atraj::online::Move;
use atraj::{Bell, Extremes, Poly, Real, Trap};
use numpy::{
    Element, PyArrayDyn, PyReadonlyArrayDyn, PyReadwriteArray1, PyUntypedArray,
    PyUntypedArrayMethods,
};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::values::{error, named};

/// A real type of the library and of NumPy.
pub trait Number:
    Real + Element + Into<f64> + for<'a, 'py> FromPyObject<'a, 'py> + 'static
{
}

impl Number for f32 {}
impl Number for f64 {}

/// A planned motion. Times `x` are in seconds since its start.
pub trait Motion<R>: Send + Sync {
    fn position(&self, x: R) -> R;
    fn velocity(&self, x: R) -> R;
    fn acceleration(&self, x: R) -> R;
    /// NaN if the acceleration jumps.
    fn jerk(&self, x: R) -> R;
    /// The lowest and the highest state of the motion, which lasts `t`, s.
    fn extremes(&self, t: R) -> Extremes<R>;
    /// Fills each output to its end; an output may be empty.
    fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; 4]);
}

/// Methods that the library has under these names.
macro_rules! delegate {
    ($($name:ident)+) => {
        $(fn $name(&self, x: R) -> R {
            self.$name(x)
        })+
    };
}

impl<R: Number> Motion<R> for Bell<R> {
    delegate!(position velocity acceleration jerk);
    fn extremes(&self, _: R) -> Extremes<R> {
        self.extremes()
    }
    fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; 4]) {
        self.sample_into(x0, dt, outputs);
    }
}

impl<R: Number> Motion<R> for Trap<R> {
    delegate!(position velocity acceleration);
    fn jerk(&self, _: R) -> R {
        R::NAN
    }
    fn extremes(&self, _: R) -> Extremes<R> {
        self.extremes()
    }
    fn sample_into(&self, x0: R, dt: R, [p, v, a, j]: [&mut [R]; 4]) {
        self.sample_into(x0, dt, [p, v, a]);
        j.fill(R::NAN);
    }
}

impl<R: Number, const N: usize> Motion<R> for Poly<R, N> {
    delegate!(position velocity acceleration jerk);
    fn extremes(&self, t: R) -> Extremes<R> {
        self.extremes(t)
    }
    fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; 4]) {
        self.sample_into(x0, dt, outputs);
    }
}

impl<R: Number> Motion<R> for Move<R> {
    delegate!(position velocity acceleration jerk);
    fn extremes(&self, _: R) -> Extremes<R> {
        self.extremes()
    }
    fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; 4]) {
        self.sample_into(x0, dt, outputs);
    }
}

/// The values at a time, or at each of an array of times, s.
pub fn at<'py, R: Number>(
    times: &Bound<'py, PyAny>,
    value: impl Fn(R) -> R,
) -> PyResult<Bound<'py, PyAny>> {
    let py = times.py();
    if !times.is_instance_of::<PyUntypedArray>() {
        if let Ok(x) = times.extract::<R>() {
            let y: f64 = value(x).into();
            return y.into_bound_py_any(py);
        }
    }
    let times = in_rows(times)?;
    let values = times.as_array().mapv(value);
    Ok(PyArrayDyn::from_owned_array(py, values).into_any())
}

/// The numbers as an aligned array of `R` in C order, which NumPy copies if it must. The crate `numpy` divides strides by the size of
/// an item, so it reads a field of a packed record at wrong addresses.
pub fn in_rows<'py, R: Number>(
    numbers: &Bound<'py, PyAny>,
) -> PyResult<PyReadonlyArrayDyn<'py, R>> {
    const ALIGNED_IN_C_ORDER: &str = "AC";
    if let Ok(array) = numbers.extract::<PyReadonlyArrayDyn<'py, R>>() {
        if array.is_aligned() && array.is_c_contiguous() {
            return Ok(array);
        }
    }
    let py = numbers.py();
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
    pub fn sample(
        self,
        py: Python<'py>,
        motion: &dyn Motion<R>,
        t: R,
    ) -> PyResult<Bound<'py, PyAny>> {
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

/// Arrays for `n` samples.
fn fresh<R: Number>(py: Python<'_>, n: usize) -> PyResult<Arrays<'_, R>> {
    let mut arrays = Arrays::default();
    for array in &mut arrays {
        *array = Some(empty::<R>(py, n)?.extract()?);
    }
    Ok(arrays)
}

/// An array of this shape. NumPy allocates it, and raises MemoryError if it cannot.
pub fn empty<'py, R: Number>(
    py: Python<'py>,
    shape: impl IntoPyObject<'py>,
) -> PyResult<Bound<'py, PyAny>> {
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
