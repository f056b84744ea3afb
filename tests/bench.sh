#!/bin/sh
# Writes docs/performance.md to standard output. BENCH and RUSTFLAGS come from the Makefile.
set -eu

cat <<'END'
# Performance

Written by `make bench`: this library and the original (liba 0.1.15, compiled by gcc at `-O2` and at `-O3` with
`-ffp-contract=off`), all called through the C ABI, in one process, in turns over the same memory, each from a loop of its own
that begins a cache line. Nanoseconds and ratios are the medians of 99 rounds in which each has a turn; a ratio above 1 means
that ours is faster. Only ratios carry over to another machine. "Warm" is 4,096 moves, "cold" 262,144, whose structs fit in no
cache; a sweep is over the times of one move. Instructions are counted by callgrind. `atraj_bell_sample` and `atraj_bell_state`
find all four quantities, into arrays that begin at cache lines, and are compared with four calls of the original, per sample.
END
printf '\nMeasured on %s with %s; %s.\n' "$(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -1)" \
    "$(rustc --version)" "$(cc --version | head -1)"

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

printf '\n## binary64\n\n'
$BENCH
same_evaluations 8
printf '\n## binary32\n\n'
$BENCH --features float
same_evaluations 4
cat <<'END'

Of the original's evaluations gcc makes the same instructions at `-O2` and at `-O3`, which this page's script has compared: where
these columns differ, it is by nothing but the places in memory that the linker gave them.
END
printf '\n## Sampling, compiled for the processor of this machine (`target-cpu=native`)\n\nbinary64, then binary32.\n\n'
export RUSTFLAGS="$RUSTFLAGS -C target-cpu=native"
$BENCH --target-dir target/bench-native -- samples
printf '\n'
$BENCH --target-dir target/bench-native --features float -- samples
