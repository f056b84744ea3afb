//! May this library be shipped with what it depends on? Every dependency has a licence on the list below, and comes from crates.io with a
//! checksum. Advisories need a database from the network, so they are not checked here: `cargo audit` does so on a machine that can reach it.

use spdx::{Expression, ParseMode};
use std::collections::BTreeSet;
use std::process::Command;
use support::{lines, read, root};

/// Licences that ask for no more than their text with the code. A dependency offers at least one of them.
const ALLOWED: [&str; 10] = [
    "0BSD", "Apache-2.0", "Apache-2.0 WITH LLVM-exception", "BSD-2-Clause", "BSD-3-Clause", "BSL-1.0", "ISC", "MIT",
    "Unicode-3.0", "Zlib",
];
/// Build tools and the original. They are compiled for tests only, and nothing of them is shipped.
const TEST_ONLY: [(&str, &str); 4] = [
    ("axe-core", "MPL-2.0"),
    ("cbindgen", "MPL-2.0"),
    ("liba", "MPL-2.0"),
    ("libfuzzer-sys", "(MIT OR Apache-2.0) AND NCSA"),
];
/// What ships in an archive or a dependent program.
const SHIPPED: [&str; 2] = ["atraj", "libc"];

fn allowed(expression: &str) -> bool {
    let licence = Expression::parse_mode(expression, ParseMode::LAX);
    licence.is_ok_and(|licence| licence.evaluate(|part| ALLOWED.contains(&&*part.to_string())))
}

fn packages(options: &[&str]) -> BTreeSet<String> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["tree", "--locked", "--prefix=none", "--no-dedupe"]).args(options).current_dir(root());
    let lines = lines(&mut cargo);
    lines.iter().filter(|line| !line.is_empty()).map(|line| line.trim_end_matches(" (*)").to_owned()).collect()
}

#[test]
fn licences() {
    let mut names = BTreeSet::new();
    for package in packages(&["--workspace", "--all-features", "--target=all", "--format={p}|{l}"]) {
        let (name, licence) = package.split_once('|').unwrap();
        let is_ours = name.contains("(/");
        let name = name.split(' ').next().unwrap();
        let test_only = TEST_ONLY.contains(&(name, licence)) && !SHIPPED.contains(&name);
        assert!(licence.is_empty() && is_ours || allowed(licence) || test_only, "{package}");
        names.insert(name.to_owned());
    }
    for name in SHIPPED.iter().chain(&["cbindgen", "liba", "libfuzzer-sys"]) {
        assert!(names.contains(*name), "{name} is not among {names:?}");
    }
}

#[test]
fn every_locked_version_comes_from_crates_io_with_a_checksum() {
    let lock = read("Cargo.lock");
    let outside: Vec<_> = lock.split("[[package]]").filter(|package| package.contains("\nsource = ")).collect();
    assert!(outside.len() > 30);
    for package in outside {
        let registry = "\nsource = \"registry+https://github.com/rust-lang/crates.io-index\"";
        assert!(package.contains(registry) && package.contains("\nchecksum = \""), "{package}");
    }
}

/// npm compares every package with its hash. The page holds what `dependencies` names; the rest builds and tests it.
#[test]
fn the_playground_depends_on_allowed_packages() {
    let lock = read("playground/package-lock.json");
    let packages: Vec<_> = lock.split("\n    \"node_modules/").skip(1).collect();
    assert!(packages.len() > 3);
    for package in packages {
        let licence = package.split("\"license\": \"").nth(1);
        let licence = licence.and_then(|rest| rest.split('"').next()).unwrap_or_default();
        let hashed = package.contains("\"integrity\": \"sha512-");
        let name = package.split('"').next().unwrap();
        let test_only = TEST_ONLY.contains(&(name, licence)) && package.contains("\"dev\": true");
        assert!(hashed && (test_only || allowed(licence)), "{package}");
    }
}

#[test]
fn an_archive_ships_libc_and_nothing_else() {
    let packages = packages(&["--package=atraj", "--edges=normal", "--features=capi", "--format={p}"]);
    let names: Vec<_> = packages.iter().filter_map(|package| package.split(' ').next()).collect();
    assert_eq!(names, SHIPPED);
}

#[test]
fn a_planted_licence_is_seen() {
    for good in ["MIT OR GPL-3.0", "(MIT OR Apache-2.0) AND Unicode-3.0", "MIT/Apache-2.0"] {
        assert!(allowed(good), "{good}");
    }
    for bad in ["GPL-3.0-only", "MIT AND GPL-3.0", "(GPL-3.0 OR AGPL-3.0) AND MIT", ""] {
        assert!(!allowed(bad), "{bad}");
    }
}
