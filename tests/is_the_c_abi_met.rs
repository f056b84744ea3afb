//! Do C and C++ programs that link the archive get the golden bits, the layout and the answers to bad input, with every
//! compiler, language standard and build choice?

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use support::golden;
use support::repository::root;
use support::tools::{Language, compilers, has_tool, lines, run};
use support::variant::{
    COMPACT, DOUBLE, FLOAT, FLOAT_COMPACT, LOW_LEVELS, VARIANTS, Variant, headers,
};

const STRICT: [&str; 4] = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"];
const C: [&str; 3] = ["c99", "c11", "c17"];
const CPP: [&str; 4] = ["c++98", "c++11", "c++17", "c++20"];

/// Compiles `c_tests/{source}` against the variant's headers and archive, once. The result is the program.
fn build(variant: &Variant, compiler: &str, flags: &[&str], source: &str) -> PathBuf {
    static BUILT: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
    let dist = variant.dist();
    let programs = variant.scratch();
    let options = flags.concat().replace('/', "-");
    let program = programs.join(format!("{source}-{compiler}{options}"));
    let mut built = BUILT.lock().unwrap();
    if !built.contains(&program) {
        let mut command = Command::new(compiler);
        command.args(STRICT).arg("-O2").args(flags);
        command.arg("-I").arg(dist.join("include"));
        command.arg(root().join("c_tests").join(source));
        command.arg(variant.archive()).arg("-lm");
        run(command.arg("-o").arg(&program));
        built.insert(program.clone());
    }
    program
}

/// Replays the golden rows. The result is the functions that the program called, as it prints them.
fn replay_golden(command: &mut Command) -> Vec<String> {
    let table = lines(command.arg(golden::directory()));
    let mut functions = Vec::new();
    for line in table {
        let [function, rows, differing] = line.split_whitespace().collect::<Vec<_>>()[..] else {
            panic!("not a table line: {line}");
        };
        assert!(rows.parse::<u32>().unwrap() > 0, "{line}");
        assert_eq!(differing, "0", "{line}");
        functions.push(function.to_owned());
    }
    functions.sort();
    functions
}

#[test]
fn golden_rows_from_c() {
    for variant in VARIANTS {
        for compiler in compilers(Language::C) {
            let program = build(variant, compiler, &["-std=c99"], "golden.c");
            let called = replay_golden(&mut Command::new(&program));
            let mut expected = variant.symbols();
            expected.retain(|symbol| has_golden_rows(symbol) && exists(variant, symbol));
            assert_eq!(called, expected, "functions that the golden rows call");
        }
    }
}

/// Whether the original has the bits of this function: its own functions, and those of `atraj.h` that give their bits together.
fn has_golden_rows(symbol: &str) -> bool {
    let together = symbol.ends_with("_sample") || symbol.ends_with("_state");
    symbol.starts_with("a_") || symbol.starts_with("atraj_") && !is_of_moves(symbol) && together
}

/// Whether `atraj/move.h` declares this function, for one axis.
fn is_of_moves(symbol: &str) -> bool {
    symbol.starts_with("atraj_move_") || symbol.starts_with("atraj_limits_")
}

/// Whether `atraj/move.h` declares this function, for several axes.
fn is_of_axes(symbol: &str) -> bool {
    symbol.starts_with("atraj_moves_")
}

/// Whether the build has this function. It has none of a level above its own.
fn exists(variant: &Variant, symbol: &str) -> bool {
    const ABOVE: [&str; 7] = [
        "a_trajpoly3_gen1",
        "a_trajpoly3_vel",
        "a_trajpoly3_gen2",
        "a_trajpoly3_acc",
        "a_trajpoly5_gen2",
        "a_trajpoly5_acc",
        "a_trajpoly7_gen3",
    ];
    variant.directory != LOW_LEVELS.directory
        || !(ABOVE.contains(&symbol) || symbol == "a_trajpoly7_jer")
}

#[test]
fn a_wrong_golden_bit_is_found() {
    let program = build(&DOUBLE, "cc", &["-std=c99"], "golden.c");
    let copy = DOUBLE.scratch().join("golden");
    copy_golden(&copy);
    let table = copy.join("bell_eval_f64.csv");
    let csv = fs::read_to_string(&table).unwrap();
    // The last digit of the last value: the jerk of the last row.
    let end = csv.trim_end().len() - 1;
    let wrong = if csv.as_bytes()[end] == b'0' {
        "1"
    } else {
        "0"
    };
    fs::write(&table, format!("{}{wrong}\n", &csv[..end])).unwrap();
    let output = Command::new(&program).arg(&copy).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(
        text.contains("bell_eval_f64.csv") && text.contains("golden"),
        "{text}"
    );
}

