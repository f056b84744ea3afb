#!/bin/sh
# Tries every file of `make release` as a user does who has a C compiler and no Rust: each archive by the lines of docs/install.md and
# of the archive's own README.md. Then asks whether another clone makes the same files, and the sources build without a network.
set -eu
. "$(dirname "$0")/rows.sh"
unset SOURCE_DATE_EPOCH
release=$root/target/release-$version
abis=${ABIS:-double float double-compact float-compact}
host=$(rustc -vV | sed -n 's/^host: //p')
export WINEPREFIX="$work/wine" WINEDEBUG=-all

tools=$(tools_but_rust)

zig_from_pypi() {
    tools_from_pypi
    printf '#!/bin/sh\nexec "%s" -m ziglang "$@"\n' "$root/target/venv/bin/python" > "$tools/zig"
    chmod +x "$tools/zig"
    PATH=$tools zig version
}

no_rust() { test -z "$(PATH=$tools command -v cargo rustc rustdoc rustup)"; }

# lines FILE [HEADING]: the first commands that FILE shows, or the first below HEADING
lines() { sed -n "/^${2:-#}/,\$p" "$1" | awk '/^```/ { if (shown) exit; shown = /sh$/; next } shown'; }

# --- the files

complete() {
    sed -n 's/.*| TARGET=\([^|]*[^| ]\) .*/\1/p' "$root/packaging/chips.txt" | sed 's/ CPU=/-/' > targets
    test "$(wc -l < targets)" -ge 10
    printf '%s\n' x86_64-unknown-linux-gnu x86_64-unknown-linux-musl aarch64-unknown-linux-gnu aarch64-unknown-linux-musl \
        armv7-unknown-linux-gnueabihf x86_64-pc-windows-gnu >> targets
    while read -r target; do
        for abi in $abis; do
            test -s "$release/atraj-$version-$target-$abi.tar.gz"
            echo "atraj-$version-$target-$abi.tar.gz"
        done
    done < targets > expected
    for file in source.tar.gz site.tar.gz playground.html; do echo "atraj-$version-$file"; done >> expected
    printf '%s\n' "atraj-$version.cdx.json" "atraj-$version-arduino.zip" "atraj-$version-vcpkg.zip" "atraj.atraj.$version.pack" \
        SHA256SUMS ${KEY:+SHA256SUMS.sig} >> expected
    (cd "$release" && ls ./*.deb ./*.whl) | sed 's|^\./||' > named_by_tools
    test "$(grep -c '^libatraj.*\.deb$' named_by_tools)" = 4
    grep '\.whl$' named_by_tools
    (cd "$release" && ls) | grep -v "^atraj-$version\.tar\.gz$" | LC_ALL=C sort > there
    cat expected named_by_tools | LC_ALL=C sort | diff - there
    (cd "$release" && sha256sum --check --strict SHA256SUMS)
    test "$(wc -l < "$release/SHA256SUMS")" = "$(ls "$release" | grep -vc '^SHA256SUMS')"
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
    sed '/: OK$/d' printed | retargets "$1"
}

# retargets NAME: whether a program printed the lines of the example. In `float` a sample may stand on the other side of a step of the jerk.
retargets() {
    case $1 in
    *float*) digits='s/, [^,]* m.s^3$//' ;;
    *) digits= ;;
    esac
    sed "$digits" "$root/examples/expected/06_retarget.txt" > expected
    sed 's/\r$//' | sed "$digits" | diff expected -
}

# The example and the README tell the same command, and no file tells where it was built.
told_once() {
    tar xzf "$release/$1.tar.gz"
    test "$(wc -l < "$1/README.md")" -le 11
    grep -qF "$(lines "$1/README.md" | head -1)" "$1/example.c"
    for file in CHANGELOG.md "lib/pkgconfig/*.pc" "lib/cmake/*/*-config.cmake" include/a/atraj_config.h "share/doc/*/LICENSE-MIT"; do
        test -s "$1"/$file
    done
    test -z "$(grep -rlF "$root" "$1")"
}

# replays TESTS TARGET ABI COMPILER RUN…: the golden rows and the contracts of the C functions, on another host. RUN may be empty.
replays() {
    tests=$1 name=atraj-$version-$2-$3 compiler=$4
    shift 4
    tar xzf "$release/$name.tar.gz"
    for test in $tests; do
        $compiler -std=c99 -O2 -I"$name/include" "$root/c_tests/$test.c" $(ls "$name"/lib/*.a | grep -v '\.dll\.a$') -lm -o $test.exe
        case $test in
        golden | claraty) timeout 60 "$@" ./$test.exe "$root/tests/golden" ;;
        *) timeout 60 "$@" ./$test.exe ;;
        esac
    done
}

# --- the DLL for Windows

# unpacked_dll ABI: unpacks the archive with the DLL of this ABI into `windows`, and copies the DLL next to the programs
unpacked_dll() {
    tar xzf "$release/atraj-$version-x86_64-pc-windows-gnu-$1.tar.gz"
    mv atraj-* windows
    cp windows/bin/*.dll .
    test "$(ls -- *.dll)" = "libatraj$(echo "-$1" | sed 's/^-double//')-0.dll"
}

# The DLL exports the documented functions and no others.
dll_by_mingw() {
    unpacked_dll "$1"
    x86_64-w64-mingw32-objdump -p windows/bin/*.dll | sed -n '/RVA/!s/^\t\[ *[0-9]*\].* //p' | sort > exported
    sort "$root/tests/symbols.txt" | diff - exported
    x86_64-w64-mingw32-gcc -O2 -Iwindows/include windows/example.c windows/lib/*.dll.a -o example.exe
    wine ./example.exe | retargets "$1"
    package=$(basename windows/lib/cmake/*)
    cat > CMakeLists.txt << END
cmake_minimum_required(VERSION 3.12)
project(example C)
find_package($package 0.1 CONFIG REQUIRED)
add_executable(move windows/example.c)
target_link_libraries(move PRIVATE $package::$package)
END
    cmake -S . -B build -DCMAKE_SYSTEM_NAME=Windows -DCMAKE_SYSTEM_PROCESSOR=x86_64 -DCMAKE_C_COMPILER=x86_64-w64-mingw32-gcc \
        -DCMAKE_PREFIX_PATH="$PWD/windows"
    cmake --build build
    cp build/move.exe .
    x86_64-w64-mingw32-objdump -p move.exe | grep 'DLL Name: libatraj'
    wine ./move.exe | retargets "$1"
    mv -- *.dll elsewhere
    ! wine ./example.exe
}

# There is no library of Microsoft's here, so the program has none: it tells by its exit code what it found.
dll_by_lld_link() {
    unpacked_dll "$1"
    clang --target=x86_64-pc-windows-msvc -O2 -ffreestanding -Iwindows/include -c "$root/tests/consumers/windows.c" -o program.obj
    lld-link -nodefaultlib -subsystem:console -entry:start -out:program.exe program.obj windows/lib/*.dll.a \
        "$(x86_64-w64-mingw32-gcc -print-file-name=libkernel32.a)"
    status=0
    wine ./program.exe || status=$?
    test $status = 42
}

# --- Debian's packages, and the site

debian_packages() {
    for package in "$release"/*.deb; do dpkg-deb -x "$package" debian; done
    flags=$(PKG_CONFIG_PATH=$(echo debian/usr/lib/*/pkgconfig) pkg-config --cflags --libs atraj)
    "${CC:-cc}" "$root/examples/06_retarget.c" -o example $flags
    LD_LIBRARY_PATH=$(echo debian/usr/lib/*-gnu) ./example | retargets double
}

site_is_whole() {
    tar xzf "$release/atraj-$version-site.tar.gz"
    for page in index $(cd "$root" && ls docs/*.md | sed 's/\.md$//'); do
        test -s "atraj-$version-site/$page.html" || { echo "no $page.html"; exit 1; }
    done
    cmp "atraj-$version-site/playground.html" "$release/atraj-$version-playground.html"
}

# --- package managers, each by a stand-in, because none of their servers is asked

# Every folder of the library for Arduino has the archive of the release. The sketch is compiled and linked as for two boards.
arduino() {
    unzip -q "$release/atraj-$version-arduino.zip"
    grep -v '^#' "$root/packaging/arduino/boards.txt" > boards
    test "$(find atraj/src -name '*.a' | wc -l)" = "$(wc -l < boards)"
    while read -r place target; do
        tar xzOf "$release/atraj-$version-$target-float.tar.gz" "atraj-$version-$target-float/lib/libatraj-float.a" | cmp - "atraj/src/$place/libatraj-float.a"
    done < boards
    cp "$root/tests/consumers/Arduino.h" .
    cp atraj/examples/Jog/Jog.ino jog.cpp
    sketch cortex-m4/fpv4-sp-d16-hard -mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16
    sketch cortex-m0plus -mcpu=cortex-m0plus
    if sketch cortex-m0plus -mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16; then return 1; fi
}

# sketch PLACE FLAGS…
sketch() {
    place=$1
    shift
    arm-none-eabi-g++ -Os -mthumb "$@" -fno-exceptions -fno-rtti -include Arduino.h -Iatraj/src -c jog.cpp
    arm-none-eabi-gcc -mthumb "$@" --specs=nosys.specs jog.o "-Latraj/src/$place" -latraj-float -lm -o jog.elf
}

# PlatformIO packs the library, and builds its example for boards that are described here, with Debian's compilers: PlatformIO's own boards
# and compilers are not on PyPI.
platformio() {
    unzip -q "$release/atraj-$version-arduino.zip"
    cp "$root/tests/consumers/Arduino.h" .
    export PLATFORMIO_CORE_DIR=$PWD/core PLATFORMIO_SETTING_ENABLE_TELEMETRY=no
    pio pkg pack -o packed.tar.gz atraj
    tar tzf packed.tar.gz | grep -x 'src/cortex-m3/libatraj-float.a'
    scons_for_pio
    mkdir -p core/platforms
    cp -R "$root/tests/consumers/platformio" core/platforms/desk
    arm='arm-none-eabi- --specs=nosys.specs -mthumb'
    example_on nrf52840 $arm -mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16 > built
    grep -F -e '-Llib/atraj/src/cortex-m4/fpv4-sp-d16-hard ' built
    example_on samd21 $arm -mcpu=cortex-m0plus > built
    grep -F -e '-Llib/atraj/src/cortex-m0plus ' built
    example_on esp32c3 riscv64-unknown-elf- --specs=picolibc.specs -march=rv32imc -mabi=ilp32 > built
    grep -F -e '-Llib/atraj/src/esp32c3 ' built
    refused 'has no archive for' example_on stm32f4 $arm -mcpu=cortex-m4
    refused 'has no archive for esp32s3' example_on esp32s3 arm-none-eabi-
}

pio() { "$root/target/venv/bin/python" "$root/tests/consumers/pio.py" "$@"; }

# PlatformIO looks for SCons among its packages. Here it is PyPI's.
scons_for_pio() {
    scons=core/packages/tool-scons
    mkdir -p $scons
    needed=$("$root/target/venv/bin/python" -c \
        'from platformio.dependencies import get_core_dependencies as all; print(all()["tool-scons"].lstrip("~"))')
    echo '{"name": "tool-scons", "version": "'"$needed"'"}' > $scons/package.json
    echo '{"type": "tool", "name": "tool-scons", "version": "'"$needed"'", "spec": {"owner": "platformio", "name": "tool-scons"}}' > $scons/.piopm
    printf 'from SCons.Script.Main import main\n\nmain()\n' > $scons/scons.py
}

# example_on MCU COMPILER FLAGS…: builds the example for a board
example_on() {
    mcu=$1 compiler=$2
    shift 2
    mkdir -p core/platforms/desk/boards
    cat > "core/platforms/desk/boards/$mcu.json" << END
{"name": "$mcu", "vendor": "desk", "url": "https://example.org", "frameworks": ["arduino"],
"upload": {"maximum_size": 1048576, "maximum_ram_size": 262144}, "build": {"mcu": "$mcu"},
"desk": {"compiler": "$compiler", "flags": "$* -I$PWD"}}
END
    pio ci atraj/examples/Jog/Jog.ino --lib atraj --board "$mcu" --verbose
}

cmsis_pack() {
    unzip -q "$release/atraj.atraj.$version.pack"
    xmllint --noout atraj.atraj.pdsc
    for file in $(sed -n 's/.*<file .* name="\([^"]*\)".*/\1/p' atraj.atraj.pdsc) LICENSE-MIT; do test -e "$file"; done
    test "$(xmllint --xpath 'string(//release/@version)' atraj.atraj.pdsc)" = "$version"
}

