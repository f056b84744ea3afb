#!/bin/sh
# Tries every file of `make release` as a user does who has a C compiler and no Rust: each archive by the lines of docs/install.md and
# of the archive's own README.md. Then asks whether another clone makes the same files, and the sources build without a network.
set -eu
. "$(dirname "$0")/rows.sh"
unset SOURCE_DATE_EPOCH
release=$root/target/release-$version
host=$(rustc -vV | sed -n 's/^host: //p')
export WINEPREFIX="$work/wine" WINEDEBUG=-all

tools=$(tools_but_rust)

no_rust() {
    test -z "$(PATH=$tools command -v cargo rustc rustdoc rustup)"
}

# lines FILE [HEADING]: the first commands that FILE shows, or the first below HEADING
lines() {
    sed -n "/^${2:-#}/,\$p" "$1" | awk '/^```/ { if (shown) exit; shown = /sh$/; next } shown'
}

# --- the files

complete() {
    sed -n 's/.*| TARGET=\([^|]*[^| ]\) .*/\1/p' "$root/packaging/chips.txt" | sed 's/ CPU=/-/' > targets
    test "$(wc -l < targets)" -ge 10
    printf '%s\n' x86_64-unknown-linux-gnu aarch64-unknown-linux-gnu x86_64-pc-windows-gnu >> targets
    while read -r target; do
        for real in double float; do
            test -s "$release/atraj-$version-$target-$real.tar.gz"
            test -f "$release/atraj-$version-$target-$real.tar.gz" && echo "atraj-$version-$target-$real.tar.gz"
        done
    done < targets > expected
    printf '%s\n' "atraj-$version-source.tar.gz" "atraj-$version.cdx.json" SHA256SUMS >> expected
    LC_ALL=C sort expected > sorted
    (cd "$release" && LC_ALL=C ls) | diff sorted -
}

# from_release_to_program NAME: the commands of docs/install.md up to the one that enters the folder, and the commands that are shown there.
# On this machine's archive all commands of the page.
from_release_to_program() {
    cp "$release/$1.tar.gz" "$release/SHA256SUMS" .
    lines "$root/docs/install.md" '## Without Rust' | sed "1s/^name=[^ ]*/name=$1/" > commands
    test "$(wc -l < commands)" -le 5
    case $1 in
    *-"$host"-double) ;;
    *)
        sed -n '1,/ cd /p' commands > entering
        tar xzOf "$1.tar.gz" "$1/README.md" > README.md
        lines README.md | cat entering - > commands
        ;;
    esac
    cat commands
    PATH=$tools sh -e commands > printed
    sed '/: OK$/d; s/\r$//' printed | diff "$root/examples/expected/02_follow.txt" -
}

# The example and the README tell the same command, and no file tells where it was built.
told_once() {
    tar xzf "$release/$1.tar.gz"
    test "$(wc -l < "$1/README.md")" -le 10
    grep -qF "$(lines "$1/README.md" | head -1)" "$1/example.c"
    for file in "lib/pkgconfig/*.pc" "lib/cmake/*/*-config.cmake" include/a/atraj_config.h "share/doc/*/LICENSE-MIT"; do
        test -s "$1"/$file
    done
    test -z "$(grep -rlF "$root" "$1")"
}

# replays TESTS TARGET REAL COMPILER RUN…: the golden rows and the contracts of the C functions, on another host
replays() {
    tests=$1 name=atraj-$version-$2-$3 compiler=$4
    shift 4
    tar xzf "$release/$name.tar.gz"
    for test in $tests; do
        "$compiler" -std=c99 -O2 -I"$name/include" "$root/c_tests/$test.c" "$name"/lib/*.a -lm -o $test.exe
        case $test in
        golden | claraty) timeout 60 "$@" ./$test.exe "$root/tests/golden" ;;
        *) timeout 60 "$@" ./$test.exe ;;
        esac
    done
}

# --- the sources

# The archive of this machine, from the sources, where cargo has no network and no cache.
sources() {
    tar xzf "$release/atraj-$version-source.tar.gz"
    cd "atraj-$version-source"
    CARGO_HOME=$work/empty cargo build --quiet --offline --locked --features capi
    CARGO_HOME=$work/empty CARGO_NET_OFFLINE=true make -s dist
    tar xzf "$release/atraj-$version-$host-double.tar.gz"
    diff -r target/dist/lib "atraj-$version-$host-double/lib"
}

bill() {
    grep '"name": "libc"' "$release/atraj-$version.cdx.json"
    grep "\"purl\": \"pkg:cargo/atraj@$version" "$release/atraj-$version.cdx.json"
    test -z "$(grep -F -e "$root" -e serialNumber "$release/atraj-$version.cdx.json")"
}

# --- another clone, in another folder, by a user who shows files to nobody

another=$work/another/folder/atraj
again=$another/target/release-$version

another_clone() {
    ssh-keygen -q -t ed25519 -N '' -C release -f "$work/key"
    git clone --quiet "$root" "$another"
    (umask 077 && make -s -C "$another" release KEY="$work/key" BILL_TOOL="$(ls "$root"/target/cargo-cyclonedx-*/bin/cargo-cyclonedx)" \
        TARGETS="$host x86_64-pc-windows-gnu thumbv7em-none-eabihf")
    test "$(find "$again" -name '*.tar.gz' | wc -l)" = 7
    for file in "$again"/atraj-*; do
        cmp "$file" "$release/${file##*/}"
    done
}

signed() {
    echo "release@example.org $(cat "$work/key.pub")" > signers
    ssh-keygen -Y verify -f signers -I release@example.org -n file -s "$again/SHA256SUMS.sig" < "$again/SHA256SUMS"
    sed '1s/^./x/' "$again/SHA256SUMS" > forged
    ! ssh-keygen -Y verify -f signers -I release@example.org -n file -s "$again/SHA256SUMS.sig" < forged
}

row "no Rust on the path" no_rust
row "a file for every chip, host and real type" complete
for file in "$release"/atraj-*-double.tar.gz "$release"/atraj-*-float.tar.gz; do
    name=$(basename "$file" .tar.gz)
    row "$name: README and example" told_once "$name"
    row "$name: from release to program" from_release_to_program "$name"
done
# claraty.c waits for the clock of the system, which the archive for Windows does not read.
tests='golden abi fastest sample move axes'
for real in double float; do
    row "golden rows and contracts, AArch64 Linux, $real" \
        replays "$tests claraty" aarch64-unknown-linux-gnu $real aarch64-linux-gnu-gcc qemu-aarch64 -L /usr/aarch64-linux-gnu
    row "golden rows and contracts, Windows, $real" \
        replays "$tests" x86_64-pc-windows-gnu $real x86_64-w64-mingw32-gcc wine
done
row "sources build without a network" sources
row "bill of materials" bill
row "another clone makes the same files" another_clone
row "signed" signed
finish
