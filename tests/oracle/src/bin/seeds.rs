//! `seeds <directory>`: the golden moves as a fuzzer's first corpus, in one subdirectory for each family.

use oracle::bytes::encode;
use std::io::Result;
use std::path::{Path, PathBuf};
use support::{Family, Real, golden};

fn main() -> Result<()> {
    let directory = PathBuf::from(std::env::args_os().nth(1).expect("a directory"));
    for family in Family::ALL {
        write::<f64>(family, &directory.join(family.name()))?;
        write::<f32>(family, &directory.join(family.name()))?;
    }
    Ok(())
}

fn write<R: Real>(family: Family, directory: &Path) -> Result<()> {
    std::fs::create_dir_all(directory)?;
    let evaluations = golden::evaluations::<R>(family);
    for (case, golden) in golden::moves::<R>(family).iter().enumerate() {
        let times = evaluations.iter().filter(|golden| golden.case == case);
        let times: Vec<_> = times.map(|golden| golden.x).collect();
        let file = directory.join(format!("golden-{}-{case}", R::NAME));
        std::fs::write(file, encode(&golden.arguments, &times))?;
    }
    Ok(())
}
