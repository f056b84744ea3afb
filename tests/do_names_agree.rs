//! Has the same thing the same name in C, C++, Rust and Python, as the tables of `docs/names.md` say? And is the rule for infinite
//! limits said in the same words?

use atraj::machine::{Axis, Clock, Shaper, ShaperKind, Step, Steps};
use atraj::online::{Limits, Move, Phase};
use atraj::{Bell, Error, Extremes, Findings, Poly3, Poly5, Poly7, State, Trap, axes, claraty};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use support::repository::root;

/// A row of a table: what it names, and its name in C, C++, Rust and Python; empty without one.
struct Row([String; 5]);

fn rows() -> Vec<Row> {
    let page = fs::read_to_string(root().join("docs/names.md")).unwrap();
    let cells = |line: &str| -> Vec<String> {
        let cells = line.trim_matches('|').split('|');
        cells
            .map(|cell| cell.trim().trim_matches('`').to_owned())
            .collect()
    };
    let rows: Vec<_> = page
        .lines()
        .filter(|line| line.starts_with("| ") && !line.starts_with("| what |"))
        .map(|line| match &cells(line)[..] {
            [what, c, cpp, rust, python] => Row([what, c, cpp, rust, python].map(Clone::clone)),
            [what, c, rust, python] => {
                Row([what, c, &String::new(), rust, python].map(Clone::clone))
            }
            _ => panic!("not a row: {line}"),
        })
        .collect();
    assert!(rows.len() > 40, "{} rows", rows.len());
    rows
}

/// The names in one column.
fn column(k: usize) -> BTreeSet<String> {
    let names = rows().into_iter().map(|Row(cells)| cells[k].clone());
    names.filter(|name| !name.is_empty()).collect()
}

/// The text of the headers in a directory and below.
fn headers(directory: &Path) -> String {
    let entries = fs::read_dir(directory).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    paths
        .map(|path| match path.is_dir() {
            true => headers(&path),
            false => fs::read_to_string(path).unwrap(),
        })
        .collect()
}

/// Whether `text` has `word` with no letter, digit or `_` on either side.
fn has_word(text: &str, word: &str) -> bool {
    let inside = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
    text.match_indices(word).any(|(at, _)| {
        !inside(text[..at].chars().next_back()) && !inside(text[at + word.len()..].chars().next())
    })
}

/// What stands between the first `start` and the next `end`.
fn between<'a>(text: &'a str, start: &str, end: &str) -> &'a str {
    let (_, rest) = text.split_once(start).expect(start);
    rest.split_once(end).expect(end).0
}

fn last(name: &str) -> &str {
    name.rsplit([':', '.']).next().unwrap()
}

#[test]
fn c_has_the_names() {
    let symbols = fs::read_to_string(root().join("tests/symbols.txt")).unwrap();
    let headers = headers(&root().join("include"));
    for name in column(1) {
        // A type or a constant is no symbol.
        let declared = has_word(&headers, &format!("struct {name}"))
            || has_word(&headers, &format!("enum {name}"))
            || headers.contains(&format!("    {name} = "));
        let is_function = symbols.lines().any(|symbol| symbol == name);
        assert!(declared || is_function, "{name}");
    }
    // Every finding and error has a row.
    let codes = fs::read_to_string(root().join("include/atraj/codes.h")).unwrap();
    let codes = codes
        .lines()
        .filter_map(|line| line.trim().split_once(" = "));
    let codes: Vec<_> = codes.map(|(name, _)| name).collect();
    assert!(
        codes.len() == 16 && codes.iter().all(|&code| column(1).contains(code)),
        "{codes:?}"
    );
}

#[test]
fn cpp_has_the_names() {
    let headers = headers(&root().join("include"));
    for name in column(2) {
        let short = format!(
            "typedef struct {} {};",
            name.replace("::", "_"),
            last(&name)
        );
        let is_declared = |text: &str| {
            let call = format!("{}(", last(&name));
            [" ", "*"]
                .iter()
                .any(|before| text.contains(&format!("{before}{call}")))
        };
        let exists = match name.split("::").collect::<Vec<_>>()[..] {
            [_, _] if headers.contains(&short) => true,
            ["Trajectory", _] => is_declared(between(&headers, "class Trajectory\n", "\n};")),
            [space, _] => headers
                .match_indices(&format!("namespace {space}\n{{\n"))
                .any(|(at, start)| is_declared(between(&headers[at..], start, "\n} /* namespace"))),
            [space, object, _] => is_declared(between(
                &headers,
                &format!("struct {space}_{object} {{"),
                "\n};",
            )),
            _ => false,
        };
        assert!(exists, "{name}");
    }
}

