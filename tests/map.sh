#!/bin/sh
# map.sh: prints the map of the tests: each file with the first sentence of its head, which is the question that it answers.
set -eu
cd "$(dirname "$0")/.."
for folder in tests tests/*/tests c_tests fuzz/src/bin python/tests playground/tests; do
    printf '\n## In `%s`\n| file | question |\n|---|---|\n' "$folder"
    for file in "$folder"/*.rs "$folder"/*.c "$folder"/*.cpp "$folder"/*.py "$folder"/*.js "$folder"/*.sh; do
        test -e "$file" || continue
        awk -v name="${file##*/}" '
            { gsub(/^(\/\/!?|\/\*|#!.*|#|"""| )+|"""$|\*\/$/, ""); sub(name ":? *", "") }
            $0 == "" && text == "" { next }
            { text = text (text == "" ? "" : " ") $0 }
            match(text, /[?.]( |$)/) { text = substr(text, 1, RSTART); exit }
            END { gsub(/\|/, "\\|", text); printf "| `%s` | %s |\n", name, text }' "$file"
    done
done
