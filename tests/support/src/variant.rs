//! The builds of the archive and the symbols that each documents.

use crate::repository::root;
use crate::tools::run;
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::process::Command;
use std::sync::Mutex;

/// A build of the archive.
pub struct Variant {
    /// The variables that `make dist` takes.
    pub choices: &'static [&'static str],
    /// Where `make dist` puts it, in `target`.
    pub directory: &'static str,
}

/// The default build.
pub const DOUBLE: Variant = Variant {
    choices: &[],
    directory: "dist",
};
/// `a_float` is `float`.
pub const FLOAT: Variant = Variant {
    choices: &["REAL=float"],
    directory: "dist-float",
};
/// The polynomial structs of liba since 2025-03.
pub const COMPACT: Variant = Variant {
    choices: &["POLY=compact"],
    directory: "dist-compact",
};
/// Both choices.
pub const FLOAT_COMPACT: Variant = Variant {
    choices: &["REAL=float", "POLY=compact"],
    directory: "dist-float-compact",
};
/// Polynomial structs that hold few coefficient arrays.
pub const LOW_LEVELS: Variant = Variant {
    choices: &["A_TRAJPOLY3=1", "A_TRAJPOLY5=2", "A_TRAJPOLY7=3"],
    directory: "dist-poly3-level1-poly5-level2-poly7-level3",
};
/// Every build that is tested.
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

    /// The name of its library, of its pkg-config file and of its CMake package.
    pub fn name(&self) -> String {
        self.directory.replacen("dist", "atraj", 1)
    }

    /// Its archive. Builds it if need be.
    pub fn archive(&self) -> PathBuf {
        self.dist().join(format!("lib/lib{}.a", self.name()))
    }

    /// Its shared library. Builds it if need be.
    pub fn shared_library(&self) -> PathBuf {
        self.dist().join(format!("lib/lib{}.so", self.name()))
    }

    /// A folder for what tests make of this build. `make dist` replaces its own.
    pub fn scratch(&self) -> PathBuf {
        let folder = root().join("target/tests").join(self.directory);
        std::fs::create_dir_all(&folder).unwrap();
        folder
    }

    /// The symbols that the archive documents, from `tests/symbols*.txt`.
    pub fn symbols(&self) -> Vec<String> {
        let compact = self.choices.contains(&"POLY=compact");
        let file = if compact {
            "tests/symbols-compact.txt"
        } else {
            "tests/symbols.txt"
        };
        let list = std::fs::read_to_string(root().join(file)).unwrap();
        list.lines().map(str::to_owned).collect()
    }
}
