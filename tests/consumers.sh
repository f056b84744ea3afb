#!/bin/sh
# Installs the library as a user does and builds programs on it, each in an empty folder of its own. What they print must
# be what they print with the original, whose sources cargo fetches for tests/oracle. One line for each that passed.
#
# A missing tool is said aloud, and under CI it is a failure.

set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
sources=$root/tests/consumers
version=$(sed -n 's/^version = "\(.*\)"/\1/p' "$root/Cargo.toml")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0 skipped=0

# Runs a command in an empty folder. In the background, because under `||` the shell would let a failing step pass.
row() {
    title=$1
    shift
    rm -rf "$work/here"
    mkdir "$work/here"
    (cd "$work/here" && "$@") > "$work/log" 2>&1 &
    if wait $!; then
        passed=$((passed + 1))
        echo "passed   $title"
    else
        failed=$((failed + 1))
        echo "FAILED   $title"
        sed 's/^/         /' "$work/log"
    fi
}

# For rows that need a tool: does it exist?
have() {
    tool=$1
    command -v "$tool" > /dev/null && return
    skipped=$((skipped + 1))
    echo "SKIPPED  what needs $tool, which is not installed"
    return 1
}

# --- the installation itself

install_staged() {
    make -C "$root" install REAL="$1" DESTDIR="$work/$1" PREFIX=/opt/atraj
}

check_tree() {
    cd "$prefix"
    for file in lib/libatraj.a lib/pkgconfig/atraj.pc lib/cmake/atraj/atraj-config.cmake \
        lib/cmake/atraj/atraj-config-version.cmake include/a/atraj_config.h $(cd "$root" && find include -type f); do
        test -f "$file"
    done
    test "$(readlink lib/libatraj.so)" = libatraj.so.0
    test "$(readlink lib/libatraj.so.0)" = "libatraj.so.$version"
    test -z "$(find . -type f ! -perm 644 -o -type d ! -perm 755)"
    test -z "$(grep -rl "$work" .)"
}

check_shared_library() {
    readelf -dW "$1" > dynamic
    readelf -lW "$1" > segments
    grep -q 'SONAME.*\[libatraj\.so\.0\]' dynamic
    test -z "$(grep -E 'RPATH|RUNPATH|TEXTREL' dynamic)"
    test -z "$(grep NEEDED dynamic | grep -vE '\[lib[cm]\.so\.6\]')"
    test -z "$(grep -E 'GNU_STACK.*E' segments)"
}

check_pc() {
    pc=$prefix/lib/pkgconfig/atraj.pc
    pkg-config --validate "$pc"
    test "$(pkg-config --modversion "$pc")" = "$version"
    test -z "$(grep -E '(^|[^}./])/' "$pc")"
}

check_uninstall() {
    mkdir -p usr/include/a
    touch usr/include/a/list.h usr/lib.conf
    make -C "$root" install REAL=double DESTDIR="$PWD" PREFIX=/usr
    test -f usr/include/a/trajbell.h
    make -C "$root" uninstall REAL=double DESTDIR="$PWD" PREFIX=/usr
    test "$(find . ! -type d | sort | xargs)" = "./usr/include/a/list.h ./usr/lib.conf"
    test ! -e usr/lib/cmake/atraj
}

# --- C and C++ programs: $1 source, $2 shared or static, $real and $prefix say which installation

compiler() {
    case $1 in *.cpp) echo "${CXX:-c++}" ;; *) echo "${CC:-cc}" ;; esac
}

with_cc() {
    test "$2" = shared || set -- "$1" -static
    $(compiler "$1") -I"$prefix/include" "$sources/$1" -o move -L"$prefix/lib" -latraj -lm ${2#shared}
}

with_pkg_config() {
    export PKG_CONFIG_PATH="$prefix/lib/pkgconfig"
    test "$2" = shared || set -- "$1" -static
    $(compiler "$1") "$sources/$1" -o move $(pkg-config --cflags --libs ${2:+-$2} atraj) $2
}

with_cmake() {
    case $2 in shared) library=atraj::atraj ;; static) library=atraj::static ;; esac
    cmake -S "$sources" -B . -DSOURCE="$1" -DLIBRARY=$library -DCMAKE_PREFIX_PATH="$prefix"
    cmake --build .
}
