#!/bin/sh
# Writes the tables of docs/performance.md: docs/data/performance-*.csv. BENCH and RUSTFLAGS come from the Makefile.
set -eu
data=docs/data
new=target/performance
mkdir -p $new

# Instructions of the original's evaluations in the real type of $2 bytes at -O$1: without addresses, jump targets and padding.
evaluations() {
    objdump -d --no-show-raw-insn target/release/bench |
        sed -En "/<o$1c$2_traj.*_(pos|vel|acc|jer)>:/,/^\$/s/^ *[0-9a-f]+:\t//p" |
        sed -E 's/ +#.*//; s/-?0x[0-9a-f]+\(%rip\)/(%rip)/; s/^(j[a-z]+) .*/\1/; /nop|int3|^xchg +%ax,%ax/d'
}
same_evaluations() {
    test -n "$(evaluations 2 "$1")"
    test "$(evaluations 2 "$1")" = "$(evaluations 3 "$1")"
}
# table NAME [WORD]: what the benchmark prints for WORD, `double` before `float`.
table() {
    $BENCH -- ${2-} > "$new/double"
    test "$1" != liba || same_evaluations 8
    $BENCH --features float -- ${2-} > "$new/float"
    test "$1" != liba || same_evaluations 4
    { cat "$new/double"; tail -n +2 "$new/float"; } > "$new/$1.csv"
    mv "$new/$1.csv" "$data/performance-$1.csv"
}

table liba
table fastest fastest
RUCKIG=$(tests/ruckig.sh) || echo 'SKIPPED: Ruckig in C++ was not built, so performance-moves.csv has no figures of it.' >&2
export RUCKIG
table moves moves
table evaluations evaluations
table paths path
printf 'tool,version\nprocessor,%s\nrustc,%s\ncc,%s\n' "$(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -1)" \
    "$(rustc --version | cut -d ' ' -f 2-)" "$(cc --version | head -1 | cut -d ' ' -f 2-)" > $data/performance-tools.csv
