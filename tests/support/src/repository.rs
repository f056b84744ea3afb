//! Where the repository is.

use std::path::Path;

pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .ancestors()
        .find(|directory| directory.join("tests/golden").is_dir())
        .expect("a repository around this package")
}
