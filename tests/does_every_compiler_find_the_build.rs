//! Do the installed headers take the archive's real type, levels and generation with a compiler that cannot look for a file
//! (`__has_include`)?

use std::process::Command;
use support::repository::root;
use support::tools::{has_tool, run};
use support::variant::VARIANTS;

#[test]
fn tcc_finds_it() {
    if !has_tool("tcc") {
        return;
    }
    for variant in VARIANTS {
        let dist = variant.dist();
        let object = variant.scratch().join("abi-tcc.o");
        let mut compile = Command::new("tcc");
        compile.args(["-c", "-Wall", "-Werror", "-I"]);
        compile.arg(dist.join("include"));
        compile.arg(root().join("c_tests/abi.c"));
        run(compile.arg("-o").arg(&object));
        // The program prints every broken promise, a wrong size of a struct among them.
        let program = variant.scratch().join("abi-tcc");
        let mut link = Command::new("cc");
        link.args(["-z", "noexecstack"]).arg(&object);
        link.arg(variant.archive());
        run(link.arg("-lm").arg("-o").arg(&program));
        run(&mut Command::new(program));
    }
}