#[test]
fn a_missing_or_empty_golden_file_is_found() {
    let program = build(&DOUBLE, "cc", &["-std=c99"], "golden.c");
    let copy = DOUBLE.scratch().join("golden-incomplete");
    copy_golden(&copy);
    let table = copy.join("poly7_eval_f64.csv");
    fs::write(&table, "case,x,pos,vel,acc,jer\n").unwrap();
    assert_eq!(
        Command::new(&program).arg(&copy).status().unwrap().code(),
        Some(2)
    );
    fs::remove_file(&table).unwrap();
    assert_eq!(
        Command::new(&program).arg(&copy).status().unwrap().code(),
        Some(2)
    );
}

fn copy_golden(to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(golden::directory()).unwrap() {
        let from = entry.unwrap().path();
        fs::copy(&from, to.join(from.file_name().unwrap())).unwrap();
    }
}

#[test]
fn layout_prelude_and_null() {
    for variant in VARIANTS {
        for compiler in compilers(Language::C) {
            for standard in C {
                let standard = format!("-std={standard}");
                run(&mut Command::new(build(
                    variant,
                    compiler,
                    &[&standard],
                    "abi.c",
                )));
            }
        }
    }
}

#[test]
fn sampling_from_c() {
    for variant in VARIANTS {
        for compiler in compilers(Language::C) {
            let program = build(variant, compiler, &["-std=c99"], "sample.c");
            run(&mut Command::new(program));
        }
    }
}

#[test]
fn plans_that_never_fail_and_their_judge() {
    for variant in VARIANTS {
        for compiler in compilers(Language::C) {
            let program = build(variant, compiler, &["-std=c99"], "fastest.c");
            run(&mut Command::new(program));
        }
    }
}

#[test]
fn moves_from_any_state() {
    for variant in VARIANTS {
        for compiler in compilers(Language::C) {
            let program = build(variant, compiler, &["-std=c99"], "move.c");
            run(&mut Command::new(program));
        }
    }
}

#[test]
fn moves_of_several_axes() {
    for variant in VARIANTS {
        for compiler in compilers(Language::C) {
            let program = build(variant, compiler, &["-std=c99"], "axes.c");
            run(&mut Command::new(program));
        }
    }
}

/// The C functions that no golden row has, because the original has none of them.
const FASTEST: [&str; 3] = ["_gen", "_check", "_extremes"];

#[test]
fn a_c_program_calls_every_plan_that_never_fails() {
    calls_each("fastest.c", is_fastest);
}

fn is_fastest(symbol: &str) -> bool {
    symbol.starts_with("atraj_")
        && !is_of_moves(symbol)
        && FASTEST.iter().any(|end| symbol.ends_with(end))
}

#[test]
fn a_c_program_calls_every_function_of_moves() {
    calls_each("move.c", is_of_moves);
}

#[test]
fn a_c_program_calls_every_function_of_several_axes() {
    calls_each("axes.c", is_of_axes);
}

/// Whether `c_tests/{source}` calls each of these functions.
fn calls_each(source: &str, of: fn(&str) -> bool) {
    let text = fs::read_to_string(root().join("c_tests").join(source)).unwrap();
    let symbols = DOUBLE.symbols();
    let mut expected = symbols.iter().filter(|symbol| of(symbol)).peekable();
    assert!(expected.peek().is_some());
    for symbol in expected {
        assert!(text.contains(&format!("{symbol}(")), "{symbol}");
    }
}

#[test]
fn cpp_methods_and_namespace() {
    for variant in VARIANTS {
        for compiler in compilers(Language::Cpp) {
            for standard in CPP {
                let standard = format!("-std={standard}");
                run(&mut Command::new(build(
                    variant,
                    compiler,
                    &[&standard],
                    "methods.cpp",
                )));
            }
        }
    }
}

/// Runs a program that replays the scripts of CLARAty's listing twice, without a difference.
fn replay_claraty(command: &mut Command) {
    let replays = lines(command.arg(golden::directory()));
    assert_eq!(
        replays,
        ["listing-on-a-clock 5250 0", "listing-advanced 5250 0"]
    );
}

