#!/bin/sh
# book.sh FOLDER: lays out the sources of the site for mdBook: the documents where they stand in the repository with their
# tables drawn, and a page for each example.
set -eu
cd "$(dirname "$0")/../.."
book=$1
source=$book/src
rm -rf "$book"
mkdir -p "$source/examples" "$source/tests" "$source/proofs"
cp docs/site/book.toml docs/site/style.css docs/site/access.js "$book"
cp CONTRIBUTING.md CHANGELOG.md "$source"
# Without the badge, which needs a network.
sed '/^\[!\[tests\]/d' README.md > "$source/README.md"
cp -R docs "$source"
cp examples/README.md "$source/examples"
cp proofs/README.md "$source/proofs"
{ cat tests/README.md && tests/map.sh; } > "$source/tests/README.md"
# The playground is a page of its own: the one in the contents leads to it.
printf '# Playground\n<meta http-equiv="refresh" content="0; url=../../playground.html">\n\n[Open the playground](../../playground.html)\n' \
    > "$source/docs/site/playground.md"
for page in docs/*.md; do awk -v from=docs -f docs/site/tables.awk "$page" > "$source/$page"; done

# program LANGUAGE FILE: a heading and the program
program() {
    printf '\n## %s\n```%s\n' "$1" "${2##*.}"
    cat "$2"
    printf '```\n'
}

# title NAME: the title of an example, which it prints first
title() {
    sed 's/:.*//; q' "examples/expected/$1.txt"
}

# page NAME IDEA PICTURE
page() {
    printf '# %s\n`%s`: %s.\n\n%s\n' "$(title "$1")" "$1" "$(echo "$2" | awk '{ print toupper(substr($0, 1, 1)) substr($0, 2) }')" "!$3"
    program C "examples/$1.c"
    program C++ "examples/$1.cpp"
    program Rust "examples/$1.rs"
}

# The rows of the table in examples/README.md: name, idea and picture.
sed -n 's/^| `\([0-9][^`]*\)` | \(.*\) | \(.*\) |$/\1|\2|\3/p' examples/README.md > "$book/examples"
while IFS='|' read -r name idea picture; do
    page "$name" "$idea" "$picture" > "$source/examples/$name.md"
done < "$book/examples"

# The contents: without a page that is not written, and with the examples.
while IFS= read -r line; do
    file=$(echo "$line" | sed -n 's/.*](\(.*\))$/\1/p')
    test -z "$file" || test -e "$source/$file" || continue
    echo "$line"
    test "$file" = examples/README.md || continue
    while IFS='|' read -r name rest; do echo "    - [$(title "$name")](examples/$name.md)"; done < "$book/examples"
done < docs/site/SUMMARY.md > "$source/SUMMARY.md"
