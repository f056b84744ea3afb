//! May this library be shipped with what it depends on? Every dependency of every lock file has a licence on the list below,
//! and comes from crates.io with a checksum. Advisories need a database from the network, so they are not checked here:
//! `cargo audit` or `cargo deny check advisories` does so on a machine that can reach it.

use std::collections::BTreeSet;
use std::fs;
use std::process::Command;
use support::repository::root;
use support::tools::run;

/// Licences that ask for no more than their text beside the code. A dependency offers at least one of them.
const ALLOWED: [&str; 10] = [
    "0BSD",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "BSL-1.0",
    "ISC",
    "MIT",
    "Unicode-3.0",
    "Zlib",
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
const LOCKED: [&str; 7] = [
    ".",
    "tests/oracle",
    "tests/handover",
    "tests/miri",
    "tests/mutants",
    "fuzz",
    "python",
];
const REGISTRY: &str = "registry+https://github.com/rust-lang/crates.io-index";

/// Whether an SPDX expression can be met with the allowed licences.
fn allowed(expression: &str) -> bool {
    let expression = expression.replace('/', " OR ");
    let whole = expression.trim();
    let group = whole
        .strip_prefix('(')
        .and_then(|rest| rest.split_once(')'));
    if let Some((group, rest)) = group {
        return match rest.trim().split_once(' ') {
            None => allowed(group),
            Some(("AND", rest)) => allowed(group) && allowed(rest),
            Some(("OR", rest)) => allowed(group) || allowed(rest),
            Some(_) => false,
        };
    }
    if let Some((left, right)) = whole.split_once(" AND ") {
        return allowed(left) && allowed(right);
    }
    whole
        .split(" OR ")
        .any(|licence| ALLOWED.contains(&licence.trim()))
}

/// Each value of `key` in the JSON of `cargo metadata`, package by package: name, version, licence, source.
fn packages(manifest: &str) -> Vec<[String; 4]> {
    let output = run(Command::new(env!("CARGO"))
        .args(["metadata", "--format-version=1", "--locked"])
        .arg("--manifest-path")
        .arg(root().join(manifest).join("Cargo.toml")));
    let json = String::from_utf8(output.stdout).unwrap();
    let packages = json.split("{\"name\":\"").skip(1);
    packages
        .filter(|package| package.contains("\"license\":") && package.contains("\"version\":\""))
        .map(|package| {
            let field = |key: &str| {
                let (_, rest) = package.split_once(&format!("\"{key}\":")).unwrap();
                let rest = rest.strip_prefix('"').unwrap_or("");
                rest.split('"').next().unwrap().to_owned()
            };
            let name = package.split('"').next().unwrap().to_owned();
            [name, field("version"), field("license"), field("source")]
        })
        .collect()
}

#[test]
fn licences_and_sources() {
    let mut names = BTreeSet::new();
    for manifest in LOCKED {
        for [name, version, licence, source] in packages(manifest) {
            let test_only = TEST_ONLY.contains(&(&name, &licence)) && !SHIPPED.contains(&&*name);
            let ours = source.is_empty();
            assert!(
                ours || source == REGISTRY,
                "{name} {version} is from {source}"
            );
            assert!(
                licence.is_empty() && ours || allowed(&licence) || test_only,
                "{manifest}: {name} {version} has the licence {licence:?}"
            );
            names.insert(name);
        }
    }
    for name in SHIPPED
        .iter()
        .chain(&["cbindgen", "liba", "proptest", "libfuzzer-sys"])
    {
        assert!(names.contains(*name), "{name} is not among {names:?}");
    }
}

#[test]
fn every_locked_version_has_a_checksum() {
    for manifest in LOCKED {
        let lock = fs::read_to_string(root().join(manifest).join("Cargo.lock")).unwrap();
        for package in lock.split("[[package]]").skip(1) {
            let outside = package.contains("\nsource = ");
            let pinned = package.contains(REGISTRY) && package.contains("\nchecksum = \"");
            assert!(!outside || pinned, "{manifest}:{package}");
        }
    }
}

/// npm compares every package with its hash. The page holds what `dependencies` names; the rest builds and tests it.
#[test]
fn the_playground_depends_on_allowed_packages() {
    let lock = fs::read_to_string(root().join("playground/package-lock.json")).unwrap();
    let packages: Vec<_> = lock.split("\n    \"node_modules/").skip(1).collect();
    assert!(packages.len() > 3);
    for package in packages {
        let licence = package.split("\"license\": \"").nth(1);
        let licence = licence
            .and_then(|rest| rest.split('"').next())
            .unwrap_or_default();
        let hashed = package.contains("\"integrity\": \"sha512-");
        let name = package.split('"').next().unwrap();
        let test_only = TEST_ONLY.contains(&(name, licence)) && package.contains("\"dev\": true");
        assert!(hashed && (test_only || allowed(licence)), "{package}");
    }
}

#[test]
fn an_archive_ships_libc_and_nothing_else() {
    let output = run(Command::new(env!("CARGO"))
        .args(["tree", "--locked", "--edges", "normal", "--prefix", "none"])
        .args(["--features", "capi", "--format", "{p}"])
        .current_dir(root()));
    let tree = String::from_utf8(output.stdout).unwrap();
    let names: Vec<_> = tree
        .lines()
        .filter_map(|line| line.split(' ').next())
        .collect();
    assert_eq!(names, SHIPPED);
}

#[test]
fn a_planted_licence_is_seen() {
    for good in [
        "MIT OR GPL-3.0",
        "(MIT OR Apache-2.0) AND Unicode-3.0",
        "MIT/Apache-2.0",
    ] {
        assert!(allowed(good), "{good}");
    }
    for bad in [
        "GPL-3.0-only",
        "MIT AND GPL-3.0",
        "(GPL-3.0 OR AGPL-3.0) AND MIT",
        "",
    ] {
        assert!(!allowed(bad), "{bad}");
    }
}
