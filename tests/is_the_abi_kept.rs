//! Does a program that was linked with the last release of this soname still run with today's library? `docs/compatibility.md` promises
//! it. The library of the last tag is built and compared. A new function is compatible; any other change needs a new soname.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use support::{abidiff, has_tool, root, run};

/// Two builds hold both real types and both generations of the polynomial structs.
const BUILDS: [(&str, &[&str]); 2] = [("double", &[]), ("float-compact", &["REAL=float", "POLY=compact"])];

/// The shared library of a source tree with these build choices. It has debugging information, where the types are.
fn library(tree: &Path, name: &str, choices: &[&str]) -> PathBuf {
    let dist = format!("target/dist-abi-{name}");
    let mut make = Command::new("make");
    make.current_dir(tree).env_remove("MAKEFLAGS").env("CARGO_PROFILE_RELEASE_DEBUG", "2");
    make.args(["-s", "dist"]).args(choices);
    // The levels of x86-64 have the same ABI.
    make.args([format!("DIST={dist}"), format!("CARGO_DIR=target/build-abi-{name}"), "HWCAPS=".into()]);
    run(&mut make);
    let files = fs::read_dir(tree.join(dist).join("lib")).unwrap();
    let mut paths = files.map(|file| file.unwrap().path()).filter(|path| path.extension().is_some_and(|e| e == "so"));
    paths.next().expect("a shared library")
}

/// The source tree of the last release; `None` before the first.
fn last_release() -> Option<PathBuf> {
    let describe = ["describe", "--tags", "--abbrev=0", "--match=v*", "HEAD^"];
    let output = Command::new("git").current_dir(root()).args(describe).output().unwrap();
    let tag = String::from_utf8(output.stdout).unwrap().trim().to_owned();
    if tag.is_empty() {
        return None;
    }
    let tree = Path::new(env!("CARGO_TARGET_TMPDIR")).join(&tag);
    fs::create_dir_all(&tree).unwrap();
    let unpack = format!("git -C '{}' archive {tag} | tar -x -C '{}'", root().display(), tree.display());
    run(Command::new("sh").args(["-c", &unpack]));
    Some(tree)
}

#[test]
fn since_the_last_release() {
    if !has_tool("abidiff") {
        return;
    }
    let Some(release) = last_release() else {
        println!("no release has a tag yet, so there is no ABI to keep");
        return;
    };
    for (name, choices) in BUILDS {
        let (text, changed) = abidiff(&library(&release, name, choices), &library(root(), name, choices));
        assert!(!changed, "{name}: {text}");
    }
}

#[test]
fn a_planted_change_is_seen() {
    if !has_tool("abidiff") || !has_tool("abidw") {
        return;
    }
    let [double, float] = BUILDS.map(|(name, choices)| library(root(), name, choices));
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let baseline = folder.join("double.abi");
    let abidw = ["--type-id-style", "hash", "--drop-undefined-syms", "--no-elf-needed"];
    let text = String::from_utf8(run(Command::new("abidw").args(abidw).arg(&double)).stdout).unwrap();
    fs::write(&baseline, &text).unwrap();
    let (before, structs) = text.split_at(text.find("<class-decl name='a_trajtrap'").unwrap());
    let of_struct = |field: &str, other: &str| format!("{before}{}", structs.replacen(field, other, 1));
    let planted = [
        ("another name", text.replace("a_trajtrap_acc", "a_trajtrap_acceleration")),
        ("a larger struct", of_struct("size-in-bits='768'", "size-in-bits='832'")),
        ("a field elsewhere", of_struct("layout-offset-in-bits='64'", "layout-offset-in-bits='96'")),
        ("another soname", text.replacen("soname='libatraj.so.0'", "soname='libatraj.so.1'", 1)),
    ];
    let (said, changed) = abidiff(&baseline, &double);
    assert!(!changed, "the library differs from its own description: {said}");
    for (what, planted) in planted {
        assert!(planted != text, "{what} was not planted");
        let file = folder.join("planted.abi");
        fs::write(&file, planted).unwrap();
        let (said, changed) = abidiff(&baseline, &file);
        assert!(changed, "{what} went unseen: {said}");
    }
    let (said, changed) = abidiff(&double, &float);
    assert!(changed, "another build went unseen: {said}");
}
