# Compares instruction counts, `function, case: count`: the first file has the allowed counts, the second the counts of this build.
NR == FNR { allowed[$1] = $2; next }
{
    if (!($1 in allowed)) { print "new: " $0; failed = 1 }
    else if ($2 > allowed[$1] * 1.03) { print "more than 3 % over " allowed[$1] ": " $0; failed = 1 }
    delete allowed[$1]
    ++count
}
END {
    for (name in allowed) { print "gone: " name; failed = 1 }
    if (!count) { print "nothing was counted"; failed = 1 }
    if (failed) { print "`make instructions UPDATE=1` accepts the new counts" }
    exit failed
}
