//! Does the library define the documented symbols and no other, and need nothing but the square root, the clock, `memcpy` and `memset`?

use std::path::Path;
use std::process::Command;
use support::variant::{COMPACT, DOUBLE, FLOAT, FLOAT_COMPACT, PREFIXED, Variant};
use support::{has_tool, lines};

fn names(flags: &[&str], file: &Path) -> Vec<String> {
    let table = lines(Command::new("nm").arg("--format=posix").args(flags).arg(file));
    let symbols = table.iter().filter(|line| !line.ends_with(':'));
    let mut names: Vec<_> = symbols.filter_map(|line| line.split_whitespace().next().map(str::to_owned)).collect();
    names.sort();
    names
}

/// What the archive may need: the clock, roots, `memcpy` for moves on a line, and `memset` for samples that are all 0. LLVM emits a bare root instruction
/// only if the argument cannot be negative. Otherwise it also emits a call.
fn needed(variant: &Variant) -> &'static [&'static str] {
    let count = if variant.choices.contains(&"REAL=float") { 5 } else { 4 };
    &["clock_gettime", "memcpy", "memset", "sqrt", "sqrtf"][..count]
}

#[test]
fn in_the_archive() {
    if !has_tool("nm") || !has_tool("ar") {
        return;
    }
    for variant in [&DOUBLE, &FLOAT, &COMPACT, &FLOAT_COMPACT, &PREFIXED] {
        let archive = variant.archive();
        let members = lines(Command::new("ar").arg("t").arg(&archive));
        assert_eq!(members, ["atraj.o"], "members of the archive");
        assert_eq!(names(&["--defined-only", "--extern-only"], &archive), variant.symbols());
        let undefined = names(&["--undefined-only"], &archive);
        assert!(undefined.iter().any(|name| name == "clock_gettime"));
        for name in &undefined {
            assert!(needed(variant).contains(&name.as_str()), "needs {name}");
        }
        // Local symbols too: a panic or an allocation that the code can reach leaves its function here.
        for name in names(&[], &archive) {
            assert!(!["panic", "alloc", "unwind", "core"].iter().any(|word| name.contains(word)), "{name}");
        }
    }
}

#[test]
fn in_the_shared_library() {
    if !has_tool("nm") || !has_tool("readelf") {
        return;
    }
    for variant in [&DOUBLE, &FLOAT, &COMPACT, &FLOAT_COMPACT, &PREFIXED] {
        let library = variant.shared_library();
        assert_eq!(names(&["--dynamic", "--defined-only", "--extern-only"], &library), variant.symbols());
        let dynamic = lines(Command::new("readelf").arg("--dynamic").arg("--wide").arg(&library));
        let entry = |kind: &str| -> Vec<&str> {
            let of_kind = dynamic.iter().filter(|line| line.contains(kind));
            of_kind.filter_map(|line| line.split(['[', ']']).nth(1)).collect()
        };
        assert_eq!(entry("(SONAME)"), [format!("lib{}.so.0", variant.name())]);
        assert!(entry("(NEEDED)").iter().all(|name| ["libm.so.6", "libc.so.6"].contains(name)));
        assert!(entry("(RPATH)").is_empty() && entry("(RUNPATH)").is_empty());
    }
}
