//! `seeds <directory>`: the golden moves as a fuzzer's first corpus, in one subdirectory for each family.

use oracle::bytes::encode;
use oracle::common::golden;
use oracle::family::Family;
use oracle::real::OracleReal;
use std::io::Result;
use std::path::{Path, PathBuf};

fn main() -> Result<()> {
    let directory = PathBuf::from(std::env::args_os().nth(1).expect("a directory"));
    for family in Family::ALL {
        write::<f64>(family, &directory.join(family.name()))?;
        write::<f32>(family, &directory.join(family.name()))?;
    }
    Ok(())
}

fn write<R: OracleReal>(family: Family, directory: &Path) -> Result<()> {
    std::fs::create_dir_all(directory)?;
    let arguments = family.arguments().len();
    let (text, returned) = family.golden_columns();
    let columns = arguments + returned + family.fields().len();
    let times = golden::<R>(
        &format!("{}_eval", family.name()),
        1,
        1 + family.functions().len(),
    );
    for row in golden::<R>(&format!("{}_gen", family.name()), text, columns) {
        let times = times.iter().filter(|time| time.case == row.case);
        let times: Vec<_> = times.map(|time| time.values[0]).collect();
        let bytes = encode(&row.values[..arguments], &times);
        std::fs::write(
            directory.join(format!("golden-{}-{}", R::NAME, row.case)),
            bytes,
        )?;
    }
    Ok(())
}
