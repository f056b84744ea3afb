#!/usr/bin/env bash
# coverage.sh: runs the tests with counters in the library, and prints how many regions of each file they reach, and how many sides of all
# conditions. C programs call the C functions. It fails if a side that no test takes is not in docs/data/untaken-sides.csv with its reason.
# Needs llvm-cov of the LLVM that rustc is built with.
set -euo pipefail
out=$PWD/target/coverage
llvm=$(rustc -vV | sed -n 's/^LLVM version: \([0-9]*\).*/\1/p')
rm -rf "$out/raw"
mkdir -p "$out"

# Branches are counted by an unstable option. The tests are one program, tests/oracle/brief.rs: counters of the library
# with its unit tests would not match those of the library.
export RUSTC_BOOTSTRAP=1 RUSTFLAGS='-C instrument-coverage -Z coverage-options=branch' BRIEF=1 CARGO_TARGET_DIR=$out/build
LLVM_PROFILE_FILE=/dev/null cargo test --locked --profile mutants -p oracle --test brief --no-run --message-format=json \
    > "$out/messages.json"
program=$(sed -n 's/.*"executable":"\([^"]*\)".*/\1/p' "$out/messages.json")
LLVM_PROFILE_FILE=$out/raw/%p-%m.profraw "$program" -q > "$program.log" 2>&1 || { cat "$program.log" >&2; exit 1; }
"llvm-profdata-$llvm" merge --sparse "$out"/raw/*.profraw -o "$out/profile"
cov() { "llvm-cov-$llvm" "$@" "$program" --instr-profile "$out/profile" --sources "$PWD/src"; }
cov report --show-branch-summary=false | sed "s|$PWD/||"

# A row for each side that no test takes. Each instance of a generic function has counts of its own; they count together.
LC_ALL=C
cov show --show-branches=count --show-instantiations=false | awk '
    /^\/.*:$/ { file = $0; sub(/.*\/src\//, "src/", file); sub(/:$/, "", file) }
    /^ *[0-9]+\|/ { line = $0; sub(/^[^|]*\|[^|]*\|/, "", line); text[file, $1 + 0] = line }
    /Branch \(.*True: / {
        split($0, part, /[(:)]/)
        condition = substr(text[file, part[2]], part[3])
        sub(/( \{|;|,)$/, "", condition)
        gsub(/"/, "\"\"", condition)
        place = file SUBSEP part[2] SUBSEP part[3]
        row[place] = file ",\"" condition "\","
        taken[place SUBSEP "true"] += !/True: 0,/
        taken[place SUBSEP "false"] += !/False: 0\]/
    }
    END {
        for (side in taken) {
            sides++
            split(side, part, SUBSEP)
            if (taken[side]) { reached++ } else { print row[part[1] SUBSEP part[2] SUBSEP part[3]] part[4] }
        }
        printf "%d of %d sides of conditions are taken\n", reached, sides > "/dev/stderr"
    }' | sort > "$out/untaken"
sed -n 's/^\(src.*\),[a-z]*$/\1/p' docs/data/untaken-sides.csv | sort > "$out/listed"
comm -13 "$out/untaken" "$out/listed" | sed 's/^/taken, so its row may go: /'
unlisted=$(comm -23 "$out/untaken" "$out/listed")
test -z "$unlisted" || { printf 'taken by no test, and not in docs/data/untaken-sides.csv:\n%s\n' "$unlisted"; exit 1; }