# vcpkg's functions, as far as the port calls them. A program finds what the port installs.
vcpkg_port() {
    unzip -q "$release/atraj-$version-vcpkg.zip"
    python3 -m json.tool vcpkg/atraj/vcpkg.json
    cat > stand-in.cmake << END
set(VERSION $version)
set(PORT atraj)
set(TARGET_TRIPLET x64-linux)
set(VCPKG_TARGET_IS_LINUX TRUE)
set(VCPKG_TARGET_ARCHITECTURE x64)
set(VCPKG_LIBRARY_LINKAGE static)
set(CURRENT_PACKAGES_DIR "$PWD/packages")
function(vcpkg_download_distfile variable)
    cmake_parse_arguments(arg "" "URLS;FILENAME;SHA512" "" \${ARGN})
    file(SHA512 "$release/\${arg_FILENAME}" sum)
    if(NOT sum STREQUAL arg_SHA512)
        message(FATAL_ERROR "another checksum")
    endif()
    set(\${variable} "$release/\${arg_FILENAME}" PARENT_SCOPE)
endfunction()
function(vcpkg_extract_source_archive variable)
    cmake_parse_arguments(arg "" "ARCHIVE" "" \${ARGN})
    file(ARCHIVE_EXTRACT INPUT "\${arg_ARCHIVE}" DESTINATION "$PWD/source")
    file(GLOB folder "$PWD/source/*")
    set(\${variable} "\${folder}" PARENT_SCOPE)
endfunction()
function(vcpkg_fixup_pkgconfig)
endfunction()
function(vcpkg_install_copyright)
    cmake_parse_arguments(arg "" "" "FILE_LIST" \${ARGN})
    file(INSTALL \${arg_FILE_LIST} DESTINATION "\${CURRENT_PACKAGES_DIR}/share/\${PORT}")
endfunction()
include("$PWD/vcpkg/atraj/portfile.cmake")
END
    cmake -P stand-in.cmake
    test -z "$(find packages -name '*.so*')"
    cmake -S "$root/tests/consumers" -B build -DSOURCE=move.c -DLIBRARY=atraj::static -DCMAKE_PREFIX_PATH="$PWD/packages"
    cmake --build build
    build/move | grep .
    grep "atraj_DIR:PATH=$PWD/packages/share/atraj" build/CMakeCache.txt
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
    grep "\"purl\": \"pkg:cargo/atraj@$version\"" "$release/atraj-$version.cdx.json"
    test -z "$(grep -F -e "$root" -e serialNumber "$release/atraj-$version.cdx.json")"
}

