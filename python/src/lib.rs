//! The extension module `atraj._atraj`: the library's profiles as Python classes.
#![forbid(unsafe_code)]
#![allow(clippy::duplicate_mod, reason = "the same classes for both real types")]

mod claraty;
mod motion;
mod values;
mod why;

use pyo3::prelude::*;
use pyo3::types::PyString;

// A Python class cannot be generic, so the files in `classes` are compiled once for each real type.
#[path = "classes"]
mod binary64 {
    type Real = f64;
    pub mod axes;
    pub mod group;
    pub mod machine;
    pub mod online;
    pub mod path;
    pub mod profiles;
}
#[path = "classes"]
mod binary32 {
    type Real = f32;
    pub mod axes;
    pub mod group;
    pub mod machine;
    pub mod online;
    pub mod path;
    pub mod profiles;
}

#[pymodule]
fn _atraj(module: &Bound<'_, PyModule>) -> PyResult<()> {
    add_part(module, "f64", "atraj", |part| {
        binary64::profiles::add(part)?;
        binary64::online::add(part)?;
        binary64::axes::add(part)?;
        binary64::path::add(part)?;
        binary64::machine::add(part)?;
        binary64::group::add(part)
    })?;
    add_part(module, "f32", "atraj.f32", |part| {
        binary32::profiles::add(part)?;
        binary32::online::add(part)?;
        binary32::axes::add(part)?;
        binary32::path::add(part)?;
        binary32::machine::add(part)?;
        binary32::group::add(part)
    })?;
    add_part(module, "claraty", "atraj.claraty", |part| part.add_class::<claraty::Trajectory>())
}

/// Adds a part, whose content Python finds in the module `public`.
fn add_part<'py>(
    module: &Bound<'py, PyModule>, name: &str, public: &str, add: impl Fn(&Bound<'py, PyModule>) -> PyResult<()>,
) -> PyResult<()> {
    let part = PyModule::new(module.py(), public)?;
    add(&part)?;
    for name in part.index()? {
        part.getattr(name.cast::<PyString>()?)?.setattr("__module__", public)?;
    }
    module.add(name, part)
}
