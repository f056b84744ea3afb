#!/usr/bin/env bash
# coverage.sh: runs the tests with counters in the library, and prints how many regions and branches of each file they reach, then each line
# and each branch that none reaches. C programs call the C functions. Needs llvm-cov of the LLVM that rustc is built with.
set -euo pipefail
out=$PWD/target/coverage
tree=$out/tree
llvm=$(rustc -vV | sed -n 's/^LLVM version: \([0-9]*\).*/\1/p')
rm -rf "$tree" "$out/raw"
mkdir -p "$tree"
git ls-files -z | xargs -0 cp --parents -t "$tree"

# Branches are counted by an unstable option.
export RUSTC_BOOTSTRAP=1 RUSTFLAGS='-C instrument-coverage -Z coverage-options=branch'
LLVM_PROFILE_FILE=/dev/null tests/programs.sh "$tree" "$out/programs"
export LLVM_PROFILE_FILE=$out/raw/%p-%m.profraw
cd "$tree"
for program in c unit root oracle; do "$out/programs/$program" -q || true; done > "$out/log" 2>&1
cd - > /dev/null
"llvm-profdata-$llvm" merge --sparse "$out"/raw/*.profraw -o "$out/profile"
objects=()
for program in "$out"/programs/{unit,root,oracle,c-*}; do objects+=(--object "$program"); done
cov() { "llvm-cov-$llvm" "$@" "${objects[@]:1}" --instr-profile "$out/profile" --sources "$tree/src"; }
cov report --show-branch-summary | sed "s|$tree/||"
