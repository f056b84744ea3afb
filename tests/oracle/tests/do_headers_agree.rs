//! Do the original's headers and ours mean the same to a compiler?

use oracle::liba::original::{REALS, directory, include, shared_symbols};
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use support::variant::{DOUBLE, Variant, headers};
use support::{Family, Language, compilers, golden, lines, root, run};

/// The prototypes that gcc sees in the headers of a directory, with the real type by its C name.
fn prototypes(include: &Path, size: &str) -> Vec<String> {
    let directory = directory("prototypes");
    let program = Family::ALL.map(|family| format!("#include \"a/{}.h\"\n", family.c_name())).concat();
    let source = directory.join("prototypes.c");
    let list = directory.join("prototypes.txt");
    fs::write(&source, program).unwrap();
    run(Command::new("gcc").args(["-fsyntax-only", size, "-aux-info"]).arg(&list).arg("-I").arg(include).arg(source));
    let real = if size.ends_with('4') { "float" } else { "double" };
    let text = fs::read_to_string(list).unwrap();
    let prototypes = text.lines().filter_map(|line| Some(line.split_once("*/ ")?.1));
    let named = prototypes.map(|prototype| prototype.replace("struct ", "").replace("a_float", real));
    let mut prototypes: Vec<_> = named.filter(|prototype| prototype.contains(" a_traj")).collect();
    prototypes.sort();
    prototypes
}

#[test]
fn prototypes_are_the_same() {
    for (variant, size) in REALS {
        let theirs = prototypes(&include(), size);
        assert_eq!(prototypes(&variant.include(), size), theirs);
        assert_eq!(theirs.len(), shared_symbols(variant).len());
    }
    let (double, float) = (REALS[0].1, REALS[1].1);
    assert_ne!(prototypes(&include(), double), prototypes(&include(), float));
}

/// A C program that includes both sets of headers, the first set with all names changed. In it the compiler compares size, offset and type of every
/// field. The second set uses the prelude of the first. `tv` replaces the field `tv` of the first set.
fn layout_program(first: &Path, second: &Path, levels: usize, tv: &str) -> String {
    let headers = Family::ALL.map(Family::c_name);
    let names: Vec<_> = shared_symbols(&DOUBLE).into_iter().chain(headers.map(|name| format!("a_{name}"))).collect();
    let mut program = format!("#define tv {tv}\n");
    for (header, highest) in headers.iter().zip([0, 0, 3, 3, 4]) {
        if highest > 0 {
            let level = levels.min(highest);
            writeln!(program, "#define A_{} {level}", header.to_uppercase()).unwrap();
        }
    }
    program.extend(names.iter().map(|name| format!("#define {name} first_{name}\n")));
    program.extend(headers.map(|header| format!("#include \"{}/a/{header}.h\"\n", first.display())));
    program.push_str("#undef tv\n");
    program.extend(names.iter().map(|name| format!("#undef {name}\n")));
    for header in headers {
        writeln!(program, "#undef LIBA_{}_H", header.to_uppercase()).unwrap();
        writeln!(program, "#include \"{}/a/{header}.h\"", second.display()).unwrap();
    }
    for family in Family::ALL {
        let ours = format!("a_{}", family.c_name());
        let stored = &["p", "v", "a", "j"][..levels];
        let is_stored = |field: &&&str| !field.contains('[') || stored.contains(&&field[..1]);
        writeln!(program, "_Static_assert(sizeof({ours}) == sizeof(first_{ours}), \"{ours}\");").unwrap();
        for field in family.fields().iter().filter(is_stored) {
            writeln!(
                program,
                "_Static_assert(offsetof({ours}, {field}) == offsetof(first_{ours}, {field}) && \
                 _Generic((({ours} *)0)->{field}, __typeof__(((first_{ours} *)0)->{field}): 1), \"{ours}.{field}\");"
            )
            .unwrap();
        }
    }
    program
}

fn check_layout(compiler: &str, size: &str, program: &str) -> Output {
    let source = directory("layouts").join("layout.c");
    fs::write(&source, program).unwrap();
    let flags = ["-std=gnu11", "-Wall", "-Werror", "-fsyntax-only", size];
    Command::new(compiler).args(flags).arg(source).output().unwrap()
}

#[test]
fn layouts_are_the_same() {
    let theirs = include();
    for levels in 1..=4 {
        for (bytes, (_, size)) in [8, 4].into_iter().zip(REALS) {
            let ours = headers(bytes, false, [levels.min(3), levels.min(3), levels]);
            for (first, second) in [(&theirs, &ours), (&ours, &theirs)] {
                let program = layout_program(first, second, levels.into(), "tv");
                for compiler in compilers(Language::C) {
                    let output = check_layout(compiler, size, &program);
                    let errors = String::from_utf8_lossy(&output.stderr);
                    assert!(output.status.success(), "{compiler} {size} level {levels}: {errors}");
                }
            }
        }
    }
    for planted in ["more, tv", "t_v"] {
        let program = layout_program(&theirs, &headers(8, false, [3, 3, 4]), 4, planted);
        let output = check_layout("cc", REALS[0].1, &program);
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(errors.contains("a_trajbell"), "{planted} went unseen: {errors}");
    }
}

fn consume(variant: &Variant, include: &Path, compiler: &[&str], source: &Path) -> Vec<String> {
    let program = directory("consumer").join("program");
    let mut compile = Command::new(compiler[0]);
    compile.args(&compiler[1..]).args(["-Wall", "-Wextra", "-Werror", "-I"]).arg(include).arg(source);
    run(compile.arg(variant.archive()).args(["-lm", "-o"]).arg(&program));
    lines(Command::new(program).arg(golden::directory()))
}

#[test]
fn programs_are_the_same_with_either_headers() {
    let prelude = Path::new(env!("CARGO_MANIFEST_DIR")).join("c/prelude.c");
    let golden = root().join("c_tests/golden.c");
    let methods = root().join("c_tests/methods.cpp");
    for (variant, size) in REALS {
        let both = |compiler: &[&str], source: &Path| {
            let compiler = [compiler, &[size]].concat();
            let ours = consume(variant, &variant.include(), &compiler, source);
            assert_eq!(ours, consume(variant, &include(), &compiler, source), "{compiler:?} {}", source.display());
            ours
        };
        for compiler in compilers(Language::C) {
            assert_eq!(both(&[compiler, "-std=c99", "-DLIBA_HEADERS"], &golden).len(), shared_symbols(variant).len());
            for standard in ["-std=c99", "-std=c11", "-std=c17"] {
                assert!(both(&[compiler, standard], &prelude).len() > 20);
            }
        }
        for compiler in compilers(Language::Cpp) {
            for standard in ["-std=c++98", "-std=c++11", "-std=c++17", "-std=c++20"] {
                both(&[compiler, standard, "-DLIBA_HEADERS"], &methods);
            }
        }
    }
}
