//! `make mutants`: how many small faults of the library do its tests see? cargo-mutants lists the faults. It builds the library anew for each
//! one, which would take days. So this program plants many into one copy of the library, each behind a switch, and the tests run once for
//! each switch.
//!
//! - `mutants plant LIST TREE SEED OF_EACH UNVIABLE` plants a sample of the list into the files under `TREE/src`.
//! - `mutants refuse TREE MESSAGES UNVIABLE` adds the mutants that the compiler's messages name to the file of unviable ones.
//! - `mutants judge LIST SEED OF_EACH UNVIABLE CONSTANT PROGRAMS CLAIMS RESULTS` judges them, but for those that are in the results already.
//! - `mutants report RESULTS PAGE` prints the table, and each survivor with what the page says of it.

mod judge;
mod mutant;
mod plant;
mod report;

use mutant::{Mutant, Place, list, sample};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments[..] {
        ["plant", all, tree, seed, of_each, unviable] => {
            let drawn = drawn(all, seed, of_each);
            plant_all(Path::new(tree), drawn, &numbers(unviable));
        }
        ["refuse", tree, messages, unviable] => refuse(Path::new(tree), messages, unviable),
        [
            "judge",
            all,
            seed,
            of_each,
            unviable,
            constant,
            programs,
            claims,
            results,
        ] => {
            let left_out = [
                ("unviable", numbers(unviable)),
                ("constant", numbers(constant)),
            ];
            let drawn = drawn(all, seed, of_each);
            judge::all(
                &drawn,
                &left_out,
                Path::new(programs),
                Path::new(claims),
                Path::new(results),
            );
        }
        ["report", results, page] => report::print(&read(results), &read(page)),
        _ => panic!("plant, refuse, judge or report: the first lines of src/main.rs"),
    }
}

fn read(file: impl AsRef<Path>) -> String {
    fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.as_ref().display()))
}

fn drawn(all: &str, seed: &str, of_each: &str) -> Vec<Mutant> {
    let [seed, of_each] = [seed, of_each].map(|text| text.parse().expect("a number"));
    sample(list(&read(all)), seed, of_each as usize)
}

fn numbers(file: &str) -> BTreeSet<u32> {
    read(file)
        .lines()
        .map(|line| line.parse().expect("a number"))
        .collect()
}

fn plant_all(tree: &Path, drawn: Vec<Mutant>, unviable: &BTreeSet<u32>) {
    let mut files: BTreeMap<String, BTreeMap<Place, Vec<Mutant>>> = BTreeMap::new();
    for mutant in drawn
        .into_iter()
        .filter(|mutant| !unviable.contains(&mutant.number))
    {
        let places = files.entry(mutant.file.clone()).or_default();
        places.entry(mutant.place).or_default().push(mutant);
    }
    for (file, mutants) in &mut files {
        let path = tree.join(file);
        let planted = plant::plant(&read(&path), mutants);
        fs::write(path, planted).expect("a file to write to");
        // Constants cannot ask a switch.
        for mutant in mutants.values().flatten() {
            println!("{}", mutant.number);
        }
    }
    let root = tree.join("src/lib.rs");
    fs::write(&root, format!("{}\nmod mutant;\n", read(&root))).expect("a file to write to");
    fs::write(tree.join("src/mutant.rs"), include_str!("switch.rs")).expect("a file to write to");
}

/// An error stands in the branch of a mutant: the last switch before it.
fn refuse(tree: &Path, messages: &str, unviable: &str) {
    let mut refused = numbers(unviable);
    for line in read(messages).lines() {
        let Ok(message) = serde_json::from_str::<serde_json::Value>(line) else {
            continue;
        };
        let message = &message["message"];
        if message["level"] != "error" {
            continue;
        }
        let spans = message["spans"].as_array().map_or(&[][..], Vec::as_slice);
        for span in spans.iter().filter(|span| span["is_primary"] == true) {
            let file = tree.join(span["file_name"].as_str().expect("a file"));
            let end = span["byte_start"].as_u64().expect("a place") as usize;
            let before = read(file);
            let last = before
                .get(..end)
                .and_then(|text| text.rsplit_once("mutant :: is ("));
            if let Some((_, number)) = last {
                let digits = number.split(|c: char| !c.is_ascii_digit()).next();
                refused.insert(
                    digits
                        .and_then(|digits| digits.parse().ok())
                        .expect("a number"),
                );
            }
        }
    }
    let lines: String = refused.iter().map(|number| format!("{number}\n")).collect();
    fs::write(unviable, lines).expect("a file to write to");
}
