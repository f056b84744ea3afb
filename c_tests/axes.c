/*
 Tests the contract of atraj_moves_sync, atraj_moves_sync_within and atraj_moves_line. Each pointer is once NULL, each time and each
 number once wrong; a refusal leaves all moves untouched, also if the last axis is the one refused. Then the arguments that reach the
 planner: the duration, the cycle, the walls, the findings. `tests/oracle` judges the motions.
 Prints the line of the first broken promise and fails.
*/
#include "atraj/move.h"
#include "promise.h"

typedef int planner(atraj_move *axes, const atraj_limits *limits, const atraj_state *from, const atraj_state *to, size_t n,
                    a_float duration, a_float cycle);
enum { AXES = 3, NUMBERS = 12 };

/* Between no walls. */
static int sync_within(atraj_move *axes, const atraj_limits *limits, const atraj_state *from, const atraj_state *to, size_t n,
                       a_float duration, a_float cycle)
{
    const a_float lowest[AXES] = {-endless, -endless, -endless}, highest[AXES] = {endless, endless, endless};
    return atraj_moves_sync_within(axes, limits, from, to, lowest, highest, n, duration, cycle);
}
static planner *const planners[] = {atraj_moves_sync, atraj_moves_line, sync_within};
enum { PLANNERS = 3 };

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
    int i, axis, number;
    PROMISE(sizeof(struct axis) == NUMBERS * sizeof(a_float));
    for (i = 0; i < PLANNERS * AXES * NUMBERS; ++i)
    {
        planner *const plan = planners[i % PLANNERS];
        axis = i / PLANNERS % AXES, number = i / PLANNERS / AXES;
        {
            const int is_limit = number < 6;
            const struct set no_number = with(axis, number, none);
            const struct set no_limit = with(axis, number, 0), far = with(axis, number, number % 2 ? endless : -endless);
            PROMISE(answers(ATRAJ_ERR_NOT_FINITE, plan, &no_number, 0, 0));
            PROMISE(!is_limit || answers(ATRAJ_ERR_LIMITS, plan, &no_limit, 0, 0));
            PROMISE(answers(is_limit ? ATRAJ_ERR_LIMITS : ATRAJ_ERR_NOT_FINITE, plan, &far, 0, 0));
        }
    }
    return 0;
}

/* An end too fast, a start beside the line. */
static int refused_ends(void)
{
    atraj_move axes[AXES];
    int i, axis;
    for (i = 0; i < PLANNERS * AXES; ++i)
    {
        axis = i / PLANNERS;
        {
            const struct set fast = with(axis, 10, 8), beside = with(axis, 7, A_FLOAT_C(0.125));
            PROMISE(answers(ATRAJ_ERR_TARGET, planners[i % PLANNERS], &fast, 0, 0));
            PROMISE(answers(ATRAJ_ERR_LINE, atraj_moves_line, &beside, 0, 0));
            PROMISE(atraj_moves_sync(axes, beside.limits, beside.from, beside.to, AXES, 0, 0) >= 0);
        }
    }
    return 0;
}

