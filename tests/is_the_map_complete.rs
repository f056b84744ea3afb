//! Does the map in `tests/README.md` name each test file, and does each file that it names exist?

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
