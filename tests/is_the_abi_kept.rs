//! Does a program that was linked with the library of this soname still run with today's? `docs/compatibility.md` promises it.
//!
//! `tests/abi` holds the ABI of the first library with this soname, as `abidw` describes it. A new function is compatible, and
//! `UPDATE_ABI=1 cargo test --test is_the_abi_kept` adds it to the descriptions before a release. Any other change needs a new
//! soname and new descriptions.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use support::repository::root;
use support::tools::{has_tool, run};

/// Two builds hold both real types and both generations of the polynomial structs.
const BUILDS: [(&str, &[&str]); 2] = [
    ("double", &[]),
    ("float-compact", &["REAL=float", "POLY=compact"]),
];

/// The shared library of these build choices, with debugging information: `abidw` reads the types there.
fn library(name: &str, choices: &[&str]) -> PathBuf {
    let dist = format!("target/dist-abi-{name}");
    let build = format!("target/build-abi-{name}");
    let mut make = Command::new("make");
    make.current_dir(root())
        .env_remove("MAKEFLAGS")
        .env("CARGO_PROFILE_RELEASE_DEBUG", "2");
    make.args(["-s", "dist"]).args(choices);
    make.arg(format!("DIST={dist}"));
    // One of the variables names the directory that cargo builds in. The levels of x86-64 have the same ABI.
    make.args([
        format!("BUILD={build}"),
        format!("CARGO_DIR={build}"),
        "HWCAPS=".into(),
    ]);
    run(&mut make);
    let files = fs::read_dir(root().join(dist).join("lib")).unwrap();
    let mut libraries = files
        .map(|file| file.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "so"));
    libraries.next().expect("a shared library")
}

fn described(name: &str) -> PathBuf {
    root().join("tests/abi").join(name).with_extension("abi")
}

/// The description that `abidw` gives, without the names of files and of Rust's modules, in which C's types have no part.
fn describe(library: &Path) -> String {
    let output = run(Command::new("abidw")
        .args(["--no-show-locs", "--no-comp-dir-path", "--no-corpus-path"])
        .args(["--type-id-style", "hash", "--drop-undefined-syms"])
        .arg("--no-elf-needed")
        .arg(library));
    let text = String::from_utf8(output.stdout).unwrap();
    let lines = text.lines().filter(|line| !line.contains("namespace-decl"));
    let lines = lines.map(|line| match line.split_once(" path='") {
        // Each unit needs a path of its own.
        Some((before, rest)) => {
            let (path, rest) = rest.split_once('\'').unwrap();
            let unit = if path.contains("libc-") {
                "libc"
            } else {
                "atraj"
            };
            format!("{before} path='{unit}'{rest}\n")
        }
        None => format!("{line}\n"),
    });
    lines.collect()
}

/// What `abidiff` prints about the two, and whether it found more than new functions.
fn changes(old: &Path, new: &Path) -> (String, bool) {
    let output = Command::new("abidiff")
        .arg("--no-added-syms")
        .args([old, new])
        .output()
        .unwrap();
    let code = output.status.code().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(code & 0b11, 0, "abidiff fails: {text}");
    (text, code != 0)
}

#[test]
fn since_the_first_library_of_this_soname() {
    if !has_tool("abidiff") || !has_tool("abidw") {
        return;
    }
    for (name, choices) in BUILDS {
        let today = describe(&library(name, choices));
        let baseline = described(name);
        if std::env::var_os("UPDATE_ABI").is_some() {
            fs::write(&baseline, &today).unwrap();
        }
        let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.abi"));
        fs::write(&file, today).unwrap();
        let (text, changed) = changes(&baseline, &file);
        assert!(!changed, "{name}: {text}");
    }
}

#[test]
fn a_planted_change_is_seen() {
    if !has_tool("abidiff") {
        return;
    }
    let baseline = described("double");
    let text = fs::read_to_string(&baseline).unwrap();
    let struct_start = text.find("<class-decl name='a_trajtrap'").unwrap();
    let (before, structs) = text.split_at(struct_start);
    let planted = [
        (
            "another name",
            text.replace("a_trajtrap_acc", "a_trajtrap_acceleration"),
        ),
        (
            "a larger struct",
            format!(
                "{before}{}",
                structs.replacen("size-in-bits='768'", "size-in-bits='832'", 1)
            ),
        ),
        (
            "a field elsewhere",
            format!(
                "{before}{}",
                structs.replacen(
                    "layout-offset-in-bits='64'",
                    "layout-offset-in-bits='96'",
                    1
                )
            ),
        ),
        (
            "another soname",
            text.replacen("soname='libatraj.so.0'", "soname='libatraj.so.1'", 1),
        ),
    ];
    for (what, planted) in planted {
        assert!(planted != text, "{what} was not planted");
        let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("planted.abi");
        fs::write(&file, planted).unwrap();
        let (said, changed) = changes(&baseline, &file);
        assert!(changed, "{what} went unseen: {said}");
    }
    let (said, changed) = changes(&baseline, &described("float-compact"));
    assert!(changed, "another build went unseen: {said}");
}
