/* Replays golden rows on the target. Every number must have the original's bits, or both must be NaN. Plans that never fail, and
 * moves from any state to any state, must have the bits of the host's. */
#include <stddef.h>
#include "atraj.h"
#include "claraty/trapezoid.h"
#include "golden.h"
#include "semihost.h"

static unsigned rows, compared, differing;

static int same(real a, real b) {
    return a.bits == b.bits || (a.value != a.value && b.value != b.value);
}

/* Counts a number that is not the golden one, and prints the first of them. */
static void differ(const char *what, uint64_t row, size_t column, uint64_t got, uint64_t want) {
    if (++differing > 10) { return; }
    semihost_print(what);
    semihost_count(row, " column ");
    semihost_count(column, " is ");
    semihost_print_unsigned(got, 16);
    semihost_print(", golden ");
    semihost_print_unsigned(want, 16);
    semihost_print("\n");
}

static void compare(const char *what, const real *row, size_t column, size_t count, const a_float *got) {
    for (size_t i = 0; i != count; ++i) {
        real const value = {.value = got[i]}, want = row[column + i];
        ++compared;
        if (!same(value, want)) { differ(what, row[0].bits, column + i, value.bits, want.bits); }
    }
    ++rows;
}

/* A profile of liba, or a plan of atraj.h in liba's struct: its tables hold the arguments, the duration if the plan returns one and the
 * members of the struct; the case, the time and the evaluations. */
typedef a_float plan(void *ctx, const real *r);
typedef a_float evaluation(const void *ctx, a_float x);
typedef struct { const real *row; size_t rows, columns; } table;
typedef struct {
    const char *name;
    plan *plan;
    size_t arguments;
    int returns;
    table plans, evaluated;
    evaluation *evaluations[4];
} profile;

#define FIVE(r) r[1].value, r[2].value, r[3].value, r[4].value, r[5].value
#define SEVEN(r) FIVE(r), r[6].value, r[7].value
static a_float bell(void *ctx, const real *r) { return a_trajbell_gen(ctx, SEVEN(r)); }
static a_float trap(void *ctx, const real *r) { return a_trajtrap_gen(ctx, SEVEN(r)); }
static a_float poly3(void *ctx, const real *r) { return a_trajpoly3_gen(ctx, FIVE(r)), 0; }
static a_float poly5(void *ctx, const real *r) { return a_trajpoly5_gen(ctx, SEVEN(r)), 0; }
static a_float poly7(void *ctx, const real *r) { return a_trajpoly7_gen(ctx, SEVEN(r), r[8].value, r[9].value), 0; }
static a_float fastest_bell_plan(void *ctx, const real *r) { return atraj_bell_gen(ctx, SEVEN(r)); }
static a_float fastest_trap_plan(void *ctx, const real *r) { return atraj_trap_gen(ctx, SEVEN(r)); }

#define TABLE(t) {*t, ROWS(t), sizeof(*t) / sizeof(**t)}
#define F(name) (evaluation *)(void (*)(void))a_traj##name
static const profile profiles[] = {
    {"bell case ", bell, 7, 1, TABLE(bell_gen), TABLE(bell_eval), {F(bell_pos), F(bell_vel), F(bell_acc), F(bell_jer)}},
    {"trap case ", trap, 7, 1, TABLE(trap_gen), TABLE(trap_eval), {F(trap_pos), F(trap_vel), F(trap_acc)}},
    {"poly3 case ", poly3, 5, 0, TABLE(poly3_gen), TABLE(poly3_eval), {F(poly3_pos), F(poly3_vel), F(poly3_acc)}},
    {"poly5 case ", poly5, 7, 0, TABLE(poly5_gen), TABLE(poly5_eval), {F(poly5_pos), F(poly5_vel), F(poly5_acc)}},
    {"poly7 case ", poly7, 9, 0, TABLE(poly7_gen), TABLE(poly7_eval), {F(poly7_pos), F(poly7_vel), F(poly7_acc), F(poly7_jer)}},
    {"atraj_bell_gen case ", fastest_bell_plan, 7, 1, TABLE(fastest_bell), {0}, {0}},
    {"atraj_trap_gen case ", fastest_trap_plan, 7, 1, TABLE(fastest_trap), {0}, {0}},
};

