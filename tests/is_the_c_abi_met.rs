//! Do C and C++ programs that link the archive get the golden bits, the layout and the answers to bad input, with every
//! compiler, language standard and build choice?

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use support::variant::{COMPACT, DOUBLE, FLOAT, FLOAT_COMPACT, LOW_LEVELS, VARIANTS, Variant, headers};
use support::{Language, compilers, golden, has_tool, lines, names, read, root, run};

const STRICT: [&str; 4] = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"];
const C: [&str; 3] = ["c99", "c11", "c17"];
const CPP: [&str; 4] = ["c++98", "c++11", "c++17", "c++20"];

fn build(variant: &Variant, compiler: &str, flags: &[&str], source: &str) -> PathBuf {
    let options = flags.concat().replace('/', "-");
    // The tests run in threads, and some need the same program.
    let own = format!("{source}-{compiler}{options}-{:?}", std::thread::current().id());
    let program = variant.scratch().join(own.replace(['(', ')'], ""));
    let source = root().join("c_tests").join(source);
    variant.link(Command::new(compiler).args(STRICT).arg("-O2").args(flags).arg(source), program)
}

/// Compiles `c_tests/{source}` with each compiler of the language and each of these standards, and hands the programs over.
fn each(variant: &Variant, language: Language, standards: &[&str], source: &str, mut judge: impl FnMut(&mut Command)) {
    for compiler in compilers(language) {
        for standard in standards {
            judge(&mut Command::new(build(variant, compiler, &[&format!("-std={standard}")], source)));
        }
    }
}

fn succeeds(program: &mut Command) {
    run(program);
}

fn replay_golden(command: &mut Command) -> Vec<String> {
    let mut functions = Vec::new();
    for line in lines(command.arg(golden::directory())) {
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
        let mut expected = variant.symbols();
        expected.retain(|symbol| symbol.starts_with("a_") && exists(variant, symbol));
        each(variant, Language::C, &["c99"], "golden.c", |program| {
            assert_eq!(replay_golden(program), expected, "functions that the golden rows call");
        });
    }
}

/// Whether the build has this function. It has none of a level above its own.
fn exists(variant: &Variant, symbol: &str) -> bool {
    const ABOVE: [&str; 7] = [
        "a_trajpoly3_gen1", "a_trajpoly3_vel", "a_trajpoly3_gen2", "a_trajpoly3_acc", "a_trajpoly5_gen2",
        "a_trajpoly5_acc", "a_trajpoly7_gen3",
    ];
    variant.directory != LOW_LEVELS.directory || !(ABOVE.contains(&symbol) || symbol == "a_trajpoly7_jer")
}

/// What a program answers if a golden table is changed: its exit code and what it prints.
fn replay_changed(source: &str, table: &str, change: impl Fn(&str) -> Option<String>) -> (i32, String) {
    let program = build(&DOUBLE, "cc", &["-std=c99"], source);
    let copy = DOUBLE.scratch().join("golden");
    fs::create_dir_all(&copy).unwrap();
    for name in names(golden::directory()) {
        fs::copy(golden::directory().join(&name), copy.join(name)).unwrap();
    }
    match change(&read(copy.join(table))) {
        Some(changed) => fs::write(copy.join(table), changed).unwrap(),
        None => fs::remove_file(copy.join(table)).unwrap(),
    }
    let output = Command::new(program).arg(copy).output().unwrap();
    (output.status.code().unwrap(), String::from_utf8(output.stdout).unwrap())
}

/// In one test, as the changes share a directory.
#[test]
fn a_wrong_bit_and_missing_golden_data_are_found() {
    // The last digit of the last value: the jerk of the last row.
    let (code, text) = replay_changed("golden.c", "bell_eval_f64.csv", |csv| {
        let (rest, last) = csv.trim_end().split_at(csv.trim_end().len() - 1);
        Some(format!("{rest}{}\n", if last == "0" { "1" } else { "0" }))
    });
    assert_eq!(code, 1, "{text}");
    assert!(text.contains("bell_eval_f64.csv") && text.contains("golden"), "{text}");
    // The last digit of t1 of the first start.
    let (code, text) = replay_changed("claraty.c", "claraty_listing_f64.csv", |csv| {
        Some(csv.replacen("40011dcf747091b4,400c", "40011dcf747091b5,400c", 1))
    });
    assert_eq!(code, 1, "{text}");
    assert!(text.contains("claraty_listing_f64.csv:3: column 6"), "{text}");

    for table in [Some("case,x,pos,vel,acc,jer\n".to_owned()), None] {
        let (code, text) = replay_changed("golden.c", "poly7_eval_f64.csv", |_| table.clone());
        assert_eq!(code, 2, "{text}");
    }
}

