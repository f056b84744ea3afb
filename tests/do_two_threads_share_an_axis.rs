//! Do two threads share an axis or a group of the C ABI, one that plans and one that ticks, without a jump and without a data race?
//!
//! A plan that is published before it is whole is the planted fault. ThreadSanitizer needs the run-time library that rustup's compiler
//! brings along; it does not know fences, so it wants each order from a store and a load.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use support::variant::{DOUBLE, FLOAT, Variant};
use support::{lines, printed, root, run};

const EARLY: &str = "-DPUBLISHED_EARLY";
const GROUP: &str = "-DGROUP";

fn compiler(variant: &Variant, flags: &[&str]) -> Command {
    let mut command = Command::new("cc");
    command.args(["-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-O2", "-pthread"]);
    command.arg("-I").arg(variant.include()).arg(root().join("c_tests/threads.c")).args(flags);
    command
}

fn program(variant: &Variant, flags: &[&str]) -> Output {
    let program = variant.scratch().join(format!("threads{}", flags.concat()));
    Command::new(variant.link(&mut compiler(variant, flags), program)).output().unwrap()
}

#[test]
fn without_a_jump() {
    for variant in [&DOUBLE, &FLOAT] {
        for flags in [&[][..], &[GROUP]] {
            let output = program(variant, flags);
            assert!(output.status.success(), "{flags:?} {}", printed(&output));
        }
    }
    // Threads that share a processor see the fault in 19 of 20 runs.
    assert!((0..20).any(|_| !program(&DOUBLE, &[EARLY]).status.success()));
}

/// The archive, in which ThreadSanitizer watches each access.
fn watched_archive() -> PathBuf {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(root()).args(["rustc", "--quiet", "--release", "--lib"]);
    cargo.args(["--crate-type", "staticlib", "--no-default-features", "--features", "capi"]);
    // With --target, cargo compiles build.rs without these flags.
    cargo.args(["--target", host().as_str(), "--target-dir", "target/watched"]);
    cargo.env("RUSTC_BOOTSTRAP", "1").env("RUSTFLAGS", "-Zsanitizer=thread -Cunsafe-allow-abi-mismatch=sanitizer");
    run(cargo.args(["--", "--cfg", "atraj_archive"]));
    root().join("target/watched").join(host()).join("release/libatraj.a")
}

fn host() -> String {
    format!("{}-unknown-linux-gnu", std::env::consts::ARCH)
}

fn watched_program(archive: &Path, library: &Path, flags: &[&str]) -> Output {
    let program = DOUBLE.scratch().join(format!("watched{}", flags.concat()));
    let object = program.with_extension("o");
    run(compiler(&DOUBLE, flags).args(["-fsanitize=thread", "-c", "-o"]).arg(&object));
    let mut link = Command::new("cc");
    link.args(["-no-pie", "-rdynamic", "-pthread"]).arg(object).arg(archive).arg(library);
    run(link.args(["-lm", "-ldl", "-lrt", "-o"]).arg(&program));
    Command::new(program).output().unwrap()
}

#[test]
fn without_a_data_race() {
    let libraries = lines(Command::new("rustc").args(["--print", "target-libdir"])).concat();
    let library = Path::new(&libraries).join("librustc-stable_rt.tsan.a");
    if !library.exists() {
        println!("SKIPPED: {} is missing, so ThreadSanitizer watches nothing", library.display());
        return;
    }
    let archive = watched_archive();
    for flags in [&[][..], &[GROUP]] {
        let output = watched_program(&archive, &library, flags);
        assert!(output.status.success(), "{flags:?} {}", printed(&output));
    }
    let early = printed(&watched_program(&archive, &library, &[EARLY]));
    assert!(early.contains("data race"), "{early}");
}
