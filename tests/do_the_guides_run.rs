//! Do the programs and the commands of the pages for firmware, C++, CI and Rust run as they are written?

use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;
use support::{blocks, has_tool, read, root, run};

/// One after the other, because `make dist` replaces the directory that the next page uses.
#[test]
fn each() {
    for (reader, needed, printed) in [
        ("firmware", "arm-none-eabi-gcc", "thumbv7em-none-eabihf"),
        ("cpp", "c++", "at rest at "),
        ("ci", "cc", concat!("atraj ", env!("CARGO_PKG_VERSION"))),
        ("rust", "cargo", "-2.0000 m after "),
    ] {
        if has_tool(needed) {
            let said = followed(reader);
            assert!(said.contains(printed), "{reader}: {said}");
        }
    }
}

/// Does what the page for `reader` says, in an empty directory next to the repository; what the commands print.
fn followed(reader: &str) -> String {
    let page = read(format!("docs/for-{reader}.md"));
    assert!(page.lines().count() <= 90, "{reader}: the page is long");
    // Outside the repository, because a package in it would belong to its workspace.
    let directory = std::env::temp_dir().join(format!("atraj-for-{reader}-{}", std::process::id()));
    fs::create_dir(&directory).unwrap();
    symlink(root(), directory.join("atraj")).unwrap();
    let mut written = 0;
    for language in ["c", "cpp", "rust", "toml"] {
        for code in blocks(&page, language) {
            write(&directory, &code);
            written += 1;
        }
    }
    let commands = blocks(&page, "sh");
    assert!(written > 0 && commands.len() == 1, "{reader}");
    let jobs = blocks(&page, "yaml");
    let script = if jobs.is_empty() {
        commands[0].clone()
    } else {
        write(&directory, &commands[0]);
        jobs.iter().flat_map(|job| steps(job)).collect()
    };
    let mut shell = Command::new("sh");
    shell.args(["-euc", &script]).current_dir(&directory);
    // The repository's dependencies are there, and a test needs no network for others.
    shell.env_remove("MAKEFLAGS").env("CARGO_NET_OFFLINE", "true");
    let said = String::from_utf8(run(&mut shell).stdout).unwrap();
    fs::remove_dir_all(directory).unwrap();
    said
}

fn steps(job: &str) -> Vec<String> {
    let command = |line: &str| {
        let step = line.trim_start().strip_prefix("- ")?;
        let command = step.strip_prefix("run: ").unwrap_or(step);
        command.starts_with("sh ").then(|| format!("{command}\n"))
    };
    let commands: Vec<_> = job.lines().filter_map(command).collect();
    assert!(!commands.is_empty(), "{job}");
    commands
}

/// CONTRIBUTING.md names a file and an expression in it, whose change a test must see.
#[test]
fn the_first_change_can_be_made() {
    let page = read("CONTRIBUTING.md");
    let (file, expression) = ("src/liba/bell/motion.rs", "j * z * z * z / R::from(6)");
    assert!(page.contains(file) && page.contains(expression));
    assert!(read(file).contains(expression), "{file}: no {expression}");
}

fn write(directory: &Path, code: &str) {
    let file = directory.join(code.lines().next().unwrap().trim_matches([' ', '/', '*', '#']));
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    fs::write(file, code).unwrap();
}
