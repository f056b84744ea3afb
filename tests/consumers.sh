#!/bin/sh
# Installs the library as a user does and builds programs on it, each in an empty folder of its own. They must print what
# they print with the original, whose sources cargo fetches for tests/oracle.

set -eu
. "$(dirname "$0")/rows.sh"
sources=$root/tests/consumers

# --- the installation of $package (atraj or atraj-float) in $prefix, for the real type $real. Both are in one prefix.

# staged_install BUILD-CHOICE…
staged_install() {
    make -C "$root" dist "$@"
    make -C "$root" install "$@" DESTDIR="${prefix%/opt/atraj}" PREFIX=/opt/atraj
}

complete() {
    cd "$prefix"
    for file in "lib/lib$package.a" "lib/pkgconfig/$package.pc" "lib/cmake/$package/$package-config.cmake" \
        "lib/cmake/$package/$package-config-version.cmake" "$headers/a/atraj_config.h" \
        "share/doc/$package/LICENSE-MIT" "share/doc/$package/LICENSE-APACHE" \
        $(cd "$root/include" && find . -type f | sed "s|^|$headers/|"); do
        test -f "$file"
    done
    test "$(readlink "lib/lib$package.so")" = "lib$package.so.0"
    test "$(readlink "lib/lib$package.so.0")" = "lib$package.so.$version"
    test -z "$(find . -type f ! -perm 644 -o -type d ! -perm 755)"
}

shared_library() {
    readelf -dW "$prefix/lib/lib$package.so" > dynamic
    readelf -lW "$prefix/lib/lib$package.so" > segments
    grep "SONAME.*\[lib$package\.so\.0\]" dynamic
    test -z "$(grep -E 'RPATH|RUNPATH|TEXTREL' dynamic)"
    test -z "$(grep NEEDED dynamic | grep -vE '\[lib[cm]\.so\.6\]')"
    grep GNU_STACK segments
    test -z "$(grep 'GNU_STACK.* RWE' segments)"
}

relocatable() {
    pc=$prefix/lib/pkgconfig/$package.pc
    pkg-config --validate "$pc"
    test "$(pkg-config --modversion "$pc")" = "$version"
    test -z "$(grep -E '(^|[ =IL])/' "$pc")"
    test -z "$(grep -rlF -e "$work" -e "$root" -e /opt/atraj "$prefix")"
}

# --- C and C++: with_… SOURCE LINKAGE, where LINKAGE is shared or static

compiler_of() { case $1 in *.cpp) echo "${CXX:-c++}" ;; *) echo "${CC:-cc}" ;; esac; }

flag_of() { case $1 in static) echo -static ;; esac; }

with_cc() { $(compiler_of "$1") -I"$prefix/$headers" "$sources/$1" -o move -L"$prefix/lib" "-l$package" -lm $(flag_of "$2"); }

with_pkg_config() {
    flags=$(PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --cflags --libs "--$2" "$package")
    $(compiler_of "$1") "$sources/$1" -o move $flags $(flag_of "$2")
}

with_cmake() {
    case $2 in shared) target=$package::$package ;; static) target=$package::static ;; esac
    cmake -S "$sources" -B . -DSOURCE="$1" -DPACKAGE="$package" -DLIBRARY="$target" -DCMAKE_PREFIX_PATH="$prefix"
    cmake --build .
}

found() {
    rm -rf build
    cmake -S "$sources" -B build -DSOURCE=move.c -DCMAKE_PREFIX_PATH="$prefix" "$@"
}

refuses_processor() {
    own="$version (for $(uname -m)-"
    for processor in riscv64 cortex-m4; do
        refused "$own" found -DCMAKE_SYSTEM_NAME=Generic -DCMAKE_SYSTEM_PROCESSOR=$processor
    done
    refused "$own" found -DSIZEOF_VOID_P=4
    for processor in "$(uname -m)" some-board; do found -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR="$processor"; done
}

refuses_version() {
    for other in 0.0 0.2 1.0 "$version.1" 99; do refused 'version: ' found -DWANTED=$other; done
    for same in 0.1 "$version"; do found -DWANTED=$same; done
}

refuses_real() {
    refused 'find_package(atraj-float)' found -DCOMPONENT=float
    refused atraj_ABI found -DALSO=atraj-float
}

