//! Ruckig's C++ library. tests/ruckig.sh builds it, and the variable RUCKIG names the shared library.

use libloading::Library;
use std::sync::OnceLock;

pub type Axis = [f64; 11]; // what Ruckig plans for one axis: the fields of `Axis` in tests/oracle/c/ruckig.cpp

pub type Plan = unsafe extern "C" fn(*const Axis) -> f64;

pub fn plan(axes: usize) -> Option<Plan> {
    let name = format!("ruckig_plan_{axes}");
    // SAFETY: the functions of the library have this type.
    library().map(|library| unsafe { *library.get(name.as_bytes()).expect("a planner") })
}

fn library() -> Option<&'static Library> {
    static LIBRARY: OnceLock<Option<Library>> = OnceLock::new();
    let load = || {
        let path = std::env::var_os("RUCKIG").filter(|path| !path.is_empty())?;
        // SAFETY: nothing runs when this library is loaded.
        Some(unsafe { Library::new(path) }.expect("RUCKIG names a shared library"))
    };
    LIBRARY.get_or_init(load).as_ref()
}
