/* Searches the arguments for which a function takes the most instructions: from random arguments it climbs by small changes that take no
 * fewer, and begins again where TRIES changes in a row take fewer. These are the largest counts that were found, not the largest that exist.
 *
 * Prints lines "function instructions". */
#include <math.h>
#include <stddef.h>
#include "atraj.h"
#include "problem.h"
#include "semihost.h"
#include "timer.h"

/* EFFORT is how many instructions the climb of each function may take, in millions. */
enum { MOST_ARGUMENTS = 40, TRIES = 60 };

static uint32_t state = SEED;
static uint32_t draw(uint32_t below) {
    state ^= state << 13, state ^= state >> 17, state ^= state << 5;
    return (uint32_t)(((uint64_t)state * below) >> 32);
}

/* Of any sign, between 1/256 and 256, evenly in its logarithm; often a small whole number or 0. */
static a_float drawn(void) {
    a_float const sign = draw(2) ? 1 : -1;
    if (draw(4) == 0) { return sign * (a_float)draw(4); }
    return (a_float)ldexp(sign * (1 + (double)draw(1024) / 1024), (int)draw(16) - 8);
}

static a_float changed(const a_float *arguments, size_t count, a_float x) {
    switch (draw(7)) {
    case 0: return drawn();
    case 1: return -x;
    case 2: return x * (draw(2) ? 2 : (a_float)0.5);
    case 3: return arguments[draw((uint32_t)count)];
    case 4: return x + drawn() / 16;
    default: return x + x * (a_float)((int)draw(1024) - 512) / (draw(2) ? 1024 : 65536);
    }
}

/* What is planned. The limits are as `atraj_limits_init` takes them: three numbers, for each way. */
static atraj_limits limits_of(const a_float *a) {
    atraj_limits const limits = {fabs(a[0]), -fabs(a[1]), fabs(a[2]), -fabs(a[3]), fabs(a[4]), -fabs(a[5])};
    return limits;
}
static atraj_state state_of(const a_float *a) { return (atraj_state){a[0], a[1], a[2]}; }

/* Where the count begins: a function that needs something planned first moves it. */
static uint32_t start;

static atraj_move axes[AXES], room[3 * AXES];
static atraj_state setpoints[AXES];
static atraj_limits wide[AXES];
static atraj_axis axis;
static atraj_group group;
static axes_problem set;
static path_problem way;

static void bell(const a_float *a) { a_trajbell ctx; a_trajbell_gen(&ctx, a[0], a[1], a[2], a[3], a[4], a[5], a[6]); }
static void trap(const a_float *a) { a_trajtrap ctx; a_trajtrap_gen(&ctx, a[0], a[1], a[2], a[3], a[4], a[5], a[6]); }
static void fastest_bell(const a_float *a) { a_trajbell ctx; atraj_bell_gen(&ctx, a[0], a[1], a[2], a[3], a[4], a[5], a[6]); }
static void fastest_trap(const a_float *a) { a_trajtrap ctx; atraj_trap_gen(&ctx, a[0], a[1], a[2], a[3], a[4], a[5], a[6]); }

static void move(unsigned function, const a_float *a) {
    problem const q = {function, limits_of(a), state_of(a + 6), state_of(a + 9)};
    solve(&q, axes);
}
static void plan(const a_float *a) { move(PLAN, a); }
static void stop(const a_float *a) { move(STOP, a); }
static void meet(const a_float *a) { move(MEET, a); }
static void track(const a_float *a) { move(TRACK, a); }

/* Returns the arguments that are left. */
static const a_float *pose_axes(unsigned function, const a_float *a) {
    set.function = function;
    for (unsigned i = 0; i != AXES; ++i, a += 12) {
        set.limits[i] = limits_of(a), set.from[i] = state_of(a + 6), set.to[i] = state_of(a + 9);
        /* A line begins and ends at rest here: random states are hardly ever on one. */
        if (function == LINE) { set.from[i].v = set.from[i].a = set.to[i].v = set.to[i].a = 0; }
    }
    return a;
}

static void together(unsigned function, const a_float *a) {
    set.duration = 0, set.cycle = fabs(*pose_axes(function, a)) / 256;
    solve_axes(&set, axes);
}
static void sync(const a_float *a) { together(SYNC, a); }
static void line(const a_float *a) { together(LINE, a); }
static void sync_within(const a_float *a) { together(SYNC_WITHIN, a); }

