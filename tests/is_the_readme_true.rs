//! Do README.md and the pages behind it keep their word where a machine can tell: are their programs whole, do they build and run as
//! they say, and are the figures of README and of the pages those of the measured tables? They stay short, too.

use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;
use support::variant::DOUBLE;
use support::{Language, blocks, compilers, names, read, root, run};

/// The width counts characters. The words are those of `wc -w`, code and tables included.
#[test]
fn it_is_short() {
    let readme = read("README.md");
    let words = readme.split_whitespace().count();
    assert!(words <= 800, "{words} words");
    for line in readme.lines() {
        assert!(line.chars().count() <= 120, "too wide: {line}");
    }
}

/// Measured tables are in `docs/data`, so that these pages can be read.
#[test]
fn measured_pages_are_short() {
    for page in MEASURED {
        let words = read(format!("docs/{page}.md")).split_whitespace().count();
        assert!(words <= 1200, "{page}: {words} words");
    }
}

/// README.md and the pages in `docs`, each with its name. `do_the_guides_run` follows the pages for one kind of reader.
fn documents() -> Vec<(String, String)> {
    let pages = names("docs").into_iter().filter(|name| name.ends_with(".md") && !name.starts_with("for-"));
    let paths = pages.map(|name| format!("docs/{name}"));
    paths.chain(["README.md".to_owned()]).map(|path| (path.clone(), read(&path))).collect()
}

fn directory(name: &str) -> PathBuf {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("readme").join(name);
    let _ = fs::remove_dir_all(&directory);
    fs::create_dir_all(&directory).unwrap();
    symlink(root().join("target"), directory.join("target")).unwrap();
    directory
}

#[test]
fn its_lines_build_its_program() {
    let readme = read("README.md");
    let (programs, commands) = (blocks(&readme, "c"), blocks(&readme, "sh"));
    let ([program], [commands]) = (&programs[..], &commands[..]) else {
        panic!("one program, and the lines that build it");
    };
    let lines = commands.strip_prefix("make dist\n").unwrap();
    assert_eq!(lines.lines().count(), 2);
    DOUBLE.dist();
    let directory = directory("lines");
    fs::write(directory.join("axis.c"), program).unwrap();
    let said = run(Command::new("sh").args(["-euc", lines]).current_dir(directory)).stdout;
    assert!(said.starts_with(b"-2.0000 m after "));
}

fn built_and_run(compiler: &str, source: &Path, flags: &[&str]) -> String {
    let mut compile = Command::new(compiler);
    compile.args(["-Wall", "-Wextra", "-Werror"]).args(flags);
    compile.arg("-I").arg(DOUBLE.include().join("claraty")).arg(source);
    let program = DOUBLE.link(&mut compile, source.with_extension(compiler));
    String::from_utf8(run(&mut Command::new(program)).stdout).unwrap()
}

/// README, the pages for those who come from liba, of CLARAty, for safety engineers and of waypoints have such programs.
#[test]
fn each_program_runs() {
    let directory = directory("programs");
    for (name, language, flags, count) in [("c", Language::C, "-std=c99", 4), ("cpp", Language::Cpp, "-std=c++98", 4)] {
        let mut programs = 0;
        for (page, text) in documents() {
            for program in blocks(&text, name) {
                programs += 1;
                let source = directory.join(format!("{programs}.{name}"));
                fs::write(&source, program).unwrap();
                for compiler in compilers(language) {
                    let printed = built_and_run(compiler, &source, &[flags]);
                    assert!(printed.contains(" m"), "{page}, {compiler}: {printed}");
                }
            }
        }
        assert_eq!(programs, count, "programs in {name}");
    }
}

/// The tests of the documentation run the Rust programs, if `src/lib.rs` includes the page.
#[test]
fn each_rust_program_is_a_test() {
    let crate_docs = read("src/lib.rs");
    let mut programs = 0;
    for (page, text) in documents() {
        for program in blocks(&text, "rust") {
            assert!(program.contains("fn main()"), "{page}: {program}");
            let included = crate_docs.contains(&format!("include_str!(\"../{page}\")"));
            assert!(included, "src/lib.rs does not include {page}");
            programs += 1;
        }
    }
    assert!(programs > 0);
}

const MEASURED: [&str; 5] = ["firmware", "for-firmware", "bounds", "performance", "trust"];

/// `figures.tsv` has the words on a page, and the words in the file that they come from. `\n` begins a line there.
#[test]
fn its_figures_are_measured() {
    let functions = read("tests/symbols.txt").lines().count();
    assert!(read("README.md").contains(&format!("| {functions} functions in one object")));
    let table = read("tests/figures.tsv");
    let rows: Vec<_> = table.lines().skip(1).map(|line| line.split('\t').collect::<Vec<_>>()).collect();
    for page in MEASURED.map(|page| format!("docs/{page}.md")).iter().map(String::as_str).chain(["README.md"]) {
        assert!(rows.iter().filter(|row| row[0] == page).count() > 2, "{page}");
    }
    for row in rows {
        let [page, figure, file, there] = row[..] else { panic!("not a row: {row:?}") };
        assert!(read(page).contains(figure), "{page}: {figure}");
        assert!(read(file).contains(&there.replace("\\n", "\n")), "{page}, {figure}: {file} does not have {there}");
    }
}
