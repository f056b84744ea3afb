//! Does a plan of an axis take over in its own tick or never, wherever the interrupt comes?
//!
//! The tests of the package in `tests/handover` ask for one processor and for two. This test runs them.

use std::path::Path;
use std::process::Command;

#[test]
fn wherever_the_interrupt_comes() {
    let package = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/handover");
    let status = Command::new(env!("CARGO"))
        .args(["test", "--release", "--locked"])
        .args(["--", "--nocapture"])
        .current_dir(package)
        .status()
        .expect("cargo runs");
    assert!(status.success(), "a plan took over wrongly: see above");
}
