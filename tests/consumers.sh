#!/bin/sh
# Installs the library as a user does and builds programs on it, each in an empty folder of its own. They must print what
# they print with the original, whose sources cargo fetches for tests/oracle. Prints one line for each program.
#
# A missing tool is printed. In CI it is a failure.

set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
sources=$root/tests/consumers
version=$(sed -n 's/^version = "\(.*\)"/\1/p' "$root/Cargo.toml")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0 skipped=0
unset MAKEFLAGS MAKELEVEL REAL POLY A_TRAJPOLY3 A_TRAJPOLY5 A_TRAJPOLY7 TARGET DESTDIR PREFIX LD_LIBRARY_PATH

# row TITLE COMMAND: runs the command in an empty folder. In the background, because under `if` a shell lets failing steps
# pass.
row() {
    title=$1
    shift
    folder=$work/rows/$((passed + failed))
    mkdir -p "$folder"
    (cd "$folder" && "$@") > "$work/log" 2>&1 &
    if wait $!; then
        passed=$((passed + 1))
        echo "passed   $title"
    else
        failed=$((failed + 1))
        echo "FAILED   $title"
        sed 's/^/         /' "$work/log"
    fi
}

have() {
    command -v "$1" > /dev/null && return
    skipped=$((skipped + 1))
    echo "SKIPPED  what needs $1: install it"
    return 1
}

# --- the installation in $prefix, for the real type $real

# staged_install BUILD-CHOICE…
staged_install() {
    make -C "$root" dist "$@"
    make -C "$root" install "$@" DESTDIR="${prefix%/opt/atraj}" PREFIX=/opt/atraj
}

complete() {
    cd "$prefix"
    for file in lib/libatraj.a lib/pkgconfig/atraj.pc lib/cmake/atraj/atraj-config.cmake \
        lib/cmake/atraj/atraj-config-version.cmake include/a/atraj_config.h $(cd "$root" && find include -type f) \
        share/doc/atraj/LICENSE-MIT share/doc/atraj/LICENSE-APACHE; do
        test -f "$file"
    done
    test "$(readlink lib/libatraj.so)" = libatraj.so.0
    test "$(readlink lib/libatraj.so.0)" = "libatraj.so.$version"
    test -z "$(find . -type f ! -perm 644 -o -type d ! -perm 755)"
}

# shared_library_in PREFIX
shared_library_in() {
    readelf -dW "$1/lib/libatraj.so" > dynamic
    readelf -lW "$1/lib/libatraj.so" > segments
    grep 'SONAME.*\[libatraj\.so\.0\]' dynamic
    test -z "$(grep -E 'RPATH|RUNPATH|TEXTREL' dynamic)"
    test -z "$(grep NEEDED dynamic | grep -vE '\[lib[cm]\.so\.6\]')"
    grep GNU_STACK segments
    test -z "$(grep 'GNU_STACK.* RWE' segments)"
}

relocatable() {
    pc=$prefix/lib/pkgconfig/atraj.pc
    pkg-config --validate "$pc"
    test "$(pkg-config --modversion "$pc")" = "$version"
    test -z "$(grep -E '(^|[^}.])/' "$pc")"
    test -z "$(grep -rlF -e "$work" -e "$root" -e /opt/atraj "$prefix")"
}

uninstalled() {
    mkdir -p usr/include/a
    touch usr/include/a/list.h
    make -C "$root" install REAL="$real" DESTDIR="$PWD" PREFIX=/usr
    test -f usr/include/a/trajbell.h
    make -C "$root" uninstall REAL="$real" DESTDIR="$PWD" PREFIX=/usr
    test "$(find . ! -type d)" = ./usr/include/a/list.h
    test ! -e usr/lib/cmake/atraj
}

# --- C and C++: with_… SOURCE LINKAGE, where LINKAGE is shared or static

compiler_of() {
    case $1 in *.cpp) echo "${CXX:-c++}" ;; *) echo "${CC:-cc}" ;; esac
}

flag_of() {
    case $1 in static) echo -static ;; esac
}

with_cc() {
    $(compiler_of "$1") -I"$prefix/include" "$sources/$1" -o move -L"$prefix/lib" -latraj -lm $(flag_of "$2")
}

with_pkg_config() {
    flags=$(PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --cflags --libs "--$2" atraj)
    $(compiler_of "$1") "$sources/$1" -o move $flags $(flag_of "$2")
}

with_cmake() {
    case $2 in shared) target=atraj::atraj ;; static) target=atraj::static ;; esac
    cmake -S "$sources" -B . -DSOURCE="$1" -DLIBRARY="$target" -DCMAKE_PREFIX_PATH="$prefix"
    cmake --build .
}

program() {
    "with_$1" "$2" "$3"
    readelf -dW move > dynamic
    case $3 in
    shared) grep 'NEEDED.*\[libatraj\.so\.0\]' dynamic ;;
    static) test -z "$(grep 'NEEDED.*atraj' dynamic)" ;;
    esac
    LD_LIBRARY_PATH=$prefix/lib ./move > printed
    diff "$work/$real.expected" printed
}

# --- the example of firmware, linked