/* Returns the number of evaluations that belong to no plan. */
static size_t replay_profile(const profile *p) {
    size_t next = 0;
    for (size_t i = 0; i != p->plans.rows; ++i) {
        const real *r = p->plans.row + i * p->plans.columns;
        const size_t members = 1 + p->arguments + (p->returns ? 1 : 0);
        a_float ctx[sizeof(a_trajpoly7) / sizeof(a_float)] = {0}, t = p->plan(ctx, r);
        if (p->returns) { compare(p->name, r, members - 1, 1, &t); }
        compare(p->name, r, members, p->plans.columns - members, ctx);
        for (; next != p->evaluated.rows; ++next) {
            const real *e = p->evaluated.row + next * p->evaluated.columns;
            if (e[0].bits != r[0].bits) { break; }
            a_float y[4];
            for (size_t k = 0; k != p->evaluated.columns - 2; ++k) { y[k] = p->evaluations[k](ctx, e[1].value); }
            compare(p->name, e, 2, p->evaluated.columns - 2, y);
        }
    }
    return p->evaluated.rows - next;
}

/* Compares binary64 numbers with `*golden` and moves `*golden` behind them. The columns count from 1, as in the golden file. */
static void compare_claraty(uint64_t line, size_t column, size_t count, const double *got, const uint64_t **golden) {
    for (size_t i = 0; i != count; ++i) {
        union { uint64_t bits; double value; } const value = {.value = got[i]}, want = {.bits = *(*golden)++};
        ++compared;
        if (value.bits == want.bits || (value.value != value.value && want.value != want.value)) { continue; }
        differ("claraty line ", line, column + i, value.bits, want.bits);
    }
}

static void compare_claraty_number(uint64_t line, size_t column, unsigned got, unsigned want) {
    ++compared;
    if (got != want) { differ("claraty line ", line, column, got, want); }
}

/* Plays the scripts of CLARAty's listing on the manual clock. */
static void replay_claraty(void) {
    claraty_trapezoid axis;
    const uint64_t *next = claraty_listing;
    while (next != claraty_listing + ROWS(claraty_listing)) {
        const uint64_t row = *next++, line = row >> 32;
        const unsigned operation = row & 0xFF, started = row >> 8 & 0xFF, type = row >> 16 & 0xFF, warnings = row >> 24 & 0xFF;
        double argument[4], setpoint[3];
        const size_t arguments = operation == OP_set ? 4 : operation == OP_advance || operation == OP_get_at;
        unsigned warned = 0;
        __builtin_memcpy(argument, next, arguments * sizeof *next);
        next += arguments;
        switch (operation) {
        case OP_init:
            claraty_trapezoid_init(&axis);
            claraty_trapezoid_set_mode(&axis, CLARATY_LISTING);
            claraty_trapezoid_set_clock(&axis, NULL, NULL);
            continue;
        case OP_set: claraty_trapezoid_set(&axis, argument[0], argument[1], argument[2], argument[3]); break;
        case OP_start: warned = claraty_trapezoid_start(&axis); break;
        case OP_stop: warned = claraty_trapezoid_stop(&axis); break;
        case OP_reset: claraty_trapezoid_reset(&axis); break;
        case OP_advance: claraty_trapezoid_advance_timer_by(&axis, argument[0]); break;
        case OP_get: claraty_trapezoid_get_setpoint(&axis, &setpoint[0], &setpoint[1], &setpoint[2]); break;
        case OP_get_at:
            claraty_trapezoid_get_setpoint_at(&axis, argument[0], &setpoint[0], &setpoint[1], &setpoint[2]);
            break;
        }
        if (operation == OP_start || (operation == OP_stop && started)) {
            claraty_profile p;
            claraty_trapezoid_get_profile(&axis, &p);
            const double profile[] = {p.t1, p.t2, p.tf, p.p_at_t1, p.p_at_t2, p.final_position, p.velocity, p.accel, p.decel};
            compare_claraty(line, 7, 9, profile, &next);
            compare_claraty_number(line, 16, p.type, type);
            compare_claraty_number(line, 18, warned, warnings);
        }
        if (operation == OP_get || operation == OP_get_at) { compare_claraty(line, 19, 3, setpoint, &next); }
        compare_claraty_number(line, 17, claraty_trapezoid_is_started(&axis), started);
        ++rows;
    }
}

