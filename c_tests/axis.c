/*
 Tests the contract of every function of atraj/axis.h. Ticks between plans: each setpoint has the bits of the move that is in
 force. `tests/miri` asks for NULL and NaN, `are_bad_requests_refused` for leads of no tick. The tests of `src/machine` and
 `c_tests/firmware/interrupt.c` interrupt the plans.
 Prints the line of the first broken promise and fails.
*/
#include "atraj/axis.h"
#include "promise.h"

static const atraj_limits limits = {5, -4, 10, -9, 30, -20};
static const atraj_state start = {1, 0, 0}, target = {9, 0, 0};
static const a_float period = A_FLOAT_C(0.0009765625); /* with it, the times of few ticks are exact */

static atraj_axis axis, before;

static int untouched(void) { return memcmp(&axis, &before, sizeof(axis)) == 0; }

static int same(atraj_state x, atraj_state y) { return x.p == y.p && x.v == y.v && x.a == y.a; }

static atraj_state tick(void) {
    atraj_state now = {none, none, none};
    atraj_axis_tick(&axis, &now);
    return now;
}

/* From the next tick on, the move is in force for `n` ticks. */
static int follows(const atraj_move *move, int from, int n) {
    int i;
    for (i = from; i < from + n; ++i) {
        atraj_state expected;
        atraj_move_state(move, period * (a_float)i, &expected.p, &expected.v, &expected.a, A_NULL);
        PROMISE(same(tick(), expected));
    }
    return 0;
}

/* Each planner starts from the state after `lead` ticks, and the old move goes on until then. The counter of ticks wraps on the way. */
static int takes_over(void) {
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
static int replaced(void) {
    static const atraj_limits slow = {1, -1, 2, -2, 5, -5};
    static const atraj_limits no_limits = {0, -4, 10, -9, 30, -20};
    static const unsigned leads[][3] = {{9, 9, 9}, {9, 12, 9}, {9, 4, 4}, {1, 5, 1}, {5, 1, 1}};
    atraj_move move;
    int i;
    PROMISE(atraj_move_plan(&move, &slow, &start, &target) == 0);
    for (i = 0; i < (int)A_LEN(leads); ++i) {
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
static int tracked(void) {
    static const atraj_state signal = {A_FLOAT_C(1.5), 2, 3};
    static const unsigned leads[][2] = {{1, 1}, {8, 8}, {3, 8}};
    const a_float horizon = A_FLOAT_C(0.5), jerk = 4;
    atraj_move move;
    int i;
    for (i = 0; i < (int)A_LEN(leads); ++i) {
        const a_float ahead = period * (a_float)leads[i][0];
        atraj_state later = signal;
        unsigned k;
        later.p = signal.p + ahead * (signal.v + ahead * (A_FLOAT_C(0.5) * signal.a + ahead * jerk * (1 / (a_float)6)));
        later.v = signal.v + ahead * (signal.a + A_FLOAT_C(0.5) * ahead * jerk);
        later.a = signal.a + ahead * jerk;
        PROMISE(atraj_move_track(&move, &limits, &start, &later, jerk, horizon) >= 0);
        PROMISE(atraj_axis_init(&axis, period, &start) == 0);
        if (leads[i][0] < leads[i][1]) { PROMISE(atraj_axis_go(&axis, &limits, &target, leads[i][0]) == 0); }
        PROMISE(atraj_axis_track(&axis, &limits, &signal, jerk, horizon, leads[i][1]) >= 0);
        for (k = 1; k < leads[i][0]; ++k) { PROMISE(same(tick(), start)); }
        PROMISE(!follows(&move, 0, 600));
    }
    return 0;
}

int main(void) { return takes_over() || replaced() || tracked(); }
