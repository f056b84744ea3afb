#!/bin/sh
# figures.sh LIBRARY: prints "family size bytes" for each family of functions, "function size bytes" for each function, and "image size bytes" for the
# whole library linked with the C toolchain's libraries. It prints "function fastest-flash bytes" for each planner: the planner alone, linked in the
# same way, and for an evaluation of a move, and "moves fastest-flash bytes" for planners and evaluations of moves together. CC is the compiler.
set -eu
library=$1
api=$(grep ^a_ ../../tests/symbols.txt) # the original has only these
object=$(mktemp)
trap 'rm -f "$object"' EXIT
text() { arm-none-eabi-size "$object" | awk 'NR == 2 { print $1 }'; }
roots() { printf -- "-Wl,-u,%s " $1; }

# needs FUNCTIONS: the size of these functions linked with all that they call.
needs() {
    $CC -nostartfiles --specs=nano.specs --specs=nosys.specs -Wl,--gc-sections,--entry="${1%%[[:space:]]*}" \
        -Wl,--no-warn-rwx-segments,--no-warn-execstack $(roots "$1") "$library" -lm -o "$object"
    text
}

for family in trajbell trajtrap trajpoly; do
    functions=$(echo "$api" | grep "$family")
    $CC -nostdlib -r -Wl,--gc-sections $(roots "$functions") "$library" -o "$object"
    echo "$family size $(text)"
done
echo "image size $(needs "$api")"
# flash NAME FUNCTIONS: what they need, if the library has the first of them.
flash() {
    if arm-none-eabi-nm "$library" | grep -q " T ${2%%[[:space:]]*}\$"; then
        echo "$1 fastest-flash $(needs "$2")"
    fi
}
evaluations='atraj_move_pos atraj_move_vel atraj_move_acc atraj_move_jer'
for function in atraj_bell_gen a_trajbell_gen atraj_trap_gen a_trajtrap_gen atraj_move_plan atraj_move_stop atraj_move_meet $evaluations \
    atraj_moves_sync atraj_moves_line atraj_moves_sync_within atraj_axis_tick atraj_axis_go atraj_axis_track \
    atraj_group_tick atraj_group_sync atraj_group_line atraj_group_rate atraj_group_stop atraj_steps_next atraj_shaper_state atraj_shaper_stream_tick \
    atraj_clock_rate atraj_clock_state atraj_path_plan atraj_path_improve; do
    flash $function $function
done
flash moves "atraj_move_plan atraj_move_reach atraj_move_stop $evaluations"
flash paths 'atraj_path_plan atraj_path_improve atraj_moves_sync'
arm-none-eabi-size -A "$library" | awk '$1 ~ /^\.text\../ { sub(/^\.text\.(a_traj)?/, "", $1); print $1, "size", $2 }'
