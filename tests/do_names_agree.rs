//! Has the same thing the same name in C, C++, Rust and Python, as `names.csv` says? And is the rule for infinite limits said in the same words?
//!
//! C and C++ have liba's short names: `gen`, `pos`, `vel`, `acc`, `jer`. Rust and Python have whole words, and the same ones. The crate's name is
//! left out of Rust's paths, and the package's out of Python's. Four names differ for a reason: `gen` is liba's own plan, so the plan that never
//! fails is `fastest` in C++ too; Rust's `sample_into` fills arrays of the caller; Rust's `state_at` gives a whole `State`, and its `state` plain
//! numbers with the jerk; Python's `path` also makes the motions of a path, and its `Shaper.shape` gives the shaped move as a motion.
//! `python/tests/test_use.py` asks whether Python has its names.

use atraj::{axes, claraty};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use support::prelude::*;
use support::{read, root};

/// What a row names, and its name in C, C++, Rust and Python; empty without one. Other profiles have the names of the double-S.
struct Row([String; 5]);

fn rows() -> Vec<Row> {
    let table = read("tests/names.csv");
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("what,C,C++,Rust,Python"));
    let row = |line: &str| match line.split(',').collect::<Vec<_>>()[..] {
        [what, c, cpp, rust, python] => Row([what, c, cpp, rust, python].map(str::to_owned)),
        _ => panic!("not a row: {line}"),
    };
    let rows: Vec<_> = lines.map(row).collect();
    assert!(rows.len() > 40, "{} rows", rows.len());
    rows
}

fn column(k: usize) -> BTreeSet<String> {
    rows().into_iter().map(|Row(cells)| cells[k].clone()).filter(|name| !name.is_empty()).collect()
}

fn headers(directory: &Path) -> String {
    let paths = fs::read_dir(directory).unwrap().map(|entry| entry.unwrap().path());
    paths.map(|path| if path.is_dir() { headers(&path) } else { read(path) }).collect()
}

fn has_word(text: &str, word: &str) -> bool {
    let inside = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
    text.match_indices(word)
        .any(|(at, _)| !inside(text[..at].chars().next_back()) && !inside(text[at + word.len()..].chars().next()))
}

fn between<'a>(text: &'a str, start: &str, end: &str) -> &'a str {
    let (_, rest) = text.split_once(start).expect(start);
    rest.split_once(end).expect(end).0
}

fn last(name: &str) -> &str {
    name.rsplit([':', '.']).next().unwrap()
}

#[test]
fn c_has_the_names() {
    let symbols = read("tests/symbols.txt");
    let headers = headers(&root().join("include"));
    for name in column(1) {
        // A type or a constant is no symbol.
        let declared = has_word(&headers, &format!("struct {name}"))
            || has_word(&headers, &format!("enum {name}"))
            || headers.contains(&format!("    {name} = "));
        assert!(declared || symbols.lines().any(|symbol| symbol == name), "{name}");
    }
    // Every error has a row, and every function that is not liba's or CLARAty's.
    let codes = read("include/atraj/codes.h");
    let errors = codes.lines().filter_map(|line| line.trim().split_once(" = ")).map(|(name, _)| name);
    let ours = errors.chain(symbols.lines()).filter(|name| name.starts_with("atraj_") || name.starts_with("ATRAJ_ERR"));
    for name in ours {
        let others = ["trap", "poly3", "poly5", "poly7", "move"].map(|profile| format!("_{profile}_"));
        let of_bell = others.iter().fold(name.to_owned(), |name, profile| name.replace(profile, "_bell_"));
        let has_row =
            [name.to_owned(), of_bell.replace("atraj_", "a_traj"), of_bell].iter().any(|name| column(1).contains(name));
        assert!(has_row, "{name} has no row in names.csv");
    }
}

