//! Does a program tell which build of the library it holds, and at no cost?

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use support::variant::{COMPACT, DOUBLE, FLOAT, FLOAT_COMPACT, LOW_LEVELS, Variant};
use support::{has_tool, identify, lines, run};

fn identity(file: &Path) -> String {
    let output = identify(file);
    assert!(output.status.success(), "{}: {output:?}", file.display());
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(text.lines().count(), 1, "{text}");
    text.trim().to_owned()
}

fn expected(variant: &Variant) -> String {
    let (real, polynomials) = match variant.directory {
        name if name == DOUBLE.directory => ("double", "polynomial levels 3 3 4"),
        name if name == FLOAT.directory => ("float", "polynomial levels 3 3 4"),
        name if name == COMPACT.directory => ("double", "compact polynomials"),
        name if name == FLOAT_COMPACT.directory => ("float", "compact polynomials"),
        _ => ("double", "polynomial levels 1 2 3"),
    };
    let version = env!("CARGO_PKG_VERSION");
    format!("atraj {version}, {real}, {polynomials}, ")
}

fn link(name: &str, archive: &Path, flags: &[&str]) -> PathBuf {
    let tests = DOUBLE.scratch();
    let source = tests.join("one.c");
    let text = "#include \"a/trajbell.h\"\n\
                int main(void) { a_trajbell b; return a_trajbell_gen(&b, 30, 10, 5, 0, 10, 0, 0) > 0 ? 0 : 1; }\n";
    fs::write(&source, text).unwrap();
    let program = tests.join(name);
    let mut cc = Command::new("cc");
    cc.arg("-O2").args(flags).arg("-I").arg(DOUBLE.include()).arg(source).arg(archive);
    run(cc.args(["-lm", "-o"]).arg(&program));
    program
}

#[test]
fn the_library_itself() {
    for variant in [&DOUBLE, &FLOAT, &COMPACT, &FLOAT_COMPACT, &LOW_LEVELS] {
        for file in [variant.archive(), variant.shared_library()] {
            let told = identity(&file);
            assert!(told.starts_with(&expected(variant)), "{told}");
            assert!(told.contains(std::env::consts::ARCH), "{told}");
        }
    }
}

#[test]
fn readelf_finds_the_note() {
    let notes = lines(Command::new("readelf").arg("-n").arg(DOUBLE.archive()));
    assert!(notes.iter().any(|l| l.trim().starts_with("atraj ")), "{notes:?}");
}

fn sizes(program: &Path) -> String {
    lines(Command::new("size").arg(program))[1].split_whitespace().take(3).collect::<Vec<_>>().join(" ")
}

#[test]
fn a_program_without_unused_sections_tells_it_at_no_cost() {
    let archive = DOUBLE.archive();
    let bare = DOUBLE.scratch().join("without-note.a");
    run(Command::new("objcopy").args(["-R", ".atraj.note"]).arg(&archive).arg(&bare));
    for linker in ["bfd", "lld"] {
        if !has_tool(&format!("ld.{linker}")) {
            continue;
        }
        let chosen = format!("-fuse-ld={linker}");
        for strip in ["-g", "-s"] {
            let flags = ["-Wl,--gc-sections", &chosen, strip];
            let program = link(&format!("one-{linker}"), &archive, &flags);
            assert!(identity(&program).starts_with(&expected(&DOUBLE)));
            let without = link(&format!("one-{linker}-bare"), &bare, &flags);
            assert_eq!(sizes(&program), sizes(&without), "{linker} {strip}");
            assert!(!identify(&without).status.success());
        }
    }
}

#[test]
fn a_file_without_the_library_is_answered_with_a_sentence() {
    for (file, answer) in [
        ("/bin/sh", "/bin/sh holds no atraj: "),
        ("Cargo.toml", "Cargo.toml holds no atraj: "),
        ("missing", "FILE="),
        ("", "FILE="),
    ] {
        let output = identify(Path::new(file));
        let text = String::from_utf8(output.stderr).unwrap();
        assert!(!output.status.success(), "{file}");
        assert!(text.contains(answer), "{file}: {text}");
    }
}

#[test]
fn the_preprocessor_knows_the_version() {
    let version = env!("CARGO_PKG_VERSION");
    let flags = ["-dM", "-E", "-x", "c", "-include", "atraj.h", "/dev/null", "-I"];
    let macros = lines(Command::new("cc").args(flags).arg(DOUBLE.include()));
    let numbers = version.split(['.', '-']);
    let names = ["MAJOR", "MINOR", "PATCH"].map(|part| format!("ATRAJ_VERSION_{part}"));
    let mut wanted = vec![format!("#define ATRAJ_VERSION \"{version}\"")];
    wanted.extend(names.iter().zip(numbers).map(|(name, number)| format!("#define {name} {number}")));
    for line in wanted {
        assert!(macros.contains(&line), "{line}");
    }
}
