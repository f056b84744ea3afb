#!/usr/bin/env bash
# coverage.sh: runs the tests with counters in the library, and prints how many regions and branches of each file they reach, then each branch
# that none takes, with its line. C programs call the C functions. Needs llvm-cov of the LLVM that rustc is built with.
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
# A test that builds or runs other programs reaches nothing here, and in the copy each folder of tests has a file more than on the map.
mapfile -t skipped < <(grep -lE 'Command|Variant' tests/{,oracle/tests/}*_*.rs | sed 's|.*/\(.*\)\.rs|--skip=\1::|')
skipped+=(--skip=is_the_map_complete::)
for program in c unit root oracle; do
    (cd "$tree" && "$out/programs/$program" -q "${skipped[@]}") > "$out/$program.log" 2>&1 || echo "$program: $(tail -1 "$out/$program.log")" >&2
done
"llvm-profdata-$llvm" merge --sparse "$out"/raw/*.profraw -o "$out/profile"
objects=()
# The C functions have one name in each program, and the first program counts.
for program in "$out"/programs/{c-*,unit,root,oracle}; do objects+=(--object "$program"); done
cov() { "llvm-cov-$llvm" "$@" "${objects[@]:1}" --instr-profile "$out/profile" --sources "$tree/src"; }
cov report | sed "s|$tree/||"
cov show --show-branches=count --show-instantiations=false | awk '
    /^\/.*:$/ { file = $0; sub(/.*\/src\//, "src/", file); sub(/:$/, "", file) }
    /Branch \(/ && /(True|False): 0[],]/ { match($0, /\([0-9]+:[0-9]+\)/); print file ":" substr($0, RSTART + 1, RLENGTH - 2), substr($0, index($0, "[")) }'
