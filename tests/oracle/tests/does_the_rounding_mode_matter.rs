//! Do the floating-point settings of the processor decide whether a plan has the original's bits? `docs/parity.md` says how
//! much; this file prints the figures there: `-- --nocapture`.

use oracle::liba::original::{build, directory, include, shared_symbols};
use std::collections::HashMap;
use std::path::Path;
use std::process::Command;
use support::variant::DOUBLE;
use support::{lines, run};

/// What `c/rounding.c` prints: for each mode, the plans that differ from the original's and from those of the default mode.
fn differences() -> HashMap<String, [u64; 2]> {
    let directory = directory("rounding");
    build(&directory, &["poly", "trajbell", "trajtrap"], &["-DA_SIZE_FLOAT=8"]);
    let original = directory.join("original.a");
    let mut rename = Command::new("objcopy");
    for name in shared_symbols(&DOUBLE) {
        rename.arg(format!("--redefine-sym={name}=original_{name}"));
    }
    run(rename.arg(directory.join("liba.a")).arg(&original));

    let program = directory.join("rounding");
    let mut compile = Command::new("cc");
    compile.args(["-std=c99", "-O2", "-frounding-math", "-Wall", "-Wextra"]);
    compile.arg("-I").arg(include()).arg("-DA_SIZE_FLOAT=8");
    compile.arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("c/rounding.c"));
    compile.arg(DOUBLE.archive());
    run(compile.arg(&original).arg("-lm").arg("-o").arg(&program));
    let entry = |line: String| {
        println!("{line}");
        let words: Vec<_> = line.split(' ').collect();
        let number = |i: usize| words[i].parse().unwrap();
        (words[0].to_owned(), [number(1), number(2)])
    };
    lines(&mut Command::new(program)).into_iter().map(entry).collect()
}

#[test]
fn the_default_and_truncation_agree_and_directed_rounding_does_not() {
    let found = differences();
    let [plans, _] = found["plans"];
    assert_eq!(found["nearest"], [0, 0]);
    assert_eq!(found["flushed"], [0, 0], "no number here is subnormal");
    for mode in ["zero", "up", "down"] {
        let [from_original, from_default] = found[mode];
        assert!(from_default > plans / 2, "{mode}: {from_default}");
        assert_eq!(from_original == 0, mode == "zero", "{mode}");
    }
}
