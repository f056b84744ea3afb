//! Do our headers refuse a program that differs from the archive if a header of liba's has chosen the real type before?

use oracle::liba::original::{directory, include};
use std::fs;
use std::path::Path;
use std::process::Command;
use support::variant::{DOUBLE, FLOAT, Variant};
use support::{Family, Language, compilers};

/// What the compiler says of a program that begins with `first` and then includes a header of ours; empty if it takes the program.
fn says(compiler: &str, ours: &Path, first: &str, header: &str, flags: &[&str]) -> String {
    let source = directory(&format!("behind-liba-{}", std::thread::current().name().unwrap())).join("program.c");
    fs::write(&source, format!("{first}\n#include \"{header}\"\n")).unwrap();
    let mut check = Command::new(compiler);
    check.args(["-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-I"]).arg(ours).arg("-I").arg(include());
    let output = check.args(flags).arg(source).output().unwrap();
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.success(), errors.is_empty(), "{errors}");
    errors
}

const LIBA: &str = "#include \"a/pid.h\"";

/// What matters of liba's `a.h` since 2025: another name of the real type.
const NEWER_LIBA: &str = "
#define LIBA_A_H
#include <stddef.h>
#define A_EXTERN extern
#define A_REAL_TYPE 0x08
typedef double a_real;
";

fn headers() -> Vec<String> {
    Family::ALL.map(|family| format!("a/{}.h", family.c_name())).into_iter().chain(["atraj.h".into()]).collect()
}

#[test]
fn the_real_type() {
    let flags: [(&Variant, &[&str], &str); 7] = [
        (&DOUBLE, &[], ""),
        (&DOUBLE, &["-DA_SIZE_FLOAT=8"], ""),
        (&DOUBLE, &["-DA_SIZE_FLOAT=4"], "define A_SIZE_FLOAT"),
        // Only the compiler sees the sizes of a type that the program brings.
        (&DOUBLE, &["-DA_FLOAT=float"], "not_the_archives"),
        (&FLOAT, &[], "define A_SIZE_FLOAT"),
        (&FLOAT, &["-DA_SIZE_FLOAT=8"], "define A_SIZE_FLOAT"),
        (&FLOAT, &["-DA_SIZE_FLOAT=4"], ""),
    ];
    for (variant, flags, expected) in flags {
        let ours = variant.include();
        for compiler in compilers(Language::C) {
            for header in headers() {
                let said = says(compiler, &ours, LIBA, &header, flags);
                let context = format!("{compiler} {} {flags:?} {header}: {said}", variant.directory);
                assert_eq!(said.is_empty(), expected.is_empty(), "{context}");
                assert!(said.contains(expected), "{context}");
            }
        }
    }
}

#[test]
fn levels_and_generation() {
    for flag in ["-DA_TRAJPOLY3=2", "-DA_TRAJPOLY5=1", "-DA_TRAJPOLY7=3", "-DA_TRAJPOLY_COMPACT"] {
        for header in headers() {
            let said = says("cc", &DOUBLE.include(), LIBA, &header, &[flag]);
            assert!(said.contains("leave"), "{flag} {header}: {said}");
        }
    }
}

#[test]
fn newer_liba() {
    for header in headers() {
        let says = |variant: &Variant| says("cc", &variant.include(), NEWER_LIBA, &header, &[]);
        assert_eq!(says(&DOUBLE), "");
        assert!(says(&FLOAT).contains("A_SIZE_REAL"));
    }
}

/// `atraj.h` serves liba's own structs too. Its C++ members belong to ours.
#[test]
fn libas_own_structs() {
    let line = |family: Family| format!("#include \"{}/a/{}.h\"\n", include().display(), family.c_name());
    let theirs = Family::ALL.map(line).concat();
    for compiler in compilers(Language::Cpp) {
        assert_eq!(says(compiler, &DOUBLE.include(), &theirs, "atraj.h", &["-xc++"]), "");
    }
}