# prints_the_bits COMMAND: a program must print the numbers that it prints with the original.
prints_the_bits() {
    "$@" > printed
    diff "$work/$real.expected" printed
}

program() {
    "with_$1" "$2" "$3"
    readelf -dW move > dynamic
    case $3 in
    shared) grep "NEEDED.*\[lib$package\.so\.0\]" dynamic ;;
    static) test -z "$(grep 'NEEDED.*atraj' dynamic)" ;;
    esac
    LD_LIBRARY_PATH=$prefix/lib prints_the_bits ./move
}

# --- the levels of x86-64

loader=/lib64/ld-linux-x86-64.so.2
levels="x86-64-v3 x86-64-v4"

# has_level LEVEL: whether this processor has it, as the loader says
has_level() {
    "$loader" --help | grep -q "^  $1 (supported" && return
    echo "SKIPPED  $1: this processor lacks it"
    return 1
}

# takes FOLDER ARGUMENT…: with these arguments the loader must take the library in this folder.
takes() {
    folder=$1
    shift
    with_cc move.c shared
    LD_DEBUG=libs LD_DEBUG_OUTPUT=libs prints_the_bits "$loader" "$@" --library-path "$prefix/lib" ./move
    grep "calling init: $folder/lib$package.so.0" libs.*
}

# same_bits LEVEL: golden data and every function, from the library of this level
same_bits() {
    for program in golden claraty calls; do
        ${CC:-cc} -std=c99 -I"$prefix/$headers" "$root/c_tests/$program.c" -o $program -L"$prefix/lib" "-l$package" -lm
        LD_DEBUG=libs LD_DEBUG_OUTPUT=$program "$loader" --glibc-hwcaps-mask "$1" --library-path "$prefix/lib" \
            ./$program "$root/tests/golden"
        grep "calling init: .*/$1/lib$package.so.0" $program.*
    done
}

# A fused multiply-add rounds once where the original rounds twice.
nothing_fused() {
    for level in $levels; do
        objdump -d "$prefix/lib/glibc-hwcaps/$level/lib$package.so.0" > code
        grep -q ymm code
        test -z "$(grep -E 'vfn?m(add|sub)' code)"
    done
}

# --- the programs of the example of firmware, linked, and run in an emulator

example=$root/examples/embedded

# firmware TOOL
firmware() {
    case $1 in
    cmake)
        cmake -S "$example" -B . -DCMAKE_TOOLCHAIN_FILE="$example/cortex-m4f.cmake" -DCMAKE_PREFIX_PATH="$prefix"
        cmake --build . ;;
    make)
        cp "$example"/* .
        make ATRAJ="$prefix" ;;
    clone)
        copy_of_the_sources atraj
        make -C atraj/examples/embedded
        cp atraj/examples/embedded/*.elf . ;;
    esac
    arm-none-eabi-nm axis.elf > symbols
    grep ' T a_trajbell_gen$' symbols
    test -z "$(grep ' a_trajtrap_gen$' symbols)"
    arm-none-eabi-nm jog.elf > symbols
    grep ' T atraj_axis_go$' symbols
    test -z "$(grep ' a_trajbell_gen$' symbols)"
    for program in axis jog; do arm-none-eabi-readelf -A $program.elf | grep 'Tag_ABI_VFP_args: VFP registers'; done
}

# chip NAME: sets the linker's flags and the emulator for the chip, whose archive has this name. The result of `main` is the emulator's exit code.
chip() {
    make -s -C "$root/c_tests/firmware" commands NAME="$1" > commands
    { read -r _ && read -r map && read -r emulator; } < commands
}

firmware_runs() {
    cp "$example"/* .
    chip thumbv7em-none-eabihf
    make ATRAJ="$prefix" BOARD="$map"
    for program in axis.elf jog.elf; do emulate $program; done
    # Half the limit of the velocity's step, so that a setpoint jumps.
    sed -i "s/0\.01001/0.00501/" jog.c
    make ATRAJ="$prefix" BOARD="$map"
    if emulate jog.elf; then return 1; fi
}

emulate() { timeout 60 $emulator "$1" < /dev/null; }

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
    ln -s "$prefix/lib/lib$package.so.0" liba.so
    LD_LIBRARY_PATH=. prints_the_bits "$work/original-$real/move"
}

runs_preloaded() {
    LD_LIBRARY_PATH=$work/original-$real prints_the_bits \
        env LD_DEBUG=bindings LD_DEBUG_OUTPUT=bindings LD_PRELOAD="$prefix/lib/lib$package.so.0" "$work/original-$real/move"
    grep "/move .* to .*/lib$package\.so\.0 .*a_trajbell_gen" bindings.*
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
    for real in double float; do prints_the_bits cargo run --target-dir target -- $real; done
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

