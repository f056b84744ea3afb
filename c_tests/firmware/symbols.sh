#!/bin/sh
# symbols.sh ARCHIVE API: fails unless the archive
#   - gives the linker the functions listed in API and no other symbol,
#   - needs only symbols that every C toolchain has,
#   - cannot panic,
#   - has no unwind tables,
#   - has a note that is not loaded, so it takes no flash,
#   - needs the memory functions only in CLARAty, atraj.h and atraj/move.h, which copy enough at once: a move, several axes. liba's
#     functions must not need them.
set -eu
archive=$1 api=$2
symbols=$(readelf -Ws "$archive" | awk '$4 != "FILE" && $8 != "" && $7 != "Ndx" { print $5, ($7 == "UND" ? "U" : "D"), $8 }')
# Software floating point of the Arm run-time ABI and of libgcc.
soft='__aeabi_([df](add|sub|rsub|mul|div|cmp[a-z]+|2[a-z]+)|[iu]i?2[df])|__((add|sub|mul|div|eq|ne|lt|le|gt|ge|unord)[sd]f[23]|float(un)?si[sd]f|fix[sd]fsi)'
memory='(__aeabi_)?mem(cpy|set|move|clr)[48]?'

fail() { echo "$archive: $1" >&2; exit 1; }

test "$(echo "$symbols" | awk '$1 != "LOCAL" && $2 == "D" { print $3 }' | LC_ALL=C sort)" = "$(cat "$api")" ||
    fail "defined symbols differ from $api"
foreign=$(echo "$symbols" | awk '$2 == "U" { print $3 }' | grep -vxE "sqrtf?|$soft|$memory" || true)
test -z "$foreign" || fail "undefined: $(echo $foreign)"
readelf -Wr "$archive" | awk -v memory=" $memory" '/^Relocation section/ { place = $3 }
    $0 ~ memory && place !~ /claraty|online|together|sampl(e|ing)|\.atraj_|capi5atraj/ { print; found = 1 } END { exit found }' || fail "memory functions in what liba has too"
! echo "$symbols" | grep panic || fail "can panic"
! readelf -WS "$archive" | grep -E 'ARM\.ex|eh_frame' || fail "unwind tables"
readelf -WS "$archive" | grep -qE '\.atraj\.note +NOTE +([0-9a-f]+ +){4} [0-9]+ ' || fail "no note, or a loaded one"
echo "$archive: $(wc -l < "$api") functions; needs $(echo "$symbols" | awk '$2 == "U" { print $3 }' | paste -sd ' ')"
