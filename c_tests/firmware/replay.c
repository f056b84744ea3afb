/* Replays golden rows on the target. Every number must have the original's bits, or both must be NaN. Plans that never fail, and
 * moves from any state to any state, must have the bits of the host's. */
#include <stddef.h>
#include "a/trajbell.h"
#include "a/trajpoly3.h"
#include "a/trajpoly5.h"
#include "a/trajpoly7.h"
#include "a/trajtrap.h"
#include "atraj.h"
#include "claraty/trapezoid.h"
#include "golden.h"
#include "semihost.h"

static unsigned rows, compared, differing;

static int same(real a, real b)
{
    return a.bits == b.bits || (a.value != a.value && b.value != b.value);
}

/* Counts a number that is not the golden one, and prints the first of them. */
static void differ(const char *what, uint64_t row, size_t column, uint64_t got, uint64_t want)
{
    if (++differing > 10) { return; }
    semihost_print(what);
    semihost_print_unsigned(row, 10);
    semihost_print(" column ");
    semihost_print_unsigned(column, 10);
    semihost_print(" is ");
    semihost_print_unsigned(got, 16);
    semihost_print(", golden ");
    semihost_print_unsigned(want, 16);
    semihost_print("\n");
}

static void compare(const char *what, const real *row, size_t column, size_t count, const a_float *got)
{
    for (size_t i = 0; i != count; ++i) {
        real const value = {.value = got[i]}, want = row[column + i];
        ++compared;
        if (!same(value, want)) { differ(what, row[0].bits, column + i, value.bits, want.bits); }
    }
    ++rows;
}

/* Visits the rows of `table` with the case of `row`. `next` goes on from case to case, because tables are in order of cases. */
#define EACH(e, table, next, row) \
    for (const real *e; next != ROWS(table) && (e = table[next])[0].bits == row[0].bits; ++next)

static size_t replay_bell(void)
{
    size_t next = 0;
    for (size_t i = 0; i != ROWS(bell_gen); ++i) {
        const real *r = bell_gen[i];
        a_trajbell ctx = {0};
        a_float t = a_trajbell_gen(&ctx, r[1].value, r[2].value, r[3].value, r[4].value, r[5].value, r[6].value, r[7].value);
        compare("bell_gen case ", r, 8, 1, &t);
        compare("bell_gen case ", r, 9, 14, (const a_float *)&ctx);
        EACH(e, bell_eval, next, r)
        {
            a_float x = e[1].value;
            a_float y[] = {a_trajbell_pos(&ctx, x), a_trajbell_vel(&ctx, x), a_trajbell_acc(&ctx, x), a_trajbell_jer(&ctx, x)};
            compare("bell_eval case ", e, 2, 4, y);
        }
    }
    return ROWS(bell_eval) - next;
}

static size_t replay_trap(void)
{
    size_t next = 0;
    for (size_t i = 0; i != ROWS(trap_gen); ++i) {
        const real *r = trap_gen[i];
        a_trajtrap ctx = {0};
        a_float t = a_trajtrap_gen(&ctx, r[1].value, r[2].value, r[3].value, r[4].value, r[5].value, r[6].value, r[7].value);
        compare("trap_gen case ", r, 8, 1, &t);
        compare("trap_gen case ", r, 9, 12, (const a_float *)&ctx);
        EACH(e, trap_eval, next, r)
        {
            a_float x = e[1].value;
            a_float y[] = {a_trajtrap_pos(&ctx, x), a_trajtrap_vel(&ctx, x), a_trajtrap_acc(&ctx, x)};
            compare("trap_eval case ", e, 2, 3, y);
        }
    }
    return ROWS(trap_eval) - next;
}

static size_t replay_poly3(void)
{
    size_t next = 0;
    for (size_t i = 0; i != ROWS(poly3_gen); ++i) {
        const real *r = poly3_gen[i];
        a_trajpoly3 ctx;
        a_trajpoly3_gen(&ctx, r[1].value, r[2].value, r[3].value, r[4].value, r[5].value);
        compare("poly3_gen case ", r, 6, 9, (const a_float *)&ctx);
        EACH(e, poly3_eval, next, r)
        {
            a_float x = e[1].value;
            a_float y[] = {a_trajpoly3_pos(&ctx, x), a_trajpoly3_vel(&ctx, x), a_trajpoly3_acc(&ctx, x)};
            compare("poly3_eval case ", e, 2, 3, y);
        }
    }
    return ROWS(poly3_eval) - next;
}

static size_t replay_poly5(void)
{
    size_t next = 0;
    for (size_t i = 0; i != ROWS(poly5_gen); ++i) {
        const real *r = poly5_gen[i];
        a_trajpoly5 ctx;
        a_trajpoly5_gen(&ctx, r[1].value, r[2].value, r[3].value, r[4].value, r[5].value, r[6].value, r[7].value);
        compare("poly5_gen case ", r, 8, 15, (const a_float *)&ctx);
        EACH(e, poly5_eval, next, r)
        {
            a_float x = e[1].value;
            a_float y[] = {a_trajpoly5_pos(&ctx, x), a_trajpoly5_vel(&ctx, x), a_trajpoly5_acc(&ctx, x)};
            compare("poly5_eval case ", e, 2, 3, y);
        }
    }
    return ROWS(poly5_eval) - next;
}

