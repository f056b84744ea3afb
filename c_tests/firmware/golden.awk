# Turns golden CSV files into C tables of bit patterns: awk -v stride=N -f golden.awk FILES > golden_rows.h
# It takes every stride-th case, so the tables fit into a small flash. A row begins with its case number.
BEGIN { FS = ","; print "/* Every case whose number is a multiple of " stride ". */" }
FNR == 1 {
    if (NR > 1) { print "};" }
    name = FILENAME
    sub(/.*\//, "", name)
    sub(/_f(32|64)\.csv$/, "", name)
    first = $2 == "category" ? 3 : 2
    print "static const real " name "[][" NF - first + 2 "] = {"
    next
}
$1 % stride == 0 {
    row = "{{" $1 "}"
    for (i = first; i <= NF; ++i) { row = row ",{" ($i == "nan" ? "NAN_BITS" : "0x" $i) "}" }
    print row "},"
}
END { print "};" }
