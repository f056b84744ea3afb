#!/usr/bin/env bash
# mutants.sh SEED OF_EACH: judges so many random mutants of each storey, and prints the table and the survivors. It goes on where it was
# stopped: target/mutants/SEED holds a line for each judged mutant. After a change of the library, take another seed. MUTANT_BASE=<commit> judges
# only mutants of the lines that have changed since then, in target/mutants/changed-SEED.
set -euo pipefail
seed=$1 of_each=$2
out=$PWD/target/mutants/${MUTANT_BASE:+changed-}$seed
tree=$out/tree
results=$out/results.tsv
mkdir -p "$out"
touch "$out/unviable" "$results"
tool=$PWD/target/mutants/tool/release/mutants

CARGO_TARGET_DIR=target/mutants/tool cargo build --quiet --release --locked --manifest-path tests/mutants/Cargo.toml

copy() {
    rm -rf "$tree"
    mkdir -p "$tree"
    git ls-files -z | xargs -0 cp --parents -t "$tree"
}
# cargo-mutants leaves unsafe functions out, and each C function is one. The places stay where they were.
safe='s/pub unsafe extern "C" fn/pub        extern "C" fn/'
if ! test -s "$out/list.json"; then
    copy
    find "$tree/src/capi" -name '*.rs' -exec sed -i "$safe" {} +
    changed=()
    if test -n "${MUTANT_BASE:-}"; then
        git diff "$MUTANT_BASE" -- src | sed "$safe" > "$out/changes.diff"
        changed=(--in-diff "$out/changes.diff")
    fi
    (cd "$tree" && cargo mutants --list --json "${changed[@]}") > "$out/list.json"
    test -s "$out/list.json" || { echo 'no mutant stands in a line that has changed'; exit; }
fi

# check FEATURES FLAGS: whether a build compiles.
check() {
    (cd "$tree" && CARGO_TARGET_DIR=$out/programs/build RUSTFLAGS="$RUSTFLAGS $2" cargo check --quiet --features "$1" --message-format=json) \
        > "$out/messages.json"
}
if ! test -e "$out/programs/whole"; then
    # A mutant may leave a name unused.
    export RUSTFLAGS=-Awarnings
    while
        copy
        "$tool" plant "$out/list.json" "$tree" "$seed" "$of_each" "$out/unviable" > "$out/constant" || exit
        ! { check capi '' && check capi,poly-compact '--cfg unit_lacks_binary64'; }
    do
        refused=$(wc -l < "$out/unviable")
        "$tool" refuse "$tree" "$out/messages.json" "$out/unviable"
        test "$(wc -l < "$out/unviable")" -gt "$refused" || { echo 'the planted library does not compile' >&2; exit 1; }
    done
    tests/programs.sh "$tree" "$out/programs"
fi

page=$PWD/docs/trust.md
trap '"$tool" report "$results" "$page"' EXIT
cd "$tree"
rm -rf "$out/claims"
mkdir "$out/claims"
judges=()
for _ in $(seq "$(nproc)"); do
    "$tool" judge "$out/list.json" "$seed" "$of_each" "$out/unviable" "$out/constant" "$out/programs" "$out/claims" "$results" &
    judges+=($!)
done
for judge in "${judges[@]}"; do wait "$judge"; done
