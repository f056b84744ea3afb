//! Do the original's own test programs print the same with our headers and archive as with the original's?

use oracle::liba::original::{LIBA, REALS, build, directory, include};
use std::path::{Path, PathBuf};
use std::process::Command;
use support::{Family, has_tool, lines, run};

const MOVES: [&str; 7] = [
    "30 10 5 0 10 1 0", "3 2 2 10 -10 0 0.5", "5 4 -2 0 50 0 0", "2 -1 1.5 10 -3 0 0.25", "0 8 0 10 0 0 0 0 0 0",
    "0 8 10 -10 1 -1 2 0.5 -3 1", "0 5 4 -2 0 50 0 0",
];

/// Compiles a program: the C source alone, or the C source with its C++ twin, which then does the printing.
fn compile(directory: &Path, name: &str, cpp: bool, size: &str, include: &Path, archive: &Path) -> PathBuf {
    let source = |extension| Path::new(LIBA).join(format!("test/{name}.{extension}"));
    let object = directory.join(format!("{name}.o"));
    let mut c = Command::new("cc");
    c.args(["-c", "-O2", size, "-I"]).arg(include).arg(source("c"));
    run(c.args(cpp.then_some("-DHAS_CXX")).arg("-o").arg(&object));
    let program = directory.join(name);
    let mut link = Command::new(if cpp { "c++" } else { "cc" });
    if cpp {
        link.args(["-O2", size, "-DHAS_CXX", "-I"]).arg(include).arg(source("cc"));
    }
    run(link.arg(object).arg(archive).args(["-lm", "-o"]).arg(&program));
    program
}

#[test]
fn the_originals_own_programs_print_the_same() {
    let has_cpp = has_tool("c++");
    for (variant, size) in REALS {
        let [ours, theirs] = ["programs-ours", "programs-theirs"].map(directory);
        build(&theirs, &[], &[size]);
        let ours = |name, cpp| compile(&ours, name, cpp, size, &variant.include(), &variant.archive());
        let theirs = |name, cpp| compile(&theirs, name, cpp, size, &include(), &theirs.join("liba.a"));
        for name in Family::ALL.map(Family::c_name) {
            let mut printed = [0, 0];
            for cpp in [false, true].into_iter().filter(|&cpp| !cpp || has_cpp) {
                let programs = [ours(name, cpp), theirs(name, cpp)];
                for arguments in MOVES {
                    let output = programs.each_ref().map(|program| {
                        let mut program = Command::new(program);
                        lines(program.arg("/dev/stdout").args(arguments.split(' ')))
                    });
                    assert_eq!(output[0], output[1], "{name} {arguments}");
                    printed[usize::from(cpp)] += output[0].len();
                }
            }
            assert!(printed[0] > 1000 && (!has_cpp || printed[1] == printed[0]), "{size} {name}: {printed:?} lines");
        }
    }
}