cargo_c() {
    cargo cinstall -p atraj --manifest-path "$root/Cargo.toml" --locked --target-dir target --prefix "$PWD/usr" --libdir "$PWD/usr/lib"
    prefix=$PWD/usr
    shared_library
    for header in $(cd "$root/include" && find . -type f) a/atraj_config.h; do test -f "$prefix/include/$header"; done
    for linkage in shared static; do program pkg_config move.cpp $linkage; done
}

cargo_package() {
    cargo package --manifest-path "$root/Cargo.toml" --allow-dirty --target-dir target > said 2>&1
    cat said
    # Tests and the packages that hold them are not published.
    test -z "$(grep warning said | grep -vE 'ignoring (test|example|benchmark) .* is not included|profile package spec `handover`')"
    test "$(wc -c < "target/package/atraj-$version.crate")" -lt 500000
    tar tzf "target/package/atraj-$version.crate" | sed "s|^atraj-$version/||" > files
    for file in src/lib.rs LICENSE-MIT LICENSE-APACHE; do grep -x $file files; done
    test -z "$(grep -vE '^(src|include|examples|docs)/|^((tests|proofs)/README\.md|build\.rs|[A-Z]+\.md|LICENSE-[A-Z]+.*|Cargo\..*|\.cargo_vcs_info\.json)$' files)"
}

# --- the matrix

liba=$(cargo metadata --locked --format-version=1 --manifest-path "$root/Cargo.toml" |
    sed -n 's|.*"manifest_path":"\([^"]*/liba-[0-9.]*\)/Cargo.toml".*|\1|p')

prefix=$work/host/opt/atraj
# about REAL: sets the names of the package for this real type.
about() {
    real=$1
    case $real in
    double) package=atraj headers=include ;;
    float) package=atraj-float headers=include/atraj-float ;;
    esac
}

for real in double float; do
    row "original, $real" original_program
    row "make install, $real" staged_install REAL=$real
done
for real in double float; do
    about $real
    row "every file, for everybody to read, $real" complete
    row "soname, no run path, no executable stack, $real" shared_library
    have pkg-config && row "no absolute path, $real" relocatable
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
if test -x "$loader"; then
    for real in double float; do
        about $real
        highest=$prefix/lib
        for level in $levels; do
            has_level $level || continue
            highest=$prefix/lib/glibc-hwcaps/$level
            row "the loader takes $level, $real" takes "$highest" --glibc-hwcaps-mask $level
            row "golden data and samples, $level, $real" same_bits $level
        done
        row "the loader takes the highest level, $real" takes "$highest"
        row "the loader takes the default for an old processor, $real" takes "$prefix/lib" --glibc-hwcaps-mask none
        row "no level has fused operations, $real" nothing_fused
    done
else
    echo "SKIPPED  levels of x86-64: there is no $loader"
fi
if have cmake; then
    row "cmake refuses another processor" refuses_processor
    row "cmake refuses another version" refuses_version
    row "cmake refuses another real type" refuses_real
fi

if have arm-none-eabi-gcc; then
    prefix=$work/firmware/opt/atraj
    about float
    row "make install, Cortex-M4F, float" staged_install TARGET=thumbv7em-none-eabihf REAL=float
    row "make, firmware, Cortex-M4F, float" firmware make
    row "make in examples/embedded of a clone" firmware clone
    have cmake && row "cmake, firmware, Cortex-M4F, float" firmware cmake
    have qemu-system-arm && row "firmware in the emulator, Cortex-M4F, float" firmware_runs
fi

. "$sources/packages.sh"

row "cargo, path, default features" rust_program true
row "cargo, path, no default features" rust_program false
row "cargo, path, no_std" rust_without_std
row "cargo package" cargo_package
about double
if command -v cargo-cinstall > /dev/null; then row "cargo cinstall" cargo_c; else echo "SKIPPED  cargo cinstall: there is no cargo-c"; fi

finish
