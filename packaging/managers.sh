#!/bin/sh
# managers.sh RELEASE WORK: packs what package managers of firmware and of C++ take, of the archives that are unpacked in WORK, into
# RELEASE: a library for Arduino and PlatformIO, a CMSIS-Pack, and a port for vcpkg, which fetches the archives of RELEASE. A release of
# fewer targets or of one ABI leaves out the packages that need others, and says so.
set -eu
release=$1 work=$2
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml)
date=$(date -u -d "@$SOURCE_DATE_EPOCH" +%Y-%m-%d)

# filled FILE: the file with version and date
filled() { sed "s/@VERSION@/$version/g; s/@DATE@/$date/g" "$1"; }

# zipped FOLDER NAME FILE: packs NAME of the folder, with the same bytes in every clone
zipped() {
    (
        cd "$1"
        find "$2" -exec touch -h -d "@$SOURCE_DATE_EPOCH" {} +
        rm -f "$3"
        find "$2" -type f | LC_ALL=C sort | TZ=UTC zip -q -X -@ "$3"
    )
}

# has PACKAGE ABI TARGET…: whether the archives of a package are there
has() {
    package=$1 abi=$2
    shift 2
    for target; do
        test -d "$work/atraj-$version-$target-$abi" || {
            echo "the package for $package is left out, because this release has no atraj-$version-$target-$abi"
            return 1
        }
    done
}

# placed TARGET FOLDER INCLUDE: copies the archive of the target and its headers
placed() {
    mkdir -p "$2"
    cp "$work/atraj-$version-$1-float/lib/libatraj-float.a" "$2"
    cp -R "$work/atraj-$version-$1-float/include/." "$3"
}

arduino() {
    library=$work/atraj
    rm -rf "$library"
    mkdir -p "$library/src" "$library/examples/Jog"
    grep -v '^#' packaging/arduino/boards.txt | while read -r place target; do
        placed "$target" "$library/src/$place" "$library/src"
    done
    filled packaging/arduino/library.properties > "$library/library.properties"
    filled packaging/arduino/library.json > "$library/library.json"
    cp packaging/arduino/archive.py CHANGELOG.md LICENSE-* "$library"
    cp packaging/arduino/Jog.ino "$library/examples/Jog"
    printf '# atraj %s\nMotion profiles for one axis or several, compiled for the processors whose folders are in `src`. `a_float` is float.\n' \
        "$version" > "$library/README.md"
    zipped "$work" atraj "$release/atraj-$version-arduino.zip"
}

cmsis() {
    pack=$work/pack
    rm -rf "$pack"
    mkdir -p "$pack/include"
    filled packaging/cmsis/atraj.pdsc > "$pack/atraj.atraj.pdsc"
    cp LICENSE-* CHANGELOG.md "$pack"
    for target; do placed "$target" "$pack/lib/$target" "$pack/include"; done
    zipped "$pack" . "$release/atraj.atraj.$version.pack"
}

vcpkg() {
    port=$work/vcpkg/atraj
    rm -rf "$work/vcpkg"
    mkdir -p "$port"
    filled packaging/vcpkg/vcpkg.json > "$port/vcpkg.json"
    cp packaging/vcpkg/portfile.cmake "$port"
    for target; do
        checksum=$(sha512sum "$release/atraj-$version-$target-double.tar.gz" | cut -d ' ' -f 1)
        sed -i "s/@SHA512_$target@/$checksum/" "$port/portfile.cmake"
    done
    zipped "$work" vcpkg "$release/atraj-$version-vcpkg.zip"
}

boards=$(awk '!/^#/ { print $2 }' packaging/arduino/boards.txt)
cores=$(sed -n 's/.*name="lib\/\(.*\)\/libatraj-float\.a".*/\1/p' packaging/cmsis/atraj.pdsc)
systems=$(sed -n 's/.*@SHA512_\(.*\)@.*/\1/p' packaging/vcpkg/portfile.cmake)
# shellcheck disable=SC2086 # a list of words
{
    if has 'Arduino and PlatformIO' float $boards; then arduino; fi
    if has CMSIS float $cores; then cmsis $cores; fi
    if has vcpkg double $systems; then vcpkg $systems; fi
}