/// Whether Python's class has just the members that the core's set has, given as text: `Set(NAME)` for each bit alone.
fn python_has_members(class: &str, shown: impl Fn(u8) -> String) {
    let text = read("python/atraj/values.py");
    let body = between(&text, &format!("class {class}(IntFlag):"), "\nclass ");
    let in_python: Vec<_> = body.lines().filter(|line| line.contains(" = ")).map(str::trim).collect();
    let bits = (0..8).map(|k| 1 << k).map(|bit| (bit, shown(bit)));
    let members = bits.filter(|(_, text)| !text.ends_with("()"));
    let in_rust: Vec<_> = members.map(|(bit, text)| format!("{} = {bit}", between(&text, "(", ")"))).collect();
    assert_eq!(in_python, in_rust, "{class}");
}

/// The build asserts that C has every member.
#[test]
fn every_finding_has_its_copies() {
    python_has_members("Warnings", |bit| format!("{:?}", claraty::Warnings::from_bits(bit)));
    python_has_members("Findings", |bit| format!("{:?}", Findings::from_bits(bit)));
    let (in_c, in_rust, in_python) = (column(1), column(3), column(4));
    for bit in (0..8).map(|k| 1 << k).filter(|&bit| !Findings::from_bits(bit).is_empty()) {
        let shown = format!("{:?}", Findings::from_bits(bit));
        let name = between(&shown, "(", ")");
        let [c, rust, python] = ["ATRAJ_", "Findings::", "Findings."].map(|space| format!("{space}{name}"));
        let has_row = in_c.contains(&c) && in_rust.contains(&rust) && in_python.contains(&python);
        assert!(has_row, "{name} has no row in names.csv");
    }
}

#[test]
fn cpp_has_the_names() {
    let headers = headers(&root().join("include"));
    for name in column(2) {
        let short = format!("typedef struct {} {};", name.replace("::", "_"), last(&name));
        let is_declared = |text: &str| {
            let call = format!("{}(", last(&name));
            [" ", "*"].iter().any(|before| text.contains(&format!("{before}{call}")))
        };
        let exists = match name.split("::").collect::<Vec<_>>()[..] {
            [_, _] if headers.contains(&short) => true,
            ["Trajectory", _] => is_declared(between(&headers, "class Trajectory\n", "\n};")),
            [space, _] => headers
                .match_indices(&format!("namespace {space}\n{{\n"))
                .any(|(at, start)| is_declared(between(&headers[at..], start, "\n} /* namespace"))),
            [space, object, _] => is_declared(between(&headers, &format!("struct {space}_{object} {{"), "\n};")),
            _ => false,
        };
        assert!(exists, "{name}");
    }
}

/// Compiles each path and gives its text as the table writes it.
macro_rules! paths {
    (types: $($Type:ty),+; values: $($value:expr),+ $(,)?) => {{
        $(let _ = size_of::<$Type>();)+
        $(let _ = $value;)+
        let texts = [$(stringify!($Type)),+, $(stringify!($value)),+];
        texts.map(|text| text.replace(' ', "").replace("::<f64>", "").replace("<f64>", ""))
    }};
}