static size_t replay_poly7(void)
{
    size_t next = 0;
    for (size_t i = 0; i != ROWS(poly7_gen); ++i) {
        const real *r = poly7_gen[i];
        a_trajpoly7 ctx;
        a_trajpoly7_gen(&ctx, r[1].value, r[2].value, r[3].value, r[4].value, r[5].value, r[6].value, r[7].value, r[8].value, r[9].value);
        compare("poly7_gen case ", r, 10, 26, (const a_float *)&ctx);
        EACH(e, poly7_eval, next, r)
        {
            a_float x = e[1].value;
            a_float y[] = {a_trajpoly7_pos(&ctx, x), a_trajpoly7_vel(&ctx, x), a_trajpoly7_acc(&ctx, x), a_trajpoly7_jer(&ctx, x)};
            compare("poly7_eval case ", e, 2, 4, y);
        }
    }
    return ROWS(poly7_eval) - next;
}

/* Compares binary64 numbers with `*golden` and moves `*golden` behind them. The columns count from 1, as in the golden file. */
static void compare_claraty(uint64_t line, size_t column, size_t count, const double *got, const uint64_t **golden)
{
    for (size_t i = 0; i != count; ++i) {
        union { uint64_t bits; double value; } const value = {.value = got[i]}, want = {.bits = *(*golden)++};
        ++compared;
        if (value.bits == want.bits || (value.value != value.value && want.value != want.value)) { continue; }
        differ("claraty line ", line, column + i, value.bits, want.bits);
    }
}

static void compare_claraty_number(uint64_t line, size_t column, unsigned got, unsigned want)
{
    ++compared;
    if (got != want) { differ("claraty line ", line, column, got, want); }
}

/* Plays the scripts of CLARAty's listing on the manual clock. */
static void replay_claraty(void)
{
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

static void replay_fastest(void)
{
    for (size_t i = 0; i != ROWS(fastest_bell); ++i) {
        const real *r = fastest_bell[i];
        a_trajbell ctx;
        a_float t = atraj_bell_gen(&ctx, r[1].value, r[2].value, r[3].value, r[4].value, r[5].value, r[6].value, r[7].value);
        compare("atraj_bell_gen", r, 8, 1, &t);
        compare("atraj_bell_gen", r, 9, 14, (const a_float *)&ctx);
    }
    for (size_t i = 0; i != ROWS(fastest_trap); ++i) {
        const real *r = fastest_trap[i];
        a_trajtrap ctx;
        a_float t = atraj_trap_gen(&ctx, r[1].value, r[2].value, r[3].value, r[4].value, r[5].value, r[6].value, r[7].value);
        compare("atraj_trap_gen", r, 8, 1, &t);
        compare("atraj_trap_gen", r, 9, 12, (const a_float *)&ctx);
    }
}

static size_t replay_moves(void)
{
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
        const atraj_phase *replayed = m.phase;
        EACH(e, fastest_phase, phase, r) { compare("phase of move ", e, 1, 6, (const a_float *)replayed++); }
        EACH(e, fastest_eval, evaluation, r)
        {
            a_float x = e[1].value, p = atraj_move_pos(&m, x);
            a_float y[] = {p, atraj_move_vel(&m, x), atraj_move_acc(&m, x), atraj_move_jer(&m, x), atraj_move_time_at(&m, p)};
            compare("evaluation of move ", e, 2, 5, y);
        }
    }
    return ROWS(fastest_phase) - phase + ROWS(fastest_eval) - evaluation;
}

static size_t replay_axes(void)
{
    static atraj_move axes[AXES]; /* the stack of the smallest board is small */
    size_t phase = 0;
    for (size_t i = 0; i != ROWS(fastest_axes); ++i) {
        const real *r = fastest_axes[i];
        axes_problem const q = axes_of(r);
        int const returned = solve_axes(&q, axes);
        a_float const result[] = {(a_float)returned, axes->t};
        compare("axes ", r, 40, 2, result);
        unsigned axis = 0, replayed = 0;
        EACH(e, fastest_stretched, phase, r)
        {
            if (replayed > axes[axis].phases && axis + 1 < AXES) { ++axis, replayed = 0; }
            compare("phase of axes ", e, 1, 6, (const a_float *)&axes[axis].phase[replayed++]);
        }
    }
    return ROWS(fastest_stretched) - phase;
}

#if defined(NEIGHBOUR)
/* From another Rust library in the same image: how many of `count` doubles lie below their mean. */
uint32_t neighbour_below_mean(const double *values, uint32_t count);

static int neighbour_works(void)
{
    const double values[] = {1, 2, 3, 10};
    return neighbour_below_mean(values, 4) == 3;
}
#else
static int neighbour_works(void) { return 1; }
#endif

int main(void)
{
    size_t left = replay_bell() + replay_trap() + replay_poly3() + replay_poly5() + replay_poly7() + replay_moves() + replay_axes();
    replay_claraty();
    replay_fastest();
    semihost_print_unsigned(rows, 10);
    semihost_print(" comparisons, ");
    semihost_print_unsigned(compared, 10);
    semihost_print(" numbers, ");
    semihost_print_unsigned(differing, 10);
    semihost_print(" differing\n");
    return differing || left || !compared || !neighbour_works();
}
