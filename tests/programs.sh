#!/usr/bin/env bash
# programs.sh TREE OUT: builds the tests of the copy TREE of this repository as few programs: OUT/unit, OUT/root, OUT/oracle and OUT/border. OUT/c runs the C
# programs OUT/c-*, OUT/compact runs them with the polynomials of the newest liba, and OUT/soft with the `double` of a core whose unit lacks it.
# `make mutants` and `make coverage` run them. The oracle's tests that are made for minutes are made for seconds here.
set -euo pipefail
tree=$1 out=$2
mkdir -p "$out"
export CARGO_TARGET_DIR=$out/build CARGO_PROFILE_RELEASE_LTO=off CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16 CARGO_PROFILE_RELEASE_OPT_LEVEL=1
export CARGO_PROFILE_TEST_OPT_LEVEL=1
cd "$tree"

sizes='do_axes_arrive_together:SEEDS:1 do_axes_arrive_together:SETS:1_000 does_a_path_pass_its_points:PATHS:200
    is_a_step_lost:MOVES:10_000 does_the_clock_keep_the_limits:PATHS:3_334 does_a_replan_detour:MOVES:400
    does_every_plan_pass:PROBLEMS:20_000 does_every_plan_pass:SETS:1_000 is_the_fastest_motion_right:SEEDS:1'
for size in $sizes; do
    IFS=: read -r name constant value <<< "$size"
    sed -i "/^const $constant: /{s/= .*;/= $value;/;h};\${x;/./!{x;q1};x}" "tests/oracle/tests/$name.rs"
done

# No test needs the bins.
rm -r tests/oracle/src/bin

# This test compiles files of the library as its own, with the switch of a mutant if there is one. So it cannot be a part of another program.
border=tests/oracle/tests/are_the_derivatives_right.rs
if test -e src/mutant.rs; then
    echo '#[path = "../../../src/mutant.rs"] mod mutant;' >> "$border"
fi

# One program for all tests of a package: the library is compiled once.
merge() {
    local file modules=
    for file in "$1"/*.rs; do
        test "$file" != "$border" || continue
        modules+="#[path = \"${file##*/}\"] mod $(basename "$file" .rs);"
    done
    printf '//! All tests as one program.\n%s\n' "$modules" > "$1/all.rs"
}
merge tests
merge tests/oracle/tests

# program NAME ARGUMENTS…: what cargo builds with these arguments, as OUT/NAME.
program() {
    cargo "${@:2}" --message-format=json-render-diagnostics > "$out/messages.json"
    cp "$(sed -n 's/.*"executable":"\([^"]*\)".*/\1/p' "$out/messages.json" | tail -1)" "$out/$1"
}
program unit test --quiet --no-run --lib
program root test --quiet --no-run --test all
program oracle test --quiet --release --no-run --locked --manifest-path tests/oracle/Cargo.toml --test all
program border test --quiet --release --no-run --locked --manifest-path tests/oracle/Cargo.toml --test are_the_derivatives_right

contracts='abi sample fastest move axes axis path clock shaper steps' replays='golden claraty'
# c_programs NAME FEATURES HEADER FLAGS…: the C programs beside the library that rustc builds with these flags, as OUT/NAME-*, and OUT/NAME,
# which runs all of them. Each program includes the HEADER.
c_programs() {
    local name=$1 features=$2 header=$3 include=$out/include-$1 library config source
    cargo rustc --quiet --release --lib --crate-type staticlib --features "$features" --message-format=json-render-diagnostics \
        -- --cfg atraj_archive "${@:4}" > "$out/messages.json"
    library=$(sed -n 's|.*"filenames":\["\([^"]*/libatraj\.a\)".*|\1|p' "$out/messages.json")
    config=$(sed -n 's|.*"out_dir":"\([^"]*/build/atraj-[0-9a-f]*/out\)".*|\1|p' "$out/messages.json")
    mkdir -p "$include"
    cp -R include/. "$include"
    cp "$config/atraj_config.h" "$include/a/"
    for source in $contracts $replays; do
        # The symbol links what writes the counters of `make coverage`.
        cc -std=c99 -O1 -I"$include" -include "$header" -Wl,--defsym=rust_eh_personality=0,--undefined=__llvm_profile_runtime \
            "c_tests/$source.c" "$library" -lm -o "$out/$name-$source"
    done
    cat > "$out/$name" <<END
#!/bin/sh
set -e
for source in $contracts; do $out/$name-\$source; done
for source in $replays; do $out/$name-\$source $tree/tests/golden; done
END
    chmod +x "$out/$name"
}
c_programs c capi a/a.h
c_programs compact capi,poly-compact a/a.h
c_programs soft capi c_tests/aeabi.h --cfg unit_lacks_binary64
touch "$out/whole"
