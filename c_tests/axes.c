/*
 Tests the contract of atraj_moves_sync and atraj_moves_line. Each pointer is once NULL, each time and each number once wrong; a
 refusal leaves all moves untouched, also if the last axis is the one refused. Then the plans: one axis, equal durations, ticks,
 exact ends, the line.
 Prints the line of the first broken promise and fails.
*/
#include "atraj/move.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

#define PROMISE(condition) \
    do { \
        if (!(condition)) \
        { \
            printf("%s:%d: broken: %s\n", __FILE__, __LINE__, #condition); \
            return 1; \
        } \
    } while (0)

static const a_float none = (a_float)NAN, endless = (a_float)INFINITY;

typedef int planner(atraj_move *axes, const atraj_limits *limits, const atraj_state *from, const atraj_state *to, size_t n,
                    a_float duration, a_float cycle);
static planner *const planners[] = {atraj_moves_sync, atraj_moves_line};
enum { SYNC, LINE, PLANNERS };

enum { AXES = 3, NUMBERS = 12 };

/* What one axis is asked for, as twelve numbers: limits, start, end. */
struct axis
{
    atraj_limits limits;
    atraj_state from, to;
};
/* Velocities and accelerations that point along the line from (1, 2, -1) to (9, -2, 1). */
static const struct axis good[AXES] = {
    {{5, -4, 10, -9, 30, -20}, {1, 2, 2}, {9, 1, -2}},
    {{3, -6, 12, -8, 25, -40}, {2, -1, -1}, {-2, A_FLOAT_C(-0.5), 1}},
    {{7, -2, 9, -15, 50, -35}, {-1, A_FLOAT_C(0.5), A_FLOAT_C(0.5)}, {1, A_FLOAT_C(0.25), A_FLOAT_C(-0.5)}},
};

struct set
{
    atraj_limits limits[AXES];
    atraj_state from[AXES], to[AXES];
};
static struct set set_of(const struct axis axes[AXES])
{
    struct set set;
    int i;
    for (i = 0; i < AXES; ++i)
    {
        set.limits[i] = axes[i].limits;
        set.from[i] = axes[i].from;
        set.to[i] = axes[i].to;
    }
    return set;
}
/* The good axes, but for a number of one. */
static struct set with(int axis, int number, a_float value)
{
    struct axis axes[AXES];
    a_float numbers[NUMBERS];
    memcpy(axes, good, sizeof(axes));
    memcpy(numbers, &axes[axis], sizeof(numbers));
    numbers[number] = value;
    memcpy(&axes[axis], numbers, sizeof(numbers));
    return set_of(axes);
}

/* --- refusals */

/* Whether a plan has this answer, and an error has left all moves untouched. */
static int answers(int expected, planner *plan, const struct set *set, a_float duration, a_float cycle)
{
    atraj_move before[AXES], axes[AXES];
    int answer;
    memset(before, 0x55, sizeof(before));
    memcpy(axes, before, sizeof(axes));
    answer = plan(axes, set->limits, set->from, set->to, AXES, duration, cycle);
    if (answer != expected) { printf("answer %d instead of %d\n", answer, expected); }
    return answer == expected && (answer < 0) == (memcmp(axes, before, sizeof(axes)) == 0);
}

static int refused_pointers(void)
{
    const struct set set = set_of(good);
    int i;
    PROMISE(ATRAJ_ERR_DURATION < ATRAJ_ERR_TARGET && ATRAJ_ERR_LINE < ATRAJ_ERR_TARGET && ATRAJ_ERR_DURATION != ATRAJ_ERR_LINE);
    for (i = 0; i < PLANNERS; ++i)
    {
        atraj_move before[AXES], axes[AXES];
        memset(before, 0x55, sizeof(before));
        memcpy(axes, before, sizeof(axes));
        PROMISE(planners[i](A_NULL, set.limits, set.from, set.to, AXES, 0, 0) == ATRAJ_ERR_NULL);
        PROMISE(planners[i](axes, A_NULL, set.from, set.to, AXES, 0, 0) == ATRAJ_ERR_NULL);
        PROMISE(planners[i](axes, set.limits, A_NULL, set.to, AXES, 0, 0) == ATRAJ_ERR_NULL);
        PROMISE(planners[i](axes, set.limits, set.from, A_NULL, AXES, 0, 0) == ATRAJ_ERR_NULL);
        PROMISE(planners[i](A_NULL, A_NULL, A_NULL, A_NULL, 0, 0, 0) == ATRAJ_ERR_NULL);
        PROMISE(planners[i](axes, set.limits, set.from, set.to, 0, 0, 0) == ATRAJ_ERR_NULL);
        PROMISE(memcmp(axes, before, sizeof(axes)) == 0);
        PROMISE(planners[i](axes, set.limits, set.from, set.to, AXES - 1, 0, 0) >= 0);
        PROMISE(memcmp(&axes[AXES - 1], &before[AXES - 1], sizeof(axes[0])) == 0);
    }
    return 0;
}

static int refused_times(void)
{
    const struct set set = set_of(good);
    int i, k;
    const a_float wrong[] = {-A_FLOAT_MIN, -1, -A_FLOAT_MAX, -endless, endless, none};
    for (i = 0; i < PLANNERS; ++i)
    {
        for (k = 0; k < (int)A_LEN(wrong); ++k)
        {
            PROMISE(answers(ATRAJ_ERR_DURATION, planners[i], &set, wrong[k], 0));
            PROMISE(answers(ATRAJ_ERR_DURATION, planners[i], &set, wrong[k], wrong[k]));
            PROMISE(answers(ATRAJ_ERR_DURATION, planners[i], &set, 0, wrong[k]));
        }
        PROMISE(answers(0, planners[i], &set, -(a_float)0, -(a_float)0));
    }
    return 0;
}

/* Each number of each axis. The last axis is refused after the others could be planned. */
static int refused_numbers(void)
{
    struct set bad;
    int i, axis, number;
    PROMISE(sizeof(struct axis) == NUMBERS * sizeof(a_float));
    for (i = 0; i < PLANNERS; ++i)
    {
        for (axis = 0; axis < AXES; ++axis)
        {
            for (number = 0; number < NUMBERS; ++number)
            {
                bad = with(axis, number, none);
                PROMISE(answers(ATRAJ_ERR_NOT_FINITE, planners[i], &bad, 0, 0));
                if (number < 6)
                {
                    bad = with(axis, number, 0);
                    PROMISE(answers(ATRAJ_ERR_LIMITS, planners[i], &bad, 0, 0));
                    bad = with(axis, number, number % 2 ? endless : -endless);
                    PROMISE(answers(ATRAJ_ERR_LIMITS, planners[i], &bad, 0, 0));
                }
                else
                {
                    bad = with(axis, number, endless);
                    PROMISE(answers(ATRAJ_ERR_NOT_FINITE, planners[i], &bad, 0, 0));
                    bad = with(axis, number, -endless);
                    PROMISE(answers(ATRAJ_ERR_NOT_FINITE, planners[i], &bad, 0, 0));
                }
            }
            bad = with(axis, 10, 8);
            PROMISE(answers(ATRAJ_ERR_TARGET, planners[i], &bad, 0, 0));
            bad = with(axis, 11, 16);
            PROMISE(answers(ATRAJ_ERR_TARGET, planners[i], &bad, 0, 0));
        }
    }
    return 0;
}

/* A way beyond the range of the real type. */
static int too_far(void)
{
    struct set bad = set_of(good);
    bad.from[AXES - 1] = (atraj_state){-A_FLOAT_MAX, 0, 0};
    bad.to[AXES - 1] = (atraj_state){A_FLOAT_MAX, 0, 0};
    PROMISE(answers(ATRAJ_ERR_NOT_FINITE, atraj_moves_sync, &bad, 0, 0));
    bad.from[0].v = bad.from[0].a = bad.to[0].v = bad.to[0].a = 0;
    bad.from[1].v = bad.from[1].a = bad.to[1].v = bad.to[1].a = 0;
    PROMISE(answers(ATRAJ_ERR_NOT_FINITE, atraj_moves_line, &bad, 0, 0));
    return 0;
}

static int off_the_line(void)
{
    atraj_move axes[AXES];
    int axis, number;
    for (axis = 0; axis < AXES; ++axis)
    {
        for (number = 7; number < NUMBERS; ++number)
        {
            struct set bad = with(axis, number, A_FLOAT_C(0.125));
            if (number == 9) { continue; } /* the position at the end */
            PROMISE(answers(ATRAJ_ERR_LINE, atraj_moves_line, &bad, 0, 0));
            PROMISE(atraj_moves_sync(axes, bad.limits, bad.from, bad.to, AXES, 0, 0) >= 0);
        }
    }
    return 0;
}

/* --- plans */

static int is_same(atraj_state x, atraj_state y) { return x.p == y.p && x.v == y.v && x.a == y.a; }
static atraj_state state_at(const atraj_move *axis, a_float x)
{
    atraj_state now;
    atraj_move_state(axis, x, &now.p, &now.v, &now.a, A_NULL);
    return now;
}

/* Lasts t, to the bit, and begins and ends exactly where it is told. */
static int is_met(const atraj_move *axis, a_float t, atraj_state from, atraj_state to)
{
    PROMISE(t > 0 && memcmp(&axis->t, &t, sizeof(t)) == 0 && axis->phases <= 15);
    PROMISE(axis->phase[axis->phases].t == t && axis->phase[axis->phases].duration == 0);
    PROMISE(is_same(state_at(axis, 0), from) && is_same(state_at(axis, -1), from));
    PROMISE(is_same(state_at(axis, t), to) && is_same(state_at(axis, endless), to));
    return 0;
}

static int is_tick(a_float t, a_float cycle)
{
    const a_float count = t / cycle;
    return A_ABS(count - (a_float)floor((double)count + 0.5)) <= 4 * A_FLOAT_EPSILON * count;
}

static int several_axes(void)
{
    static const a_float durations[] = {0, 1, A_FLOAT_C(2.5), 20}, cycles[] = {0, A_FLOAT_C(0.001), A_FLOAT_C(0.004), A_FLOAT_C(0.3), 7};
    const struct set set = set_of(good);
    int i, d, c, k;
    for (i = 0; i < PLANNERS; ++i)
    {
        atraj_move fastest[AXES], axes[AXES];
        PROMISE(planners[i](fastest, set.limits, set.from, set.to, AXES, 0, 0) >= 0);
        for (d = 0; d < (int)A_LEN(durations); ++d)
        {
            for (c = 0; c < (int)A_LEN(cycles); ++c)
            {
                PROMISE(planners[i](axes, set.limits, set.from, set.to, AXES, durations[d], cycles[c]) >= 0);
                for (k = 0; k < AXES; ++k)
                {
                    if (is_met(&axes[k], axes[0].t, set.from[k], set.to[k])) { return 1; }
                }
                PROMISE(axes[0].t >= durations[d] * (1 - 4 * A_FLOAT_EPSILON));
                PROMISE(axes[0].t >= fastest[0].t * (1 - 4 * A_FLOAT_EPSILON));
                PROMISE(cycles[c] <= 0 || is_tick(axes[0].t, cycles[c]));
            }
        }
    }
    return 0;
}

static int the_slowest_axis_leads(void)
{
    const struct set set = set_of(good);
    atraj_move axes[AXES], alone;
    a_float slowest = 0;
    int i;
    PROMISE(atraj_moves_sync(axes, set.limits, set.from, set.to, AXES, 0, 0) >= 0);
    for (i = 0; i < AXES; ++i)
    {
        PROMISE(atraj_move_plan(&alone, &set.limits[i], &set.from[i], &set.to[i]) >= 0);
        PROMISE(axes[i].t >= alone.t);
        slowest = alone.t > slowest ? alone.t : slowest;
    }
    PROMISE(axes[0].t <= slowest * (1 + 4 * A_FLOAT_EPSILON));
    return 0;
}

/* Every axis is as far on its way as the others. */
static int on_the_line(void)
{
    const struct set set = set_of(good);
    atraj_move axes[AXES];
    int tick, i;
    PROMISE(atraj_moves_line(axes, set.limits, set.from, set.to, AXES, 3, A_FLOAT_C(0.004)) >= 0);
    for (tick = 0; tick <= 1000; ++tick)
    {
        const a_float x = axes[0].t * (a_float)tick / 1000;
        for (i = 1; i < AXES; ++i)
        {
            const a_float share = i == 1 ? A_FLOAT_C(-0.5) : A_FLOAT_C(0.25);
            const atraj_state lead = state_at(&axes[0], x), now = state_at(&axes[i], x);
            PROMISE(A_ABS(now.p - set.from[i].p - share * (lead.p - set.from[0].p)) <= 64 * A_FLOAT_EPSILON);
            PROMISE(A_ABS(now.v - share * lead.v) <= 64 * A_FLOAT_EPSILON && A_ABS(now.a - share * lead.a) <= 64 * A_FLOAT_EPSILON);
        }
    }
    return 0;
}

/* One axis is stretched, or ends on a tick. Without a way, a move of the given duration rests. */
static int one_axis(void)
{
    const atraj_state from = {0, 0, 0}, to = {10, 0, 0};
    atraj_limits limits;
    atraj_move axis, plan;
    int i;
    atraj_limits_init(&limits, 30, 10, 5);
    PROMISE(atraj_move_plan(&plan, &limits, &from, &to) == 0); /* 17/6 s */
    for (i = 0; i < PLANNERS; ++i)
    {
        PROMISE(planners[i](&axis, &limits, &from, &to, 1, 0, 0) == 0);
        PROMISE(A_ABS(axis.t - plan.t) <= 4 * A_FLOAT_EPSILON * plan.t);
        PROMISE(planners[i](&axis, &limits, &from, &to, 1, 5, 0) == 0 && axis.t == 5);
        if (is_met(&axis, 5, from, to)) { return 1; }
        PROMISE(planners[i](&axis, &limits, &from, &to, 1, 0, A_FLOAT_C(0.25)) == 0 && axis.t == 3);
        if (is_met(&axis, 3, from, to)) { return 1; }
        PROMISE(planners[i](&axis, &limits, &from, &to, 1, A_FLOAT_C(4.75), A_FLOAT_C(0.5)) == 0 && axis.t == 5);
        if (is_met(&axis, 5, from, to)) { return 1; }
        PROMISE(planners[i](&axis, &limits, &to, &to, 1, 2, 0) == 0 && axis.t == 2);
        if (is_met(&axis, 2, to, to)) { return 1; }
        PROMISE(atraj_move_pos(&axis, 1) == 10 && atraj_move_vel(&axis, 1) == 0);
        PROMISE(planners[i](&axis, &limits, &to, &to, 1, 0, A_FLOAT_C(0.5)) == 0 && axis.t == 0);
    }
    return 0;
}

static int flags(void)
{
    struct set set = set_of(good);
    atraj_move axes[AXES];
    set.from[AXES - 1].v = 8;
    PROMISE(atraj_moves_sync(axes, set.limits, set.from, set.to, AXES, 0, 0) & ATRAJ_STARTS_OUTSIDE);
    set = set_of(good);
    set.to[AXES - 1] = (atraj_state){A_FLOAT_C(-0.9375), 0, 0}; /* too near to stop */
    set.from[AXES - 1].v = 2;
    PROMISE(atraj_moves_sync(axes, set.limits, set.from, set.to, AXES, 0, 0) & ATRAJ_OVERSHOOTS);
    return 0;
}

int main(void)
{
    return refused_pointers() || refused_times() || refused_numbers() || too_far() || off_the_line() || several_axes() ||
           the_slowest_axis_leads() || on_the_line() || one_axis() || flags();
}