/* Each axis has a wall at its own index: at an end, beyond it, wrong, and no number. */
static int positions(void)
{
    const struct set set = set_of(good);
    const a_float lowest[AXES] = {-3, -3, -3}, highest[AXES] = {12, 4, 3};
    const struct
    {
        a_float low, high;
        int answer;
    } walls[] = {{-endless, endless, 0},
                 {-3, A_FLOAT_C(-2.5), ATRAJ_ERR_POSITION},
                 {A_FLOAT_C(9.5), 12, ATRAJ_ERR_POSITION},
                 {12, -3, ATRAJ_ERR_LIMITS},
                 {endless, -endless, ATRAJ_ERR_LIMITS},
                 {2, 2, ATRAJ_ERR_LIMITS},
                 {none, 12, ATRAJ_ERR_NOT_FINITE},
                 {-3, none, ATRAJ_ERR_NOT_FINITE}};
    atraj_move before[AXES], axes[AXES];
    int axis, i, k;
    memset(before, 0x55, sizeof(before));
    memcpy(axes, before, sizeof(axes));
    PROMISE(atraj_moves_sync_within(axes, set.limits, set.from, set.to, A_NULL, highest, AXES, 0, 0) == ATRAJ_ERR_NULL);
    PROMISE(atraj_moves_sync_within(axes, set.limits, set.from, set.to, lowest, A_NULL, AXES, 0, 0) == ATRAJ_ERR_NULL);
    PROMISE(memcmp(axes, before, sizeof(axes)) == 0);
    PROMISE(atraj_moves_sync_within(axes, set.limits, set.from, set.to, lowest, highest, AXES, 30, 0) == 0 && axes[0].t == 30);
    for (axis = 0; axis < AXES; ++axis)
    {
        atraj_state low, high;
        atraj_move_extremes(&axes[axis], &low, &high);
        PROMISE(low.p >= lowest[axis] && high.p <= highest[axis]);
    }
    for (i = 0; i < AXES * (int)A_LEN(walls); ++i)
    {
        a_float lows[AXES], highs[AXES];
        axis = i % AXES, k = i / AXES;
        memcpy(lows, lowest, sizeof(lows));
        memcpy(highs, highest, sizeof(highs));
        lows[axis] = walls[k].low, highs[axis] = walls[k].high;
        memcpy(axes, before, sizeof(axes));
        PROMISE(atraj_moves_sync_within(axes, set.limits, set.from, set.to, lows, highs, AXES, 0, 0) == walls[k].answer);
        PROMISE((walls[k].answer < 0) == (memcmp(axes, before, sizeof(axes)) == 0));
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

/* --- plans */

/* Each argument arrives: the duration, the cycle, the number of axes. */
static int one_axis(void)
{
    const atraj_state from = {0, 0, 0}, to = {10, 0, 0};
    atraj_limits limits;
    atraj_move axis, fastest;
    int i;
    atraj_limits_init(&limits, 30, 10, 5);
    PROMISE(atraj_move_plan(&fastest, &limits, &from, &to) == 0); /* 17/6 s */
    for (i = 0; i < PLANNERS; ++i)
    {
        PROMISE(planners[i](&axis, &limits, &from, &to, 1, 0, 0) == 0);
        PROMISE(A_ABS(axis.t - fastest.t) <= 4 * A_FLOAT_EPSILON * fastest.t);
        PROMISE(planners[i](&axis, &limits, &from, &to, 1, 5, 0) == 0 && axis.t == 5);
        PROMISE(atraj_move_pos(&axis, 0) == 0 && atraj_move_pos(&axis, 5) == 10);
        PROMISE(planners[i](&axis, &limits, &from, &to, 1, 0, A_FLOAT_C(0.25)) == 0 && axis.t == 3);
        PROMISE(planners[i](&axis, &limits, &from, &to, 1, A_FLOAT_C(4.75), A_FLOAT_C(0.5)) == 0 && axis.t == 5);
        PROMISE(planners[i](&axis, &limits, &to, &to, 1, 2, 0) == 0 && axis.t == 2);
        PROMISE(planners[i](&axis, &limits, &to, &to, 1, 0, A_FLOAT_C(0.5)) == 0 && axis.t == 0);
    }
    return 0;
}

/* Each axis has the limits, the start and the end at its own index. */
static int several_axes(void)
{
    const struct set set = set_of(good);
    int i, k;
    for (i = 0; i < PLANNERS; ++i)
    {
        atraj_move axes[AXES];
        PROMISE(planners[i](axes, set.limits, set.from, set.to, AXES, 20, 0) == 0);
        for (k = 0; k < AXES; ++k)
        {
            PROMISE(axes[k].t == 20);
            PROMISE(atraj_move_pos(&axes[k], 0) == set.from[k].p && atraj_move_vel(&axes[k], 0) == set.from[k].v);
            PROMISE(atraj_move_pos(&axes[k], 20) == set.to[k].p && atraj_move_acc(&axes[k], 20) == set.to[k].a);
        }
    }
    return 0;
}

static int findings(void)
{
    struct set set = with(AXES - 1, 7, 8);
    atraj_move axes[AXES];
    PROMISE(atraj_moves_sync(axes, set.limits, set.from, set.to, AXES, 0, 0) & ATRAJ_STARTS_OUTSIDE);
    set = with(AXES - 1, 7, 2);
    set.to[AXES - 1] = (atraj_state){A_FLOAT_C(-0.9375), 0, 0}; /* too near to stop */
    PROMISE(atraj_moves_sync(axes, set.limits, set.from, set.to, AXES, 0, 0) & ATRAJ_OVERSHOOTS);
    return 0;
}

/* Axes on a line stop on it. A refusal leaves them. */
static int stops_on_the_line(void)
{
    static const atraj_limits limits[2] = {{5, -5, 10, -10, 30, -30}, {5, -5, 10, -10, 60, -60}};
    static const atraj_limits no_limits[2] = {{5, -5, 10, -10, 30, -30}, {0, -5, 10, -10, 60, -60}};
    static const atraj_state from[2] = {{0, 0, 0}, {0, 0, 0}}, to[2] = {{10, 0, 0}, {-5, 0, 0}};
    atraj_move axes[2], before[2];
    a_float p;
    memset(axes, 0, sizeof(axes));
    PROMISE(atraj_moves_line(axes, limits, from, to, 2, 0, 0) == 0);
    memcpy(before, axes, sizeof(axes));
    PROMISE(atraj_moves_line_stop(A_NULL, limits, 2, 1) == ATRAJ_ERR_NULL);
    PROMISE(atraj_moves_line_stop(axes, A_NULL, 2, 1) == ATRAJ_ERR_NULL);
    PROMISE(atraj_moves_line_stop(axes, limits, 0, 1) == ATRAJ_ERR_NULL);
    PROMISE(atraj_moves_line_stop(axes, no_limits, 2, 1) == ATRAJ_ERR_LIMITS);
    axes[1] = axes[0], axes[1].phase[1].a = axes[1].phase[1].j = 1;
    PROMISE(atraj_moves_line_stop(axes, limits, 2, 1) == ATRAJ_ERR_LINE);
    axes[1] = before[1];
    PROMISE(memcmp(axes, before, sizeof(axes)) == 0);
    p = atraj_move_pos(axes, 1);
    PROMISE(atraj_moves_line_stop(axes, limits, 2, 1) == 0);
    PROMISE(axes[0].phase[0].p == p && axes[0].t == axes[1].t && atraj_move_vel(axes, axes[0].t) == 0);
    PROMISE(fabs((double)(atraj_move_pos(&axes[0], axes[0].t) + 2 * atraj_move_pos(&axes[1], axes[0].t))) < 1e-5);
    return 0;
}

int main(void)
{
    return refused_pointers() || refused_times() || refused_numbers() || refused_ends() || positions() || too_far() || one_axis() || several_axes() ||
           findings() || stops_on_the_line();
}
