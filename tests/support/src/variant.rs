//! The builds of the archive and the symbols that each documents.

use crate::repository::{read, root};
use crate::tools::run;
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::process::Command;
use std::sync::Mutex;

pub struct Variant {
    /// The variables that `make dist` takes. Only the real types have libraries for levels of x86-64, which take two thirds of the time.
    pub choices: &'static [&'static str],
    pub directory: &'static str, // where `make dist` puts it, in `target`
}

pub const DOUBLE: Variant = Variant { choices: &[], directory: "dist" };
pub const FLOAT: Variant = Variant { choices: &["REAL=float"], directory: "dist-float" };
pub const COMPACT: Variant = Variant { choices: &["POLY=compact", "HWCAPS="], directory: "dist-compact" };
pub const FLOAT_COMPACT: Variant =
    Variant { choices: &["REAL=float", "POLY=compact", "HWCAPS="], directory: "dist-float-compact" };
pub const LOW_LEVELS: Variant = Variant {
    choices: &["A_TRAJPOLY3=1", "A_TRAJPOLY5=2", "A_TRAJPOLY7=3", "HWCAPS="],
    directory: "dist-poly3-level1-poly5-level2-poly7-level3",
};
/// Functions under other names, to stand next to liba in one program.
pub const PREFIXED: Variant = Variant { choices: &["SYMBOL_PREFIX=x_", "HWCAPS="], directory: "dist-prefix-x_" };
pub const FLOAT_PREFIXED: Variant =
    Variant { choices: &["REAL=float", "SYMBOL_PREFIX=x_", "HWCAPS="], directory: "dist-float-prefix-x_" };
pub const VARIANTS: [&Variant; 5] = [&DOUBLE, &FLOAT, &COMPACT, &FLOAT_COMPACT, &LOW_LEVELS];

impl Variant {
    pub fn dist(&self) -> PathBuf {
        static BUILT: Mutex<BTreeSet<&str>> = Mutex::new(BTreeSet::new());
        let mut built = BUILT.lock().unwrap();
        if !built.contains(self.directory) {
            run(Command::new("make").current_dir(root()).args(["-s", "dist"]).args(self.choices));
            built.insert(self.directory);
        }
        root().join("target").join(self.directory)
    }

    pub fn name(&self) -> String {
        self.directory.replacen("dist", "atraj", 1)
    }

    pub fn archive(&self) -> PathBuf {
        self.dist().join(format!("lib/lib{}.a", self.name()))
    }

    pub fn shared_library(&self) -> PathBuf {
        self.dist().join(format!("lib/lib{}.so", self.name()))
    }

    pub fn include(&self) -> PathBuf {
        self.dist().join("include")
    }

    /// Lets a compiler build a program with the headers and the archive of this build.
    pub fn link(&self, compiler: &mut Command, program: PathBuf) -> PathBuf {
        compiler.arg("-I").arg(self.include()).arg(self.archive());
        run(compiler.arg("-lm").arg("-o").arg(&program));
        program
    }

    /// A folder for what tests make of this build. `make dist` replaces its own.
    pub fn scratch(&self) -> PathBuf {
        let folder = root().join("target/tests").join(self.directory);
        std::fs::create_dir_all(&folder).unwrap();
        folder
    }

    pub fn symbols(&self) -> Vec<String> {
        let prefix = self.choices.iter().find_map(|choice| choice.strip_prefix("SYMBOL_PREFIX=")).unwrap_or_default();
        // In place of `gen0` to `gen3`, a compact polynomial has its coefficients: `c0` to `c3`.
        let part = if self.choices.contains(&"POLY=compact") { "_c" } else { "_gen" };
        let name = |line: &str| match line.split_once("_gen") {
            Some((family, order)) if !order.is_empty() => format!("{prefix}{family}{part}{order}"),
            _ => format!("{prefix}{line}"),
        };
        let mut names: Vec<_> = read("tests/symbols.txt").lines().map(name).collect();
        names.sort();
        names
    }
}

/// Our headers with the configuration of a build that need not exist, in a directory of their own.
pub fn headers(size_float: u8, compact: bool, levels: [u8; 3]) -> PathBuf {
    let dist = DOUBLE.dist();
    let [poly3, poly5, poly7] = levels;
    let include = root().join("target/headers").join(format!("{size_float}-{compact}-{poly3}{poly5}{poly7}"));
    std::fs::create_dir_all(&include).unwrap();
    run(Command::new("cp").arg("-R").arg(dist.join("include/.")).arg(&include));
    let config = include.join("a/atraj_config.h");
    let mut text = read(&config);
    for (field, built, wanted) in [
        ("SIZE_FLOAT", 8, size_float),
        ("TRAJPOLY_COMPACT", 0, u8::from(compact)),
        ("TRAJPOLY3", 3, poly3),
        ("TRAJPOLY5", 3, poly5),
        ("TRAJPOLY7", 4, poly7),
    ] {
        let line = |value| format!("#define ATRAJ_{field} {value}\n");
        assert!(text.contains(&line(built)), "{field} in {text}");
        text = text.replace(&line(built), &line(wanted));
    }
    std::fs::write(config, text).unwrap();
    include
}
