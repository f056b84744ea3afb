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
cp README.md CONTRIBUTING.md CHANGELOG.md "$source"
cp -R docs "$source"
cp examples/README.md "$source/examples"
cp proofs/README.md "$source/proofs"
{ cat tests/README.md && tests/map.sh; } > "$source/tests/README.md"
for page in docs/*.md; do awk -v from=docs -f docs/site/tables.awk "$page" > "$source/$page"; done

# program LANGUAGE FILE: a heading and the program
program() {
    printf '\n## %s\n```%s\n' "$1" "${2##*.}"
    cat "$2"
    printf '```\n'
}

# page NAME IDEA PICTURE
page() {
    printf '# %s\n%s.\n\n%s\n' "$(echo "$1" | tr _ ' ')" "$(echo "$2" | awk '{ print toupper(substr($0, 1, 1)) substr($0, 2) }')" "!$3"
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
    test "$file" != examples/README.md || sed 's/|.*//; s/.*/    - [&](examples\/&.md)/' "$book/examples"
done < docs/site/SUMMARY.md > "$source/SUMMARY.md"
