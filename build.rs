//! Reads the build choices of the C ABI and writes the C header that tells them to the compiler of a user.

use std::{env, fs, path::Path};

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(trajpoly3_v, trajpoly3_a)");
    println!("cargo::rustc-check-cfg=cfg(trajpoly5_v, trajpoly5_a)");
    println!("cargo::rustc-check-cfg=cfg(trajpoly7_v, trajpoly7_a, trajpoly7_j)");

    println!("cargo::rerun-if-env-changed=CARGO_ENCODED_RUSTFLAGS");
    println!("cargo::rustc-check-cfg=cfg(unit_lacks_binary64)");
    if unit_lacks_binary64() {
        println!("cargo::rustc-cfg=unit_lacks_binary64");
    }

    let size = if feature("FLOAT") { 4 } else { 8 };
    let compact = u8::from(feature("POLY_COMPACT"));
    let poly3 = level("A_TRAJPOLY3", 3);
    let poly5 = level("A_TRAJPOLY5", 3);
    let poly7 = level("A_TRAJPOLY7", 4);
    let version = package("VERSION");
    let (major, minor, patch) = (package("VERSION_MAJOR"), package("VERSION_MINOR"), package("VERSION_PATCH"));
    let config = format!(
        "\
/*!
 @file atraj_config.h
 @brief how the atraj archive of these headers was built
 @details Its build writes this file. The other headers include it and refuse a program that differs.
*/

#ifndef ATRAJ_CONFIG_H
#define ATRAJ_CONFIG_H

/*! @name version
 @{{ */
/*! version of the headers; `make identify FILE=program` tells the version of the library in a program */
#define ATRAJ_VERSION \"{version}\"
#define ATRAJ_VERSION_MAJOR {major}
#define ATRAJ_VERSION_MINOR {minor}
#define ATRAJ_VERSION_PATCH {patch}
/*! @}} */

/*! @name ABI
 @{{ */
/*! size of #a_float; 1 if the polynomial structs are compact, else 0; levels of the older polynomial structs */
#define ATRAJ_SIZE_FLOAT {size}
#define ATRAJ_TRAJPOLY_COMPACT {compact}
#define ATRAJ_TRAJPOLY3 {poly3}
#define ATRAJ_TRAJPOLY5 {poly5}
#define ATRAJ_TRAJPOLY7 {poly7}
/*! @}} */

#endif /* ATRAJ_CONFIG_H */
"
    );

    let real = if size == 4 { "float" } else { "double" };
    let polynomials =
        if compact == 1 { "compact polynomials".into() } else { format!("polynomial levels {poly3} {poly5} {poly7}") };
    let target = env::var("TARGET").expect("cargo sets TARGET");
    println!("cargo::rustc-env=ATRAJ_IDENTITY=atraj {version}, {real}, {polynomials}, {target}, cpu {}", cpu());

    let out = env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");
    fs::write(Path::new(&out).join("atraj_config.h"), config).expect("OUT_DIR is writable");
}

/// The processor that the compiler is told to compile for.
fn cpu() -> String {
    let flags = env::var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default();
    // Of several choices, the compiler takes the last.
    let chosen =
        flags.split('\x1f').filter_map(|flag| flag.trim_start_matches("-C").strip_prefix("target-cpu=")).next_back();
    chosen.unwrap_or("default").to_owned()
}

/// A Cortex-M whose floating-point unit computes in binary32 only, as far as the compiler is told.
fn unit_lacks_binary64() -> bool {
    let target = env::var("TARGET").expect("cargo sets TARGET");
    let flags = env::var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default();
    let computes_in_binary64 = ["cortex-m7", "cortex-m52", "cortex-m55", "cortex-m85"];
    target.starts_with("thumb")
        && target.ends_with("eabihf")
        && !computes_in_binary64.contains(&cpu().as_str())
        && !flags.contains("+fp64")
}

/// What `Cargo.toml` says of the package.
fn package(field: &str) -> String {
    env::var(format!("CARGO_PKG_{field}")).expect("cargo sets CARGO_PKG_*")
}

fn feature(name: &str) -> bool {
    env::var_os(format!("CARGO_FEATURE_{name}")).is_some()
}

/// How many of the arrays `p v a j` the struct of `variable` holds; emits a cfg for each beyond `p`.
fn level(variable: &str, highest: usize) -> usize {
    println!("cargo::rerun-if-env-changed={variable}");
    let level = match env::var(variable) {
        Err(_) => highest,
        Ok(text) => match text.parse() {
            Ok(level) if (1..=highest).contains(&level) => level,
            _ => {
                println!("cargo::error={variable}={text} does not exist: set it to 1 … {highest} or leave it unset.");
                highest
            }
        },
    };
    if feature("POLY_COMPACT") && level != highest {
        println!("cargo::error={variable} does not go with `poly-compact`, whose structs have no levels: unset one.");
    }
    let module = variable.trim_start_matches("A_").to_lowercase();
    for array in &["v", "a", "j"][..level - 1] {
        println!("cargo::rustc-cfg={module}_{array}");
    }
    level
}
