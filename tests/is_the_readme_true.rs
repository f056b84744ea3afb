//! Does README.md keep its word where a machine can tell: are its programs whole, do they build and run as it says, and does the
//! firmware gate build its table of chips? It stays short, too.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use support::documents::blocks;
use support::repository::root;
use support::tools::{Language, compilers, run};
use support::variant::DOUBLE;

fn readme() -> String {
    fs::read_to_string(root().join("README.md")).unwrap()
}

#[test]
fn it_is_short() {
    assert!(readme().lines().count() < 200);
}

/// Builds a program as README says, with one flag set more; what it prints.
fn built_and_run(compiler: &str, source: &Path, flags: &[&str]) -> String {
    let dist = DOUBLE.dist();
    let program = source.with_extension(compiler);
    let mut compile = Command::new(compiler);
    compile.args(["-Wall", "-Wextra", "-Werror"]).args(flags);
    compile.arg("-I").arg(dist.join("include"));
    compile.arg("-I").arg(dist.join("include/claraty"));
    compile.arg(source).arg(dist.join("lib/libatraj.a"));
    run(compile.arg("-lm").arg("-o").arg(&program));
    String::from_utf8(run(&mut Command::new(program)).stdout).unwrap()
}

fn written(name: &str, text: &str) -> PathBuf {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("readme");
    fs::create_dir_all(&directory).unwrap();
    let file = directory.join(name);
    fs::write(&file, text).unwrap();
    file
}

#[test]
fn its_programs_run() {
    for (name, language, flags, count) in [
        ("c", Language::C, "-std=c99", 2),
        ("cpp", Language::Cpp, "-std=c++98", 2),
    ] {
        let programs = blocks(&readme(), name);
        assert_eq!(programs.len(), count, "programs in {name}");
        for (i, program) in programs.iter().enumerate() {
            let source = written(&format!("axis{i}.{name}"), program);
            for compiler in compilers(language) {
                let printed = built_and_run(compiler, &source, &[flags]);
                assert!(printed.contains(" m"), "{compiler}: {printed}");
            }
        }
    }
    // A whole program too; a test of the documentation builds and runs it.
    let programs = blocks(&readme(), "rust");
    assert!(programs.iter().all(|code| code.contains("fn main()")));
}

/// The rows of the table of chips: the choices of `make dist`, and the C flags.
fn chips() -> Vec<(String, Vec<String>)> {
    let readme = readme();
    let rows = readme.lines().filter(|line| line.contains("`TARGET="));
    rows.map(|row| {
        let cells: Vec<_> = row
            .split('|')
            .map(|cell| cell.trim().trim_matches('`'))
            .collect();
        let flags = cells[3].split(' ').filter(|flag| flag.starts_with('-'));
        (cells[2].to_owned(), flags.map(str::to_owned).collect())
    })
    .collect()
}

#[test]
fn the_firmware_gate_builds_its_table_of_chips() {
    let makefile = fs::read_to_string(root().join("c_tests/firmware/Makefile")).unwrap();
    let (_, targets) = makefile.split_once("\nTARGETS :=").unwrap();
    let targets: String = targets.split("\nMACHINES").next().unwrap().into();
    let compilers: Vec<_> = makefile
        .lines()
        .filter(|line| line.contains("_CC :="))
        .collect();
    let chips = chips();
    assert_eq!(chips.len(), 10);
    for (choices, flags) in chips {
        let (target, cpu) = match choices.split_once(" CPU=") {
            Some((target, cpu)) => (target, Some(cpu)),
            None => (&*choices, None),
        };
        let triple = target.strip_prefix("TARGET=").unwrap();
        let built = match cpu {
            Some(cpu) => makefile.contains(triple) && makefile.contains(cpu),
            None => targets.split_whitespace().any(|name| name == triple),
        };
        assert!(built, "{choices}");
        assert!(
            flags.is_empty()
                || compilers.iter().any(|line| {
                    flags
                        .iter()
                        .all(|flag| line.split(' ').any(|word| word == flag))
                }),
            "no machine is compiled with {flags:?}"
        );
    }
}