/// Compiles each path and gives its text as the page writes it.
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
        types: Bell<f64>, Trap<f64>, Poly3<f64>, Poly5<f64>, Poly7<f64>, Move<f64>, Phase<f64>, Limits<f64>, State<f64>,
            Extremes<f64>, Axis<f64>, Step<f64>, Steps<f64>, Clock<f64>, Shaper<f64>, ShaperKind, Findings, Error, claraty::Trajectory, claraty::Warnings;
        values: Bell::<f64>::new, Bell::<f64>::fastest, Bell::<f64>::check, Bell::<f64>::extremes, Bell::<f64>::position,
            Bell::<f64>::velocity, Bell::<f64>::acceleration, Bell::<f64>::jerk, Bell::<f64>::state_at,
            Bell::<f64>::sample_into, Poly7::<f64>::extremes, Limits::<f64>::symmetric, Move::<f64>::plan, Move::<f64>::within, Move::<f64>::track, Move::<f64>::check,
            Move::<f64>::reach, Move::<f64>::stop, Move::<f64>::meet, Move::<f64>::time_at, Move::<f64>::phases,
            axes::synchronise::<f64>, axes::synchronise_within::<f64>, axes::line::<f64>, axes::path_size, axes::plan_path::<f64>, axes::improve_path::<f64>,
            Axis::<f64>::new, Axis::<f64>::tick, Axis::<f64>::go, Axis::<f64>::reach, Axis::<f64>::track, Axis::<f64>::stop,
            Steps::<f64>::new, Steps::<f64>::next, Steps::<f64>::follow, Shaper::<f64>::new,
            Shaper::<f64>::add, Shaper::<f64>::smooth, Shaper::<f64>::state, Shaper::<f64>::bell_state,
            axes::line_stop::<f64>, Clock::<f64>::new, Clock::<f64>::rate, Clock::<f64>::until, Clock::<f64>::time, Clock::<f64>::state,
            claraty::Trajectory::start, claraty::Trajectory::stop,
            claraty::Trajectory::reset, Findings::EXCEEDS_JERK, Findings::EXCEEDS_ACCELERATION,
            Findings::EXCEEDS_VELOCITY, Findings::JUMPS, Findings::OVERSHOOTS, Findings::STARTS_OUTSIDE, Findings::ENDS_LEAVING, Error::Axes,
            Error::NotFinite, Error::Limits, Error::Target, Error::Duration, Error::Line, Error::Position, Error::Late, Error::Unreachable,
    );
    let named = column(3)
        .into_iter()
        .map(|name| name.replace("online::", "").replace("machine::", ""));
    assert_eq!(
        named.collect::<BTreeSet<_>>(),
        compiled.into_iter().collect()
    );
}

/// The names that the type stubs of a module declare: classes, functions and the members of classes, inherited ones too.
fn declared(files: &[&str], module: &str) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for file in files {
        let text = fs::read_to_string(root().join("python/atraj").join(file)).unwrap();
        let mut class = String::new();
        let mut is_docstring = false;
        for line in text.lines() {
            let begins_or_ends = line.matches("\"\"\"").count() % 2 == 1;
            is_docstring ^= begins_or_ends;
            if is_docstring || begins_or_ends {
                continue;
            }
            let word = |line: &str| -> String {
                line.chars()
                    .take_while(|c| c.is_alphanumeric() || *c == '_')
                    .collect()
            };
            if let Some(rest) = line.strip_prefix("class ") {
                class = word(rest);
                let base = rest
                    .split_once('(')
                    .map_or(String::new(), |(_, base)| word(base));
                let inherited: Vec<_> = names
                    .iter()
                    .filter_map(|name: &String| name.strip_prefix(&format!("{module}{base}.")))
                    .map(|member| format!("{module}{class}.{member}"))
                    .collect();
                names.extend(inherited);
                names.insert(format!("{module}{class}"));
            } else if let Some(rest) = line.strip_prefix("def ") {
                names.insert(format!("{module}{}", word(rest)));
            } else if let Some(rest) = line.strip_prefix("    ") {
                let member = word(rest.strip_prefix("def ").unwrap_or(rest));
                names.insert(format!("{module}{class}.{member}"));
            }
        }
    }
    names
}

#[test]
fn python_has_the_names() {
    let mut names = declared(&["values.py", "__init__.pyi"], "");
    names.extend(declared(&["values.py", "claraty.pyi"], "claraty."));
    for name in column(4) {
        assert!(names.contains(&name), "{name}");
    }
}

#[test]
fn names_agree() {
    for Row([what, c, cpp, rust, python]) in rows() {
        if !cpp.is_empty() && last(&cpp) != "fastest" {
            assert!(c.ends_with(last(&cpp)), "{what}: {c}, {cpp}");
        }
        // The constructor has the name of the class.
        let rust = rust.strip_suffix("::new").unwrap_or(&rust);
        if !python.is_empty() && last(&python) != "sample" {
            assert_eq!(last(rust), last(&python), "{what}");
        }
        let code = c
            .strip_prefix("ATRAJ_")
            .map(|code| code.trim_start_matches("ERR_").replace('_', ""));
        if let Some(code) = code.filter(|_| c != "ATRAJ_ERR_NULL") {
            assert_eq!(code, last(rust).replace('_', "").to_uppercase(), "{what}");
        }
    }
}

#[test]
fn the_rule_for_infinite_limits_has_one_wording() {
    for file in [
        "src/limits.rs",
        "src/fastest/bell.rs",
        "src/capi/atraj/bell.rs",
        "src/capi/atraj/move.rs",
        "include/atraj.h",
        "include/atraj/move.h",
        "python/atraj/values.py",
        "python/src/classes/profiles.rs",
    ] {
        let text = fs::read_to_string(root().join(file)).unwrap();
        assert!(
            text.contains("A jerk, or both accelerations, are finite."),
            "{file}"
        );
    }
}
