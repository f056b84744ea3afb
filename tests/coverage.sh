#!/usr/bin/env bash
# coverage.sh: runs the tests with counters in the library, and prints how many regions of each file they reach, and how many sides of all
# conditions. C programs call the C functions. It fails if a side that no test takes is not in the table of docs/trust.md with its reason.
# Needs llvm-cov of the LLVM that rustc is built with.
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
cov report --show-branch-summary=false | sed "s|$tree/||"

# A row for each side that no test takes. Each instance of a generic function has counts of its own; they count together.
LC_ALL=C
cov show --show-branches=count --show-instantiations=false | awk '
    /^\/.*:$/ { file = $0; sub(/.*\/src\//, "src/", file); sub(/:$/, "", file) }
    /^ *[0-9]+\|/ { line = $0; sub(/^[^|]*\|[^|]*\|/, "", line); text[file, $1 + 0] = line }
    /Branch \(.*True: / {
        split($0, part, /[(:)]/)
        condition = substr(text[file, part[2]], part[3])
        sub(/( \{|;|,)$/, "", condition)
        gsub(/\|/, "\\|", condition)
        place = file SUBSEP part[2] SUBSEP part[3]
        row[place] = "| `" file "` | `" condition "` |"
        taken[place SUBSEP "true"] += !/True: 0,/
        taken[place SUBSEP "false"] += !/False: 0\]/
    }
    END {
        for (side in taken) {
            sides++
            split(side, part, SUBSEP)
            if (taken[side]) { reached++ } else { print row[part[1] SUBSEP part[2] SUBSEP part[3]], part[4] " |" }
        }
        printf "%d of %d sides of conditions are taken\n", reached, sides > "/dev/stderr"
    }' | sort > "$out/untaken"
sed -n '/<!-- branches -->/,/<!-- end -->/s/^\(| `src.* |\) [a-z]* |$/\1/p' docs/trust.md | sort > "$out/listed"
comm -13 "$out/untaken" "$out/listed" | sed 's/^/taken, so its row may go: /'
unlisted=$(comm -23 "$out/untaken" "$out/listed")
test -z "$unlisted" || { printf 'taken by no test, and not in docs/trust.md:\n%s\n' "$unlisted"; exit 1; }
