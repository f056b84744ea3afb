//! Does the repository say things in the words of the field? Each of these words once stood for a term that has a name.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use support::{read, root};

#[rustfmt::skip]
const WORDS: [(&str, &str); 17] = [
    ("anew", "again"), ("to and fro", "back and forth"), ("nasty", "adversarial"), ("referee", "reference solver"),
    ("storey|storeys", "layer"), ("undone", "at zero acceleration"), ("calm", "shaped"), ("mend|mends", "fix"),
    ("comes inside", "returns within the limits"), ("bound to leave", "will unavoidably exceed"), ("beside", "next to"),
    ("is no number", "is NaN or infinite"), ("way point|way points", "waypoint"), ("wall|walls", "position limit"),
    ("gets farthest", "covers the largest displacement"), ("slip|slips", "time shift"),
    ("so many is printed", "print every EVERY-th"),
];

/// Not written where a user reads: the tests have variables of this name.
const WORD_OF_TESTS: (&str, &str) = ("roundings", "ulps, or the rounding error");
const FOR_USERS: [&str; 5] = ["docs", "include", "src", "examples", "python"];
const FOR_DEVELOPERS: [&str; 4] = ["tests", "c_tests", "fuzz", "packaging"];
const EXTENSIONS: [&str; 10] = ["md", "rs", "c", "h", "cpp", "py", "pyi", "sh", "toml", "txt"];
const THIS: &str = "is_the_text_plain.rs";

fn texts(directory: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(directory).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().and_then(OsStr::to_str).unwrap();
        if path.is_dir() {
            if !["target", "corpus", "golden", ".venv"].contains(&name) {
                texts(&path, found);
            }
        } else if path.extension().and_then(OsStr::to_str).is_some_and(|e| EXTENSIONS.contains(&e)) && name != THIS {
            found.push(path);
        }
    }
}

fn faults(text: &str, words: &[(&str, &str)]) -> Vec<String> {
    let mut found = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let is_of_a_word = |letter: char| letter.is_alphanumeric() || letter == '_';
        // The warnings of a C compiler are no words.
        let apart = line.to_lowercase().replace("-wall", "").replace(|letter| !is_of_a_word(letter), " ");
        let stands_alone = |word: &str| format!(" {apart} ").contains(&format!(" {word} "));
        let bad = words.iter().filter(|(forms, _)| forms.split('|').any(stands_alone));
        found.extend(bad.map(|(forms, plain)| format!("{}: {forms}, say {plain}", index + 1)));
    }
    found
}

#[test]
fn every_text_is() {
    let every: Vec<_> = WORDS.iter().copied().chain([WORD_OF_TESTS]).collect();
    let mut wrong = Vec::new();
    for (directories, words) in [(&FOR_USERS[..], &every[..]), (&FOR_DEVELOPERS[..], &WORDS[..])] {
        let mut paths = Vec::new();
        directories.iter().for_each(|directory| texts(&root().join(directory), &mut paths));
        assert!(paths.len() > 50, "{directories:?}");
        for path in paths {
            wrong.extend(faults(&read(&path), words).into_iter().map(|fault| format!("{}:{fault}", path.display())));
        }
    }
    for page in ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md"] {
        wrong.extend(faults(&read(page), &every).into_iter().map(|fault| format!("{page}:{fault}")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn faults_are_seen() {
    assert_eq!(faults("Walls\nIt begins Anew.", &WORDS), ["1: wall|walls, say position limit", "2: anew, say again"]);
    assert_eq!(faults("A renewed v_undone, amend with -Wall.", &WORDS), [""; 0]);
}
