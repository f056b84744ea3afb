#!/bin/sh
# address.sh URL [MAINTAINER]: writes the address of the repository, and the maintainer `Name <mail>`, into every file that names them. The site's
# address on GitHub follows from it; elsewhere the link to the site leads to the repository.
set -eu
url=${1%.git} maintainer=${2:-}
case $url in
https://*/*) ;;
*)
    echo 'usage: address.sh URL [MAINTAINER], where URL is an address that begins with https://' >&2
    exit 1
    ;;
esac

# replaced OLD NEW: in the files of git, which may not be committed yet
replaced() {
    git grep --untracked -IlF -e "$1" | while read -r file; do
        OLD=$1 NEW=$2 awk '{
            line = ""
            while (at = index($0, ENVIRON["OLD"])) {
                line = line substr($0, 1, at - 1) ENVIRON["NEW"]
                $0 = substr($0, at + length(ENVIRON["OLD"]))
            }
            print line $0
        }' "$file" > "$file.new"
        cat "$file.new" > "$file"
        rm "$file.new"
    done
}

site() { echo "$1" | sed 's|^https://github.com/\([^/]*\)/\(.*\)|https://\1.github.io/\2/|'; }

old=$(sed -n 's/^repository = "\(.*\)"/\1/p' Cargo.toml)
replaced "$old" "$url"
replaced "$(site "$old")" "$(site "$url")"
test -z "$maintainer" || replaced "$(sed -n 's/^Maintainer: //p' debian/control)" "$maintainer"
