//! Can one C program hold the original and our library under other names, and call both?

use oracle::liba::original::{build, directory};
use std::path::Path;
use std::process::{Command, Output};
use support::tools::{Language, compilers, run};
use support::variant::{FLOAT_PREFIXED, PREFIXED, Variant};

fn compare(variant: &Variant, compiler: &str, liba: &Path, flags: &[&str]) -> Output {
    let dist = variant.dist();
    let program = directory("both").join("program");
    let mut link = Command::new(compiler);
    link.args(["-std=c99", "-O2", "-Wall", "-Wextra", "-Werror"]);
    link.args(flags).arg("-I").arg(dist.join("include"));
    link.arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("c/both.c"));
    link.arg(liba.join("liba.a"));
    link.arg(variant.archive());
    run(link.arg("-lm").arg("-o").arg(&program));
    Command::new(program).output().unwrap()
}

#[test]
fn and_they_agree() {
    for (variant, size) in [(&PREFIXED, "-DA_SIZE_FLOAT=8"), (&FLOAT_PREFIXED, "-DA_SIZE_FLOAT=4")] {
        let liba = directory("both-liba");
        build(&liba, &[], &[size]);
        for compiler in compilers(Language::C) {
            let output = compare(variant, compiler, &liba, &[]);
            let text = String::from_utf8(output.stdout).unwrap();
            println!("{compiler} {size}: {text}");
            assert!(output.status.success(), "{text}");
            let (values, _) = text.split_once(' ').unwrap();
            assert!(values.parse::<u32>().unwrap() > 100_000, "{text}");
        }
        // The program would not see a difference if both names were one function.
        assert_eq!(compare(variant, "cc", &liba, &["-DLIMIT=9"]).status.code(), Some(1));
    }
}
