//! `seeds <directory>`: the golden moves as a fuzzer's first corpus, in one subdirectory for each family, and nasty problems in
//! another.

use oracle::bytes::encode;
use oracle::nasty::{Kind, Problems};
use std::io::Result;
use std::path::{Path, PathBuf};
use support::{Family, Real, golden};

fn main() -> Result<()> {
    let directory = PathBuf::from(std::env::args_os().nth(1).expect("a directory"));
    for family in Family::ALL {
        write::<f64>(family, &directory.join(family.name()))?;
        write::<f32>(family, &directory.join(family.name()))?;
    }
    write_problems::<f64>(&directory.join("fastest"))?;
    write_problems::<f32>(&directory.join("fastest"))
}

fn write_problems<R: Real>(directory: &Path) -> Result<()> {
    std::fs::create_dir_all(directory)?;
    for (case, problem) in Problems::<R>::new(0).take(4 * Kind::ALL.len()).enumerate() {
        let file = directory.join(format!("nasty-{}-{case}", R::NAME));
        std::fs::write(file, encode(&problem.arguments, &[]))?;
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
