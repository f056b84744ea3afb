#!/bin/sh
# symbols.sh ARCHIVE API CALLS: fails unless the archive
#   - gives the linker the functions listed in API and no other symbol,
#   - needs only what CALLS says in the words of packaging/chips.txt, and the memory functions,
#   - cannot panic,
#   - has no unwind tables,
#   - has a note that is not loaded, so it takes no flash,
#   - needs the memory functions only above `src/liba`, where enough is copied at once: a move, several axes. liba's functions must not
#     need them.
set -eu
archive=$1 api=$2 calls=$3
symbols=$(readelf -Ws "$archive" | awk '$4 != "FILE" && $8 != "" && $7 != "Ndx" { print $5, ($7 == "UND" ? "U" : "D"), $8 }')
# Software floating point of the Arm run-time ABI, and of libgcc where no unit computes in binary32 either.
double='__aeabi_(d(add|sub|rsub|mul|div|cmp[a-z]+|2[a-z]+)|[iu]i?2d)'
any="$double|__aeabi_(f(add|sub|rsub|mul|div|cmp[a-z]+|2[a-z]+)|[iu]i?2f)|__((add|sub|mul|div|eq|ne|lt|le|gt|ge|unord)[sd]f[23]|float(un)?si[sd]f|fix[sd]fsi)"
memory='(__aeabi_)?mem(cpy|set|move|clr)[48]?'

needed=$memory
case $calls in
*'software floating point'*) needed="$needed|$any" ;;
*'software `double`'*) needed="$needed|$double" ;;
esac
case $calls in *'`sqrt`'*) needed="$needed|sqrt" ;; esac
case $calls in *'`sqrtf`'*) needed="$needed|sqrtf" ;; esac

fail() { echo "$archive: $1" >&2; exit 1; }

test "$(echo "$symbols" | awk '$1 != "LOCAL" && $2 == "D" { print $3 }' | LC_ALL=C sort)" = "$(cat "$api")" ||
    fail "defined symbols differ from $api"
foreign=$(echo "$symbols" | awk '$2 == "U" { print $3 }' | grep -vxE "$needed" || true)
test -z "$foreign" || fail "calls not only $calls, but $(echo $foreign)"
readelf -Wr "$archive" | awk -v memory=" $memory" '/^Relocation section/ { place = $3 }
    $0 ~ memory && place ~ /4liba|\.a_traj/ { print place, $0; found = 1 } END { exit found }' || fail "memory functions in liba's functions"
! echo "$symbols" | grep panic || fail "can panic"
! readelf -WS "$archive" | grep -E 'ARM\.ex|eh_frame' || fail "unwind tables"
readelf -WS "$archive" | grep -qE '\.atraj\.note +NOTE +([0-9a-f]+ +){4} [0-9]+ ' || fail "no note, or a loaded one"
echo "$archive: $(wc -l < "$api") functions; needs $(echo "$symbols" | awk '$2 == "U" { print $3 }' | paste -sd ' ')"
