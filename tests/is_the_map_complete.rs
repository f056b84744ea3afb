//! Does the map in `tests/README.md` name each test file, and does each file that it names exist? Does the page for safety engineers name
//! tests on the map alone?

use std::collections::BTreeSet;
use std::fs;
use support::repository::root;

/// The folders of the map: a heading `## In `folder`` names one. A row of its table begins with a file.
fn on_the_map() -> Vec<(String, BTreeSet<String>)> {
    let map = fs::read_to_string(root().join("tests/README.md")).unwrap();
    let parts = map.split("\n## In `").skip(1);
    parts
        .map(|part| {
            let (folder, table) = part.split_once('`').unwrap();
            let rows = table.lines().filter_map(|line| line.strip_prefix("| `"));
            let files = rows.map(|row| row.split('`').next().unwrap().to_owned());
            (folder.to_owned(), files.collect())
        })
        .collect()
}

/// The files of a folder that are written in one of the languages of the tests.
fn there(folder: &str) -> BTreeSet<String> {
    let entries = fs::read_dir(root().join(folder)).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    names
        .filter(|name| {
            let language = name.rsplit('.').next().unwrap();
            ["rs", "c", "cpp", "sh", "py", "js"].contains(&language)
        })
        .collect()
}

#[test]
fn each_test_file_is_on_the_map() {
    let map = on_the_map();
    let folders: Vec<_> = map.iter().map(|(folder, _)| folder.as_str()).collect();
    assert_eq!(
        folders,
        [
            "tests",
            "tests/oracle/tests",
            "tests/handover/tests",
            "tests/miri/tests",
            "c_tests",
            "fuzz/fuzz_targets",
            "python/tests",
            "playground/tests",
        ]
    );
    for (folder, files) in &map {
        let there = there(folder);
        let missing: Vec<_> = there.difference(files).collect();
        assert!(missing.is_empty(), "{folder}: not on the map: {missing:?}");
        let gone: Vec<_> = files.difference(&there).collect();
        assert!(gone.is_empty(), "{folder}: on the map only: {gone:?}");
    }
}

#[test]
fn each_promise_has_a_test() {
    let page = fs::read_to_string(root().join("docs/safety.md")).unwrap();
    let (_, table) = page
        .split_once("\n## Which test proves which promise\n")
        .unwrap();
    let map = on_the_map();
    let mut promises = 0;
    for row in table.lines().filter(|line| line.starts_with("| ")).skip(1) {
        let tests = row.rsplit(" | ").next().unwrap();
        let mut names = tests.split('`').skip(1).step_by(2).peekable();
        assert!(names.peek().is_some(), "no test: {row}");
        for name in names {
            let file = format!("{name}.rs");
            let is_known = map.iter().any(|(_, files)| files.contains(&file));
            assert!(is_known, "no such test: {row}");
        }
        promises += 1;
    }
    assert!(promises > 10);
}
