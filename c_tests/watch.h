/* What the programs share that interrupt the plans of an axis, or with GROUP of a group of two: a main loop that plans at random, and an
 * interrupt that watches every setpoint. */
#ifdef GROUP
#include "atraj/group.h"
enum { AXES = 2 };
#else
#include "atraj/axis.h"
enum { AXES = 1 };
#endif

#define PERIOD ((a_float)0.001)
enum { SETTLED = 600 }; /* ticks: every move is over by then */

static const atraj_limits limits[2] = {{5, -5, 100, -100, 5000, -5000}, {5, -5, 100, -100, 5000, -5000}};
static const atraj_state start[2] = {{0, 0, 0}, {0, 0, 0}}, last_target[2] = {{A_FLOAT_C(0.25), 0, 0}, {A_FLOAT_C(-0.125), 0, 0}};

/* The interrupt's own. */
static struct {
    atraj_state now[AXES];
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
    a_float const jerk = limits->jmax, rounding = 64 * A_FLOAT_EPSILON;
    return A_ABS(y.p - x.p - PERIOD / 2 * (x.v + y.v)) <= jerk * PERIOD * PERIOD * PERIOD / 12 + rounding &&
           A_ABS(y.v - x.v - PERIOD / 2 * (x.a + y.a)) <= jerk * PERIOD * PERIOD / 4 + rounding * limits->vmax &&
           A_ABS(y.a - x.a) <= jerk * PERIOD + rounding * limits->amax && A_ABS(y.v) <= limits->vmax * (1 + rounding) &&
           A_ABS(y.a) <= limits->amax * (1 + rounding);
}

#ifdef GROUP
static atraj_group group;
static atraj_state states[AXES];
static atraj_move room[3 * AXES];
static int init(void) { return atraj_group_init(&group, PERIOD, states, room, AXES); }
static void tick(atraj_state *now) { atraj_group_tick(&group, now); }
static int go(const atraj_state *to, unsigned lead) { return atraj_group_go(&group, limits, to, lead); }
#else
static atraj_axis axis;
static int init(void) { return atraj_axis_init(&axis, PERIOD, start); }
static void tick(atraj_state *now) { atraj_axis_tick(&axis, now); }
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
    return atraj_move_plan(&axis.moves[next], limits, &from, to);
}
#else
static int go(const atraj_state *to, unsigned lead) { return atraj_axis_go(&axis, limits, to, lead); }
#endif
#endif

static void interrupt(void) {
    atraj_state now[AXES];
    int i;
    tick(now);
    for (i = 0; i != AXES; ++i) {
        if (!continues(watch.now[i], now[i])) { ++watch.jumps; }
        watch.now[i] = now[i];
    }
    ++watch.ticks;
}

static void count(int answer) {
    if (answer >= 0) { ++answers.accepted; }
    else if (answer == ATRAJ_ERR_LATE) { ++answers.late; }
    else { ++answers.refused; }
}

/* Plans once, a stop, a move, or with one axis next to a signal at rest, with a lead of at most this number of ticks. */
static void plan(unsigned longest_lead) {
    static unsigned random = 1;
    unsigned const lead = 1 + next_random(&random) % longest_lead, where = next_random(&random);
    atraj_state to[2] = {{0, 0, 0}, {0, 0, 0}};
    to[0].p = (a_float)(where % 1000) / 1000 - A_FLOAT_C(0.5);
    to[1].p = (a_float)(where % 777) / 1000 - A_FLOAT_C(0.5);
    switch (where % 4) {
#ifdef GROUP
    case 0: count(atraj_group_stop(&group, limits, lead)); break;
    case 1: count(atraj_group_sync(&group, limits, to, lead)); break;
#else
    case 0: count(atraj_axis_stop(&axis, limits, lead)); break;
    case 1: count(atraj_axis_track(&axis, limits, to, 0, 50 * PERIOD, lead)); break;
#endif
    default: count(go(to, lead));
    }
}

/* Whether the axes, which had time to settle, are where the last plan leads, and came there smoothly. */
static int is_good(void) {
    int i, is_there = 1;
    for (i = 0; i != AXES; ++i) { is_there &= watch.now[i].p == last_target[i].p && watch.now[i].v == 0 && watch.now[i].a == 0; }
    return watch.jumps == 0 && answers.refused == 0 && answers.accepted > 0 && answers.late > 0 && is_there;
}
