# Reads files CORE-REAL.stack or CORE-REAL.worst: functions with their bytes or instructions, the most of several searches. Prints them as one
# table in CSV. With `listed`, such a table, it prints nothing, and fails if a number is above the listed one or if the functions differ.

FNR == 1 {
    count = split(FILENAME, part, "/")
    build = part[count]
    sub(/\..*/, "", build)
    sub(/-/, " ", build)
    builds[++build_count] = build
}
!($1 in known) { known[$1]; names[++name_count] = $1 }
!(($1, build) in bound) || $2 + 0 > bound[$1, build] + 0 { bound[$1, build] = $2 }
function row(name,   b, line) {
    line = name
    for (b = 1; b <= build_count; ++b) { line = line "," (name == "function" ? builds[b] : bound[name, builds[b]]) }
    return line
}
function compare(   line, count, cell, title, i, key, failed) {
    while ((getline line < listed) > 0) {
        count = split(line, cell, ",")
        for (i = 2; i <= count; ++i) { if (cell[1] == "function") { title[i] = cell[i] } else { limit[cell[1], title[i]] = cell[i] } }
    }
    for (key in bound) { if (!(key in limit)) { failed = differs(key) } }
    for (key in limit) {
        if (!(key in bound)) { failed = differs(key) }
        else if (bound[key] + 0 > limit[key] + 0) { failed = 1; print shown(key) ": " bound[key] " is above the bound " limit[key] }
    }
    return failed
}
function shown(key,   part) { split(key, part, SUBSEP); return part[1] ", " part[2] }
function differs(key) { print shown(key) ": only measured or only in " listed ": make -C c_tests/firmware bounds"; return 1 }
END {
    if (listed != "") { exit compare() }
    print row("function")
    for (k = 1; k <= name_count; ++k) { print row(names[k]) }
}
