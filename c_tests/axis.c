/*
 Tests the contract of every function of atraj/axis.h. Each pointer is once NULL, each number once wrong; a refusal leaves the axis
 untouched. Then ticks between plans: each setpoint has the bits of the move that is in force. The tests of `src/machine` and
 `c_tests/firmware/interrupt.c` interrupt the plans.
 Prints the line of the first broken promise and fails.
*/
#include "atraj/axis.h"
#include "promise.h"

static const atraj_limits limits = {5, -4, 10, -9, 30, -20};
static const atraj_state start = {1, 0, 0}, target = {9, 0, 0};
static const a_float period = A_FLOAT_C(0.0009765625); /* with it, the times of few ticks are exact */
enum { TOO_FAR_AHEAD = 1 << 27 };

static atraj_axis axis, before;

static int untouched(void) { return memcmp(&axis, &before, sizeof(axis)) == 0; }

static int same(atraj_state x, atraj_state y) { return x.p == y.p && x.v == y.v && x.a == y.a; }

static atraj_state tick(void)
{
    atraj_state now = {none, none, none};
    atraj_axis_tick(&axis, &now);
    return now;
}

/* --- refusals */

static int refused_init(void)
{
    const a_float periods[] = {0, -(a_float)0, -period, -A_FLOAT_MIN, endless, -endless, none}, no_numbers[] = {endless, -endless, none};
    int i, k;
    memset(&before, 0x55, sizeof(before));
    axis = before;
    for (i = 0; i < (int)A_LEN(periods); ++i)
    {
        PROMISE(atraj_axis_init(&axis, periods[i], &start) == ATRAJ_ERR_DURATION);
    }
    for (i = 0; i < (int)A_LEN(no_numbers); ++i)
    {
        for (k = 0; k < 3; ++k)
        {
            a_float numbers[3] = {1, 2, 3};
            numbers[k] = no_numbers[i];
            {
                const atraj_state state = {numbers[0], numbers[1], numbers[2]};
                PROMISE(atraj_axis_init(&axis, period, &state) == ATRAJ_ERR_NOT_FINITE);
            }
        }
    }
    PROMISE(atraj_axis_init(A_NULL, period, &start) == ATRAJ_ERR_NULL);
    PROMISE(atraj_axis_init(&axis, period, A_NULL) == ATRAJ_ERR_NULL);
    PROMISE(untouched());
    return 0;
}