#[test]
fn rust_has_the_names() {
    let compiled = paths!(
        types: Bell<f64>, Trap<f64>, Poly3<f64>, Poly5<f64>, Poly7<f64>, Move<f64>, Phase<f64>, Limits<f64>, State<f64>, Extremes<f64>, Axis<f64>,
            Planner<f64>, Ticker<f64>, Group<f64>, GroupPlanner<f64>, GroupTicker<f64>, Tick, Step<f64>, Steps<f64>, StepStream<f64>, Clock<f64>,
            Shaper<f64>, ShaperStream<f64>, ShaperKind, axes::Contour<f64>, Findings, Error, claraty::Trajectory, claraty::Warnings;
        values: Bell::<f64>::new, Bell::<f64>::fastest, Bell::<f64>::check, Bell::<f64>::extremes, Bell::<f64>::position, Bell::<f64>::velocity,
            Bell::<f64>::acceleration, Bell::<f64>::jerk, Bell::<f64>::state_at, Bell::<f64>::sample_into, Poly7::<f64>::extremes,
            Limits::<f64>::symmetric, Move::<f64>::plan, Move::<f64>::within, Move::<f64>::track, Move::<f64>::check, Move::<f64>::reach,
            Move::<f64>::stop, Move::<f64>::meet, Move::<f64>::time_at, Move::<f64>::phases, axes::synchronise::<f64>,
            axes::synchronise_within::<f64>, axes::line::<f64>, axes::path_size, axes::path_size_near, axes::plan_path::<f64>,
            axes::plan_path_near::<f64>, axes::improve_path::<f64>, axes::path_moves::<f64>, axes::path_deviation::<f64>, axes::plan_contour::<f64>,
            axes::limit_feed::<f64>, Axis::<f64>::new, Axis::<f64>::split, Ticker::<f64>::tick, Planner::<f64>::go, Planner::<f64>::reach,
            Planner::<f64>::track, Planner::<f64>::stop, Group::<f64>::new, Group::<f64>::split, GroupTicker::<f64>::tick, GroupPlanner::<f64>::within,
            GroupPlanner::<f64>::go, GroupPlanner::<f64>::sync, GroupPlanner::<f64>::line, GroupPlanner::<f64>::path, GroupPlanner::<f64>::rate, GroupPlanner::<f64>::stop,
            GroupPlanner::<f64>::time,
            Steps::<f64>::new, Steps::<f64>::next, Steps::<f64>::follow, StepStream::<f64>::new, StepStream::<f64>::wait, StepStream::<f64>::tick,
            StepStream::<f64>::next, StepStream::<f64>::count, Shaper::<f64>::size, ShaperStream::<f64>::new, ShaperStream::<f64>::advance,
            ShaperStream::<f64>::change, ShaperStream::<f64>::tick, Shaper::<f64>::new, Shaper::<f64>::add, Shaper::<f64>::smooth,
            Shaper::<f64>::state, Shaper::<f64>::bell_state, axes::line_stop::<f64>, Clock::<f64>::new, Clock::<f64>::rate, Clock::<f64>::until,
            Clock::<f64>::rebase, Clock::<f64>::time, Clock::<f64>::state, claraty::Trajectory::start, claraty::Trajectory::stop,
            claraty::Trajectory::reset, Findings::EXCEEDS_JERK, Findings::EXCEEDS_ACCELERATION, Findings::EXCEEDS_VELOCITY, Findings::JUMPS,
            Findings::OVERSHOOTS, Findings::STARTS_OUTSIDE, Findings::ENDS_LEAVING, Findings::RATE_NOT_REACHED, Error::Axes, Error::NotFinite,
            Error::Limits, Error::Target, Error::Duration, Error::Line, Error::Position, Error::Late, Error::Unreachable, Error::Moving,
    );
    let named = column(3).into_iter().map(|name| name.replace("online::", "").replace("machine::", ""));
    assert_eq!(named.collect::<BTreeSet<_>>(), compiled.into_iter().collect());
}

#[test]
fn names_agree() {
    for Row([what, c, cpp, rust, python]) in rows() {
        if !cpp.is_empty() && last(&cpp) != "fastest" {
            assert!(c.ends_with(last(&cpp)), "{what}: {c}, {cpp}");
        }
        let rust = rust.strip_suffix("::new").unwrap_or(&rust); // the constructor has the name of the class
        if !python.is_empty() && last(&python) != "sample" {
            assert_eq!(last(rust), last(&python), "{what}");
        }
        let code = c.strip_prefix("ATRAJ_").map(|code| code.trim_start_matches("ERR_").replace('_', ""));
        if let Some(code) = code.filter(|_| c != "ATRAJ_ERR_NULL") {
            assert_eq!(code, last(rust).replace('_', "").to_uppercase(), "{what}");
        }
    }
}

#[test]
fn the_rule_for_infinite_limits_has_one_wording() {
    for file in [
        "src/limits.rs", "src/fastest/bell.rs", "src/capi/atraj/profiles.rs", "src/capi/atraj/move.rs",
        "include/atraj.h", "include/atraj/move.h", "python/atraj/values.py", "python/src/classes/profiles.rs",
    ] {
        assert!(read(file).contains("A jerk, or both accelerations, are finite."), "{file}");
    }
}