#[test]
fn claraty_from_c() {
    for variant in [&DOUBLE, &FLOAT] {
        for compiler in compilers(Language::C) {
            for standard in C {
                let standard = format!("-std={standard}");
                let program = build(variant, compiler, &[&standard], "claraty.c");
                replay_claraty(&mut Command::new(program));
            }
        }
    }
}

#[test]
fn claraty_from_cpp_by_the_name_of_the_original_header() {
    let include = DOUBLE.dist().join("include/claraty");
    let include = format!("-I{}", include.display());
    for compiler in compilers(Language::Cpp) {
        for standard in CPP {
            for warnings in ["-UCLARATY_NO_WARNINGS", "-DCLARATY_NO_WARNINGS"] {
                let standard = format!("-std={standard}");
                let flags = [standard.as_str(), &include, warnings];
                let program = build(&DOUBLE, compiler, &flags, "claraty.cpp");
                replay_claraty(&mut Command::new(program));
            }
        }
    }
}

#[test]
fn a_wrong_golden_bit_of_claraty_is_found() {
    let program = build(&DOUBLE, "cc", &["-std=c99"], "claraty.c");
    let copy = DOUBLE.scratch().join("golden-claraty");
    copy_golden(&copy);
    let table = copy.join("claraty_listing_f64.csv");
    let csv = fs::read_to_string(&table).unwrap();
    // The last digit of t1 of the first start.
    let wrong = csv.replacen("40011dcf747091b4,400c", "40011dcf747091b5,400c", 1);
    assert_ne!(csv, wrong);
    fs::write(&table, wrong).unwrap();
    let output = Command::new(&program).arg(&copy).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(
        text.contains("claraty_listing_f64.csv:3: column 6"),
        "{text}"
    );
}

#[test]
fn the_c_program_calls_every_claraty_function() {
    calls_each("claraty.c", |symbol| symbol.starts_with("claraty_"));
}

#[test]
fn no_sanitizer_finding() {
    let sanitize = [
        "-g",
        "-fsanitize=address,undefined",
        "-fno-sanitize-recover=all",
    ];
    for variant in [&DOUBLE, &FLOAT_COMPACT] {
        let golden = build(variant, "cc", &sanitize, "golden.c");
        replay_golden(&mut Command::new(golden));
        for source in ["abi.c", "fastest.c", "move.c", "axes.c"] {
            run(&mut Command::new(build(variant, "cc", &sanitize, source)));
        }
        let sample = build(variant, "cc", &sanitize, "sample.c");
        run(&mut Command::new(sample));
        let claraty = build(variant, "cc", &sanitize, "claraty.c");
        replay_claraty(&mut Command::new(claraty));
    }
}

#[test]
fn no_valgrind_finding() {
    if !has_tool("valgrind") {
        return;
    }
    let golden = build(&DOUBLE, "cc", &["-g"], "golden.c");
    let valgrind = ["--quiet", "--error-exitcode=9", "--leak-check=full"];
    replay_golden(Command::new("valgrind").args(valgrind).arg(golden));
    let claraty = build(&DOUBLE, "cc", &["-g"], "claraty.c");
    replay_claraty(Command::new("valgrind").args(valgrind).arg(claraty));
}

/// Whether all headers in `include` compile together with these flags.
fn accepts(compiler: &str, language: &str, include: &Path, flags: &[&str]) -> bool {
    let mut command = Command::new(compiler);
    command
        .args(STRICT)
        .args(["-fsyntax-only", "-I"])
        .arg(include);
    command.args(["-include", "atraj.h"]);
    command.args(["-include", "claraty/trapezoid.h"]);
    if language == "c++" {
        command.args(["-include", "claraty/trapezoidal_trajectory.h"]);
    }
    let output = command
        .args(flags)
        .args(["-x", language, "/dev/null"])
        .output();
    output.unwrap().status.success()
}

