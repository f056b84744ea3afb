#!/bin/sh
# debian.sh install [GOAL…]: installs what debian-packages.txt names for these goals, or for all.
# debian.sh tools GOAL: fails if a tool of the goal is missing, and names the package.
set -eu
action=$1
shift
wanted=$(awk -v goals=" $* " '!/^#/ && NF && (goals == "  " || index(goals, " " $1 " ")) { $1 = ""; print }' \
    "$(dirname "$0")/debian-packages.txt")
test -n "$wanted" || { echo "packaging/debian-packages.txt has no line for $*." >&2; exit 1; }

# there PACKAGE, PACKAGE=TOOL or PACKAGE=COMPILER:FILE
there() {
    case $1 in
    *:*) compiler=${1#*=} && test -e "$("${compiler%:*}" -print-file-name="${compiler#*:}" 2> /dev/null)" ;;
    *=*) command -v "${1#*=}" > /dev/null ;;
    *) test "$action" = tools || dpkg -s "$1" > /dev/null 2>&1 ;;
    esac
}

missing=
for package in $wanted; do
    there "$package" || missing="$missing ${package%%=*}"
done
test -n "$missing" || exit 0
if test "$action" = tools; then
    echo "Debian packages are missing:$missing (sudo make setup FOR=$1)." >&2
    exit 1
fi
test "$(id -u)" = 0 || { echo 'make setup installs packages of Debian, so it needs root: sudo make setup.' >&2; exit 1; }
apt-get update -qq
# shellcheck disable=SC2086
DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends $missing
