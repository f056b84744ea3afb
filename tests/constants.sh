#!/usr/bin/env bash
# constants.sh COUNT SEED: halves and doubles about COUNT numbers of the planners, every n-th of all, and prints those that no test finds, as rows
# of CSV: seed, change, file, line. cargo-mutants leaves numbers as they are. The tests are those of `make mutants`.
set -euo pipefail
count=$1 seed=$2
out=$PWD/target/constants
tree=$out/tree
rm -rf "$tree"
mkdir -p "$tree"
git ls-files -z | xargs -0 cp -p --parents -t "$tree"
cd "$tree"
export BRIEF=1 RUSTC_BOOTSTRAP=1 CARGO_TARGET_DIR=$out/build RUSTFLAGS='--cap-lints warn -C link-arg=-Wl,-z,muldefs'
# settings NAME: the strings of a list in the settings of cargo-mutants.
settings() { sed -n "/^$1 / { :more; /\]\$/! { N; b more }; p }" .cargo/mutants.toml | grep -o '"[^"]*"' | tr -d '"'; }
mapfile -t build < <(settings additional_cargo_args)
mapfile -t tests < <(settings additional_cargo_test_args)
# A test that takes ten times its time hangs.
run() { timeout "$1" cargo test --quiet --profile mutants "${@:2}" > "$out/log" 2>&1; }
compiles() { run 900 --no-run "${build[@]}"; }
pass() { run 300 "${build[@]}" "${tests[@]}"; }

pass || { tail "$out/log"; echo 'a test fails without a change'; exit 1; }
number='R::from\([0-9]+\)|^(pub(\([a-z]+\))? )?const [A-Z_]+: [a-z0-9]+ = [0-9_]+;'
grep -nEo "$number" $(git -C "$OLDPWD" ls-files src/{fastest,interval,machine,online,path,several}) src/roots.rs > "$out/all.txt"
of=$(((2 * $(wc -l < "$out/all.txt") + count - 1) / count))
awk '{ print "half " $0; print "double " $0 }' "$out/all.txt" | awk -v of="$of" -v seed="$seed" 'NR % of == seed % of' > "$out/drawn.txt"
judged=0 found=0
while IFS=' :' read -r change file line _; do
    cp "$file" "$out/before.rs"
    CHANGE=$change perl -pi -e '$. == '"$line"' and s{(R::from\(|= )([0-9_]+)(?=\)|;)}
        { my $n = $2 =~ tr/_//dr; $1 . ($ENV{CHANGE} eq "half" ? int($n / 2) : 2 * $n) }e' "$file"
    if compiles; then
        judged=$((judged + 1))
        if pass; then
            echo "$seed,$change,$file,\"$(sed -n "${line}s/^ *//p" "$out/before.rs")\""
        else
            found=$((found + 1))
        fi
    fi
    cp "$out/before.rs" "$file"
done < "$out/drawn.txt"
echo "$judged numbers, $found found"