#[test]
fn layout_prelude_and_null() {
    for variant in VARIANTS {
        each(variant, Language::C, &C, "abi.c", succeeds);
    }
}

/// tcc cannot look for a file (`__has_include`), and finds the archive's real type, levels and generation all the same.
#[test]
fn layout_by_tcc() {
    for variant in VARIANTS.iter().filter(|_| has_tool("tcc")) {
        let [object, program] = ["abi-tcc.o", "abi-tcc"].map(|file| variant.scratch().join(file));
        let mut compile = Command::new("tcc");
        compile.args(["-c", "-Wall", "-Werror", "-I"]).arg(variant.include());
        run(compile.arg(root().join("c_tests/abi.c")).arg("-o").arg(&object));
        let program = variant.link(Command::new("cc").args(["-z", "noexecstack"]).arg(object), program);
        run(&mut Command::new(program));
    }
}

const CONTRACTS: [&str; 2] = ["calls.c", "axis.c"];

#[test]
fn contracts_of_our_own_functions() {
    for variant in VARIANTS {
        // The other builds differ in the polynomials alone, which the first program calls.
        let has_its_own_real = [DOUBLE.directory, FLOAT.directory].contains(&variant.directory);
        for source in if has_its_own_real { &CONTRACTS[..] } else { &CONTRACTS[..1] } {
            each(variant, Language::C, &["c99"], source, succeeds);
        }
    }
}

#[test]
fn a_c_program_calls_every_function() {
    let sources = CONTRACTS.into_iter().chain(["golden.c", "claraty.c"]);
    let calls = sources.flat_map(|source| {
        let object = DOUBLE.scratch().join(source).with_extension("o");
        let mut compile = Command::new("cc");
        compile.args(["-std=c99", "-c", "-I"]).arg(DOUBLE.include());
        run(compile.arg(root().join("c_tests").join(source)).arg("-o").arg(&object));
        lines(Command::new("nm").args(["-u", "-j"]).arg(object))
    });
    let called: BTreeSet<_> = calls.collect();
    assert_eq!(DOUBLE.symbols().into_iter().filter(|symbol| !called.contains(symbol)).collect::<Vec<_>>(), [""; 0]);
}

#[test]
fn cpp_methods_and_namespace() {
    for variant in VARIANTS {
        each(variant, Language::Cpp, &CPP, "methods.cpp", succeeds);
        for compiler in compilers(Language::Cpp) {
            // Without optimisation, bytes between the members of a struct are what was there before.
            run(&mut Command::new(build(variant, compiler, &["-O0"], "methods.cpp")));
        }
    }
}

/// Runs a program that replays the scripts of CLARAty's listing twice, without a difference.
fn replay_claraty(command: &mut Command) {
    assert_eq!(lines(command.arg(golden::directory())), ["listing-on-a-clock 1750 0", "listing-advanced 1750 0"]);
}

#[test]
fn claraty_from_c() {
    for variant in [&DOUBLE, &FLOAT] {
        each(variant, Language::C, &C, "claraty.c", replay_claraty);
    }
}

#[test]
fn claraty_from_cpp_by_the_name_of_the_original_header() {
    let include = format!("-I{}", DOUBLE.dist().join("include/claraty").display());
    for compiler in compilers(Language::Cpp) {
        for standard in CPP {
            for warnings in ["-UCLARATY_NO_WARNINGS", "-DCLARATY_NO_WARNINGS"] {
                let standard = format!("-std={standard}");
                run(&mut Command::new(build(&DOUBLE, compiler, &[&standard, &include, warnings], "claraty.cpp")));
            }
        }
    }
}

#[test]
fn no_sanitizer_finding() {
    let sanitize = ["-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"];
    for variant in [&DOUBLE, &FLOAT_COMPACT] {
        replay_golden(&mut Command::new(build(variant, "cc", &sanitize, "golden.c")));
        for source in CONTRACTS.iter().chain(&["abi.c"]) {
            run(&mut Command::new(build(variant, "cc", &sanitize, source)));
        }
        replay_claraty(&mut Command::new(build(variant, "cc", &sanitize, "claraty.c")));
    }
}