# firmware TOOL
firmware() {
    example=$root/examples/embedded
    case $1 in
    cmake)
        cmake -S "$example" -B . -DCMAKE_TOOLCHAIN_FILE="$example/cortex-m4f.cmake" -DCMAKE_PREFIX_PATH="$prefix"
        cmake --build .
        ;;
    make)
        cp "$example"/* .
        make ATRAJ="$prefix"
        ;;
    esac
    arm-none-eabi-nm axis.elf > symbols
    grep ' T a_trajbell_gen$' symbols
    test -z "$(grep ' a_trajtrap_gen$' symbols)"
    arm-none-eabi-readelf -A axis.elf | grep 'Tag_ABI_VFP_args: VFP registers'
}

# --- a binary that was linked with the original's shared library

# $liba is the original as cargo fetched it. $work/original-$real gets the library and the program.
original_program() {
    case $real in double) size=8 ;; float) size=4 ;; esac
    set -- -DA_SIZE_FLOAT=$size -I"$liba/include"
    mkdir "$work/original-$real"
    cd "$work/original-$real"
    ${CC:-cc} -O2 -ffp-contract=off -fPIC -shared "$@" "$liba"/src/poly.c "$liba"/src/traj*.c -Wl,-soname,liba.so -o liba.so -lm
    ${CC:-cc} "$@" "$sources/move.c" -o move -L. -l:liba.so
    LD_LIBRARY_PATH=. ./move > "$work/$real.expected"
}

runs_under_its_name() {
    ln -s "$prefix/lib/libatraj.so.0" liba.so
    LD_LIBRARY_PATH=. "$work/original-$real/move" > printed
    diff "$work/$real.expected" printed
}

runs_preloaded() {
    LD_DEBUG=bindings LD_DEBUG_OUTPUT=bindings LD_LIBRARY_PATH=$work/original-$real LD_PRELOAD=$prefix/lib/libatraj.so.0 \
        "$work/original-$real/move" > printed
    grep '/move .* to .*/libatraj\.so\.0 .*a_trajbell_gen' bindings.*
    diff "$work/$real.expected" printed
}

# --- Rust

# crate DEFAULT_FEATURES: a package that depends on ours by its path
crate() {
    mkdir src
    cat > Cargo.toml << END
[package]
name = "consumer"
edition = "2024"
[dependencies]
atraj = { path = "$root", default-features = $1 }
[profile.dev]
panic = "abort"
END
}

rust_program() {
    crate "$1"
    cp "$sources/move.rs" src/main.rs
    for real in double float; do
        cargo run --target-dir target -- $real > printed
        diff "$work/$real.expected" printed
    done
}

# If atraj used `std`, this crate's panic handler would be the second one, which is an error.
rust_without_std() {
    crate false
    cat > src/lib.rs << 'END'
#![no_std]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
#[unsafe(no_mangle)]
pub extern "C" fn at_half_time() -> f32 {
    atraj::Poly3::new(1.0, atraj::Boundary::rest_to_rest(0.0, 1.0)).map_or(0.0, |cubic| cubic.position(0.5))
}
END
    cargo rustc --target-dir target --crate-type staticlib
}

cargo_package() {
    cargo package --manifest-path "$root/Cargo.toml" --allow-dirty --target-dir target > said 2>&1
    cat said
    test -z "$(grep warning said | grep -vE 'ignoring (test|example|benchmark) .* is not included in the published package')"
    test "$(wc -c < "target/package/atraj-$version.crate")" -lt 500000
    tar tzf "target/package/atraj-$version.crate" | sed "s|^atraj-$version/||" > files
    for file in src/lib.rs LICENSE-MIT LICENSE-APACHE; do grep -x $file files; done
    test -z "$(grep -vE '^(src|include|examples|docs)/|^(build\.rs|[A-Z]+\.md|LICENSE-[A-Z]+.*|Cargo\..*|\.cargo_vcs_info\.json)$' files)"
}

cargo_c() {
    cargo cinstall --manifest-path "$root/Cargo.toml" --locked --target-dir target --destdir . --prefix / --libdir /lib
    shared_library_in .
    test "$(find include -name '*.h' | sort)" = "$(cd "$work/double/opt/atraj" && find include -name '*.h' | sort)"
    prefix=$PWD
    with_cc move.c shared
    LD_LIBRARY_PATH=lib ./move > printed
    diff "$work/double.expected" printed
}

# --- the matrix

liba=$(cargo metadata --locked --format-version=1 --manifest-path "$root/tests/oracle/Cargo.toml" |
    sed -n 's|.*"manifest_path":"\([^"]*/liba-[0-9.]*\)/Cargo.toml".*|\1|p')

for real in double float; do
    prefix=$work/$real/opt/atraj
    row "original, $real" original_program
    row "make install, $real" staged_install REAL=$real
    row "every file, for everybody to read, $real" complete
    row "soname, no run path, no executable stack, $real" shared_library_in "$prefix"
    have pkg-config && row "no absolute path, $real" relocatable
    row "make uninstall leaves nothing, $real" uninstalled
    for tool in cc pkg_config cmake; do
        have "$(echo $tool | tr _ -)" || continue
        for source in move.c move.cpp; do
            for linkage in shared static; do
                row "$tool, $source, $linkage, $real" program $tool $source $linkage
            done
        done
    done
    row "binary of the original, ours under its name, $real" runs_under_its_name
    row "binary of the original, ours preloaded, $real" runs_preloaded
done

if have arm-none-eabi-gcc; then
    prefix=$work/firmware/opt/atraj
    row "make install, Cortex-M4F, float" staged_install TARGET=thumbv7em-none-eabihf REAL=float
    row "make, firmware, Cortex-M4F, float" firmware make
    have cmake && row "cmake, firmware, Cortex-M4F, float" firmware cmake
fi

row "cargo, path, default features" rust_program true
row "cargo, path, no default features" rust_program false
row "cargo, path, no_std" rust_without_std
row "cargo package" cargo_package
# May be missing in CI, because cargo-c takes longer to build than every row here together.
if command -v cargo-cinstall > /dev/null; then
    row "cargo cinstall" cargo_c
else
    echo "NOT RUN  cargo cinstall: no cargo-c here (cargo install cargo-c --version 0.10.24 --locked)"
fi

echo "$passed passed, $failed failed, $skipped skipped"
test $failed = 0
test $skipped = 0 || test -z "${CI:-}"
