//! Does each test file begin with its question, and has each promise to safety engineers a test, and a fault that the test has seen?

use std::collections::HashMap;
use std::process::Command;
use support::{lines, read, root};

fn questions() -> HashMap<String, String> {
    let map = lines(Command::new("sh").arg(root().join("tests/map.sh")));
    let rows = map.iter().filter_map(|line| line.strip_prefix("| `")?.strip_suffix(" |")?.split_once("` | "));
    rows.map(|(file, question)| (file.to_owned(), question.to_owned())).collect()
}

#[test]
fn each_file_begins_with_its_question() {
    let questions = questions();
    assert!(questions.len() > 80);
    for (file, question) in questions {
        let is_named_by_it = file.ends_with(".rs") && file.contains('_');
        assert!(question.len() > 20 && (!is_named_by_it || question.ends_with('?')), "{file}: {question}");
    }
}

/// The code of a fault stands exactly once in its file, so `tests/audit.sh` can plant it.
#[test]
fn each_promise_has_a_test_and_a_fault() {
    let questions = questions();
    let table = read("docs/data/audit.csv");
    let (mut promises, mut tried) = (0, 0);
    for row in table.lines().skip(1) {
        let [promise, test, file, code, fault, seen] = row.split(',').collect::<Vec<_>>()[..] else {
            panic!("not six cells: {row}");
        };
        assert!(questions.contains_key(&format!("{test}.rs")) || root().join(test).is_file(), "no such test: {row}");
        assert_eq!(read(file).matches(code).count(), 1, "{code} in {file}");
        assert!(promise.len() > 10 && code != fault, "{row}");
        // An empty cell: the fault was not planted since it changed.
        let is_date = seen.len() == "2026-11-25".len() && seen.starts_with("20");
        assert!(seen.is_empty() || is_date, "no date: {row}");
        tried += usize::from(is_date);
        promises += 1;
    }
    assert!(promises > 25 && 2 * tried > promises, "{tried} of {promises} faults were tried");
}
