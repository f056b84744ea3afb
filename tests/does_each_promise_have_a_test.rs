//! Does each test file begin with its question, and does each promise in the page for safety engineers name tests that exist?

use std::collections::HashMap;
use std::fs;
use std::process::Command;
use support::repository::root;
use support::tools::lines;

/// The question of each test file, by the name of the file.
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

#[test]
fn each_promise_names_its_tests() {
    let questions = questions();
    let page = fs::read_to_string(root().join("docs/safety.md")).unwrap();
    let (_, table) = page.split_once("\n## Which test proves which promise\n").unwrap();
    let mut promises = 0;
    for row in table.lines().filter(|line| line.starts_with("| ")).skip(1) {
        let mut names = row.rsplit(" | ").next().unwrap().split('`').skip(1).step_by(2).peekable();
        assert!(names.peek().is_some(), "no test: {row}");
        assert!(names.all(|name| questions.contains_key(&format!("{name}.rs"))), "no such test: {row}");
        promises += 1;
    }
    assert!(promises > 10);
}