#[test]
fn no_valgrind_finding() {
    if !has_tool("valgrind") {
        return;
    }
    let valgrind = |source| {
        let (program, mut valgrind) = (build(&DOUBLE, "cc", &["-g"], source), Command::new("valgrind"));
        valgrind.args(["--quiet", "--error-exitcode=9", "--leak-check=full"]).arg(program);
        valgrind
    };
    replay_golden(&mut valgrind("golden.c"));
    replay_claraty(&mut valgrind("claraty.c"));
}

fn accepts(compiler: &str, language: &str, include: &Path, flags: &[&str]) -> bool {
    let mut command = Command::new(compiler);
    command.args(STRICT).args(["-fsyntax-only", "-I"]).arg(include);
    command.args(["-include", "atraj.h", "-include", "claraty/trapezoid.h"]);
    if language == "c++" {
        command.args(["-include", "claraty/trapezoidal_trajectory.h"]);
    }
    command.args(flags).args(["-x", language, "/dev/null"]).output().unwrap().status.success()
}

#[test]
fn headers_compile_clean_in_every_configuration() {
    let full = [3, 3, 4];
    let mut configurations = vec![
        (headers(4, false, full), vec!["-DA_SIZE_FLOAT=4"]),
        (headers(4, false, full), vec!["-DA_SIZE_REAL=4"]),
        (headers(8, true, full), vec!["-DA_SIZE_FLOAT=8", "-DA_TRAJPOLY_COMPACT"]),
        (headers(8, false, full), vec!["-DA_TRAJPOLY7=4"]),
    ];
    for level in 1..=3 {
        let flags = [3, 5, 7].map(|n| format!("-DA_TRAJPOLY{n}={level}").leak() as &str);
        configurations.push((headers(8, false, [level; 3]), flags.to_vec()));
    }
    for (language, standards, suffix) in [(Language::C, C.to_vec(), "c"), (Language::Cpp, CPP.to_vec(), "c++")] {
        for compiler in compilers(language) {
            for standard in &standards {
                for (include, configuration) in &configurations {
                    let standard = format!("-std={standard}");
                    let flags = [&configuration[..], &[&standard]].concat();
                    assert!(accepts(compiler, suffix, include, &flags), "{compiler} {flags:?}");
                }
            }
        }
    }
}

#[test]
fn headers_are_strict_c90() {
    for compiler in compilers(Language::C) {
        assert!(accepts(compiler, "c", &DOUBLE.include(), &["-std=c90", "-pedantic-errors"]), "{compiler}");
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
    const CLANG: [&str; 5] =
        ["-Weverything", "-Wno-padded", "-Wno-weak-vtables", "-Wno-c++98-compat", "-Wno-c++98-compat-pedantic"];
    let source = root().join("target/class_user.cpp");
    fs::write(&source, CLASS_USER).unwrap();
    for compiler in compilers(Language::Cpp) {
        let warnings: &[&str] = if compiler.starts_with("clang") { &CLANG } else { &["-Weffc++"] };
        for standard in CPP {
            let mut command = Command::new(compiler);
            command.args(STRICT).args(warnings).args(["-fsyntax-only", &format!("-std={standard}"), "-I"]);
            run(command.arg(DOUBLE.include()).arg(&source));
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
        let include = variant.include();
        assert!(accepts("cc", "c", &include, &[]), "{}", variant.directory);
        assert!(!accepts("cc", "c", &include, flags), "{} {flags:?}", variant.directory);
    }
    // Headers without the configuration, as in the repository, know no archive.
    assert!(!accepts("cc", "c", &root().join("include"), &[]));
}

#[test]
fn a_level_that_does_not_exist_fails_the_build_with_a_sentence() {
    for choice in ["A_TRAJPOLY3=4", "A_TRAJPOLY5=0", "A_TRAJPOLY7=5", "REAL=half", "POLY=wide"] {
        let output = Command::new("make").current_dir(root()).args(["-s", "dist", choice]).output().unwrap();
        let text = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success(), "{choice}");
        assert!(text.contains("does not exist: "), "{choice}: {text}");
    }
}
