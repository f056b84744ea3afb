# Turns the figures of CORE-REAL-IMPLEMENTATION.figures into the tables firmware-*.csv of the folder `data`: ours, the original's C at -Os and
# at -O2, and ours divided by one of them.

FNR == 1 {
    split(FILENAME, part, "/")
    name = part[length(part)]
    sub(/\.figures$/, "", name)
    split(name, part, "-")
    build = part[1] "," part[2]
    library = part[3] part[4]
    if (!(build in seen)) { seen[build]; builds[++build_count] = build }
}
{
    figure[build, library, $1, $2] = $3
    if (library == "ours" && !(($1, $2) in known)) { known[$1, $2]; keys[++key_count] = $1 SUBSEP $2 }
}
function file(table) { return data "/firmware-" table ".csv" }
function figures(name, what) {
    return figure[build, "ours", name, what] "," figure[build, "originalOs", name, what] "," figure[build, "originalO2", name, what]
}
# The original has no function like some of ours.
function row(table, label, name, what, against,   limit) {
    limit = figure[build, "original" against, name, what]
    if (limit != "") { printf "%s,%s,%s,%.2f\n", build, label, figures(name, what), figure[build, "ours", name, what] / limit > file(table) }
}
function path(label, what) {
    if (figure[build, "ours", "paths", what "-instructions"] == "") { return }
    printf "%s,%s,%s,%s,%s\n", build, label, figure[build, "ours", "paths", what "-instructions"], figure[build, "ours", "paths", what "-stack"],
        figure[build, "ours", "paths", what "-memory"] > file("paths")
}
function plan(name,   library) {
    library = name ~ /^a_/ ? "originalO2" : "ours"
    printf "%s,%s,%s", build, name, name ~ /^a_/ ? "C -O2" : "ours" > file("plans")
    printf ",%s,%s,%s,%s\n", figure[build, library, name, "fastest-flash"], figure[build, library, name, "fastest-mean"],
        figure[build, library, name, "fastest-max"], figure[build, library, name, "fastest-stack"] > file("plans")
}
END {
    print "core,real,part,ours,C -Os,C -O2,ours / C -Os" > file("size")
    print "core,real,function,case,ours,C -Os,C -O2,ours / C -O2" > file("instructions")
    print "core,real,function,library,flash,mean instructions,most instructions,stack" > file("plans")
    print "core,real,function,ours,C -Os,C -O2" > file("stack")
    print "core,real,path of three axes,instructions,stack,working memory" > file("paths")
    for (b = 1; b <= build_count; ++b) {
        build = builds[b]
        row("size", "bell", "trajbell", "size", "Os")
        row("size", "trapezoid", "trajtrap", "size", "Os")
        row("size", "polynomials and Horner", "trajpoly", "size", "Os")
        row("size", "all with libgcc and libm", "image", "size", "Os")
        for (k = 1; k <= key_count; ++k) {
            split(keys[k], key, SUBSEP); name = key[1]; what = key[2]
            if (what == "size" && name ~ /^(bell|trap|poly[357])_/) { row("size", name, name, what, "Os") }
            label = what == "worst-golden" ? "worst golden plan: case " figure[build, "ours", name, "worst-case"] : what
            if (what !~ /size|stack|-case|fastest/) { row("instructions", name "," label, name, what, "O2") }
            if (what == "fastest-flash" && name ~ /_/) { plan(name) }
            if (what == "stack" && name != "bell_gen" || what == "worst-stack") { print build "," name "," figures(name, what) > file("stack") }
        }
        print build ",moves with libgcc and libm," figure[build, "ours", "moves", "fastest-flash"] ",,," > file("size")
        print build ",paths and atraj_moves_sync with libgcc and libm," figure[build, "ours", "paths", "fastest-flash"] ",,," > file("size")
        print build ",working memory of a path," figure[build, "ours", "path", "fastest-memory"] ",,," > file("size")
        path("4 waypoints", "4")
        path("16 waypoints", "16")
        path("64 waypoints", "64")
        path("a window of 16 sections moved on by one", "window")
    }
}
