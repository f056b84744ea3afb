//! Does every file of `src` import from its own layer and from those below it only, and do no files import each other in a circle?
//!
//! An import is a `use`, or a path in a body. It does not count if it is for tests only, or if a module re-exports its own parts.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use support::root;

/// The layers from the ground, and the modules of each. `|` parts layers at the same height.
const HOUSE: &str = "real < state limits findings roots sampling table < liba | claraty < fastest < interval < online < several < path < machine < capi < lib";

/// How high a module stands, and which of the layers at this height is its own.
fn layer(module: &[String]) -> Option<(usize, usize)> {
    let top = module.first().map_or("lib", String::as_str);
    let has_top = |layer: &str| layer.split_whitespace().any(|name| name == top);
    let mut heights = HOUSE.split('<').enumerate();
    heights.find_map(|(height, layers)| Some((height, layers.split('|').position(has_top)?)))
}

type Module = Vec<String>; // The names that lead to a module. The crate itself has none.

fn module_of(path: &str) -> Module {
    // Two files with one face are one module.
    let path = &path.replace("/host.rs", "/target.rs").replace("/bare_metal.rs", "/target.rs");
    let names = path.trim_end_matches(".rs").trim_end_matches("/mod").split('/');
    names.filter(|name| *name != "lib").map(str::to_owned).collect()
}

struct Import {
    names: Vec<String>,
    known_as: Option<String>, // the name that a `use` gives it; `None` in a body
    is_public: bool,
}

/// The words and marks of a file. Comments, literals and items for tests are left out.
fn flat(stream: TokenStream, words: &mut Vec<String>) {
    let mut trees = stream.into_iter();
    while let Some(tree) = trees.next() {
        match tree {
            TokenTree::Group(group) => {
                let is_block = group.delimiter() == Delimiter::Brace;
                let [open, close] = if is_block { ["{", "}"] } else { ["(", ")"] };
                let is_for_tests = group.stream().to_string() == "cfg (test)";
                if is_for_tests && words.last().is_some_and(|last| last == "#") {
                    trees.find(|tree| match tree {
                        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
                        tree => tree.to_string() == ";",
                    });
                    continue;
                }
                words.push(open.into());
                flat(group.stream(), words);
                words.push(close.into());
            }
            TokenTree::Punct(mark) if mark.as_char() == ':' && mark.spacing() == Spacing::Joint => {
                trees.next();
                words.push("::".into());
            }
            TokenTree::Literal(_) => words.push("0".into()),
            tree => words.push(tree.to_string()),
        }
    }
}

fn imports(text: &str) -> Vec<Import> {
    let mut words = Vec::new();
    flat(text.parse().expect("Rust"), &mut words);
    let word = |at: usize| words.get(at).map_or("", String::as_str);
    let until = |at: usize, end: &str| words[at..].iter().take_while(|word| *word != end).count();
    let mut imports = Vec::new();
    let (mut at, mut is_public) = (0, false);
    while at < words.len() {
        let first = at;
        match word(at) {
            "mod" if word(at + 2) == "{" => {
                let body = &words[at..at + until(at, "}")];
                assert!(!body.iter().any(|word| word == "super"), "mod {} reads super: write crate", word(at + 1));
            }
            "pub" if word(at + 1) == "(" => at += until(at, ")"),
            "use" if word(at + 1) != "<" => {
                at += until(at, ";");
                let mut tree = words[first + 1..at].iter().map(String::as_str);
                read_use(&mut tree, &[], is_public, &mut imports);
            }
            _ => {
                while word(at + 1) == "::" && word(at + 2) != "<" {
                    at += 2;
                }
                let names: Vec<_> = words[first..=at].iter().step_by(2).cloned().collect();
                imports.extend((at > first).then_some(Import { names, known_as: None, is_public: false }));
            }
        }
        is_public = word(first) == "pub";
        at += 1;
    }
    imports
}

fn read_use<'a>(
    words: &mut impl Iterator<Item = &'a str>, outer: &[String], is_public: bool, imports: &mut Vec<Import>,
) {
    let mut names = outer.to_vec();
    let mut alias = None;
    loop {
        match words.next() {
            Some("::") => {}
            Some("{") => {
                read_use(words, &names, is_public, imports);
                names = outer.to_vec();
            }
            Some("as") => alias = words.next().map(str::to_owned),
            end @ (Some("," | "}") | None) => {
                if names.len() > outer.len() {
                    names.truncate(names.len() - usize::from(names.ends_with(&["self".into()])));
                    let known_as = alias.take().or(names.last().cloned());
                    imports.push(Import { names, known_as, is_public });
                }
                names = outer.to_vec();
                if end != Some(",") {
                    return;
                }
            }
            Some(name) => names.push(name.to_owned()),
        }
    }
}

struct Files<'a>(BTreeMap<Module, (&'a str, Vec<Import>)>);

impl<'a> Files<'a> {
    /// The file of the crate is not read, as it may import everything.
    fn new(sources: impl IntoIterator<Item = (&'a str, &'a str)>) -> Self {
        let files = sources.into_iter().map(|(path, text)| {
            let module = module_of(path);
            let imports = if module.is_empty() { Vec::new() } else { imports(text) };
            (module, (path, imports))
        });
        Self(files.collect())
    }

