#!/usr/bin/env bash
# Proves with Gappa, for binary64 and binary32, how far a move that passes the check can be from its limits: README.md.
# Coq checks each proof of Gappa again, and the steps between them, if it is installed.
set -euo pipefail
cd "$(dirname "$0")/.."

fail() {
    printf '%s\n' "$*" >&2
    exit 1
}
command -v gappa > /dev/null || fail 'gappa is needed: apt-get install gappa'
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

# The lines after "# source: FILE" are in this file, one after the other. Comments and indentation do not count.
compare() {
    local path='' quoted='' line code
    while IFS= read -r line; do
        case $line in
            '# source: '*) path=${line#'# source: '} ;;
            '#   '*) quoted+=$(sed 's/^# *//' <<< "$line")$'\n' ;;
            *)
                if [ "$quoted" ]; then
                    code=$'\n'$(sed '/^ *\/\//d; s/^ *//' "$path")$'\n'
                    [[ $code == *$'\n'"$quoted"* ]] || fail "$1: $path no longer has these lines. The proof is about them:"$'\n'"$quoted"
                    quoted=
                fi
                ;;
        esac
    done < <(cat "$1" && echo)
}

# The k of the evaluation of a quantity.
proved() {
    sed -n 's/^.* <= \([0-9.]*\) # k .*/\1/p' "proofs/$1.g"
}

# A script with the numbers of a type. Domain: scales from LOW to HIGH.
of_type() {
    case $1 in
        binary64) set -- 1b-52 1b-53 1b-73 ieee_64 1b-1021 1b1023 1b-1074 1b-200 1b200 ;;
        binary32) set -- 1b-23 1b-24 1b-44 ieee_32 1b-125 1b127 1b-149 1b-40 1b40 ;;
    esac
    sed "s/\<DOUBT\>/(64 * EPSILON)/g; s/\<EPSILON\>/$1/g; s/\<UNIT\>/$2/g; s/\<TINIER\>/$3/g; s/\<FORMAT\>/$4/g; s/\<NORMAL\>/$5/g
        s/\<HIGHEST\>/$6/g; s/\<TINY\>/$7/g; s/\<LOW\>/$8/g; s/\<HIGH\>/$9/g
        s/\<POSITION\>/$(proved position)/g; s/\<VELOCITY\>/$(proved velocity)/g; s/\<ACCELERATION\>/$(proved acceleration)/g"
}

# For Gappa's Coq output, the rewriting rules of a script are hypotheses. Here they are lemmas, and Coq proves them.
coq() {
    {
        echo 'Require Import Reals.'
        gappa -Bcoq -Eno-auto-dichotomy "$1.g"
    } | sed 's/^Hypothesis \(a[0-9]*\) : \(.*\)\.$/Lemma \1 : \2. Proof. unfold Float1; ring. Qed./' > "$1.v"
    ! grep -qE '^(Hypothesis|Axiom)|Admitted|admit' "$1.v" || fail "$script: Coq would have to believe something"
    (cd "$work" && coqc "$1.v") || fail "$script: Coq does not accept the proof"
}

checker='Gappa alone (apt-get install coq libcoq-gappa: then Coq checks its proofs and steps.v)'
if command -v coqc > /dev/null && [ -d "$(coqc -where)/user-contrib/Gappa" ]; then
    checker='Gappa and Coq'
    cp proofs/steps.v "$work"
    (cd "$work" && coqc steps.v) || fail 'proofs/steps.v: no proof'
fi
compare proofs/code.txt
for script in proofs/*.g; do
    compare "$script"
    for type in binary64 binary32; do
        proof=$work/$(basename "$script" .g)_$type
        of_type $type < "$script" > "$proof.g"
        said=$(gappa -Eno-auto-dichotomy "$proof.g" 2>&1) || fail "$script: no proof for $type"$'\n'"$said"
        # A warning is a rewriting rule that Gappa does not see to be right.
        [ -z "$said" ] || fail "$script, $type: $said"
        if [ "$checker" = 'Gappa and Coq' ]; then
            coq "$proof"
        fi
    done
done

echo "Proved by $checker: errors of at most k ulps of a scale, and k EPSILON in each type"
sed -n 's/^.* <= \([0-9.]*\) # k \(.*\) | \(.*\)$/\2\t\1\t\3/p' proofs/{position,velocity,acceleration,check}.g |
    awk -F '\t' '
        BEGIN { row = "%-42s | %6s | %8s | %8s | %s\n"; printf row, "quantity", "k", "binary64", "binary32", "of the scale" }
        { printf row, $1, $2, sprintf("%.1e", $2 * 2 ^ -52), sprintf("%.1e", $2 * 2 ^ -23), $3 }'
