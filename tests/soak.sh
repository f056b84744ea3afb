#!/bin/sh
# soak.sh calls|plans|moves|axes|paths|programs…: goes on with each kind of random cases where its last row in docs/data/soak.csv ends, and appends
# a row when it ends or is stopped. SOAK is the program. SOAK_SEED starts elsewhere, SOAK_SEEDS ends sooner or later.
set -eu
table=docs/data/soak.csv

# commit KIND: the commit that last changed what this kind runs. A program of a group runs all of the library, and nothing else its machine.
commit() {
    parts='src'
    test "$1" = programs || parts='src :!src/machine'
    commit=$(git log -1 --format=%h -- $parts)
    git diff --quiet HEAD -- $parts || commit=$commit-dirty
}
done=$(mktemp)
running=

# A stopped run counts up to its last whole seed.
note() {
    test ! -s "$done" || echo "$(date -u +%F),$commit,$(cat "$done")" >> "$table"
    : > "$done"
}
trap 'test -z "$running" || kill "$running" 2>/dev/null || true; note; rm -f "$done"; exit 1' INT TERM HUP

faults=0
for what in "$@"; do
    commit "$what"
    next=$(sed -n "s/.*,$what,[0-9]*\.\.\([0-9]*\),.*/\1/p" "$table" | sort -n | tail -1)
    $SOAK "$what" "${SOAK_SEED:-${next:-0}}" "${SOAK_SEEDS:-1000}" "$done" &
    running=$!
    wait "$running" || faults=1
    running=
    note
done
rm -f "$done"
exit "$faults"
