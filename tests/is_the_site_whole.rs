//! Does `make doc` write one site: a page for each document and each example, all in the table of contents, both references, the
//! playground, and no dead link?

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;
use support::repository::root;
use support::tools::{has_tool, run};

/// Where `make doc` writes the site. It runs once for all tests of this file; without Doxygen and npm there is no site.
static SITE: LazyLock<Option<PathBuf>> = LazyLock::new(|| {
    (has_tool("doxygen") && has_tool("npm")).then(|| {
        run(Command::new("make")
            .current_dir(root())
            .env_remove("MAKEFLAGS")
            .args(["-s", "doc"]));
        root().join("target/site")
    })
});

/// The guide's pages: one for README.md, for each document in docs, and for each example.
fn pages(site: &Path) -> Vec<PathBuf> {
    let names = |folder: &str, extension: &str| -> Vec<PathBuf> {
        let entries = fs::read_dir(root().join(folder)).unwrap();
        let paths = entries.map(|entry| Path::new(folder).join(entry.unwrap().file_name()));
        paths
            .filter(|path| path.extension().is_some_and(|e| e == extension))
            .collect()
    };
    let mut documents = names("docs", "md");
    documents.extend(names("examples", "c"));
    documents.extend(["README.md", "examples/README.md", "tests/README.md"].map(PathBuf::from));
    let pages = documents
        .iter()
        .map(|path| site.join(path).with_extension("html"));
    pages.collect()
}

/// What a page refers to, but for other sites.
fn links(page: &Path) -> Vec<String> {
    let text = read(page);
    let links = ["href=\"", "src=\""].map(|before| {
        let parts = text.split(before).skip(1);
        parts.map(|part| part.split('"').next().unwrap().to_owned())
    });
    let links = links.into_iter().flatten();
    links.filter(|link| !link.contains("://")).collect()
}

#[test]
fn every_page_is_in_the_table_of_contents() {
    let Some(site) = &*SITE else { return };
    let listed = links(&site.join("toc.html"));
    for page in pages(site) {
        assert!(page.is_file(), "{}", page.display());
        let name = page.strip_prefix(site).unwrap().to_str().unwrap();
        assert!(listed.iter().any(|link| link == name), "{name}");
    }
    let references = links(&site.join("docs/site/references.html"));
    for name in ["c/index.html", "rust/atraj/index.html", "playground.html"] {
        let link = format!("../../{name}");
        assert!(references.contains(&link), "{name}");
    }
}

#[test]
fn no_link_is_dead() {
    let Some(site) = &*SITE else { return };
    let mut followed = 0;
    for page in pages(site) {
        for link in links(&page) {
            let (file, place) = link.split_once('#').unwrap_or((&link, ""));
            let target = if file.is_empty() {
                page.clone()
            } else {
                page.parent().unwrap().join(file)
            };
            let leads = target.is_file()
                && (place.is_empty() || read(&target).contains(&format!("id=\"{place}\"")));
            assert!(leads, "{} leads to {link}", page.display());
            followed += 1;
        }
    }
    assert!(followed > 100, "{followed}");
}

#[test]
fn the_c_reference_tells_what_to_include() {
    let Some(site) = &*SITE else { return };
    let c = site.join("c");
    let first = read(&c.join("index.html"));
    assert!(first.contains("#include \"a/trajbell.h\"") && first.contains("a_trajbell_gen"));
    let function = without_tags(&read(&c.join("trajbell_8h.html")));
    assert!(function.contains("a_trajbell_gen") && !function.contains("A_EXTERN"));
    assert!(
        first.contains("href=\"../index.html\""),
        "no way back to the guide"
    );
    for (page, include) in [
        ("structa__trajbell.html", "a/trajbell.h"),
        ("structclaraty__trapezoid.html", "claraty/trapezoid.h"),
        (
            "classclaraty_1_1Trapezoidal__Trajectory.html",
            "claraty/trapezoidal_trajectory.h",
        ),
    ] {
        let text = without_tags(&read(&c.join(page)));
        assert!(
            text.contains(&format!("#include &lt;{include}&gt;")),
            "{page}"
        );
    }
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn without_tags(html: &str) -> String {
    html.split('<')
        .filter_map(|part| part.split_once('>'))
        .map(|(_, text)| text)
        .collect()
}
