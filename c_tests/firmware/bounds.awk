# Reads CORE-REAL.stack and CORE-REAL.worst. Prints the tables of docs/bounds.md, or fails if a number is above the one on the page, if a page is
# given.

FNR == 1 {
    count = split(FILENAME, part, "/")
    split(part[count], part, ".")
    build = part[1]; what = part[2]
    sub(/-/, " ", build)
    if (!(build in seen)) { seen[build]; builds[++build_count] = build }
}
{
    if (!((what, $1) in known)) { known[what, $1]; names[what, ++name_count[what]] = $1 }
    # The most of several searches.
    if (!((what, $1, build) in bound) || $2 + 0 > bound[what, $1, build] + 0) { bound[what, $1, build] = $2 }
}
function table(what, title,   k, b, row) {
    printf "## %s\n\n| function |", title
    for (b = 1; b <= build_count; ++b) { printf " %s |", builds[b] }
    printf "\n|---|"
    for (b = 1; b <= build_count; ++b) { printf "---:|" }
    print ""
    for (k = 1; k <= name_count[what]; ++k) {
        row = "| `" names[what, k] "` |"
        for (b = 1; b <= build_count; ++b) { row = row " " bound[what, names[what, k], builds[b]] " |" }
        print row
    }
}
function compare(   line, cell, build_of, count, b, k) {
    while ((getline line < page) > 0) {
        if (line ~ /^## /) { what = line ~ /^## Stack/ ? "stack" : line ~ /^## Instructions/ ? "worst" : "" }
        count = split(line, cell, / *\| */)
        if (what == "" || count < 4) { continue }
        if (cell[2] == "function") { for (b = 3; b < count; ++b) { build_of[b] = cell[b] } }
        gsub(/`/, "", cell[2])
        for (b = 3; b < count; ++b) {
            if (!((what, cell[2], build_of[b]) in bound)) { continue }
            ++compared
            if (bound[what, cell[2], build_of[b]] + 0 > cell[b] + 0) {
                printf "%s, %s, %s: %d is above the bound %d\n", what, cell[2], build_of[b], bound[what, cell[2], build_of[b]], cell[b]
                failed = 1
            }
        }
    }
    for (k in bound) { --compared }
    if (compared != 0) { print "docs/bounds.md has not the functions of the library: make firmware-bounds"; failed = 1 }
    exit failed
}
END {
    if (page != "") { compare() }
    table("stack", "Stack, bytes with everything called")
    print ""
    table("worst", "Instructions, the most that the search found")
}
