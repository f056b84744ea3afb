//! Compilers and other programs that a test runs.

use crate::repository::root;
use std::path::Path;
use std::process::{Command, Output};

#[derive(Clone, Copy)]
pub enum Language {
    C,
    Cpp,
}

pub fn compilers(language: Language) -> Vec<&'static str> {
    let known = match language {
        Language::C => ["gcc", "clang"],
        Language::Cpp => ["g++", "clang++"],
    };
    known.into_iter().filter(|compiler| has_tool(compiler)).collect()
}

/// Whether `tool` can be run. A missing tool is printed. In CI it is a failure.
pub fn has_tool(tool: &str) -> bool {
    let found = Command::new(tool).arg("--version").output().is_ok();
    if !found {
        assert!(std::env::var_os("CI").is_none(), "{tool} is missing");
        println!("SKIPPED: {tool} is missing, what needs it is not tested");
    }
    found
}

pub fn run(command: &mut Command) -> Output {
    let output = command.output().unwrap_or_else(|e| panic!("{command:?}: {e}"));
    assert!(output.status.success(), "{command:?}: {}\n{}", output.status, printed(&output));
    output
}

/// What a program printed, and its complaints behind it.
pub fn printed(output: &Output) -> String {
    [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text)).concat()
}

/// Asks `make identify` which library is in a program.
pub fn identify(program: &Path) -> Output {
    let file = format!("FILE={}", program.display());
    Command::new("make").current_dir(root()).args(["-s", "identify", &file]).output().unwrap()
}

pub fn lines(command: &mut Command) -> Vec<String> {
    String::from_utf8(run(command).stdout).unwrap().lines().map(str::to_owned).collect()
}

pub fn abidiff(old: &Path, new: &Path) -> (String, bool) {
    let output = Command::new("abidiff").arg("--no-added-syms").args([old, new]).output().unwrap();
    let code = output.status.code().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(code & 0b11, 0, "abidiff fails: {text}");
    (text, code != 0)
}