#[test]
fn headers_compile_clean_in_every_configuration() {
    let full = [3, 3, 4];
    let mut configurations = vec![
        (headers(4, false, full), vec!["-DA_SIZE_FLOAT=4"]),
        (headers(4, false, full), vec!["-DA_SIZE_REAL=4"]),
        (
            headers(8, true, full),
            vec!["-DA_SIZE_FLOAT=8", "-DA_TRAJPOLY_COMPACT"],
        ),
        (headers(8, false, full), vec!["-DA_TRAJPOLY7=4"]),
    ];
    for level in 1..=3 {
        let flags = [3, 5, 7].map(|n| format!("-DA_TRAJPOLY{n}={level}").leak() as &str);
        configurations.push((headers(8, false, [level; 3]), flags.to_vec()));
    }
    for (language, standards, suffix) in [
        (Language::C, C.to_vec(), "c"),
        (Language::Cpp, CPP.to_vec(), "c++"),
    ] {
        for compiler in compilers(language) {
            for standard in &standards {
                for (include, configuration) in &configurations {
                    let standard = format!("-std={standard}");
                    let mut flags = configuration.clone();
                    flags.push(&standard);
                    assert!(
                        accepts(compiler, suffix, include, &flags),
                        "{compiler} {flags:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn headers_are_strict_c90() {
    let include = DOUBLE.dist().join("include");
    for compiler in compilers(Language::C) {
        let flags = ["-std=c90", "-pedantic-errors"];
        assert!(accepts(compiler, "c", &include, &flags), "{compiler}");
    }
}

/// A user of the class in C++. The templates are compiled with a vector.
const CLASS_USER: &str = "#include <claraty/trapezoidal_trajectory.h>
#include <vector>
double use(std::vector<double> &p);
double use(std::vector<double> &p)
{
    claraty::Trapezoidal_Trajectory x, y(x);
    x.set(p, p, p);
    x.set(p, 1.0, 1.0);
    x = y;
    std::cerr << x;
    return x.get_position();
}
";

#[test]
fn the_class_compiles_under_the_warnings_of_careful_users() {
    // The layout has padding, a class of one header has its table in every file, and C++98 has no later features.
    const CLANG: [&str; 5] = [
        "-Weverything",
        "-Wno-padded",
        "-Wno-weak-vtables",
        "-Wno-c++98-compat",
        "-Wno-c++98-compat-pedantic",
    ];
    let source = root().join("target/class_user.cpp");
    fs::write(&source, CLASS_USER).unwrap();
    for compiler in compilers(Language::Cpp) {
        let warnings: &[&str] = if compiler.starts_with("clang") {
            &CLANG
        } else {
            &["-Weffc++"]
        };
        for standard in CPP {
            let mut command = Command::new(compiler);
            command.args(STRICT).args(warnings).arg("-fsyntax-only");
            command.arg(format!("-std={standard}"));
            command.arg("-I").arg(DOUBLE.dist().join("include"));
            run(command.arg(&source));
        }
    }
}

#[test]
fn headers_refuse_what_the_archive_is_not() {
    let refused: [(&Variant, &[&str]); 10] = [
        (&DOUBLE, &["-DA_SIZE_FLOAT=4"]),
        (&FLOAT, &["-DA_SIZE_FLOAT=8"]),
        (&DOUBLE, &["-DA_SIZE_FLOAT=16"]),
        (&DOUBLE, &["-DA_SIZE_FLOAT=8", "-DA_SIZE_REAL=4"]),
        (&DOUBLE, &["-DA_TRAJPOLY_COMPACT"]),
        (&DOUBLE, &["-DA_TRAJPOLY7=3"]),
        (&DOUBLE, &["-DA_TRAJPOLY3=4"]),
        (&DOUBLE, &["-DA_SIZE_FLOAT=2"]),
        (&LOW_LEVELS, &["-DA_TRAJPOLY3=3"]),
        (&COMPACT, &["-DA_TRAJPOLY5=2"]),
    ];
    for (variant, flags) in refused {
        let include = variant.dist().join("include");
        assert!(accepts("cc", "c", &include, &[]), "{}", variant.directory);
        assert!(
            !accepts("cc", "c", &include, flags),
            "{} {flags:?}",
            variant.directory
        );
    }
    // Headers without the configuration, as in the repository, know no archive.
    assert!(!accepts("cc", "c", &root().join("include"), &[]));
}

#[test]
fn a_level_that_does_not_exist_fails_the_build_with_a_sentence() {
    for choice in [
        "A_TRAJPOLY3=4",
        "A_TRAJPOLY5=0",
        "A_TRAJPOLY7=5",
        "REAL=half",
        "POLY=wide",
    ] {
        let output = Command::new("make")
            .current_dir(root())
            .args(["-s", "dist", choice])
            .output()
            .unwrap();
        let text = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success(), "{choice}");
        assert!(text.contains("does not exist: "), "{choice}: {text}");
    }
}
