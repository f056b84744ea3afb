/* What the programs share that interrupt the plans of an axis: a main loop that plans at random, and an interrupt that watches every
 * setpoint. */
#include "atraj/axis.h"

#define PERIOD ((a_float)0.001)
enum { SETTLED = 600 }; /* ticks: every move is over by then */

static const atraj_limits limits = {5, -5, 100, -100, 5000, -5000};
static const atraj_state start = {0, 0, 0}, last_target = {A_FLOAT_C(0.25), 0, 0};
static atraj_axis axis;

/* The interrupt's own. */
static struct {
    atraj_state now;
    unsigned ticks, jumps;
} watch;
/* The main loop's own. */
static struct {
    unsigned accepted, late, refused;
} answers;

static unsigned next_random(unsigned *state) {
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8;
}

/* Whether the axis can come from one state to the next within a period: the trapezoidal rule, with its error for the highest jerk. */
static int continues(atraj_state x, atraj_state y) {
    a_float const jerk = limits.jmax, rounding = 64 * A_FLOAT_EPSILON;
    return A_ABS(y.p - x.p - PERIOD / 2 * (x.v + y.v)) <= jerk * PERIOD * PERIOD * PERIOD / 12 + rounding &&
           A_ABS(y.v - x.v - PERIOD / 2 * (x.a + y.a)) <= jerk * PERIOD * PERIOD / 4 + rounding * limits.vmax &&
           A_ABS(y.a - x.a) <= jerk * PERIOD + rounding * limits.amax && A_ABS(y.v) <= limits.vmax * (1 + rounding) &&
           A_ABS(y.a) <= limits.amax * (1 + rounding);
}

static void interrupt(void) {
    atraj_state now;
    atraj_axis_tick(&axis, &now);
    if (!continues(watch.now, now)) { ++watch.jumps; }
    watch.now = now;
    ++watch.ticks;
}

static void count(int answer) {
    if (answer >= 0) { ++answers.accepted; }
    else if (answer == ATRAJ_ERR_LATE) { ++answers.late; }
    else { ++answers.refused; }
}

#ifdef PUBLISHED_EARLY
/* A fault: the plan is published before it is whole. */
static int go(const atraj_state *to, unsigned lead) {
    unsigned volatile *const now = &axis.words[0], *const due = &axis.words[2], *const starts = &axis.words[3];
    unsigned const place = *now & 3, tick = ((*now >> 2) + lead) & 0xFFFFFFF, next = (place + 1) % 3;
    a_float const x = PERIOD * (a_float)((tick - starts[place]) & 0xFFFFFFF);
    atraj_state from;
    atraj_move_state(&axis.moves[place], x, &from.p, &from.v, &from.a, A_NULL);
    starts[next] = tick;
    *due = (tick << 2 | place) << 2 | next;
    return atraj_move_plan(&axis.moves[next], &limits, &from, to);
}
#else
static int go(const atraj_state *to, unsigned lead) { return atraj_axis_go(&axis, &limits, to, lead); }
#endif

/* Plans once, a stop, a move, or one beside a signal at rest, with a lead of at most this number of ticks. */
static void plan(unsigned longest_lead) {
    static unsigned random = 1;
    unsigned const lead = 1 + next_random(&random) % longest_lead, where = next_random(&random);
    if (where % 4 == 0) { count(atraj_axis_stop(&axis, &limits, lead)); }
    else if (where % 4 == 1) {
        atraj_state signal = {0, 0, 0};
        signal.p = (a_float)(where % 1000) / 1000 - A_FLOAT_C(0.5);
        count(atraj_axis_track(&axis, &limits, &signal, 0, 50 * PERIOD, lead));
    } else {
        atraj_state to = {0, 0, 0};
        to.p = (a_float)(where % 1000) / 1000 - A_FLOAT_C(0.5);
        count(go(&to, lead));
    }
}

/* Whether the axis, which had time to settle, is where the last plan leads, and came there smoothly. */
static int is_good(void) {
    return watch.jumps == 0 && answers.refused == 0 && answers.accepted > 0 && answers.late > 0 && watch.now.p == last_target.p &&
           watch.now.v == 0 && watch.now.a == 0;
}
