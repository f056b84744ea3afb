/* Counts executed instructions and stack bytes of every function on an mps2 board. QEMU's -icount ties the board's timer to
 * the instructions, so the numbers are exact and repeatable. They are instructions, not cycles.
 *
 * Prints lines "function case number". */
#include <math.h>
#include <stddef.h>
#include "atraj.h"
#include "golden.h"
#include "semihost.h"
#include "timer.h"

/* Every function is called through this one type, so every call costs the same. */
typedef a_float function(void *ctx, a_float, a_float, a_float, a_float, a_float, a_float, a_float, a_float, a_float);
typedef struct { uint32_t instructions, stack; } cost;

__attribute__((naked)) static void stub(void) { __asm__("bx lr"); }

static const uint32_t PAINT = 0xC5C5C5C5;
enum { PAINTED_WORDS = 2048 };

__attribute__((noinline)) static cost call(function *f, void *ctx, const a_float *a) {
    uint32_t *sp, *word;
    __asm__ volatile("mov %0, sp" : "=r"(sp));
    for (word = sp - PAINTED_WORDS; word != sp; ++word) { *(volatile uint32_t *)word = PAINT; }
    uint32_t const start = now();
    f(ctx, a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8]);
    uint32_t const ticks = now() - start;
    for (word = sp - PAINTED_WORDS; *(volatile uint32_t *)word == PAINT && word != sp; ++word) {}
    return (cost){instructions(ticks), (uint32_t)(sp - word) * 4};
}

static cost measure(void (*f)(void), void *ctx, const a_float *arguments) {
    uint32_t const overhead = call((function *)stub, ctx, arguments).instructions;
    cost c = call((function *)f, ctx, arguments);
    c.instructions -= overhead - 1; /* the return instruction belongs to the function */
    return c;
}

static void print(const char *name, const char *move, const char *what, uint32_t number) {
    const char *const words[] = {name, " ", move, what, " "};
    for (size_t i = 0; i != sizeof(words) / sizeof(*words); ++i) { semihost_print(words[i]); }
    semihost_count(number, "\n");
}

static void once(const char *name, const char *move, void (*f)(void), void *ctx, const a_float *arguments) {
    cost c = measure(f, ctx, arguments);
    print(name, move, "", c.instructions);
    print(name, "", "stack", c.stack);
}

typedef struct { uint32_t calls, total, most, stack; } costs;

/* A function, and what its calls cost. */
typedef struct { const char *name; void (*f)(void); costs sum; } counted;
#define COUNTED(name) {#name, (void (*)(void))name, {0}}

static void add(costs *sum, cost c) {
    ++sum->calls;
    sum->total += c.instructions;
    if (sum->most < c.instructions) { sum->most = c.instructions; }
    if (sum->stack < c.stack) { sum->stack = c.stack; }
}

/* 101 evaluations from the start of a move to its end. */
static void sweep(const char *name, const char *move, void (*f)(void), void *ctx, a_float duration) {
    costs sum = {0};
    a_float arguments[9] = {0};
    for (unsigned i = 0; i <= 100; ++i) {
        arguments[0] = duration * (a_float)i / 100;
        add(&sum, measure(f, ctx, arguments));
    }
    arguments[0] = (a_float)0.3 * duration;
    print(name, move, "0.3T", measure(f, ctx, arguments).instructions);
    print(name, move, "mean", (sum.total + 50) / 101);
    print(name, move, "max", sum.most);
    print(name, "", "stack", sum.stack);
}