static int refused_plans(void)
{
    static const atraj_limits no_limits = {0, -4, 10, -9, 30, -20};
    const atraj_limits no_numbers = {none, -4, 10, -9, 30, -20};
    const atraj_state nowhere = {none, 0, 0}, too_fast = {9, 6, 0}, beyond_range = {A_FLOAT_MAX, A_FLOAT_MAX, A_FLOAT_MAX};
    const a_float no_horizons[] = {0, -(a_float)0, -1, endless, -endless, none};
    atraj_state no_state = start;
    int i;
    PROMISE(ATRAJ_ERR_LATE == -8);
    PROMISE(atraj_axis_init(&axis, period, &start) == 0);
    before = axis;
    PROMISE(atraj_axis_go(A_NULL, &limits, &target, 1) == ATRAJ_ERR_NULL);
    PROMISE(atraj_axis_go(&axis, A_NULL, &target, 1) == ATRAJ_ERR_NULL);
    PROMISE(atraj_axis_go(&axis, &limits, A_NULL, 1) == ATRAJ_ERR_NULL);
    PROMISE(atraj_axis_reach(A_NULL, &limits, 1, 0, 1) == ATRAJ_ERR_NULL);
    PROMISE(atraj_axis_reach(&axis, A_NULL, 1, 0, 1) == ATRAJ_ERR_NULL);
    PROMISE(atraj_axis_stop(A_NULL, &limits, 1) == ATRAJ_ERR_NULL);
    PROMISE(atraj_axis_stop(&axis, A_NULL, 1) == ATRAJ_ERR_NULL);

    PROMISE(atraj_axis_track(A_NULL, &limits, &target, 1, 1) == ATRAJ_ERR_NULL);
    PROMISE(atraj_axis_track(&axis, A_NULL, &target, 1, 1) == ATRAJ_ERR_NULL);
    PROMISE(atraj_axis_track(&axis, &limits, A_NULL, 1, 1) == ATRAJ_ERR_NULL);

    PROMISE(atraj_axis_go(&axis, &no_limits, &target, 1) == ATRAJ_ERR_LIMITS);
    PROMISE(atraj_axis_go(&axis, &no_numbers, &target, 1) == ATRAJ_ERR_NOT_FINITE);
    PROMISE(atraj_axis_go(&axis, &limits, &nowhere, 1) == ATRAJ_ERR_NOT_FINITE);
    PROMISE(atraj_axis_go(&axis, &limits, &too_fast, 1) == ATRAJ_ERR_TARGET);
    PROMISE(atraj_axis_reach(&axis, &limits, none, 0, 1) == ATRAJ_ERR_NOT_FINITE);
    PROMISE(atraj_axis_reach(&axis, &limits, 0, endless, 1) == ATRAJ_ERR_NOT_FINITE);
    PROMISE(atraj_axis_reach(&axis, &limits, 6, 0, 1) == ATRAJ_ERR_TARGET);
    PROMISE(atraj_axis_stop(&axis, &no_limits, 1) == ATRAJ_ERR_LIMITS);
    PROMISE(atraj_axis_track(&axis, &no_limits, &target, 1, 1) == ATRAJ_ERR_LIMITS);
    PROMISE(atraj_axis_track(&axis, &no_numbers, &target, 1, 1) == ATRAJ_ERR_NOT_FINITE);
    PROMISE(atraj_axis_track(&axis, &limits, &nowhere, 1, 1) == ATRAJ_ERR_NOT_FINITE);
    PROMISE(atraj_axis_track(&axis, &limits, &beyond_range, 1, 2) == ATRAJ_ERR_NOT_FINITE);
    for (i = 0; i < (int)A_LEN(no_horizons); ++i)
    {
        PROMISE(atraj_axis_track(&axis, &limits, &target, no_horizons[i], 1) == ATRAJ_ERR_DURATION);
    }

    PROMISE(atraj_axis_go(&axis, &limits, &target, 0) == ATRAJ_ERR_LATE);
    PROMISE(atraj_axis_go(&axis, &limits, &target, TOO_FAR_AHEAD) == ATRAJ_ERR_LATE);
    PROMISE(atraj_axis_reach(&axis, &limits, 1, 0, ~0u) == ATRAJ_ERR_LATE);
    PROMISE(atraj_axis_stop(&axis, &limits, 0) == ATRAJ_ERR_LATE);
    PROMISE(atraj_axis_track(&axis, &limits, &target, 1, 0) == ATRAJ_ERR_LATE);
    PROMISE(atraj_axis_track(&axis, &limits, &target, 1, TOO_FAR_AHEAD) == ATRAJ_ERR_LATE);
    PROMISE(untouched());

    atraj_axis_tick(A_NULL, A_NULL);
    atraj_axis_tick(A_NULL, &no_state);
    PROMISE(no_state.p != no_state.p && no_state.v != no_state.v && no_state.a != no_state.a);
    PROMISE(untouched() && same(tick(), start));
    return 0;
}

/* --- ticks */

/* From the next tick on, the move is in force for `n` ticks. */
static int follows(const atraj_move *move, int from, int n)
{
    int i;
    for (i = from; i < from + n; ++i)
    {
        atraj_state expected;
        atraj_move_state(move, period * (a_float)i, &expected.p, &expected.v, &expected.a, A_NULL);
        PROMISE(same(tick(), expected));
    }
    return 0;
}

