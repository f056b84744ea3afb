//! Does README.md keep its word where a machine can tell: are its programs whole, and do they build and run as it says? It stays
//! short, too.

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
