//! Compiles the original's C sources out of the `liba` crate: as `c8_…` in binary64 and as `c4_…` in binary32. For
//! measurements it compiles them again, as `o2c8_…` at `-O2` up to `o3c4_…` at `-O3`. The referee of the
//! fastest motions is compiled too.
//!
//! The new names keep the libraries apart. Under the same names the linker would resolve both sides of every comparison to
//! ours.

use std::env;
use std::path::PathBuf;
use std::process::Command;

/// Source files, each with the names that it makes public.
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
        build
            .include(liba.join("include"))
            .define("A_SIZE_FLOAT", size)
            .flag("-ffp-contract=off");
        for (source, functions) in SOURCES {
            build.file(liba.join(format!("src/{source}.c")));
            for function in functions.split(' ') {
                let name = format!("{source}_{function}");
                build.define(&format!("a_{name}"), &*format!("{level}c{size}_{name}"));
            }
        }
        build.compile(&format!("original{level}{size}"));
    }
    cc::Build::new()
        .opt_level(2)
        .flag("-std=c99")
        .flag("-fno-math-errno")
        .flag("-Wall")
        .flag("-Wextra")
        .warnings_into_errors(true)
        .file("c/referee.c")
        .file("c/steps.c")
        .compile("referee");
    println!("cargo:rerun-if-changed=c/referee.c");
    println!("cargo:rerun-if-changed=c/steps.c");
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rustc-env=LIBA={}", liba.display());
}

/// Where cargo has unpacked the crate.
fn liba() -> PathBuf {
    let manifest = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap()).join("Cargo.toml");
    let output = Command::new(env::var_os("CARGO").unwrap())
        .args(["metadata", "--format-version=1", "--locked"])
        .args(["--filter-platform", &env::var("HOST").unwrap()])
        .arg("--manifest-path")
        .arg(manifest)
        .output()
        .expect("cargo runs");
    assert!(
        output.status.success(),
        "cargo metadata: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    let metadata = String::from_utf8(output.stdout).unwrap();
    metadata
        .split('"')
        .find_map(|text| {
            text.strip_suffix("/Cargo.toml")
                .filter(|d| d.ends_with("liba-0.1.15"))
        })
        .expect("cargo metadata lists liba 0.1.15")
        .into()
}