/* Each planner starts from the state after `lead` ticks, and the old move goes on until then. The counter of ticks wraps on the way. */
static int takes_over(void)
{
    enum { LEAD = 7, LONG = 3000 };
    atraj_move move, next;
    atraj_state from;
    PROMISE(atraj_axis_init(&axis, period, &start) == 0);
    PROMISE(atraj_move_plan(&move, &limits, &start, &target) == 0);
    PROMISE(atraj_axis_go(&axis, &limits, &target, LEAD) == 0);
    PROMISE(same(tick(), start));
    PROMISE(same(tick(), start));
    atraj_axis_tick(&axis, A_NULL); /* a tick without a place for the state counts too */
    PROMISE(same(tick(), start) && same(tick(), start) && same(tick(), start));
    PROMISE(!follows(&move, 0, 700));

    atraj_move_state(&move, period * (699 + LEAD), &from.p, &from.v, &from.a, A_NULL);
    PROMISE(atraj_move_reach(&next, &limits, &from, -2, 1) == ATRAJ_OVERSHOOTS); /* it turns */
    PROMISE(atraj_axis_reach(&axis, &limits, -2, 1, LEAD) == ATRAJ_OVERSHOOTS);
    PROMISE(!follows(&move, 700, LEAD - 1) && !follows(&next, 0, 300));

    move = next;
    atraj_move_state(&move, period * (299 + LEAD), &from.p, &from.v, &from.a, A_NULL);
    PROMISE(atraj_move_stop(&next, &limits, &from) == 0);
    PROMISE(atraj_axis_stop(&axis, &limits, LEAD) == 0);
    PROMISE(!follows(&move, 300, LEAD - 1) && !follows(&next, 0, LONG));
    PROMISE(tick().v == 0);
    return 0;
}

/* A plan that waits is replaced, in its tick or earlier. A refusal leaves it. */
static int replaced(void)
{
    static const atraj_limits slow = {1, -1, 2, -2, 5, -5};
    static const atraj_limits no_limits = {0, -4, 10, -9, 30, -20};
    static const unsigned leads[][3] = {{9, 9, 9}, {9, 12, 9}, {9, 4, 4}, {1, 5, 1}, {5, 1, 1}};
    atraj_move move;
    int i;
    PROMISE(atraj_move_plan(&move, &slow, &start, &target) == 0);
    for (i = 0; i < (int)A_LEN(leads); ++i)
    {
        unsigned k;
        PROMISE(atraj_axis_init(&axis, period, &start) == 0);
        PROMISE(atraj_axis_go(&axis, &limits, &target, leads[i][0]) == 0);
        PROMISE(atraj_axis_go(&axis, &slow, &target, leads[i][1]) == 0);
        before = axis;
        PROMISE(atraj_axis_go(&axis, &no_limits, &target, 1) == ATRAJ_ERR_LIMITS);
        PROMISE(atraj_axis_stop(&axis, &limits, 0) == ATRAJ_ERR_LATE);
        PROMISE(untouched());
        for (k = 1; k < leads[i][2]; ++k) { PROMISE(same(tick(), start)); }
        PROMISE(!follows(&move, 0, 100));
    }
    return 0;
}

/* The signal goes on until the plan takes over: at the lead, or earlier in the tick of a plan that waits. */
static int tracked(void)
{
    static const atraj_state signal = {A_FLOAT_C(1.5), 2, 3};
    static const unsigned leads[][2] = {{1, 1}, {8, 8}, {3, 8}};
    const a_float horizon = A_FLOAT_C(0.5);
    atraj_move move;
    int i;
    for (i = 0; i < (int)A_LEN(leads); ++i)
    {
        const a_float ahead = period * (a_float)leads[i][0];
        atraj_state later = signal;
        unsigned k;
        later.p = signal.p + ahead * (signal.v + A_FLOAT_C(0.5) * ahead * signal.a);
        later.v = signal.v + ahead * signal.a;
        PROMISE(atraj_move_track(&move, &limits, &start, &later, horizon) >= 0);
        PROMISE(atraj_axis_init(&axis, period, &start) == 0);
        if (leads[i][0] < leads[i][1]) { PROMISE(atraj_axis_go(&axis, &limits, &target, leads[i][0]) == 0); }
        PROMISE(atraj_axis_track(&axis, &limits, &signal, horizon, leads[i][1]) >= 0);
        for (k = 1; k < leads[i][0]; ++k) { PROMISE(same(tick(), start)); }
        PROMISE(!follows(&move, 0, 600));
    }
    return 0;
}

int main(void) { return refused_init() || refused_plans() || takes_over() || replaced() || tracked(); }