# --- another clone, in another folder, by a user who shows files to nobody

another=$work/another/folder/atraj
again=$another/target/release-$version

another_clone() {
    ssh-keygen -q -t ed25519 -N '' -C release -f "$work/key"
    git clone --quiet "$root" "$another"
    (umask 077 && make -s -C "$another" release KEY="$work/key" BILL_TOOL="$(ls "$root"/target/cargo-cyclonedx-*/bin/cargo-cyclonedx)" \
        TARGETS="$host x86_64-pc-windows-gnu thumbv7em-none-eabihf" ABIS='double float' PARTS=debian)
    test "$(find "$again" -name '*.tar.gz' | wc -l)" = 7
    for file in "$again"/*atraj*; do cmp "$file" "$release/${file##*/}"; done
}

signed() {
    echo "release@example.org $(cat "$work/key.pub")" > signers
    ssh-keygen -Y verify -f signers -I release@example.org -n file -s "$again/SHA256SUMS.sig" < "$again/SHA256SUMS"
    sed '1s/^./x/' "$again/SHA256SUMS" > forged
    ! ssh-keygen -Y verify -f signers -I release@example.org -n file -s "$again/SHA256SUMS.sig" < forged
}

# Without archives no package can be made, and each is named.
fewer_targets() {
    mkdir release archives
    here=$PWD
    (cd "$root" && SOURCE_DATE_EPOCH=0 packaging/managers.sh "$here/release" "$here/archives") > said
    cat said
    test "$(grep -c 'is left out, because this release has no' said)" = 3
    test -z "$(ls release)"
}

