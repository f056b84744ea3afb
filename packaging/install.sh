#!/bin/sh
# install.sh install|uninstall DIST NAME: copies the files of DIST to DESTDIR, or removes them from there. DESTDIR, PREFIX,
# LIBDIR and INCLUDEDIR come from the Makefile.
#
# The default ABI has its headers in INCLUDEDIR. Every other ABI has headers of its own in INCLUDEDIR/NAME.
set -eu
action=$1 dist=$2 name=$3
case $name in
atraj) headers=$INCLUDEDIR ;;
*) headers=$INCLUDEDIR/$name ;;
esac

# place FILE: where this file of DIST is installed
place() {
    case $1 in
    lib/*) printf '%s\n' "$DESTDIR$LIBDIR/${1#lib/}" ;;
    include/*) printf '%s\n' "$DESTDIR$headers/${1#include/}" ;;
    *) printf '%s\n' "$DESTDIR$PREFIX/$1" ;;
    esac
}

# each_file COMMAND: calls the command with each file of DIST
each_file() {
    (cd "$dist" && find -- * ! -type d) | while read -r file; do "$1" "$file"; done
}

# machine PC: the machine that a pkg-config file stands for
machine() { sed -n 's/^machine=//p' "$1"; }

pc=lib/pkgconfig/$name.pc
installed=$(place "$pc")
if test -e "$installed" && test "$(machine "$installed")" != "$(machine "$dist/$pc")"; then
    echo "$DESTDIR$LIBDIR holds $name for $(machine "$installed"), this one is for $(machine "$dist/$pc"):" \
        "take another PREFIX, or uninstall the installed one by its own TARGET and CPU." >&2
    exit 1
fi

install_file() {
    to=$(place "$1")
    mkdir -p "$(dirname "$to")"
    case $1 in
    *.pc | *-config.cmake)
        sed "s|\.\./include|$(realpath -sm --relative-to="$LIBDIR" "$headers")|" "$dist/$1" > "$to"
        chmod 644 "$to"
        ;;
    *)
        if test -L "$dist/$1"; then cp -P --remove-destination "$dist/$1" "$to"; else install -m 644 "$dist/$1" "$to"; fi ;;
    esac
}

uninstall_file() { rm -f "$(place "$1")"; }

# The folder of a file, seen from DESTDIR.
folder() { realpath -sm --relative-to="$DESTDIR/" "$(dirname "$(place "$1")")"; }

# The loader prefers these libraries, so none of another build may stay.
remove_levels() {
    levels=$DESTDIR$LIBDIR/glibc-hwcaps
    rm -f "$levels"/*/"lib$name.so".*
    test ! -d "$levels" || find "$levels" -type d -empty -delete
}

case $action in
install)
    umask 022
    remove_levels
    each_file install_file
    ;;
uninstall)
    each_file uninstall_file
    remove_levels
    # `rmdir -p` goes up while folders are empty. DESTDIR itself stays.
    each_file folder | sort -ru | while read -r folder; do
        (cd "$DESTDIR/" && rmdir -p "$folder") 2> /dev/null || true
    done
    ;;
esac
