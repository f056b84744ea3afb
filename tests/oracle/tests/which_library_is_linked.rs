//! With our library and the original's on one link line, which library does what?

use oracle::liba::original::{build, directory, include};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use support::variant::DOUBLE;
use support::{Family, abidiff, has_tool, lines, root, run, tools};

/// Functions that the program calls: of the trajectories, of the original's other parts, and of the system.
const TRACED: [&str; 4] = ["a_trajbell_gen", "a_pid_pos", "sqrt", "memcpy"];
const MIXED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/c/mixed.c");

/// Links `c/mixed.c` with these libraries. The result is what it prints, and the file that defines each traced function.
fn link(libraries: &[&Path]) -> (Vec<String>, [String; 4]) {
    let program = directory("linked").join("mixed");
    let mut link = Command::new("cc");
    link.args(["-O2", "-fno-builtin", "-Wall", "-Wextra", "-Werror", "-I"]).arg(include()).arg(MIXED);
    for library in libraries {
        link.arg(library).arg(format!("-Wl,-rpath,{}", library.parent().unwrap().display()));
    }
    link.args(TRACED.map(|name| format!("-Wl,--trace-symbol={name}")));
    let Output { stdout, stderr, .. } = run(link.arg("-lm").arg("-o").arg(&program));
    let trace = [stdout, stderr].map(|text| String::from_utf8(text).unwrap()).concat();
    let definition = |name| {
        let suffix = format!(": definition of {name}");
        let definitions: Vec<_> = trace.lines().filter_map(|line| line.strip_suffix(&suffix)).collect();
        assert_eq!(definitions.len(), 1, "definitions of {name}:\n{trace}");
        definitions[0].to_owned()
    };
    (lines(&mut Command::new(program)), TRACED.map(definition))
}

#[test]
fn the_first_on_the_line_has_the_trajectories_and_nothing_else_is_replaced() {
    let theirs = directory("linking-theirs");
    build(&theirs, &[], &[]);
    let ours = DOUBLE.dist().join("lib");
    let (expected, _) = link(&[&theirs.join("liba.a")]);
    assert!(expected.len() > 100);
    for (ours, theirs) in [
        (ours.join("libatraj.a"), theirs.join("liba.a")),
        (ours.join("libatraj.so"), theirs.join("liba.so")),
        (ours.join("libatraj.a"), theirs.join("liba.so")),
        (ours.join("libatraj.so"), theirs.join("liba.a")),
    ] {
        for (line, winner) in [([&*ours, &*theirs], &ours), ([&*theirs, &*ours], &theirs)] {
            let (printed, [trajectory, pid, sqrt, memcpy]) = link(&line);
            assert_eq!(printed, expected, "{line:?}");
            assert!(trajectory.contains(winner.to_str().unwrap()), "{line:?}: {trajectory}");
            assert!(pid.contains(theirs.to_str().unwrap()), "{line:?}: {pid}");
            assert!(sqrt.contains("libm.so"), "{line:?}: {sqrt}");
            assert!(memcpy.contains("libc.so"), "{line:?}: {memcpy}");
        }
    }
}

#[test]
fn make_identify_shows_that_a_relink_took() {
    let theirs = directory("relinking-theirs");
    build(&theirs, &[], &[]);
    let theirs = theirs.join("liba.a");
    let ours = DOUBLE.archive();
    let identify = |line: &[&Path]| {
        let program = directory("relinked").join("program");
        let mut relink = Command::new("cc");
        relink.args(["-O2", "-I"]).arg(include()).arg(MIXED).args(line);
        run(relink.args(["-lm", "-o"]).arg(&program));
        let Output { stdout, stderr, .. } = tools::identify(&program);
        [stdout, stderr].map(|text| String::from_utf8(text).unwrap())
    };
    let [told, _] = identify(&[&ours, &theirs]);
    assert!(told.starts_with("atraj ") && told.contains(", double, "), "{told}");
    // Behind the original the archive is not asked for anything.
    for line in [&[&*theirs][..], &[&*theirs, &*ours]] {
        let [told, error] = identify(line);
        assert_eq!(told, "", "{line:?}");
        assert!(error.contains("program holds no atraj: "), "{error}");
    }
}

/// The original's shared library, with no functions but ours and with types for `abidiff`.
fn with_types(name: &str, flags: &[&str]) -> PathBuf {
    let directory = directory(name);
    let exports = directory.join("exports.map");
    fs::write(&exports, "{ global: a_traj*; local: *; };\n").unwrap();
    let mut sources = Family::ALL.map(Family::c_name).to_vec();
    sources.push("poly");
    build(&directory, &sources, &[&["-g"], flags].concat());
    let library = directory.join("exported.so");
    let mut link = Command::new("cc");
    link.args(["-shared", "-Wl,-soname,libatraj.so.0", "-Wl,--whole-archive"]).arg(directory.join("liba.a"));
    link.args(["-Wl,--no-whole-archive", &format!("-Wl,--version-script={}", exports.display()), "-lm", "-o"]);
    run(link.arg(&library));
    library
}

#[test]
fn abidiff_sees_no_change() {
    if !has_tool("abidiff") {
        return;
    }
    let dist = root().join("target/dist-types");
    let dist_of_types = ["-s", "dist", "DIST=target/dist-types"];
    run(Command::new("make").current_dir(root()).env("CARGO_PROFILE_RELEASE_DEBUG", "2").args(dist_of_types));
    let ours = dist.join("lib/libatraj.so");
    let (text, changed) = abidiff(&with_types("abi", &[]), &ours);
    assert!(!changed, "{text}");
    assert!(text.contains("0 Removed"), "{text}");
    for planted in ["-DA_SIZE_FLOAT=4", "-DA_TRAJPOLY7=3", "-Da_trajtrap_acc=a_trajtrap_acceleration"] {
        let (text, changed) = abidiff(&with_types("abi-planted", &[planted]), &ours);
        assert!(changed, "{planted} went unseen: {text}");
    }
}
