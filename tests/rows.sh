# Sourced by the shell tests. A row is one question; its answer is one line.
#
# A missing tool is printed. In CI it is a failure. ROWS is a regular expression for the titles of the rows to run; all by default.

root=$(cd "$(dirname "$0")/.." && pwd)
version=$(sed -n 's/^version = "\(.*\)"/\1/p' "$root/Cargo.toml")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0 skipped=0
unset MAKEFLAGS MAKELEVEL REAL POLY A_TRAJPOLY3 A_TRAJPOLY5 A_TRAJPOLY7 TARGET CPU HWCAPS DESTDIR PREFIX LIBDIR INCLUDEDIR \
    LD_LIBRARY_PATH RUSTFLAGS

# row TITLE COMMAND: runs the command in an empty folder. In the background, because under `if` a shell lets failing steps pass.
row() {
    title=$1
    shift
    echo "$title" | grep -qE -e "${ROWS:-}" || return 0
    folder=$work/rows/$((passed + failed))
    mkdir -p "$folder"
    (cd "$folder" && "$@") > "$work/log" 2>&1 &
    if wait $!; then
        passed=$((passed + 1))
        echo "passed   $title"
    else
        failed=$((failed + 1))
        echo "FAILED   $title"
        sed 's/^/         /' "$work/log"
    fi
}

# refused SENTENCE COMMAND: the command must fail and print the sentence. CMake breaks sentences into lines.
refused() {
    sentence=$1
    shift
    if "$@" > said 2>&1; then
        echo "not refused: $*"
        exit 1
    fi
    cat said
    tr -s ' \n' '  ' < said | grep -qF -e "$sentence"
}

# copy_of_the_sources FOLDER: without what other goals write into theirs, perhaps at this moment
copy_of_the_sources() {
    mkdir "$1"
    tar -C "$root" --exclude=./.git --exclude=target --exclude=node_modules --exclude=./fuzz/corpus --exclude=./fuzz/artifacts -cf - . |
        tar -C "$1" -xf -
}

# A path with every tool of this machine but Rust's.
tools_but_rust() {
    mkdir "$work/tools"
    for tool in /usr/bin/* /bin/*; do
        case ${tool##*/} in
        cargo* | rust*) ;;
        *) ln -sf "$tool" "$work/tools" ;;
        esac
    done
    echo "$work/tools"
}

# The versions of tests/consumers/requirements.txt from PyPI, in target/venv
tools_from_pypi() {
    test -x "$root/target/venv/bin/pip" || python3 -m venv "$root/target/venv"
    "$root/target/venv/bin/pip" install --quiet --disable-pip-version-check --requirement "$root/tests/consumers/requirements.txt"
}

have() {
    command -v "$1" > /dev/null && return
    skipped=$((skipped + 1))
    echo "SKIPPED  what needs $1: install it"
    return 1
}

finish() {
    echo "$passed passed, $failed failed, $skipped skipped"
    test $failed = 0
    test $skipped = 0 || test -z "${CI:-}"
}
