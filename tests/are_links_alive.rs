//! Does every link in the documents lead somewhere, in the repository and in the packaged crate?

use std::collections::HashSet;
use std::path::{Component, Path, PathBuf};
use std::process::Command;
use support::{lines, names, read, root};

/// A link of a document that is no address: the file it names and the heading in it.
struct Link {
    document: PathBuf,
    file: PathBuf,
    heading: String,
}

fn documents() -> Vec<PathBuf> {
    let paths =
        ["", "docs"].into_iter().flat_map(|folder| names(folder).into_iter().map(|name| Path::new(folder).join(name)));
    let documents: Vec<_> = paths.filter(|path| path.extension().is_some_and(|e| e == "md")).collect();
    assert!(documents.len() > 5);
    documents
}

/// A document without its blocks of code.
fn prose(document: &Path) -> String {
    read(document).split("```").step_by(2).collect()
}

fn links(document: &Path) -> Vec<Link> {
    let prose = prose(document);
    let targets = prose.split("](").skip(1).map(|rest| rest.split(')').next().unwrap());
    let of_files = targets.filter(|target| !target.contains("://") && !target.starts_with("mailto:"));
    let link = |target: &str| {
        let (file, heading) = target.split_once('#').unwrap_or((target, ""));
        let file = if file.is_empty() { document.to_owned() } else { plain(&document.parent().unwrap().join(file)) };
        Link { document: document.to_owned(), file, heading: heading.to_owned() }
    };
    of_files.map(link).collect()
}

fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for component in path.components() {
        match component {
            Component::ParentDir => assert!(plain.pop(), "{} leaves the repository", path.display()),
            other => plain.push(other),
        }
    }
    plain
}

/// The names under which a page can be entered: its headings in small letters, without punctuation, with hyphens.
fn headings(file: &Path) -> HashSet<String> {
    let prose = prose(file);
    let name = |line: &str| {
        let title = line.trim_start_matches('#').trim().to_lowercase();
        let letters = title.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
        letters.map(|c| if c == ' ' { '-' } else { c }).collect()
    };
    prose.lines().filter(|line| line.starts_with('#')).map(name).collect()
}

#[test]
fn in_the_repository() {
    let mut checked = 0;
    for link in documents().iter().flat_map(|document| links(document)) {
        let (document, file) = (link.document.display(), link.file.display());
        assert!(root().join(&link.file).exists(), "{document}: no {file}");
        let heading = &link.heading;
        let is_there = heading.is_empty() || headings(&link.file).contains(heading);
        assert!(is_there, "{document}: no heading {heading} in {file}");
        checked += 1;
    }
    assert!(checked > 5);
}

/// The site draws a table where a line is nothing but a link to it.
#[test]
fn each_table_is_drawn() {
    let pages: String = documents().iter().map(read).collect();
    let tables = names("docs/data");
    for table in &tables {
        let end = format!("](data/{table})");
        assert!(pages.lines().any(|line| line.starts_with('[') && line.ends_with(&end)), "no page draws {end}");
    }
    assert!(tables.len() > 10);
}

#[test]
fn in_the_package() {
    let list = lines(Command::new(env!("CARGO")).args(["package", "--list", "--allow-dirty"]).current_dir(root()));
    let packaged: HashSet<_> = list.iter().map(PathBuf::from).collect();
    let readme = Path::new("README.md");
    assert!(packaged.contains(readme) && !links(readme).is_empty());
    for document in documents().iter().filter(|path| packaged.contains(*path)) {
        for link in links(document) {
            let (page, file) = (document.display(), link.file.display());
            assert!(packaged.contains(&link.file), "{page}: {file} is not in the package");
        }
    }
}
