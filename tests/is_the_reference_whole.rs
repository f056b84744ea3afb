//! Does `make doc` write one first page that leads to both references, and does the C reference tell what to include?

use std::fs;
use std::path::Path;
use std::process::Command;
use support::repository::root;
use support::tools::{has_tool, run};

#[test]
fn the_first_page_leads_to_both() {
    if !has_tool("doxygen") {
        return;
    }
    run(Command::new("make")
        .current_dir(root())
        .env_remove("MAKEFLAGS")
        .args(["-s", "doc"]));
    let doc = root().join("target/doc");
    let links: Vec<_> = read(&doc.join("index.html"))
        .split("href=\"")
        .skip(1)
        .map(|rest| rest.split('"').next().unwrap().to_owned())
        .collect();
    assert_eq!(links, ["c/html/index.html", "atraj/index.html"]);
    for link in links {
        assert!(doc.join(&link).is_file(), "{link}");
    }

    let c = doc.join("c/html");
    let first = read(&c.join("index.html"));
    assert!(first.contains("#include \"a/trajbell.h\"") && first.contains("a_trajbell_gen"));
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
