//! Can one C program hold the original and our library under other names, and call both?

use oracle::liba::original::{build, directory};
use std::path::Path;
use std::process::{Command, Output};
use support::variant::{FLOAT_PREFIXED, PREFIXED, Variant};
use support::{Language, compilers};

fn compare(variant: &Variant, compiler: &str, liba: &Path, flags: &[&str]) -> Output {
    let mut link = Command::new(compiler);
    link.args(["-std=c99", "-O2", "-Wall", "-Wextra", "-Werror"]).args(flags);
    link.arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("c/both.c")).arg(liba.join("liba.a"));
    Command::new(variant.link(&mut link, directory("both").join("program"))).output().unwrap()
}

#[test]
fn and_they_agree() {
    for (variant, size) in [(&PREFIXED, "-DA_SIZE_FLOAT=8"), (&FLOAT_PREFIXED, "-DA_SIZE_FLOAT=4")] {
        let liba = directory("both-liba");
        build(&liba, &[], &[size]);
        for compiler in compilers(Language::C) {
            let output = compare(variant, compiler, &liba, &[]);
            let text = String::from_utf8(output.stdout).unwrap();
            assert!(output.status.success(), "{compiler} {size}: {text}");
            let (values, _) = text.split_once(' ').unwrap();
            assert!(values.parse::<u32>().unwrap() > 100_000, "{text}");
        }
        // The program would not see a difference if both names were one function.
        assert_eq!(compare(variant, "cc", &liba, &["-DLIMIT=9"]).status.code(), Some(1));
    }
}
