#!/bin/sh
# archive.sh DIST FOLDER TARGET REAL: makes FOLDER, the content of a release archive: the files of DIST, README.md, which says
# how a program for TARGET is compiled, and example.c.
set -eu
dist=$1 folder=$2 target=$3 real=$4
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml)
library=$(cd "$dist" && echo lib/*.a)
optimise=-O2 board='' run='' program=example note=''

rm -rf "$folder"
cp -R "$dist" "$folder"

# Where the example is compiled on another system, the compiler has its name from Debian, and an emulator runs the example.
case $target in
x86_64-unknown-linux-gnu)
    compiler=cc
    ;;
aarch64-unknown-linux-gnu)
    compiler=aarch64-linux-gnu-gcc
    run='qemu-aarch64 -L /usr/aarch64-linux-gnu'
    note='On an AArch64 machine, `cc` compiles it, and `./example` runs it.'
    ;;
x86_64-pc-windows-gnu)
    compiler=x86_64-w64-mingw32-gcc
    program=example.exe
    run=wine
    note='On Windows, MinGW'\''s `gcc` compiles it, and `.\example` runs it. A `claraty_trapezoid` begins with the manual clock.'
    ;;
*)
    MAKEFLAGS='' make -s -C c_tests/firmware commands NAME="$target" > "$folder.commands"
    { read -r compiler && read -r board && read -r run; } < "$folder.commands"
    echo "$board" > "$folder/board.txt"
    board=@board.txt
    optimise='-Os -Wl,--gc-sections'
    program=example.elf
    note='`board.txt` gives the linker the start code and the memory of an emulator. Those of your board take their place.'
    ;;
esac
flags=$(echo "$compiler" | cut -s -d ' ' -f 2-)
compile="$compiler $optimise -Iinclude example.c $library -lm${board:+ $board} -o $program"

cat > "$folder/README.md" << END
# atraj $version for $target, a_float is $real
Motion profiles behind a C ABI, compiled: a program needs a C compiler, and no Rust. MIT or Apache-2.0: \`share/doc\`.
Flags for C: \`-Iinclude${flags:+ $flags}\`. Link \`$library\`, then \`-lm\`.
pkg-config and CMake find the library in \`lib\`; its functions are described in \`include\`.
\`\`\`sh
$compile
${run:+$run }./$program
\`\`\`
$note
END

# The example's first comment says how it is compiled.
awk -v compile="$compile" '/^ +make dist$/ { next } /^ +cc / { $0 = "     " compile } { print }' examples/02_follow.c > "$folder/example.c"