/* Visits the rows of `table` with the case of `row`. `next` goes on from case to case, because tables are in order of cases. */
#define EACH(e, table, next, row) \
    for (const real *e; next != ROWS(table) && (e = table[next])[0].bits == row[0].bits; ++next)

static size_t replay_moves(void) {
    size_t phase = 0, evaluation = 0;
    for (size_t i = 0; i != ROWS(fastest_move); ++i) {
        const real *r = fastest_move[i];
        problem const q = problem_of(r);
        atraj_move m = {0};
        a_float const result[] = {(a_float)solve(&q, &m), m.t, (a_float)m.phases};
        atraj_state extremes[2];
        atraj_move_extremes(&m, &extremes[0], &extremes[1]);
        compare("move ", r, 14, 3, result);
        compare("move ", r, 17, 6, (const a_float *)extremes);
        a_float machine[MACHINE];
        run_machine((unsigned)r[0].bits, &q, &m, machine);
        compare("steps, shaped states and hold of move ", fastest_machine[i], 1, MACHINE, machine);
        const atraj_phase *replayed = m.phase;
        EACH(e, fastest_phase, phase, r) { compare("phase of move ", e, 1, 6, (const a_float *)replayed++); }
        EACH(e, fastest_eval, evaluation, r) {
            a_float x = e[1].value, p = atraj_move_pos(&m, x);
            a_float y[] = {p, atraj_move_vel(&m, x), atraj_move_acc(&m, x), atraj_move_jer(&m, x), atraj_move_time_at(&m, p)};
            compare("evaluation of move ", e, 2, 5, y);
        }
    }
    return ROWS(fastest_phase) - phase + ROWS(fastest_eval) - evaluation;
}

static size_t replay_axes(void) {
    static atraj_move axes[AXES]; /* the stack of the smallest board is small */
    size_t phase = 0;
    for (size_t i = 0; i != ROWS(fastest_axes); ++i) {
        const real *r = fastest_axes[i];
        axes_problem const q = axes_of(r);
        memset(axes, 0, sizeof(axes));
        int const returned = solve_axes(&q, axes);
        a_float const result[] = {(a_float)returned, axes->t};
        compare("axes ", r, 40, 2, result);
        unsigned axis = 0, replayed = 0;
        EACH(e, fastest_stretched, phase, r) {
            if (replayed > axes[axis].phases && axis + 1 < AXES) { ++axis, replayed = 0; }
            compare("phase of axes ", e, 1, 6, (const a_float *)&axes[axis].phase[replayed++]);
        }
    }
    return ROWS(fastest_stretched) - phase;
}

static void replay_paths(void) {
    static path_problem q;
    enum { PLANNED = 2 + SECTIONS + 3 * (SECTIONS + 1) * AXES };
    for (size_t i = 0; i != ROWS(fastest_path); ++i) {
        const real *r = fastest_path[i];
        pose_path(&q, r[0].bits);
        a_float returned = (a_float)plan_path(&q);
        compare("path ", r, 1, 1, &returned);
        compare("path ", r, 2, SECTIONS, q.durations);
        compare("path ", r, 2 + SECTIONS, 3 * (SECTIONS + 1) * AXES, (const a_float *)q.states);
        move_window(&q, r[0].bits);
        returned = (a_float)improve_path(&q);
        compare("window of path ", r, PLANNED, 1, &returned);
        compare("window of path ", r, PLANNED + 1, WINDOW, q.durations);
        compare("window of path ", r, PLANNED + 1 + WINDOW, 3 * (WINDOW + 1) * AXES, (const a_float *)q.states);
    }
}

#if defined(NEIGHBOUR)
/* From another Rust library in the same image: how many of `count` doubles lie below their mean. */
uint32_t neighbour_below_mean(const double *values, uint32_t count);

static int neighbour_works(void) {
    const double values[] = {1, 2, 3, 10};
    return neighbour_below_mean(values, 4) == 3;
}
#else
static int neighbour_works(void) { return 1; }
#endif

int main(void) {
    size_t left = replay_moves() + replay_axes();
    for (size_t i = 0; i != ROWS(profiles); ++i) { left += replay_profile(&profiles[i]); }
    replay_paths();
    replay_claraty();
    semihost_count(rows, " comparisons, ");
    semihost_count(compared, " numbers, ");
    semihost_count(differing, " differing\n");
    return differing || left || !compared || !neighbour_works();
}
