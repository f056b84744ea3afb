# Turns golden CSV files into C tables of bit patterns: awk -v stride=N -f golden.awk FILES > golden_rows.h
# It takes every stride-th case, so the tables fit into a small flash. A row begins with its case number. The scripts of CLARAty's
# listing become one array: each row is a ROW of golden.h, the arguments of its operation, and the numbers that it must give.
BEGIN { FS = ","; print "/* Every case whose number is a multiple of " stride ". */" }
FNR == 1 {
    if (NR > 1) { print "};" }
    name = FILENAME
    sub(/.*\//, "", name)
    sub(/_f(32|64)\.csv$/, "", name)
    if (name == "claraty_listing") {
        print "static const uint64_t claraty_listing[] = {"
        next
    }
    first = $2 == "category" ? 3 : 2
    print "static const real " name "[][" NF - first + 2 "] = {"
    next
}
function number(cell) { return cell == "nan" ? "0x7ff8000000000000" : "0x" cell }
name == "claraty_listing" {
    if ($1 % stride != 0) { next }
    if (script != $1 "") { print "ROW(init,0,0,0," FNR ")," }
    script = $1 ""
    row = "ROW(" $2 "," $17 "," $16 + 0 "," $18 + 0 "," FNR "),"
    for (i = 3; i <= NF; ++i) {
        if ($i != "" && (i < 16 || i > 18)) { row = row number($i) "," }
    }
    print row
    next
}
$1 % stride == 0 {
    row = "{{" $1 "}"
    for (i = first; i <= NF; ++i) { row = row ",{" ($i == "nan" ? "NAN_BITS" : "0x" $i) "}" }
    print row "},"
}
END { print "};" }
