//! Does atraj give the bits of the original itself?
//!
//! The tests of the package in `tests/oracle` ask. This test runs them.

use std::path::Path;
use std::process::Command;

/// Runs `cargo test` in the package with these arguments.
fn oracle(arguments: &[&str]) {
    let package = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/oracle");
    let status = Command::new(env!("CARGO"))
        .args(["test", "--release", "--locked"])
        .args(arguments)
        .args(["--", "--nocapture"])
        .current_dir(package)
        .status()
        .expect("cargo runs");
    assert!(status.success(), "the oracle found a difference: see above");
}

/// In one test, because cargo runs one build at a time. The default build runs every test, each other build the tests of its
/// C functions.
#[test]
fn the_original_agrees() {
    oracle(&[]);
    for features in ["float", "poly-compact", "float,poly-compact"] {
        oracle(&["--test", "does_the_c_abi_agree", "--features", features]);
    }
}
