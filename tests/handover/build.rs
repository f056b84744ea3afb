//! Writes the source of the handover with other words: faults, and a counter that wraps after 16 ticks.

use std::path::Path;
use std::{env, fs};

const SOURCE: &str = "../../src/machine/handover.rs";

const VARIANTS: [(&str, &[(&str, &str)]); 14] = [
    ("whole", &[]),
    ("unfenced_tick", &[("fence(SeqCst);\n        let (time", "let (time")]),
    ("unfenced_publish", &[("fence(SeqCst);\n        let halves", "let halves")]),
    ("relaxed_store", &[("time.due(place), Release", "time.due(place), Relaxed")]),
    ("relaxed_tick", &[("self.due.load(Acquire)", "self.due.load(Relaxed)")]),
    ("while_it_decides", &[("|| now.0 & DECIDES != 0", "")]),
    ("relaxed_prepare", &[("load(Acquire));\n        let (due", "load(Relaxed));\n        let (due")]),
    ("always_in_time", &[("let takes_over = waits ||", "let takes_over = true || waits ||")]),
    ("never_withdrawn", &[("if !takes_over {", "if false {")]),
    ("from_any_move", &[("if time == now {", "if time.number() == now.number() {")]),
    ("in_any_tick", &[("if time == now {", "if time.place() == now.place() {")]),
    ("without_halves", &[("known + missing", "missing")]),
    ("without_missing", &[("known + missing", "known")]),
    ("of_another_place", &[("halves.place() == now.place()", "true")]),
];

/// A counter of 16 ticks.
const SMALL: [(&str, &str); 2] = [("= 32 - 2 * PLACE_BITS", "= 4"), ("TICKS - 1000", "TICKS - 3")];

fn main() {
    println!("cargo::rerun-if-changed={SOURCE}");
    println!("cargo::rerun-if-changed=build.rs");
    let source = fs::read_to_string(SOURCE).unwrap();
    // A comment for a file cannot stand inside a module.
    let code: String = source.lines().filter(|line| !line.starts_with("//!")).map(|line| format!("{line}\n")).collect();
    let directory = env::var_os("OUT_DIR").unwrap();
    for (name, changes) in VARIANTS {
        let mut text = code.clone();
        for (from, to) in changes.iter().chain(&SMALL) {
            assert_eq!(text.matches(from).count(), 1, "{name}: {from}");
            text = text.replace(from, to);
        }
        fs::write(Path::new(&directory).join(name).with_extension("rs"), text).unwrap();
    }
}
