/* A problem for a planner of atraj/move.h. The host that plans it and the firmware that replays it share this file. */
#ifndef PROBLEM_H
#define PROBLEM_H

#include "atraj/move.h"

enum { PLAN, REACH, STOP, MEET, WITHIN, TRACK };
typedef struct {
    unsigned function;
    atraj_limits limits;
    atraj_state from, to;
} problem;

static inline int solve(const problem *q, atraj_move *m)
{
    switch (q->function) {
    case REACH: return atraj_move_reach(m, &q->limits, &q->from, q->to.v, q->to.a);
    case STOP: return atraj_move_stop(m, &q->limits, &q->from);
    case MEET: return atraj_move_meet(m, &q->limits, &q->from, &q->to);
    case WITHIN: return atraj_move_within(m, &q->limits, &q->from, &q->to, q->from.p - 1, q->to.p + 1);
    case TRACK: return atraj_move_track(m, &q->limits, &q->from, &q->to, (a_float)0.125);
    default: return atraj_move_plan(m, &q->limits, &q->from, &q->to);
    }
}

/* Axes that move together, or on a straight line. */
enum { AXES = 3 };
typedef struct {
    unsigned line;
    atraj_limits limits[AXES];
    atraj_state from[AXES], to[AXES];
    a_float duration, cycle;
} axes_problem;

static inline int solve_axes(const axes_problem *q, atraj_move *axes)
{
    return q->line ? atraj_moves_line(axes, q->limits, q->from, q->to, AXES, q->duration, q->cycle)
                   : atraj_moves_sync(axes, q->limits, q->from, q->to, AXES, q->duration, q->cycle);
}

#endif