    fn child(&self, module: &[String], name: &str) -> Option<Module> {
        let child = [module, &[name.to_owned()]].concat();
        self.0.contains_key(&child).then_some(child)
    }

    fn brought(&self, module: &[String], name: &str) -> Option<&Import> {
        let mut imports = self.0[module].1.iter();
        let brings = |import: &&Import| import.known_as.as_deref() == Some(name);
        imports.find(|import| brings(import) && import.names[0] != name)
    }

    /// The module that defines what these names mean in `module`; `None` if it is none of ours.
    fn definer(&self, module: &[String], names: &[String]) -> Option<Module> {
        let (first, rest) = names.split_first()?;
        match first.as_str() {
            "crate" => Some(self.within(&[], rest)),
            "self" => Some(self.within(module, rest)),
            "super" => Some(self.within(module.split_last()?.1, rest)),
            _ => match self.child(module, first) {
                Some(child) => Some(self.within(&child, rest)),
                None => self.definer(module, &[&self.brought(module, first)?.names, rest].concat()),
            },
        }
    }

    /// The module that defines what these names mean inside `module`. It follows all re-exports but the crate's.
    fn within(&self, module: &[String], names: &[String]) -> Module {
        let Some((first, rest)) = names.split_first() else { return module.to_vec() };
        if let (Some((_, outer)), "super") = (module.split_last(), first.as_str()) {
            return self.within(outer, rest);
        }
        if let Some(child) = self.child(module, first) {
            return self.within(&child, rest);
        }
        let brought = self.brought(module, first);
        let elsewhere = brought.and_then(|import| self.definer(module, &[&import.names, rest].concat()));
        elsewhere.unwrap_or(module.to_vec())
    }

    fn imported(&self) -> BTreeMap<&Module, BTreeSet<Module>> {
        let imported = self.0.iter().map(|(module, (_, imports))| {
            let definers = imports.iter().filter_map(|import| {
                let definer = self.definer(module, &import.names)?;
                let is_reexport = import.is_public && definer.starts_with(module);
                (!is_reexport && definer != *module).then_some(definer)
            });
            (module, definers.collect())
        });
        imported.collect()
    }

    fn faults(&self) -> BTreeSet<String> {
        let imported = self.imported();
        let path = |module: &Module| self.0[module].0;
        let homeless = self.0.keys().filter(|module| layer(module).is_none());
        let mut faults: BTreeSet<_> = homeless.map(|module| format!("{} belongs to no layer.", path(module))).collect();
        let imports = imported.iter().flat_map(|(from, all)| all.iter().map(|to| (*from, to)));
        for (from, to) in imports {
            let layers = layer(from).zip(layer(to));
            let fault = layers.and_then(|((own, side), (other, other_side))| match other.cmp(&own) {
                Ordering::Greater => Some("an upper layer"),
                Ordering::Equal if side != other_side => Some("another layer at its height"),
                _ => None,
            });
            faults.extend(fault.map(|fault| format!("{} imports {}, which is in {fault}.", path(from), path(to))));
        }
        for module in imported.keys() {
            let leads_back = |other: &&Module| reached(&imported, other).contains(module);
            let circle: Vec<_> = reached(&imported, module).into_iter().filter(leads_back).map(path).collect();
            if !circle.is_empty() {
                faults.insert(format!("{} import each other.", circle.join(" and ")));
            }
        }
        faults
    }
}

/// All that a module imports, itself or by others.
fn reached<'a>(imported: &'a BTreeMap<&Module, BTreeSet<Module>>, from: &'a Module) -> BTreeSet<&'a Module> {
    let (mut seen, mut left) = (BTreeSet::new(), vec![from]);
    while let Some(module) = left.pop() {
        left.extend(imported.get(module).into_iter().flatten().filter(|next| seen.insert(*next)));
    }
    seen
}

fn sources(directory: &Path, sources: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(directory).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            self::sources(&path, sources);
        } else if path.extension().is_some_and(|e| e == "rs") {
            let name = path.strip_prefix(root().join("src")).unwrap().to_str().unwrap().to_owned();
            sources.push((name, fs::read_to_string(&path).unwrap()));
        }
    }
}

#[test]
fn in_the_source() {
    let mut read = Vec::new();
    sources(&root().join("src"), &mut read);
    let files = Files::new(read.iter().map(|(path, text)| (path.as_str(), text.as_str())));
    let count: usize = files.imported().values().map(BTreeSet::len).sum();
    assert!(files.0.len() > 30 && count > 60, "{count} imports");
    let faults = Vec::from_iter(files.faults());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// First small files in order. Then a file in place of one of them, and what is wrong with it: a `use`, also in braces or under another name, a path
/// in a body or in a macro. A thing is where it is defined, not where it is re-exported. What the crate re-exports is for users. A module may
/// re-export its parts, but it may not use a part that uses it.
const PLANTED: &str = include_str!("planted_imports.txt");

#[test]
fn planted_imports_are_seen() {
    let file = |line: &'static str| line.split_once(": ");
    let (good, faulty) = PLANTED.split_once("\n\n").expect("two parts");
    for line in faulty.lines() {
        let (planted, sentence) = line.rsplit_once(" =>").expect("a fault");
        let faults = Vec::from_iter(Files::new(good.lines().chain([planted]).filter_map(file)).faults());
        assert_eq!(faults.join(" "), sentence.trim(), "{planted}");
    }
}
