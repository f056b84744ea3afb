/* Problems for the planners of atraj/move.h and atraj/path.h. The host that plans them and the firmware that replays them share this file. */
#ifndef PROBLEM_H
#define PROBLEM_H

#include <string.h>
#include "atraj/clock.h"
#include "atraj/move.h"
#include "atraj/path.h"
#include "atraj/shaper.h"
#include "atraj/steps.h"

enum { PLAN, REACH, STOP, MEET, WITHIN, TRACK };
typedef struct {
    unsigned function;
    atraj_limits limits;
    atraj_state from, to;
} problem;

static inline int solve(const problem *q, atraj_move *m) {
    switch (q->function) {
    case REACH: return atraj_move_reach(m, &q->limits, &q->from, q->to.v, q->to.a);
    case STOP: return atraj_move_stop(m, &q->limits, &q->from);
    case MEET: return atraj_move_meet(m, &q->limits, &q->from, &q->to);
    case WITHIN: return atraj_move_within(m, &q->limits, &q->from, &q->to, q->from.p - 1, q->to.p + 1);
    case TRACK: return atraj_move_track(m, &q->limits, &q->from, &q->to, 0, (a_float)0.125);
    default: return atraj_move_plan(m, &q->limits, &q->from, &q->to);
    }
}

/* All steps of a motor that follows a move, which stands between two lines in the beginning: how many, the line of the end, the last time, and the
 * sum of all times, in which the bits of each count. */
static inline void step_through(const atraj_move *m, a_float results[5]) {
    atraj_steps steps;
    a_float time = 0, sum = 0, count = 0;
    results[0] = (a_float)atraj_steps_init(&steps, m, m->phase[0].p - (a_float)0.0625, (a_float)0.125);
    if (results[0] == 0) {
        for (; atraj_steps_next(&steps, m, &time); ++count) { sum += time; }
        results[1] = count, results[2] = (a_float)steps.count, results[3] = time, results[4] = sum;
    }
}

/* A shaper of each kind in turn, every third one smooth, every fourth one for a second frequency too. */
static inline void pose_shaper(atraj_shaper *shaper, unsigned number) {
    atraj_shaper_smooth(shaper, number % 3 ? 0 : (a_float)0.25);
    atraj_shaper_add(shaper, (int)(number % 5), 2 + (a_float)(number % 7), (a_float)(number % 4) / 16);
    if (number % 4 == 0) { atraj_shaper_add(shaper, ATRAJ_SHAPER_ZV, 5, 0); }
}

/* A hold of a move and its resumption, within half as much again as the limits of the plan: what the clock returns, when the rates are reached, and the state
 * in the middle of the first change. */
enum { CLOCKED = 8 };
static inline atraj_limits wider(const atraj_limits *planned) {
    a_float const more = (a_float)1.5;
    return (atraj_limits){more * planned->vmax, more * planned->vmin, more * planned->amax,
                          more * planned->amin, more * planned->jmax, more * planned->jmin};
}

static inline void run_clock(const problem *q, const atraj_move *m, a_float results[CLOCKED]) {
    atraj_limits const limits = wider(&q->limits);
    a_float const begin = m->t / 4;
    atraj_clock clock;
    atraj_clock_start(&clock);
    results[0] = (a_float)atraj_clock_rate(&clock, m, &limits, 1, 1, begin, 0);
    results[1] = atraj_clock_until(&clock);
    atraj_clock_state(&clock, m, 1, 1, (begin + results[1]) / 2, &results[2], &results[3], &results[4], &results[5]);
    results[6] = (a_float)atraj_clock_rate(&clock, m, &limits, 1, 1, results[1], 1);
    results[7] = atraj_clock_until(&clock);
}

