#!/usr/bin/env bash
# mutants.sh COUNT SEED: judges about COUNT mutants, every n-th of all, and prints the mutation score and those that survived, as rows of
# docs/data/mutants.csv. MUTANT_BASE=<commit> draws from the lines that have changed since then, MUTANT_PART=src/path from a folder.
# .cargo/mutants.toml says what judges them.
set -euo pipefail
count=$1 seed=$2
out=$PWD/target/mutants
tree=$out/tree
rm -rf "$tree" "$out"/{all,compact,soft}
mkdir -p "$tree"
git ls-files -z | xargs -0 cp -p --parents -t "$tree"
# cargo-mutants leaves unsafe functions out, and each C function is one. The places stay where they were.
safe='s/pub unsafe extern "C" fn/pub        extern "C" fn/'
find "$tree/src/capi" -name '*.rs' -exec sed -i "$safe" {} +

drawn=()
if test -n "${MUTANT_BASE:-}"; then
    git diff "$MUTANT_BASE" -- src | sed "$safe" > "$out/changes.diff"
    drawn=(--in-diff "$out/changes.diff")
fi
test -z "${MUTANT_PART:-}" || drawn+=(--file "$MUTANT_PART/**")
mutants() { cargo mutants --dir "$tree" --colors never "$@"; }
of=$((($(mutants "${drawn[@]}" --list 2> /dev/null | wc -l) + count - 1) / count))
test "$of" -gt 0 || { echo 'no mutant stands in a line that has changed'; exit; }

export BRIEF=1 RUSTC_BOOTSTRAP=1 CARGO_TARGET_DIR=$out/build
# The unit tests of the library are linked with the library itself, through the package `support`: each C function stands there twice, the same.
export RUSTFLAGS='-C link-arg=-Wl,-z,muldefs'
# judge NAME OPTIONS…: exit codes 2 and 3 mean that mutants survived or hung.
judge() { mutants --in-place --output "$out/$1" "${@:2}" >&2 || [[ $? == [23] ]]; }
# again NAME FOLDER OPTIONS…: judges the survivors of a folder in a build that holds other code.
again() {
    local survivors
    survivors=$(sed -n "\|^$2|s/[][\\.*^\$+?(){}|]/\\\\&/gp" "$out/all/mutants.out/missed.txt" | paste -sd'|')
    test -z "$survivors" || judge "$1" --re "^($survivors)\$" "${@:3}"
}
judge all "${drawn[@]}" --shard "$((seed % of))/$of" --sharding round-robin
again compact src/capi/a/ --features oracle/poly-compact
RUSTFLAGS="$RUSTFLAGS --cfg unit_lacks_binary64" again soft src/real/soft.rs

# Wilson's interval. A survivor is known if the table has a row for it: file and change, without the line.
cd "$out"
{ cat {all,compact,soft}/mutants.out/{caught,timeout}.txt 2> /dev/null || true; } | sort -u > found.txt
sort all/mutants.out/missed.txt | comm -23 - found.txt > missed.txt
awk -v unviable="$(wc -l < all/mutants.out/unviable.txt)" -v found="$(wc -l < found.txt)" -v missed="$(wc -l < missed.txt)" 'BEGIN {
    n = found + missed; if (!n) exit; p = found / n; z = 1.959964
    middle = p + z * z / 2 / n; half = z * sqrt(p * (1 - p) / n + z * z / 4 / n / n); whole = 1 + z * z / n
    printf "%d mutants, %d found: %.1f %%, with 95 %% confidence %.1f to %.1f %%; %d more do not compile\n",
        n, found, 100 * p, 100 * (middle - half) / whole, 100 * (middle + half) / whole, unviable }'
sed 's/:[0-9]*:[0-9]*: /: /' missed.txt | while IFS= read -r name; do
    grep -F -m1 -e ",$name," -e ",\"$name\"," "$OLDPWD/docs/data/mutants.csv" || echo "$seed,\"$name\",open,"
done
