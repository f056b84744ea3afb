//! The original as its users have it: headers, archive and shared library under its own names.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use support::run;
use support::variant::{DOUBLE, FLOAT, Variant};

pub const LIBA: &str = env!("LIBA");

pub fn include() -> PathBuf {
    Path::new(LIBA).join("include")
}

/// Our builds that exist of the original too, each with the flag that the original's headers need.
pub const REALS: [(&Variant, &str); 2] = [(&DOUBLE, "-DA_SIZE_FLOAT=8"), (&FLOAT, "-DA_SIZE_FLOAT=4")];

pub fn shared_symbols(variant: &Variant) -> Vec<String> {
    let mut names = variant.symbols();
    names.retain(|name| name.starts_with("a_traj"));
    names
}

pub fn directory(name: &str) -> PathBuf {
    let directory = Path::new(env!("OUT_DIR")).join(name);
    let _ = fs::remove_dir_all(&directory);
    fs::create_dir_all(&directory).unwrap();
    directory
}

/// Builds `liba.a` and `liba.so` of the named sources, or of all sources if none is named, with these compiler flags.
pub fn build(directory: &Path, sources: &[&str], flags: &[&str]) {
    let mut objects = Vec::new();
    for entry in fs::read_dir(Path::new(LIBA).join("src")).unwrap() {
        let source = entry.unwrap().path();
        let stem = source.file_stem().unwrap().to_str().unwrap();
        let wanted = sources.is_empty() || sources.contains(&stem);
        if wanted && source.extension().is_some_and(|e| e == "c") {
            let object = directory.join(stem).with_extension("o");
            let mut compile = Command::new("cc");
            compile.args(["-c", "-O2", "-fPIC", "-ffp-contract=off", "-I"]).arg(include()).args(flags);
            run(compile.arg(&source).arg("-o").arg(&object));
            objects.push(object);
        }
    }
    assert!(objects.len() >= sources.len().max(1), "sources of liba");
    run(Command::new("ar").arg("crs").arg(directory.join("liba.a")).args(&objects));
    let shared = ["-shared", "-Wl,-soname,liba.so", "-o"];
    run(Command::new("cc").args(shared).arg(directory.join("liba.so")).args(&objects).arg("-lm"));
}
