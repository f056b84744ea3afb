#!/bin/sh
# deb.sh DIST NAME VERSION: packs DIST as two Debian packages in target/deb, the shared library and the files to build with.
#
# DEBFULLNAME and DEBEMAIL name the maintainer, as in Debian's own tools. Dates are SOURCE_DATE_EPOCH, or the last commit's.
set -eu
dist=$1 name=$2
: "${DEBFULLNAME:?make deb needs the maintainer: set DEBFULLNAME and DEBEMAIL}"
: "${DEBEMAIL:?make deb needs the maintainer: set DEBFULLNAME and DEBEMAIL}"
test -n "${SOURCE_DATE_EPOCH:-}" || SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH
# The revision is below that of a package by Debian.
version=$3-0upstream1
soversion=${3%%.*}
library=lib$name$soversion
development=lib$name-dev
architecture=$(dpkg --print-architecture)
libdir=usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)
out=$PWD/target/deb
work=$out/work-$name
rm -rf "$work"
umask 022
mkdir -p "$work"

# Headers stand in a folder of their own, because liba has an a/a.h too.
DESTDIR=$work/$development PREFIX=/usr LIBDIR=/$libdir INCLUDEDIR=/usr/include/atraj packaging/install.sh install "$dist" "$name"
rm -r "$work/$development/usr/share"
(cd "$work/$development" && find "$libdir" -name "lib$name.so.*") | while read -r file; do
    mkdir -p "$work/$library/$(dirname "$file")"
    mv "$work/$development/$file" "$work/$library/$file"
done
find "$work/$library" -type f -exec strip --strip-unneeded --remove-section=.comment {} +
strip --strip-debug --remove-section=.comment --enable-deterministic-archives "$work/$development/$libdir/lib$name.a"

# documents PACKAGE: the licences and the change logs
documents() {
    folder=$work/$1/usr/share/doc/$1
    mkdir -p "$folder" "$work/$1/DEBIAN"
    {
        printf 'Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\n\n'
        printf 'Files: *\n%s\nLicense: Expat or Apache-2.0\n\n' "$(sed -n 's/^Copyright (c)/Copyright:/p' LICENSE-MIT)"
        printf 'License: Expat\n'
        sed '1,4d; s/^$/./; s/^/ /' LICENSE-MIT
        printf '\nLicense: Apache-2.0\n On Debian the text is in /usr/share/common-licenses/Apache-2.0.\n'
    } > "$folder/copyright"
    gzip -9n < CHANGELOG.md > "$folder/changelog.gz"
    printf 'atraj (%s) unstable; urgency=medium\n\n  * This release: changelog.gz.\n\n -- %s <%s>  %s\n' "$version" \
        "$DEBFULLNAME" "$DEBEMAIL" "$(date -uR -d "@$SOURCE_DATE_EPOCH")" | gzip -9n > "$folder/changelog.Debian.gz"
}

# pack PACKAGE SECTION DEPENDS SUMMARY DESCRIPTION
pack() {
    documents "$1"
    cat > "$work/$1/DEBIAN/control" << END
Package: $1
Source: atraj
Version: $version
Architecture: $architecture
Multi-Arch: same
Maintainer: $DEBFULLNAME <$DEBEMAIL>
Section: $2
Priority: optional
Depends: $3
Description: $4
 $5
END
    (cd "$work/$1" && find usr -type f | LC_ALL=C sort | xargs md5sum > DEBIAN/md5sums)
    dpkg-deb --root-owner-group -Zxz --build "$work/$1" "$out/${1}_${version}_$architecture.deb"
}

echo "lib$name $soversion $library (>= $3)" | install -Dm 644 /dev/stdin "$work/$library/DEBIAN/shlibs"
echo 'activate-noawait ldconfig' > "$work/$library/DEBIAN/triggers"
mkdir "$work/debian"
printf 'Source: atraj\n\nPackage: %s\nArchitecture: any\n' "$library" > "$work/debian/control"
(cd "$work" && dpkg-shlibdeps -Tneeded "$library/$libdir/lib$name.so.$3")
profiles='Double-S, trapezoidal and polynomial profiles with the bits of liba and
 CLARAty, and the fastest moves from any state to any state, for one axis or
 several.'
pack "$library" libs "$(sed -n 's/^shlibs:Depends=//p' "$work/needed")" 'motion profiles for one axis or several' "$profiles"
pack "$development" libdevel "$library (= $version)" 'motion profiles for one axis or several: headers and archive' \
    "$profiles
 .
 This package holds the headers, the static library and the files for
 pkg-config and CMake."
rm -r "$work"
