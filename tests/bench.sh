#!/bin/sh
# Prints docs/performance.md with new tables, one file for each section. BENCH and RUSTFLAGS come from the Makefile.
set -eu
tables=target/performance
mkdir -p $tables

# Instructions of the original's evaluations in the real type of $2 bytes at -O$1: without addresses, jump targets and padding.
evaluations() {
    objdump -d --no-show-raw-insn tests/oracle/target/release/bench |
        sed -En "/<o$1c$2_traj.*_(pos|vel|acc|jer)>:/,/^\$/s/^ *[0-9a-f]+:\t//p" |
        sed -E 's/ +#.*//; s/-?0x[0-9a-f]+\(%rip\)/(%rip)/; s/^(j[a-z]+) .*/\1/; /nop|int3|^xchg +%ax,%ax/d'
}
same_evaluations() {
    test -n "$(evaluations 2 "$1")"
    test "$(evaluations 2 "$1")" = "$(evaluations 3 "$1")"
}
# both WORD: binary64, then binary32
both() {
    $BENCH -- "$1"
    echo
    $BENCH --features float -- "$1"
}

$BENCH > $tables/1
same_evaluations 8
$BENCH --features float > $tables/2
same_evaluations 4
both fastest > $tables/3
RUCKIG=$(tests/ruckig.sh) || echo 'SKIPPED: Ruckig in C++ was not built, so docs/performance.md tells nothing of it.' >&2
export RUCKIG
both moves > $tables/4
both path > $tables/5
# Cargo would rebuild the libraries for the flags of the benchmark.
for real in double float; do env -u RUSTFLAGS make -s dist REAL=$real >&2; done
both levels > $tables/6

awk -v tables=$tables -v machine="$(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -1)" \
    -v compilers="$(rustc --version); $(cc --version | head -1)" '
    /^Measured on / { $0 = "Measured on " machine " with " compilers "." }
    /^## / { file = tables "/" ++section }
    /^\|/ { while ((getline line < file) > 0) { print line } old = 1; next }
    old && /^$/ { next }
    old { print ""; old = 0 }
    { print }' docs/performance.md
