//! Does the shared library of each level of x86-64 that this processor has give the bits of the original?

use oracle::liba::{Abi, Original, run_seed};
use std::path::PathBuf;
use std::process::Command;
use support::variant::{DOUBLE, FLOAT, Variant};

const LOADER: &str = "/lib64/ld-linux-x86-64.so.2";

fn levels() -> Vec<&'static str> {
    let help = Command::new(LOADER).arg("--help").output();
    let help = help.map_or(String::new(), |output| String::from_utf8(output.stdout).unwrap());
    let mut levels = vec!["x86-64-v3", "x86-64-v4"];
    levels.retain(|level| {
        let is_here = help.contains(&format!("{level} (supported"));
        if !is_here {
            println!("SKIPPED: this processor lacks {level}");
        }
        is_here
    });
    levels
}

fn library(variant: &Variant, level: &str) -> PathBuf {
    variant.dist().join("lib/glibc-hwcaps").join(level).join(format!("lib{}.so.0", variant.name()))
}

fn every_level_agrees<R: Original>(variant: &Variant) {
    for level in levels() {
        let report = run_seed::<R>(&Abi::<R>::load(&library(variant, level)), &R::ORIGINAL, 5_000_000);
        println!("{}, {level}: {report}", R::NAME);
        report.assert_same();
    }
}

#[test]
fn in_both_real_types() {
    every_level_agrees::<f64>(&DOUBLE);
    every_level_agrees::<f32>(&FLOAT);
}
