#!/bin/sh
# figures.sh LIBRARY: prints "family size bytes" for each family of functions, "function size bytes" for each function, and
# "image size bytes" for the whole library linked with the C toolchain's libraries. CC is the compiler.
set -eu
library=$1
api=$(grep ^a_ ../../tests/symbols.txt) # the original has only these
object=$(mktemp)
trap 'rm -f "$object"' EXIT
text() { arm-none-eabi-size "$object" | awk 'NR == 2 { print $1 }'; }
roots() { printf -- "-Wl,-u,%s " $1; }

for family in trajbell trajtrap trajpoly; do
    functions=$(echo "$api" | grep "$family")
    $CC -nostdlib -r -Wl,--gc-sections $(roots "$functions") "$library" -o "$object"
    echo "$family size $(text)"
done
$CC -nostartfiles --specs=nano.specs --specs=nosys.specs -Wl,--gc-sections,--entry=a_trajbell_gen,--no-warn-rwx-segments,--no-warn-execstack $(roots "$api") \
    "$library" -lm -o "$object"
echo "image size $(text)"
arm-none-eabi-size -A "$library" | awk '$1 ~ /^\.text\../ { sub(/^\.text\.(a_traj)?/, "", $1); print $1, "size", $2 }'
