#!/bin/sh
# pages.sh DIRECTORY: writes the guide into this directory, a page for README.md and for each document in docs. rustdoc makes HTML of
# Markdown, so the guide needs no tool besides those of the references.
set -eu
cd "$(dirname "$0")/../.."
out=$1

# page DOCUMENT NAME: links between documents become links between pages. What has no page, because it is for those who have the
# repository, becomes plain text.
page() {
    rustdoc "$1" --output "$out" --markdown-no-toc --markdown-css style.css --html-before-content docs/site/navigation.html
    sed -e 's|\(href="\)docs/|\1|g; s|\(src="\)docs/|\1|g' \
        -e 's#<a href="\(\.\./\)*\(CONTRIBUTING\|[a-z]*/README\)\.md">\([^<]*\)</a>#\3#g' \
        -e 's|href="\.\./README\.md|href="overview.html|g; s|href="README\.md|href="index.html|g' \
        -e 's|\(href="[^":]*\)\.md\([#"]\)|\1.html\2|g' "$out/$(basename "$1" .md).html" > "$out/page"
    mv "$out/page" "$out/$2.html"
}

mkdir -p "$out"
cp -R docs/img docs/site/style.css "$out"
for document in docs/*.md; do
    page "$document" "$(basename "$document" .md)"
done
mv "$out/README.html" "$out/index.html"
page README.md overview
rm "$out/README.html"
