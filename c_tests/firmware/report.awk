# Turns the figures of CORE-REAL-IMPLEMENTATION.figures into the tables of docs/firmware.md.
# A figure over its limit is bold. The limit of a size is the original's -Os; the limit of instructions is its -O2.

FNR == 1 {
    split(FILENAME, part, "/")
    name = part[length(part)]
    sub(/\.figures$/, "", name)
    split(name, part, "-")
    build = part[1] " " part[2]
    library = part[3] (part[4] == "" ? "" : "-" part[4])
    if (!(build in seen)) { seen[build]; builds[++build_count] = build }
}
{
    key = $1 SUBSEP $2
    figure[build, library, key] = $3
    if (library == "ours" && !(key in known)) { known[key]; keys[++key_count] = key }
}
function value(build, library, key) { return figure[build, library, key] }
function row(build, key, label, against,   ours, limit) {
    ours = value(build, "ours", key)
    limit = value(build, "original-" against, key)
    if (limit == "") { return }
    printf "| %s | %s | %s | %s | %.2f |\n", label, (ours + 0 > limit + 0 ? "**" ours "**" : ours),
        value(build, "original-Os", key), value(build, "original-O2", key), ours / limit
}
function fastest(build, library, name) {
    printf "| `%s`%s | %s | %s | %s | %s |\n", name, (library == "ours" ? "" : ", C -O2"), value(build, library, name SUBSEP "fastest-flash"),
        value(build, library, name SUBSEP "fastest-mean"), value(build, library, name SUBSEP "fastest-max"),
        value(build, library, name SUBSEP "fastest-stack")
}
# A table of planners: their names, separated by blanks.
function planners(build, title, names,   count, name, i) {
    printf "\n### %s\n\n| function | flash | instructions, mean | max | stack |\n|---|---:|---:|---:|---:|\n", title
    count = split(names, name, " ")
    for (i = 1; i <= count; ++i) { fastest(build, name[i] ~ /^a_/ ? "original-O2" : "ours", name[i]) }
}
function head(title, first, against) {
    printf "\n### %s\n\n| %s | ours | C -Os | C -O2 | ours / C -%s |\n|---|---:|---:|---:|---:|\n", title, first, against
}
END {
    for (b = 1; b <= build_count; ++b) {
        build = builds[b]
        printf "\n## %s\n", build
        head("Size, bytes of code and constants", "part", "Os")
        row(build, "trajbell" SUBSEP "size", "bell", "Os")
        row(build, "trajtrap" SUBSEP "size", "trapezoid", "Os")
        row(build, "trajpoly" SUBSEP "size", "polynomials and Horner", "Os")
        row(build, "image" SUBSEP "size", "all, linked with libgcc and libm", "Os")
        for (k = 1; k <= key_count; ++k) {
            split(keys[k], part, SUBSEP)
            if (part[2] == "size" && part[1] ~ /^(bell|trap|poly[357])_/) {
                row(build, keys[k], "`" part[1] "`", "Os")
            }
        }
        head("Instructions", "call", "O2")
        for (k = 1; k <= key_count; ++k) {
            split(keys[k], part, SUBSEP)
            if (part[2] !~ /size|stack|-case|fastest/) { row(build, keys[k], "`" part[1] "` " part[2], "O2") }
        }
        printf "\nThe worst `bell_gen` is golden case %d.\n", value(build, "ours", "bell_gen" SUBSEP "worst-case")
        planners(build, "Plans that never fail", "atraj_bell_gen a_trajbell_gen atraj_trap_gen a_trajtrap_gen")
        planners(build, "Moves from any state to any state", "atraj_move_plan atraj_move_stop atraj_move_meet " \
            "atraj_move_pos atraj_move_vel atraj_move_acc atraj_move_jer")
        printf "\n`atraj_move_plan`, `_reach`, `_stop`, `_pos`, `_vel`, `_acc` and `_jer` together take %d bytes of flash.\n",
            value(build, "ours", "moves" SUBSEP "fastest-flash")
        planners(build, "Three axes", "atraj_moves_sync atraj_moves_line atraj_moves_sync_within")
        planners(build, "An axis between main loop and interrupt", "atraj_axis_tick atraj_axis_go atraj_axis_track")
        planners(build, "Steps of a motor, a shaper of three impulses, and a clock of one axis", \
            "atraj_steps_next atraj_shaper_state atraj_clock_rate atraj_clock_state")
        planners(build, "Paths of three axes", "atraj_path_plan atraj_path_improve")
        printf "\nBoth take %d bytes of working memory. With `atraj_moves_sync`, which makes the motions, they take %d bytes of flash.\n",
            value(build, "ours", "path" SUBSEP "fastest-memory"), value(build, "ours", "paths" SUBSEP "fastest-flash")
        printf "\n### Stack, bytes with everything called\n\n| function | ours | C -Os | C -O2 |\n|---|---:|---:|---:|\n"
        for (k = 1; k <= key_count; ++k) {
            split(keys[k], part, SUBSEP)
            if (part[2] == "stack" && keys[k] != "bell_gen" SUBSEP "stack" || part[2] == "worst-stack") {
                printf "| `%s` | %s | %s | %s |\n", part[1], value(build, "ours", keys[k]),
                    value(build, "original-Os", keys[k]), value(build, "original-O2", keys[k])
            }
        }
    }
}