#define FUNCTION(name) (void (*)(void))(a_traj##name)
#define SWEEP(name, move, ctx, duration) sweep(#name, move, FUNCTION(name), &ctx, duration)
#define SWEEP3(family, move, ctx, duration) \
    SWEEP(family##_pos, move, ctx, duration), SWEEP(family##_vel, move, ctx, duration), SWEEP(family##_acc, move, ctx, duration)
#define ONCE(name, move, ctx, ...) once(#name, move, FUNCTION(name), &ctx, (const a_float[9]){__VA_ARGS__})

static void sweep_bell(const char *move, a_trajbell ctx) {
    SWEEP3(bell, move, ctx, ctx.t);
    SWEEP(bell_jer, move, ctx, ctx.t);
}

static void bell(void) {
    a_trajbell ctx;
    ONCE(bell_gen, "cruise", ctx, 30, 10, 5, 0, 10, 1, 0);
    sweep_bell("", ctx);
    ONCE(bell_gen, "no-cruise", ctx, 30, 10, 5, 0, 1, 0, 0);
    sweep_bell("no-cruise-", ctx);
    ONCE(bell_gen, "backward", ctx, 30, 10, 5, 10, 0, -1, 0);
    sweep_bell("backward-", ctx);
}

/* The most expensive plans: the longest possible search, in which no trial fits, and the worst golden move. */
static void worst_bell(void) {
    a_trajbell longest;
    ONCE(bell_gen, "longest", longest, 1, A_FLOAT_MAX, 1, 0, (a_float)NAN, 1, 1);
    cost worst = {0, 0};
    uint32_t which = 0, stack = 0;
    for (size_t i = 0; i != ROWS(bell_gen); ++i) {
        a_float arguments[9] = {0};
        for (size_t k = 0; k != 7; ++k) { arguments[k] = bell_gen[i][k + 1].value; }
        a_trajbell ctx;
        cost c = measure(FUNCTION(bell_gen), &ctx, arguments);
        if (stack < c.stack) { stack = c.stack; }
        if (worst.instructions < c.instructions) { worst = c; which = i; }
    }
    print("bell_gen", "", "worst-golden", worst.instructions);
    print("bell_gen", "", "worst-case", which);
    print("bell_gen", "", "worst-stack", stack);
}

static void print_costs(const counted *functions, size_t number) {
    for (const counted *one = functions; one != functions + number; ++one) {
        costs const sum = one->sum;
        print(one->name, "", "fastest-mean", (sum.total + sum.calls / 2) / sum.calls);
        print(one->name, "", "fastest-max", sum.most);
        print(one->name, "", "fastest-stack", sum.stack);
    }
}
#define PRINT(...) print_costs((const counted[]){__VA_ARGS__}, sizeof((counted[]){__VA_ARGS__}) / sizeof(counted))

/* The plan of every move in a table of moves. */
static void each(counted function, const real *row, size_t rows, size_t columns) {
    for (size_t i = 0; i != rows; ++i, row += columns) {
        a_float ctx[14], arguments[9] = {0};
        for (size_t k = 0; k != 7; ++k) { arguments[k] = row[k + 1].value; }
        add(&function.sum, measure(function.f, ctx, arguments));
    }
    PRINT(function);
}
#define EACH(name, table) each((counted)COUNTED(name), *table, ROWS(table), sizeof(*table) / sizeof(**table))

/* The original lacks the plans that never fail. Its own plans of these moves stand next to them. */
#define PRAGMA(words) _Pragma(#words)
#define WEAK(name) PRAGMA(weak name)
WEAK(atraj_bell_gen) WEAK(atraj_trap_gen) WEAK(atraj_move_plan) WEAK(atraj_move_reach) WEAK(atraj_move_stop)
WEAK(atraj_move_meet) WEAK(atraj_move_within) WEAK(atraj_move_track) WEAK(atraj_move_pos) WEAK(atraj_move_vel)
WEAK(atraj_move_acc) WEAK(atraj_move_jer) WEAK(atraj_limits_init) WEAK(atraj_moves_sync) WEAK(atraj_moves_line)
WEAK(atraj_moves_sync_within) WEAK(atraj_axis_init) WEAK(atraj_axis_tick) WEAK(atraj_axis_go) WEAK(atraj_axis_track)
WEAK(atraj_steps_init) WEAK(atraj_steps_next) WEAK(atraj_clock_start) WEAK(atraj_clock_rate) WEAK(atraj_clock_state)
WEAK(atraj_shaper_init) WEAK(atraj_shaper_smooth) WEAK(atraj_shaper_add) WEAK(atraj_shaper_state)
WEAK(atraj_shaper_stream_init) WEAK(atraj_shaper_stream_tick)
WEAK(atraj_group_init) WEAK(atraj_group_tick) WEAK(atraj_group_sync) WEAK(atraj_group_line) WEAK(atraj_group_rate)
WEAK(atraj_group_stop) WEAK(atraj_path_plan) WEAK(atraj_path_improve) WEAK(atraj_path_size)

static void fastest(void) {
    if (atraj_bell_gen) {
        EACH(atraj_bell_gen, fastest_bell);
        EACH(atraj_trap_gen, fastest_trap);
    }
    EACH(a_trajbell_gen, fastest_bell);
    EACH(a_trajtrap_gen, fastest_trap);
}

/* Planners of moves and of axes take other arguments than `function`, so each is called through a function that knows its problem.
 * atraj_move_stop ignores the last argument. */
static problem posed;
static axes_problem posed_axes;
static void (*posed_to)(void);

#define POSE(name, parameters, ...) \
    static void name(void *ctx) { typedef void function_of parameters; ((function_of *)posed_to)(ctx, __VA_ARGS__); }
POSE(pose, (atraj_move *, const atraj_limits *, const atraj_state *, const atraj_state *), &posed.limits, &posed.from, &posed.to)

POSE(pose_axes, (atraj_move *, const atraj_limits *, const atraj_state *, const atraj_state *, size_t, a_float, a_float),
     posed_axes.limits, posed_axes.from, posed_axes.to, AXES, posed_axes.duration, posed_axes.cycle)

static a_float posed_lowest[AXES], posed_highest[AXES];
POSE(pose_within,
     (atraj_move *, const atraj_limits *, const atraj_state *, const atraj_state *, const a_float *, const a_float *, size_t, a_float, a_float),
     posed_axes.limits, posed_axes.from, posed_axes.to, posed_lowest, posed_highest, AXES, posed_axes.duration, posed_axes.cycle)

static void count(counted *function, void (*pose)(void *), void *ctx) {
    a_float const none[9] = {0};
    posed_to = stub;
    cost const way = measure((void (*)(void))pose, ctx, none);
    posed_to = function->f;
    cost c = measure((void (*)(void))pose, ctx, none);
    c.instructions -= way.instructions - 1; /* the return instruction belongs to the function */
    c.stack -= way.stack;
    add(&function->sum, c);
}

/* 11 evaluations from the start of a move to its end. */
static void evaluate(counted *function, atraj_move *m) {
    for (int i = 0; i <= 10; ++i) {
        a_float const arguments[9] = {m->t * (a_float)i / 10};
        add(&function->sum, measure(function->f, m, arguments));
    }
}

/* Each planner over the moves of the table that it plans, and evaluations of all these moves. */
static void moves(void) {
    counted planners[] = {[PLAN] = COUNTED(atraj_move_plan), [STOP] = COUNTED(atraj_move_stop), [MEET] = COUNTED(atraj_move_meet)};
    counted evaluations[] = {COUNTED(atraj_move_pos), COUNTED(atraj_move_vel), COUNTED(atraj_move_acc), COUNTED(atraj_move_jer)};
    for (size_t i = 0; i != ROWS(fastest_move); ++i) {
        atraj_move m;
        m.phases = 0;
        posed = problem_of(fastest_move[i]);
        if (posed.function == REACH) { continue; } /* each stop calls it */
        count(&planners[posed.function], pose, &m);
        if (!m.phases) { continue; }
        for (int k = 0; k != 4; ++k) { evaluate(&evaluations[k], &m); }
    }
    PRINT(planners[PLAN], planners[STOP], planners[MEET]);
    print_costs(evaluations, 4);
}

/* Each planner of axes over the sets of the table that it plans. */
static void axes(void) {
    static atraj_move planned[AXES];
    counted planners[] = {
        [SYNC] = COUNTED(atraj_moves_sync), [LINE] = COUNTED(atraj_moves_line), [SYNC_WITHIN] = COUNTED(atraj_moves_sync_within)};
    for (size_t i = 0; i != ROWS(fastest_axes); ++i) {
        posed_axes = axes_of(fastest_axes[i]);
        put_bounds(&posed_axes, posed_lowest, posed_highest);
        unsigned const function = posed_axes.function;
        count(&planners[function], function == SYNC_WITHIN ? pose_within : pose_axes, planned);
    }
    print_costs(planners, 3);
}

enum { LEAD = 4 };

POSE(pose_go, (atraj_axis *, const atraj_limits *, const atraj_state *, unsigned), &posed.limits, &posed.to, LEAD)

POSE(pose_track, (atraj_axis *, const atraj_limits *, const atraj_state *, a_float, a_float, unsigned),
     &posed.limits, &posed.to, 0, (a_float)0.125, LEAD)

POSE(pose_tick, (atraj_axis *, atraj_state *), &posed.from)

/* An axis that goes to each target of the table from the end before, with 100 ticks for each. */
static void axis(void) {
    static atraj_axis ctx;
    atraj_state const start = {0};
    counted plans = COUNTED(atraj_axis_go), tracks = COUNTED(atraj_axis_track), ticks = COUNTED(atraj_axis_tick);
    atraj_axis_init(&ctx, (a_float)0.01, &start);
    for (size_t i = 0; i != ROWS(fastest_move); ++i) {
        posed = problem_of(fastest_move[i]);
        if (posed.function != PLAN) { continue; }
        count(&tracks, pose_track, &ctx);
        count(&plans, pose_go, &ctx); /* it replaces the plan that waits */
        for (int n = 0; n != 100; ++n) { count(&ticks, pose_tick, &ctx); }
    }
    PRINT(ticks, plans, tracks);
}

enum { GROUPED = 2 };
static atraj_limits group_limits[GROUPED], group_reserve[GROUPED];
static atraj_state group_states[GROUPED], group_to[GROUPED], group_now[GROUPED];

POSE(pose_group_to, (atraj_group *, const atraj_limits *, const atraj_state *, unsigned), group_limits, group_to, LEAD)
POSE(pose_group_rate, (atraj_group *, const atraj_limits *, a_float, unsigned), group_reserve, 0, LEAD)
POSE(pose_group_stop, (atraj_group *, const atraj_limits *, unsigned), group_reserve, LEAD)
POSE(pose_group_tick, (atraj_group *, atraj_state *), group_now)

/* Two axes from rest on a line to each target of the table, where they come to rest. After 25 ticks a feed hold is planned, and a stop in its
 * place. */
static void group(void) {
    static atraj_group ctx;
    static atraj_move room[3 * GROUPED];
    counted syncs = COUNTED(atraj_group_sync), lines = COUNTED(atraj_group_line), rates = COUNTED(atraj_group_rate);
    counted stops = COUNTED(atraj_group_stop), ticks = COUNTED(atraj_group_tick);
    for (size_t i = 0; i != ROWS(fastest_move); ++i) {
        problem const q = problem_of(fastest_move[i]);
        if (q.function != PLAN || i % 8) { continue; }
        for (int k = 0; k != GROUPED; ++k) {
            group_limits[k] = q.limits;
            group_reserve[k] = wider(&q.limits);
            group_states[k] = (atraj_state){0, 0, 0};
            group_to[k] = (atraj_state){q.to.p / (a_float)(1 + k), 0, 0};
        }
        if (atraj_group_init(&ctx, (a_float)0.01, group_states, room, GROUPED) != 0) { continue; }
        count(&syncs, pose_group_to, &ctx);
        count(&lines, pose_group_to, &ctx); /* it replaces the plan that waits */
        for (int n = 0; n != 25; ++n) { count(&ticks, pose_group_tick, &ctx); }
        count(&rates, pose_group_rate, &ctx);
        count(&stops, pose_group_stop, &ctx);
    }
    PRINT(ticks, syncs, lines, rates, stops);
}

static atraj_steps posed_steps;
static atraj_shaper posed_shaper;
static atraj_move posed_move;

static a_float posed_time;
POSE(pose_step, (atraj_steps *, const atraj_move *, a_float *), &posed_move, &posed_time)

POSE(pose_shape, (const atraj_shaper *, const atraj_move *, a_float, atraj_state *), &posed_move, posed_axes.duration, &posed.from)

static atraj_clock posed_clock;

POSE(pose_rate, (atraj_clock *, const atraj_move *, const atraj_limits *, size_t, size_t, a_float, a_float),
     &posed_move, &posed.limits, 1, 1, posed_move.t / 4, 0)

POSE(pose_clock, (const atraj_clock *, const atraj_move *, size_t, size_t, a_float, a_float *, a_float *, a_float *, a_float *),
     &posed_move, 1, 1, posed_axes.duration, &posed.from.p, &posed.from.v, &posed.from.a, NULL)

/* All steps of each move of the table, and 11 states of each move behind a shaper of 3 impulses, and on a clock that holds it. */
static void machine(void) {
    counted steps = COUNTED(atraj_steps_next), shaped = COUNTED(atraj_shaper_state);
    counted rates = COUNTED(atraj_clock_rate), held = COUNTED(atraj_clock_state);
    atraj_shaper_init(&posed_shaper, ATRAJ_SHAPER_EI, 5, 0);
    for (size_t i = 0; i != ROWS(fastest_move); ++i) {
        if (i % 8) { continue; } /* steps are many */
        problem const q = problem_of(fastest_move[i]);
        posed_move.phases = 0;
        solve(&q, &posed_move);
        if (atraj_steps_init(&posed_steps, &posed_move, q.from.p, (a_float)1 / 64) != 0) { continue; }
        while (1) {
            atraj_steps ahead = posed_steps;
            if (!atraj_steps_next(&ahead, &posed_move, NULL)) { break; }
            count(&steps, pose_step, &posed_steps);
        }
        for (int k = 0; k <= 10; ++k) {
            posed_axes.duration = posed_move.t * (a_float)k / 10;
            count(&shaped, pose_shape, &posed_shaper);
        }
        posed.limits = wider(&q.limits);
        atraj_clock_start(&posed_clock);
        count(&rates, pose_rate, &posed_clock);
        for (int k = 0; k <= 10; ++k) {
            posed_axes.duration = posed_move.t * (a_float)k / 10;
            count(&held, pose_clock, &posed_clock);
        }
    }
    PRINT(steps, shaped, rates, held);
}

enum { DELAYS = 192 }; /* numbers of a delay line: 49 ms at 1 kHz, and more */
static atraj_shaper_stream posed_stream;
static a_float posed_line[DELAYS];

POSE(pose_stream, (atraj_shaper_stream *, const atraj_state *, a_float *, size_t, atraj_state *), &posed.from, posed_line, DELAYS, &posed.to)

/* 100 ticks of an axis behind a shaper of 16 impulses, for a load with two frequencies. */
static void stream(void) {
    a_float const period = (a_float)1 / 1000;
    counted shaped = COUNTED(atraj_shaper_stream_tick);
    posed = problem_of(fastest_move[0]);
    solve(&posed, &posed_move);
    atraj_shaper_init(&posed_shaper, ATRAJ_SHAPER_EI2, 50, 0);
    atraj_shaper_add(&posed_shaper, ATRAJ_SHAPER_EI2, 80, 0);
    if (atraj_shaper_stream_init(&posed_stream, &posed_shaper, period, &posed.from, posed_line, DELAYS) != 0) { return; }
    for (int k = 1; k <= 100; ++k) {
        posed.from.p = atraj_move_pos(&posed_move, period * (a_float)k);
        posed.from.v = atraj_move_vel(&posed_move, period * (a_float)k);
        posed.from.a = atraj_move_acc(&posed_move, period * (a_float)k);
        count(&shaped, pose_stream, &posed_stream);
    }
    PRINT(shaped);
}

static path_problem posed_path;

static a_float plan_posed_path(void) { return (a_float)plan_path(&posed_path); }
static a_float improve_posed_path(void) { return (a_float)improve_path(&posed_path); }

/* The shims that pass the arguments count too: some ten instructions. */
static void paths(void) {
    a_float const none[9] = {0};
    counted plans = COUNTED(atraj_path_plan), updates = COUNTED(atraj_path_improve);
    for (unsigned number = 0; number != PATHS; ++number) {
        pose_path(&posed_path, number);
        add(&plans.sum, measure((void (*)(void))plan_posed_path, NULL, none));
        move_window(&posed_path, number);
        add(&updates.sum, measure((void (*)(void))improve_posed_path, NULL, none));
    }
    PRINT(plans, updates);
    print("path", "", "fastest-memory", sizeof(posed_path.work));
}

/* Longer paths through the same kind of points, and a window of 16 sections that moves on by one. */
enum { MOST_POINTS = 64, LONG = MOST_POINTS + 1, WIDE = 16, LONG_SIZE = ATRAJ_PATH_SIZE(AXES, LONG) };
static atraj_state long_states[(LONG + 1) * AXES];
static a_float long_durations[LONG], long_work[LONG_SIZE];
static size_t long_sections;

static a_float plan_long(void) {
    return (a_float)atraj_path_plan(long_states, long_durations, posed_path.limits, AXES, long_sections, 0, long_work);
}
static a_float improve_long(void) {
    return (a_float)atraj_path_improve(long_states, long_durations, posed_path.limits, AXES, WIDE, STEPS, long_work);
}

static void put_long(unsigned point, unsigned place) {
    put_point(&posed_path, point / 3, point, 0);
    memcpy(long_states + place * AXES, posed_path.states, AXES * sizeof(atraj_state));
}

static void print_long(const char *what, cost c, size_t sections) {
    print("paths", what, "-instructions", c.instructions);
    print("paths", what, "-stack", c.stack);
    print("paths", what, "-memory", (uint32_t)(atraj_path_size(AXES, sections) * sizeof(a_float)));
}

/* Whether the core has a unit for the real type. Without one QEMU takes a minute for long paths. */
#if defined(__ARM_FP)
enum { HAS_UNIT = (__ARM_FP >> (sizeof(a_float) == 8 ? 3 : 2)) & 1 };
#else
enum { HAS_UNIT = 0 };
#endif

static void long_paths(void) {
    static const struct { const char *name; size_t points; } cases[] = {{"4", 4}, {"16", 16}, {"64", 64}};
    a_float const none[9] = {0};
    pose_path(&posed_path, 0);
    for (size_t i = 0; i != sizeof(cases) / sizeof(*cases); ++i) {
        long_sections = cases[i].points + 1;
        for (unsigned point = 0; point <= long_sections; ++point) { put_long(point, point); }
        print_long(cases[i].name, measure((void (*)(void))plan_long, NULL, none), long_sections);
    }
    memmove(long_states, long_states + AXES, WIDE * AXES * sizeof(atraj_state));
    memmove(long_durations, long_durations + 1, (WIDE - 1) * sizeof(a_float));
    put_long(WIDE, WIDE);
    long_durations[WIDE - 1] = 0;
    print_long("window", measure((void (*)(void))improve_long, NULL, none), WIDE);
}

static void trap(void) {
    a_trajtrap ctx;
    ONCE(trap_gen, "cruise", ctx, 5, 4, -3, 0, 50, 0, 0);
    SWEEP3(trap, "", ctx, ctx.t);
}

static void poly(void) {
    a_trajpoly3 p3;
    ONCE(poly3_gen, "move", p3, 2, 1, 10, 3, -3);
    SWEEP3(poly3, "", p3, 2);
    a_trajpoly5 p5;
    ONCE(poly5_gen, "move", p5, 2, 1, 10, 3, -3, 7, -7);
    SWEEP3(poly5, "", p5, 2);
    a_trajpoly7 p7;
    ONCE(poly7_gen, "move", p7, 2, 1, 10, 3, -3, 7, -7, 9, -9);
    SWEEP3(poly7, "", p7, 2);
    SWEEP(poly7_jer, "", p7, 2);
}

int main(void) {
    start_timer();
    bell();
    worst_bell();
    trap();
    poly();
    fastest();
    if (atraj_move_plan) { moves(); }
    if (atraj_moves_sync) { axes(); }
    if (atraj_axis_tick) { axis(); }
    if (atraj_group_tick) { group(); }
    if (atraj_steps_next) { machine(); }
    if (atraj_shaper_stream_tick) { stream(); }
    if (atraj_path_plan) { paths(); }
    if (atraj_path_plan && HAS_UNIT) { long_paths(); }
    return 0;
}
