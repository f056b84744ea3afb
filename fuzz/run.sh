#!/usr/bin/env bash
# usage: run.sh [-runs=N | -max_total_time=SECONDS]
# Runs every fuzz target so many times or so long, beginning with the golden moves. Does what `cargo fuzz run` does without cargo-fuzz
# and without a nightly compiler. libFuzzer needs a C++ compiler.
# FUZZ_SEED=n starts the random numbers at n, not at 1. libFuzzer would draw a seed. A verdict repeats if seed and runs are the same.
set -euo pipefail
cd "$(dirname "$0")"
limit=${1:--max_total_time=60}
target=$(rustc -vV | sed -n 's/^host: //p')
target_dir=../target/fuzz

cargo run --quiet --locked --profile oracle -p measure --bin seeds -- corpus
coverage=-Cllvm-args=-sanitizer-coverage
flags="-Cpasses=sancov-module $coverage-level=4 $coverage-inline-8bit-counters $coverage-pc-table $coverage-trace-compares \
    -Zsanitizer=address -Cdebug-assertions -Coverflow-checks -Ccodegen-units=1"
RUSTC_BOOTSTRAP=1 RUSTFLAGS=$flags cargo build --quiet --locked --profile oracle -p atraj-fuzz --target "$target" --target-dir $target_dir

mkdir -p artifacts
for family in bell trap poly3 poly5 poly7 fastest move axes path axis machine; do
    log=artifacts/$family.log
    if ! "$target_dir/$target/oracle/$family" -seed="${FUZZ_SEED:-1}" -max_len=640 "$limit" \
        -artifact_prefix="artifacts/$family-" "corpus/$family" 2> "$log"; then
        cat "$log"
        exit 1
    fi
    echo "fuzz $family: $(grep '^Done' "$log")"
done
