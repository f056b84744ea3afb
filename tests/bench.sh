#!/bin/sh
# Writes docs/performance.md to standard output. BENCH and RUSTFLAGS come from the Makefile.
set -eu

cat <<'END'
# Performance

`make bench` writes this page. It compares this library with the original (liba 0.1.15, compiled by gcc with `-ffp-contract=off`,
once at `-O2` and once at `-O3`). One process calls all three through the C ABI, in turns and over the same memory. Each has a loop
of its own, which begins a cache line. Nanoseconds and ratios are the medians of 99 rounds; in each round every library has a turn.
If a ratio is above 1, ours is faster. Only ratios carry over to another machine. "Warm" means 4,096 moves, "cold" means 262,144 moves,
whose structs fit in no cache. A sweep goes over the times of one move. callgrind counts the instructions. `atraj_bell_sample` and
`atraj_bell_state` compute all four quantities, into arrays that begin at cache lines. They are compared, per sample, with four calls
of the original.
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

gcc compiles the original's evaluations to the same instructions at `-O2` and at `-O3`; the script of this page has compared them.
Where these columns differ, the only cause is the place in memory that the linker gave each function.
END
printf '\n## Plans that never fail\n\n'
cat <<'END'
`atraj_bell_gen` and `atraj_trap_gen` beside the original's functions and beside the crate
[rsruckig](https://crates.io/crates/rsruckig), which plans the fastest motion too: one axis, its position interface, the same ends and
limits. All three have their turns in the same rounds. Each row names the moves; the first three rows have the moves of the tables
above. "Any v0 and v1" are velocities between the limits, from which the original refuses some moves; a refusal costs it little. "Worst"
is the longest time of one plan among the 4,096 moves. Each plan is timed alone, 41 times with all other plans between, and its shortest
time counts, so the longest time is no other work on the machine. The clock of the machine limits its resolution. rsruckig computes in
binary64 in both tables.

binary64, then binary32.

END
$BENCH -- fastest
printf '\n'
$BENCH --features float -- fastest
printf '\n## Moves from any state to any state\n\n'
cat <<'END'
`atraj_move_plan` beside rsruckig: 4,096 moves in each row, at rest, between velocities, then with an acceleration at the start, then at the
end too. In the row "asymmetric" both velocities and both accelerations have limits of their own; in "outside" velocity and acceleration
start 1.7 times as large, often beyond a limit. A ratio above 1 means that ours is faster, and "worst" is as above. The last columns count
the moves that rsruckig fails, and the moves for which rsruckig's motion takes longer than ours. Ours fails none and takes longer in none;
the benchmark stops if it does. rsruckig computes in binary64 in both tables.

The second table evaluates moves between any velocities, and the same moves as a double-S: `atraj_move_pos` beside `a_trajbell_pos`,
`atraj_move_state` beside `atraj_bell_state`, and so on. 512 moves share the time.

The third table plans several axes that arrive together: `atraj_moves_sync` beside rsruckig with as many axes. 1,024 sets of axes share the
time of a row, and the time is that of one set.

binary64, then binary32.

END
$BENCH -- moves
printf '\n'
$BENCH --features float -- moves
# Cargo would rebuild the libraries for the flags of the benchmark.
for real in double float; do env -u RUSTFLAGS make -s dist REAL=$real >&2; done
printf '\n## Sampling on each level of x86-64\n\n'
cat <<'END'
`atraj_bell_sample` in the shared libraries of `make dist`: the default, and those that glibc's loader takes on a processor with AVX2
(`x86-64-v3`) or AVX-512 (`x86-64-v4`). Beside each stand four calls of the original for each sample, and "fill": the same four arrays
filled with a constant, with the stores of the level. No sampling takes less time. All three have their turns in the same rounds.
"Unknown to callgrind" means that callgrind cannot run instructions of this level, and so counts none.

binary64, then binary32.

END
$BENCH -- levels
printf '\n'
$BENCH --features float -- levels
