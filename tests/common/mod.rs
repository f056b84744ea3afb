//! Golden data, bit-for-bit comparison, and the archives and C compilers: what the tests share.
#![allow(dead_code)] // each test file uses a part of it

use std::collections::BTreeSet;
pub mod random;

use std::fmt::{Debug, LowerExp};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::Mutex;

/// A real type as the golden files write it.
pub trait GoldenReal: atraj::Real + Default + Debug + LowerExp {
    /// How the files of this type end.
    const SUFFIX: &'static str;
    /// The value of a hex bit pattern, or of `nan`.
    fn parse(text: &str) -> Option<Self>;
    /// Same bits, or both NaN.
    fn same(self, other: Self) -> bool;
    /// Value and bit pattern, for messages.
    fn show(self) -> String;
}

macro_rules! golden_real {
    ($real:ty, $bits:ty, $suffix:literal, $digits:literal) => {
        impl GoldenReal for $real {
            const SUFFIX: &'static str = $suffix;
            fn parse(text: &str) -> Option<Self> {
                if text == "nan" {
                    return Some(<$real>::NAN);
                }
                let bits = <$bits>::from_str_radix(text, 16).ok()?;
                (text.len() == $digits).then(|| <$real>::from_bits(bits))
            }
            fn same(self, other: Self) -> bool {
                self.to_bits() == other.to_bits() || (self.is_nan() && other.is_nan())
            }
            fn show(self) -> String {
                format!("{self:e} ({:0width$x})", self.to_bits(), width = $digits)
            }
        }
    };
}
golden_real!(f32, u32, "f32", 8);
golden_real!(f64, u64, "f64", 16);

/// One row of a golden file: where it stands and its numbers.
pub struct Row<R> {
    pub place: String,
    pub case: usize,
    pub values: Vec<R>,
}

impl<R: Copy> Row<R> {
    /// The first `N` numbers.
    pub fn head<const N: usize>(&self) -> [R; N] {
        self.values[..N].try_into().unwrap()
    }
}

/// All rows of `tests/golden/{table}_{f32|f64}.csv`; the first `text` columns are a case number and words, the rest are
/// `numbers` bit patterns. Panics if the file is missing, has no rows or a row that is not of this form.
pub fn golden<R: GoldenReal>(table: &str, text: usize, numbers: usize) -> Vec<Row<R>> {
    cells(&format!("{table}_{}.csv", R::SUFFIX), text + numbers)
        .into_iter()
        .map(|(place, cells)| {
            let case = cells[0].parse().unwrap_or_else(|e| panic!("{place}: {e}"));
            let values = cells[text..]
                .iter()
                .map(|cell| R::parse(cell).unwrap_or_else(|| panic!("{place}: {cell:?}")))
                .collect();
            Row {
                place,
                case,
                values,
            }
        })
        .collect()
}

/// Where each row of a golden file stands and its `columns` cells. Panics if the file is missing, has no rows or a row
/// of another length.
pub fn cells(name: &str, columns: usize) -> Vec<(String, Vec<String>)> {
    let path = golden_dir().join(name);
    let csv = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let rows: Vec<_> = csv
        .lines()
        .enumerate()
        .skip(1)
        .map(|(index, line)| {
            let place = format!("{name}:{}", index + 1);
            let cells: Vec<_> = line.split(',').map(str::to_owned).collect();
            assert_eq!(cells.len(), columns, "{place}: columns");
            (place, cells)
        })
        .collect();
    assert!(!rows.is_empty(), "{}: no rows", path.display());
    rows
}

pub fn golden_dir() -> PathBuf {
    root().join("tests/golden")
}

/// The repository, from the package in `tests/oracle` too.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .ancestors()
        .find(|directory| directory.join("tests/golden").is_dir())
        .expect("a repository around the package")
}

/// Counts compared values and keeps the differing ones.
#[derive(Default)]
pub struct Comparison {
    pub compared: usize,
    pub differences: Vec<String>,
}

impl Comparison {
    pub fn check<R: GoldenReal>(&mut self, place: &str, what: &str, got: R, want: R) {
        self.compared += 1;
        if !got.same(want) {
            self.differences.push(format!(
                "{place}: {what} is {}, golden {}",
                got.show(),
                want.show()
            ));
        }
    }

