#!/bin/sh
# object.sh MESSAGES OBJECT: takes our object out of the static library that cargo names in MESSAGES. AR and NM are the
# target's tools.
#
# Cargo rebuilds its library whenever a flag, a profile or the toolchain changes. A file that `--emit=obj=…` names has no such
# guard.
set -eu
messages=$1 object=$2
overrides='unset the CARGO_PROFILE_* variables and the same settings in RUSTFLAGS'

fail() {
    echo "$1: $overrides." >&2
    exit 1
}

library=$(sed -n 's|.*"filenames":\["\([^"]*/libatraj\.a\)".*|\1|p' "$messages")
ours=$("$AR" t "$library" | grep '^atraj')
test "$(echo "$ours" | wc -l)" = 1 || fail 'This profile splits the library into several objects'
"$AR" p "$library" "$ours" > "$object"
runtime=$("$NM" -u "$object" | awk '$2 ~ /^(rust_|__rust|_Unwind|_ZN|_R)/ { print $2; exit }')
test -z "$runtime" || fail "This profile leaves code that needs Rust's runtime ($runtime)"