static void path(const a_float *a) {
    for (unsigned i = 0; i != AXES; ++i) { atraj_limits_init(&way.limits[i], a[i], a[i + 3], a[i + 6]); }
    for (unsigned i = 0; i != (SECTIONS + 1) * AXES; ++i) { way.states[i] = (atraj_state){a[9 + i], 0, 0}; }
    plan_path(&way);
}

static void go(const a_float *a) {
    atraj_state const from = state_of(a + 6), to = state_of(a + 9);
    atraj_limits const limits = limits_of(a);
    if (atraj_axis_init(&axis, (a_float)0.001, &from) == 0) { atraj_axis_go(&axis, &limits, &to, 1); }
}

/* A hold on a path of one section. */
static void hold(const a_float *a) {
    atraj_clock clock;
    a = pose_axes(LINE, a);
    for (unsigned i = 0; i != AXES; ++i) { wide[i] = wider(&set.limits[i]); }
    atraj_clock_start(&clock);
    int const refused = atraj_moves_sync(axes, set.limits, set.from, set.to, AXES, 0, 0);
    start = now();
    if (refused == 0) { atraj_clock_rate(&clock, axes, wide, AXES, 1, axes[0].t * (a_float)fmod(fabs(a[0]), 1), 0); }
}

/* Some ticks after a group has begun a line. */
static void ride(const a_float *a) {
    a = pose_axes(LINE, a);
    for (unsigned i = 0; i != AXES; ++i) { wide[i] = wider(&set.limits[i]); }
    if (atraj_group_init(&group, (a_float)1 / 64, set.from, room, AXES) == 0 && atraj_group_line(&group, set.limits, set.to, 1) == 0) {
        for (unsigned ticks = 2 + (unsigned)fmod(fabs(a[0]), 64); ticks; --ticks) { atraj_group_tick(&group, setpoints); }
    }
}
static void group_hold(const a_float *a) {
    ride(a);
    start = now();
    atraj_group_rate(&group, wide, 0, 1);
}
static void group_stop(const a_float *a) {
    ride(a);
    start = now();
    atraj_group_stop(&group, wide, 1);
}
/* The tick in which the axes turn back. */
static void group_tick(const a_float *a) {
    ride(a);
    atraj_group_sync(&group, wide, set.from, 1);
    start = now();
    atraj_group_tick(&group, setpoints);
}

static const struct { const char *name; void (*f)(const a_float *); size_t count; } functions[] = {
    {"a_trajbell_gen", bell, 7}, {"a_trajtrap_gen", trap, 7}, {"atraj_bell_gen", fastest_bell, 7}, {"atraj_trap_gen", fastest_trap, 7},
    {"atraj_move_plan", plan, 12}, {"atraj_move_stop", stop, 12}, {"atraj_move_meet", meet, 12}, {"atraj_move_track", track, 12},
    {"atraj_axis_go", go, 12}, {"atraj_moves_sync", sync, 37}, {"atraj_moves_line", line, 37}, {"atraj_moves_sync_within", sync_within, 37},
    {"atraj_path_plan", path, 9 + (SECTIONS + 1) * AXES}, {"atraj_clock_rate", hold, 37}, {"atraj_group_rate", group_hold, 37},
    {"atraj_group_stop", group_stop, 37}, {"atraj_group_tick", group_tick, 37},
};

static uint32_t climb(void (*f)(const a_float *), size_t count) {
    uint64_t spent = 0;
    uint32_t most = 0, here = 0;
    unsigned failed = TRIES;
    a_float arguments[MOST_ARGUMENTS], next[MOST_ARGUMENTS];
    while (spent < EFFORT * (uint64_t)1000000) {
        if (failed == TRIES) {
            for (size_t k = 0; k != count; ++k) { arguments[k] = drawn(); }
            here = 0, failed = 0;
        }
        memcpy(next, arguments, sizeof(next));
        if (here) {
            for (unsigned changes = 1 + draw(3); changes; --changes) {
                size_t const k = draw((uint32_t)count);
                next[k] = changed(arguments, count, next[k]);
            }
        }
        uint32_t const begun = start = now();
        f(next);
        uint32_t const end = now(), c = instructions(end - start);
        spent += instructions(end - begun) + 1000;
        failed = c > here ? 0 : failed + 1;
        if (c >= here) { here = c; memcpy(arguments, next, sizeof(next)); }
        if (most < here) { most = here; }
    }
    return most;
}

int main(void) {
    start_timer();
    for (size_t k = 0; k != sizeof(functions) / sizeof(functions[0]); ++k) {
        semihost_print(functions[k].name);
        semihost_print(" ");
        semihost_count(climb(functions[k].f, functions[k].count), "\n");
    }
    return 0;
}
