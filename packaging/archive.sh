#!/bin/sh
# archive.sh DIST FOLDER TARGET ABI: makes FOLDER, the content of a release archive: the files of DIST, CHANGELOG.md,
# README.md, which says how a program for TARGET is compiled, and example.c. ABI is double, float, double-compact or float-compact.
set -eu
dist=$1 folder=$2 target=$3
real=${4%-compact}
case $4 in
*-compact) polynomials="compact, as in liba since 2025-03" ;;
*) polynomials="those of liba 0.1.15" ;;
esac
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml)
library=$(cd "$dist" && ls lib/*.a | grep -v '\.dll\.a$')
optimise=-O2 board='' program=example

rm -rf "$folder"
cp -R "$dist" "$folder"
cp CHANGELOG.md "$folder"

# Hosts: the compiler has its name from Debian, an emulator runs the example of another system, and a note is for those who have that system.
# The other targets are chips.
host=$(sed -n "s/^$target|//p" << 'END'
x86_64-unknown-linux-gnu|cc||
aarch64-unknown-linux-gnu|aarch64-linux-gnu-gcc|qemu-aarch64 -L /usr/aarch64-linux-gnu|On an AArch64 machine, `cc` compiles it, and `./example` runs it.
armv7-unknown-linux-gnueabihf|arm-linux-gnueabihf-gcc|qemu-arm -L /usr/arm-linux-gnueabihf|On a 32-bit Raspberry Pi OS, for example, `cc` compiles it, and `./example` runs it.
x86_64-unknown-linux-musl|musl-gcc||On Alpine, `cc` compiles it.
aarch64-unknown-linux-musl|zig cc -target aarch64-linux-musl|qemu-aarch64|On Alpine, `cc` compiles it, and `./example` runs it. zig is on PyPI too: `pip install ziglang`, `python -m ziglang cc`.
x86_64-pc-windows-gnu|x86_64-w64-mingw32-gcc|wine|On Windows, MinGW's `gcc` compiles it, and `.\example` runs it. A `claraty_trapezoid` begins with the manual clock.
END
)
if test -n "$host"; then
    compiler=${host%%|*} note=${host##*|} run=${host#*|}
    run=${run%%|*}
    case $target in
    *-windows-*) program=example.exe note="$note
\`bin\` holds the DLL, \`lib/*.dll.a\` its import library, which \`lld-link\` takes too." ;;
    esac
else
    MAKEFLAGS='' make -s -C c_tests/firmware commands NAME="$target" > "$folder.commands"
    { read -r compiler && read -r board && read -r run; } < "$folder.commands"
    echo "$board" > "$folder/board.txt"
    board=@board.txt optimise='-Os -Wl,--gc-sections' program=example.elf
    note='`board.txt` gives the linker the start code and the memory of an emulator. Those of your board take their place.'
fi
flags=$(echo "$compiler" | sed -n 's/^[^ ]* \(cc \)\{0,1\}//p')
compile="$compiler $optimise -Iinclude example.c $library -lm${board:+ $board} -o $program"

cat > "$folder/README.md" << END
# atraj $version for $target, a_float is $real
Motion profiles behind a C ABI, compiled: a program needs a C compiler, and no Rust. MIT or Apache-2.0: \`share/doc\`.
The polynomial structs are $polynomials. The headers in \`include\` describe the functions, and the release's \`atraj-$version-site.tar.gz\` holds the documentation.
Flags for C: \`-Iinclude${flags:+ $flags}\`. Link \`$library\`, then \`-lm\`. pkg-config and CMake find the library in \`lib\`.
\`\`\`sh
$compile
${run:+$run }./$program
\`\`\`
$note
END

# The example's first comment says how it is compiled.
awk -v compile="$compile" '/^ +make dist$/ { next } /^ +cc / { $0 = "     " compile } { print }' examples/06_retarget.c > "$folder/example.c"
