//! The mutants that cargo-mutants lists.

use serde_json::Value;
use std::collections::BTreeMap;

/// Line and column, both from 1.
pub type Place = (usize, usize);

/// A small change of the library.
#[derive(Clone)]
pub struct Mutant {
    /// Its number in the list of all, from 1.
    pub number: u32,
    /// The file under `src`.
    pub file: String,
    /// Where the changed text begins.
    pub place: Place,
    /// What kind of change it is, in the words of cargo-mutants.
    pub genre: String,
    /// The new text.
    pub replacement: String,
    /// The function that it changes.
    pub function: String,
}

impl Mutant {
    /// Its name, which stays the same as long as the file does.
    pub fn name(&self) -> String {
        let Self {
            file,
            place: (line, column),
            genre,
            replacement,
            function,
            ..
        } = self;
        format!("{file}:{line}:{column} {genre} {function} -> {replacement}")
    }

    /// The part of the library whose tests can see it.
    pub fn storey(&self) -> &'static str {
        let is_in = |folder: &&str| self.file.starts_with(&format!("src/{folder}/"));
        [
            "real",
            "liba",
            "claraty",
            "fastest",
            "online",
            "together/path",
            "together",
            "machine",
            "capi",
        ]
        .into_iter()
        .find(is_in)
        .unwrap_or("shared")
    }
}

/// All mutants, from what `cargo mutants --list --json` prints.
pub fn list(json: &str) -> Vec<Mutant> {
    let list: Vec<Value> = serde_json::from_str(json).expect("a list of cargo-mutants");
    let text = |value: &Value| value.as_str().unwrap_or("").to_owned();
    let mutants = list.iter().zip(1..).map(|(value, number)| {
        let start = &value["span"]["start"];
        let part = |name: &str| start[name].as_u64().expect("a place") as usize;
        Mutant {
            number,
            file: text(&value["file"]),
            place: (part("line"), part("column")),
            genre: text(&value["genre"]),
            replacement: text(&value["replacement"]),
            function: text(&value["function"]["function_name"]),
        }
    });
    mutants.collect()
}

/// Some mutants of each storey, at most so many, in an order that the seed draws. They take turns, so a run that is stopped has judged about
/// as many of each.
pub fn sample(mutants: Vec<Mutant>, seed: u64, of_each: usize) -> Vec<Mutant> {
    let mut storeys: BTreeMap<&str, Vec<([u64; 2], Mutant)>> = BTreeMap::new();
    for mutant in mutants {
        let key = [hash(seed, &mutant.name()), u64::from(mutant.number)];
        storeys
            .entry(mutant.storey())
            .or_default()
            .push((key, mutant));
    }
    let mut turns: Vec<(usize, Mutant)> = Vec::new();
    for drawn in storeys.values_mut() {
        drawn.sort_by_key(|(key, _)| *key);
        turns.extend(
            drawn
                .drain(..)
                .take(of_each)
                .map(|(_, mutant)| mutant)
                .enumerate(),
        );
    }
    turns.sort_by_key(|(turn, _)| *turn);
    turns.into_iter().map(|(_, mutant)| mutant).collect()
}

/// FNV-1a, with the rounds of splitmix64 behind it, so near names have far values.
fn hash(seed: u64, name: &str) -> u64 {
    let start = seed ^ 0xcbf2_9ce4_8422_2325;
    let mixed = name.bytes().fold(start, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
    });
    let mixed = (mixed ^ mixed >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    mixed ^ mixed >> 31
}