    /// Prints the count; panics with the first differences if there is one.
    pub fn finish(self, what: &str) {
        println!(
            "{what}: {} values, {} differing",
            self.compared,
            self.differences.len()
        );
        assert!(self.compared > 0, "{what}: nothing was compared");
        assert!(
            self.differences.is_empty(),
            "{what}: {} of {} values differ:\n{}",
            self.differences.len(),
            self.compared,
            self.differences[..self.differences.len().min(10)].join("\n")
        );
    }
}

/// A build of the archive, named by the variables `make dist` takes, and the directory it goes to.
pub struct Variant {
    pub choices: &'static [&'static str],
    pub directory: &'static str,
}

pub const DOUBLE: Variant = Variant {
    choices: &[],
    directory: "dist",
};
pub const FLOAT: Variant = Variant {
    choices: &["REAL=float"],
    directory: "dist-float",
};
pub const COMPACT: Variant = Variant {
    choices: &["POLY=compact"],
    directory: "dist-compact",
};
pub const FLOAT_COMPACT: Variant = Variant {
    choices: &["REAL=float", "POLY=compact"],
    directory: "dist-float-compact",
};
pub const LOW_LEVELS: Variant = Variant {
    choices: &["A_TRAJPOLY3=1", "A_TRAJPOLY5=2", "A_TRAJPOLY7=3"],
    directory: "dist-poly3-level1-poly5-level2-poly7-level3",
};
pub const VARIANTS: [&Variant; 5] = [&DOUBLE, &FLOAT, &COMPACT, &FLOAT_COMPACT, &LOW_LEVELS];

impl Variant {
    /// Builds it with `make dist`, once in a test program; its directory.
    pub fn dist(&self) -> PathBuf {
        static BUILT: Mutex<BTreeSet<&str>> = Mutex::new(BTreeSet::new());
        let mut built = BUILT.lock().unwrap();
        if !built.contains(self.directory) {
            let mut make = Command::new("make");
            run(make
                .current_dir(root())
                .args(["-s", "dist"])
                .args(self.choices));
            built.insert(self.directory);
        }
        root().join("target").join(self.directory)
    }
}

/// The C or C++ compilers of this machine. In CI both must be there.
pub fn compilers(language: Language) -> Vec<&'static str> {
    let known = match language {
        Language::C => ["gcc", "clang"],
        Language::Cpp => ["g++", "clang++"],
    };
    known
        .into_iter()
        .filter(|compiler| has_tool(compiler))
        .collect()
}

#[derive(Clone, Copy)]
pub enum Language {
    C,
    Cpp,
}

/// Whether `tool` can be run. A missing one is said aloud, and is a failure in CI.
pub fn has_tool(tool: &str) -> bool {
    let found = Command::new(tool).arg("--version").output().is_ok();
    if !found {
        assert!(std::env::var_os("CI").is_none(), "{tool} is missing");
        println!("SKIPPED: {tool} is missing, what needs it is not tested");
    }
    found
}

/// Runs a command that must succeed; its output.
pub fn run(command: &mut Command) -> Output {
    let output = command
        .output()
        .unwrap_or_else(|e| panic!("{command:?}: {e}"));
    assert!(
        output.status.success(),
        "{command:?}: {}\n{}{}",
        output.status,
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
    output
}

/// The lines that a command prints; it must succeed.
pub fn lines(command: &mut Command) -> Vec<String> {
    let output = run(command).stdout;
    String::from_utf8(output)
        .unwrap()
        .lines()
        .map(str::to_owned)
        .collect()
}

/// The documented symbols of an archive, `tests/symbols*.txt`.
pub fn symbols(variant: &Variant) -> Vec<String> {
    let compact = variant.choices.contains(&"POLY=compact");
    let file = if compact {
        "tests/symbols-compact.txt"
    } else {
        "tests/symbols.txt"
    };
    let list = std::fs::read_to_string(root().join(file)).unwrap();
    list.lines().map(str::to_owned).collect()
}