row "no Rust on the path" no_rust
row "zig and PlatformIO from PyPI" zig_from_pypi
row "a file for every chip, host and real type" complete
for name in $(ls "$release" | sed -n 's/^\(atraj-.*-\(double\|float\|compact\)\)\.tar\.gz$/\1/p'); do
    row "$name: README and example" told_once "$name"
    row "$name: from release to program" from_release_to_program "$name"
done
# claraty.c waits for the clock of the system, which the archive for Windows does not read.
tests='golden abi calls axis'
for abi in double float; do
    row "golden rows and contracts, AArch64 Linux, $abi" \
        replays "$tests claraty" aarch64-unknown-linux-gnu $abi aarch64-linux-gnu-gcc qemu-aarch64 -L /usr/aarch64-linux-gnu
    row "golden rows and contracts, ARMv7 Linux, $abi" \
        replays "$tests claraty" armv7-unknown-linux-gnueabihf $abi arm-linux-gnueabihf-gcc qemu-arm -L /usr/arm-linux-gnueabihf
    row "golden rows and contracts, musl, $abi" replays "$tests claraty" x86_64-unknown-linux-musl $abi musl-gcc env
    row "golden rows and contracts, AArch64 musl, $abi" \
        replays "$tests claraty" aarch64-unknown-linux-musl $abi "$tools/zig cc -target aarch64-linux-musl" qemu-aarch64
    row "golden rows and contracts, Windows, $abi" \
        replays "$tests" x86_64-pc-windows-gnu $abi x86_64-w64-mingw32-gcc wine
    row "the DLL, linked by MinGW, $abi" dll_by_mingw $abi
    row "the DLL, linked by lld-link for Microsoft's ABI, $abi" dll_by_lld_link $abi
done
row "Debian's packages hold the library" debian_packages
row "the site has every page" site_is_whole
row "Arduino's library" arduino
row "PlatformIO's library" platformio
row "CMSIS-Pack" cmsis_pack
row "vcpkg's port" vcpkg_port
row "a release of fewer targets leaves packages out" fewer_targets
row "sources build without a network" sources
row "bill of materials" bill
row "another clone makes the same files" another_clone
row "signed" signed
finish
