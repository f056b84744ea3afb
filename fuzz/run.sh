#!/usr/bin/env bash
# usage: run.sh [-runs=N | -max_total_time=SECONDS]
# Runs every fuzz target so many times or so long, beginning with the golden moves. Does what `cargo fuzz run` does without cargo-fuzz
# and without a nightly compiler. libFuzzer needs a C++ compiler.
# FUZZ_SEED=n starts the random numbers at n, not at 1. libFuzzer would draw a seed. A verdict repeats if seed and runs are the same.
set -euo pipefail
cd "$(dirname "$0")"
limit=${1:--max_total_time=60}
target=$(rustc -vV | sed -n 's/^host: //p')
oracle=../tests/oracle/Cargo.toml

cargo fetch --quiet --locked --manifest-path $oracle
cargo run --quiet --release --locked --manifest-path $oracle --bin seeds -- corpus
flags=(
    -Cpasses=sancov-module
    -Cllvm-args=-sanitizer-coverage-level=4
    -Cllvm-args=-sanitizer-coverage-inline-8bit-counters
    -Cllvm-args=-sanitizer-coverage-pc-table
    -Cllvm-args=-sanitizer-coverage-trace-compares
    -Zsanitizer=address
    -Cdebug-assertions
    -Coverflow-checks
    -Ccodegen-units=1
)
RUSTC_BOOTSTRAP=1 RUSTFLAGS="${flags[*]}" cargo build --quiet --release --locked --target "$target"

mkdir -p artifacts
for family in bell trap poly3 poly5 poly7 fastest move axes path axis machine; do
    log=artifacts/$family.log
    if ! "target/$target/release/$family" -seed="${FUZZ_SEED:-1}" -max_len=640 "$limit" \
        -artifact_prefix="artifacts/$family-" "corpus/$family" 2> "$log"; then
        cat "$log"
        exit 1
    fi
    echo "fuzz $family: $(grep '^Done' "$log")"
done
