//! Compiles the original's C sources out of the `liba` crate: as `c8_…` in binary64 and as `c4_…` in binary32. For measurements it compiles them
//! again, as `o2c8_…` at `-O2` up to `o3c4_…` at `-O3`. The reference solver of the fastest motions is compiled too.
//!
//! The new names keep the libraries apart. Under the same names the linker would resolve both sides of every comparison to ours.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

const SOURCES: [(&str, &str); 6] = [
    ("poly", "eval eval_ evar evar_ swap"),
    ("trajbell", "gen pos vel acc jer"),
    ("trajtrap", "gen pos vel acc"),
    ("trajpoly3", "gen gen0 gen1 gen2 pos vel acc"),
    ("trajpoly5", "gen gen0 gen1 gen2 pos vel acc"),
    ("trajpoly7", "gen gen0 gen1 gen2 gen3 pos vel acc jer"),
];

fn main() {
    let liba = liba();
    for (level, size) in ["", "o2", "o3"].iter().flat_map(|l| [(l, "8"), (l, "4")]) {
        let mut build = cc::Build::new();
        if let Some(level) = level.strip_prefix('o') {
            build.opt_level_str(level);
        }
        build.include(liba.join("include")).define("A_SIZE_FLOAT", size).flag("-ffp-contract=off");
        for (source, functions) in SOURCES {
            build.file(liba.join(format!("src/{source}.c")));
            for function in functions.split(' ') {
                let name = format!("{source}_{function}");
                build.define(&format!("a_{name}"), &*format!("{level}c{size}_{name}"));
            }
        }
        build.compile(&format!("original{level}{size}"));
    }
    let mut build = cc::Build::new();
    for flag in ["-std=c99", "-fno-math-errno", "-Wall", "-Wextra"] {
        build.flag(flag);
    }
    build.opt_level(2).warnings_into_errors(true).files(["c/solver.c", "c/steps.c"]).compile("solver");
    println!("cargo:rerun-if-env-changed=BRIEF");
    if env::var_os("BRIEF").is_some() {
        brief();
    }
    println!("cargo:rerun-if-changed=c\ncargo:rerun-if-changed=build.rs");
    println!("cargo:rustc-env=LIBA={}", liba.display());
}

/// The tests of `brief.rs` that take longest. They run last, because most mutants are found before.
const LONG: [&str; 8] = [
    "do_axes_arrive_together", "do_axes_stay_inside", "do_loops_arrive", "does_the_clock_keep_the_limits",
    "is_a_corrected_motion_wrong", "is_a_path_nearly_the_shortest", "is_an_extreme_missed",
    "is_the_fastest_motion_right",
];
/// Lists the modules of `brief.rs`: every test that runs no other program and compiles no file of the library. Compiles the C programs.
fn brief() {
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap());
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let is_compact = env::var_os("CARGO_FEATURE_POLY_COMPACT").is_some();
    let mut modules = String::new();
    // The table of the C functions has those of the default build.
    let folders = ["tests", "tests/oracle/tests", "tests/miri/tests"];
    for folder in folders[..3 - usize::from(is_compact)].iter().map(|folder| root.join(folder)) {
        println!("cargo:rerun-if-changed={}", folder.display());
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_stem().unwrap().to_str().unwrap();
            let stands_apart = |text: String| ["Command", "Variant", "#[path"].iter().any(|word| text.contains(word));
            if path.extension().is_some_and(|e| e == "rs") && !stands_apart(fs::read_to_string(&path).unwrap()) {
                let order = if LONG.contains(&name) { "long_" } else { "" };
                modules += &format!("#[path = {path:?}] mod {order}{name};\n");
            }
        }
    }
    assert!(LONG.iter().all(|name| modules.contains(&format!("mod long_{name};"))), "{modules}");

    let compact = u8::from(is_compact);
    let config =
        [("SIZE_FLOAT", 8), ("TRAJPOLY_COMPACT", compact), ("TRAJPOLY3", 3), ("TRAJPOLY5", 3), ("TRAJPOLY7", 4)];
    let config = config.map(|(name, value)| format!("#define ATRAJ_{name} {value}\n")).concat();
    fs::write(out.join("atraj_config.h"), config).unwrap();
    println!("cargo:rerun-if-changed={}", root.join("c_tests").display());
    for entry in fs::read_dir(root.join("c_tests")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap();
        if path.extension().is_some_and(|e| e == "c") && !["aeabi", "threads"].contains(&name) {
            let main = format!("{name}_main");
            let mut build = cc::Build::new();
            build.include(root.join("include")).include(&out).define("main", &*main);
            build.file(&path).compile(&format!("program_{name}"));
            modules += &format!("program!({main});\n");
        }
    }
    fs::write(out.join("brief.rs"), modules).unwrap();
    if env::var("CARGO_ENCODED_RUSTFLAGS").is_ok_and(|flags| flags.contains("unit_lacks_binary64")) {
        cc::Build::new().file(root.join("c_tests/aeabi.c")).compile("aeabi");
    }
}

fn liba() -> PathBuf {
    let options = ["metadata", "--format-version=1", "--locked", "--filter-platform", &env::var("HOST").unwrap()];
    let output = Command::new(env::var_os("CARGO").unwrap()).args(options).output().expect("cargo runs");
    assert!(output.status.success(), "cargo metadata: {}", String::from_utf8_lossy(&output.stderr));
    let metadata = String::from_utf8(output.stdout).unwrap();
    let mut folders = metadata.split('"').filter_map(|text| text.strip_suffix("/Cargo.toml"));
    folders.find(|folder| folder.ends_with("liba-0.1.15")).expect("cargo metadata lists liba 0.1.15").into()
}
