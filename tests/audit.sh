#!/usr/bin/env bash
# audit.sh [TEST…]: plants the fault of each row of docs/data/audit.csv, or of the rows of these tests, and demands that the test of the row fails.
# Then the row gets the date.
set -euo pipefail
table=$PWD/docs/data/audit.csv
tree=$PWD/target/audit/tree
rm -rf "$tree"
mkdir -p "$tree"
git ls-files -z | xargs -0 cp -p --parents -t "$tree"
cd "$tree"
export CARGO_TARGET_DIR=${tree%/*}/build
unseen=0

# command TEST: how a test runs, by where its file stands.
command() {
    if test -e "$1"; then
        run=("$1")
        return
    fi
    run=(cargo test --quiet --locked --profile mutants --test "$1")
    case $(git -C "${tree%/target/*}" ls-files "*/$1.rs" "tests/$1.rs") in
    tests/oracle/*) run+=(-p oracle) ;;
    tests/miri/*) run+=(-p pointers) ;;
    tests/handover/*) run+=(-p handover) ;;
    esac
}

while IFS=, read -r promise test file code fault seen; do
    test $# = 0 || [[ " $* " == *" $test "* ]] || continue
    test "$promise" != promise || continue
    cp "$file" "$file.before"
    CODE=$code FAULT=$fault perl -0 -pi -e 's/\Q$ENV{CODE}\E/$ENV{FAULT}/' "$file"
    command "$test"
    if cmp -s "$file" "$file.before"; then
        said='there is no such code'
    elif test "$test" != "${run[0]}" && ! "${run[@]}" --no-run > ../log 2>&1 < /dev/null; then
        said='the fault does not compile'
    elif "${run[@]}" > ../log 2>&1 < /dev/null; then
        said='the test passes'
    else
        said=seen
    fi
    mv "$file.before" "$file"
    # A new time: else cargo keeps the build with the fault.
    touch "$file"
    echo "$test, $file: $said"
    test "$said" = seen || { unseen=1 && continue; }
    ROW="$promise,$test,$file,$code,$fault," DATE=$(date -u +%F) perl -pi -e 's/^\Q$ENV{ROW}\E.*/$ENV{ROW}$ENV{DATE}/' "$table"
done < "$table"
exit "$unseen"