/* What the steps of a move tell, the shaped motion at four times, and a hold. */
enum { STEPPED = 5, SHAPED = 4 * 3, MACHINE = STEPPED + SHAPED + CLOCKED };
static inline void run_machine(unsigned number, const problem *q, const atraj_move *m, a_float results[MACHINE]) {
    atraj_shaper shaper;
    atraj_state now[4];
    memset(results, 0, STEPPED * sizeof(*results)); /* a motor that is refused tells its answer alone */
    step_through(m, results);
    pose_shaper(&shaper, number);
    for (int i = 0; i != 4; ++i) { atraj_shaper_state(&shaper, m, (a_float)i / 3 * (m->t + shaper.t), &now[i]); }
    memcpy(results + STEPPED, now, sizeof(now));
    run_clock(q, m, results + STEPPED + SHAPED);
}

/* Axes that move together, on a straight line, or each between two positions. */
enum { AXES = 3 };
enum { SYNC, LINE, SYNC_WITHIN };
typedef struct {
    unsigned function;
    atraj_limits limits[AXES];
    atraj_state from[AXES], to[AXES];
    a_float duration, cycle;
} axes_problem;

/* Position limits near the ends: some axes have to wait, some cannot stop in time. */
static inline void put_bounds(const axes_problem *q, a_float *lowest, a_float *highest) {
    for (int i = 0; i != AXES; ++i) {
        a_float const p0 = q->from[i].p, p1 = q->to[i].p;
        lowest[i] = (p0 < p1 ? p0 : p1) - 3;
        highest[i] = (p0 < p1 ? p1 : p0) + 3;
    }
}

static inline int solve_axes(const axes_problem *q, atraj_move *axes) {
    switch (q->function) {
    case LINE: return atraj_moves_line(axes, q->limits, q->from, q->to, AXES, q->duration, q->cycle);
    case SYNC_WITHIN: {
        a_float lowest[AXES], highest[AXES];
        put_bounds(q, lowest, highest);
        return atraj_moves_sync_within(axes, q->limits, q->from, q->to, lowest, highest, AXES, q->duration, q->cycle);
    }
    default: return atraj_moves_sync(axes, q->limits, q->from, q->to, AXES, q->duration, q->cycle);
    }
}

/* Axes that pass 4 waypoints, and a window that moves on: it has the last 2 of these sections and a new one, and 8 steps improve it. */
enum { PATHS = 8, SECTIONS = 5, WINDOW = 3, STEPS = 8, PATH_SIZE = ATRAJ_PATH_SIZE(AXES, SECTIONS) };
typedef struct {
    atraj_limits limits[AXES];
    atraj_state states[(SECTIONS + 1) * AXES];
    a_float durations[SECTIONS], work[PATH_SIZE];
} path_problem;

/* A point of a path, at rest. The quarters are exact in both real types. */
static inline void put_point(path_problem *q, unsigned number, unsigned point, unsigned place) {
    for (unsigned i = 0; i != AXES; ++i) {
        unsigned const quarters = (number * 5 + point * (3 + i) * (i + 2) + i) % 11;
        q->states[place * AXES + i] = (atraj_state){(a_float)quarters / 4, 0, 0};
    }
}

static inline void pose_path(path_problem *q, unsigned number) {
    for (unsigned i = 0; i != AXES; ++i) { atraj_limits_init(&q->limits[i], 30 + 10 * (a_float)i, 10, 3); }
    for (unsigned point = 0; point <= SECTIONS; ++point) { put_point(q, number, point, point); }
}

static inline int plan_path(path_problem *q) {
    return atraj_path_plan(q->states, q->durations, q->limits, AXES, SECTIONS, 0, q->work);
}

/* Drops the sections that are passed, and appends a point. */
static inline void move_window(path_problem *q, unsigned number) {
    enum { PASSED = SECTIONS - (WINDOW - 1) };
    memmove(q->states, q->states + PASSED * AXES, WINDOW * AXES * sizeof(atraj_state));
    memmove(q->durations, q->durations + PASSED, (WINDOW - 1) * sizeof(a_float));
    put_point(q, number, SECTIONS + 1, WINDOW);
    q->durations[WINDOW - 1] = 0;
}

static inline int improve_path(path_problem *q) {
    return atraj_path_improve(q->states, q->durations, q->limits, AXES, WINDOW, STEPS, q->work);
}

#endif
