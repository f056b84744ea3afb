/*
 Where the originals fail: 100,000 random moves with moving ends, planned by liba's functions and by those of atraj.h. A planner
     refuses    a move if it returns no duration,
     breaks     a move if atraj_*_check finds a limit exceeded or a jump,
     misses     a move if the plan does not end at the demanded velocity,
     lengthens  a move if the plan takes 1 % longer than the other planner's plan, which does nothing of the above.
*/
#include "a/trajbell.h"
#include "a/trajtrap.h"
#include "atraj.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>

#define MOVES 100000
#define BROKEN (ATRAJ_EXCEEDS_JERK | ATRAJ_EXCEEDS_ACCELERATION | ATRAJ_EXCEEDS_VELOCITY | ATRAJ_JUMPS)

struct move {
    a_float jm, am, dm, vm, p0, p1, v0, v1;
};

enum outcome { CLEAN, REFUSED, BREAKS, MISSES };

/* A plan sets `t` to its duration, s. */
struct planner {
    char const *name;
    enum outcome (*plan)(struct move const *m, a_float *t);
    long count[4], lengthened;
};

static double random_between(double low, double high)
{
    static uint64_t state = 1;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * ((double)(state >> 11) / 9007199254740992.0);
}

/* Limits spread over one or two decades, displacements over four. Any velocity within the limit, at both ends. */
static struct move random_move(void)
{
    struct move m;
    m.jm = (a_float)pow(10, random_between(0, 2));
    m.am = (a_float)pow(10, random_between(0, 2));
    m.dm = (a_float)pow(10, random_between(0, 2));
    m.vm = (a_float)pow(10, random_between(0, 1));
    m.p0 = (a_float)random_between(-5, 5);
    m.p1 = m.p0 + (a_float)copysign(pow(10, random_between(-2, 2)), random_between(-1, 1));
    m.v0 = (a_float)random_between(-1, 1) * m.vm;
    m.v1 = (a_float)random_between(-1, 1) * m.vm;
    return m;
}

static enum outcome outcome(a_float t, int findings, a_float v1, a_float demanded_v1)
{
    if (!(t > 0)) { return REFUSED; }
    if (findings < 0 || findings & BROKEN) { return BREAKS; }
    return v1 < demanded_v1 || v1 > demanded_v1 ? MISSES : CLEAN;
}

typedef a_float plan_bell(a_trajbell *, a_float, a_float, a_float, a_float, a_float, a_float, a_float);
static enum outcome bell(plan_bell *plan, struct move const *m, a_float *t)
{
    a_trajbell c = {0};
    *t = plan(&c, m->jm, m->am, m->vm, m->p0, m->p1, m->v0, m->v1);
    return outcome(*t, atraj_bell_check(&c, m->jm, m->am, m->vm), c.v1, m->v1);
}
static enum outcome liba_bell(struct move const *m, a_float *t) { return bell(a_trajbell_gen, m, t); }
static enum outcome our_bell(struct move const *m, a_float *t) { return bell(atraj_bell_gen, m, t); }

typedef a_float plan_trap(a_trajtrap *, a_float, a_float, a_float, a_float, a_float, a_float, a_float);
static enum outcome trap(plan_trap *plan, struct move const *m, a_float *t)
{
    /* liba wants the accelerations of a backward move with the opposite signs. */
    a_float const ac = m->p1 < m->p0 ? -m->am : m->am, de = m->p1 < m->p0 ? m->dm : -m->dm;
    a_trajtrap c = {0};
    *t = plan(&c, m->vm, ac, de, m->p0, m->p1, m->v0, m->v1);
    return outcome(*t, atraj_trap_check(&c, m->vm, ac, de), c.v1, m->v1);
}
static enum outcome liba_trap(struct move const *m, a_float *t) { return trap(a_trajtrap_gen, m, t); }
static enum outcome our_trap(struct move const *m, a_float *t) { return trap(atraj_trap_gen, m, t); }

static void compare(struct planner planners[2], struct move const *m)
{
    a_float t[2];
    enum outcome const o[2] = {planners[0].plan(m, &t[0]), planners[1].plan(m, &t[1])};
    for (int i = 0; i != 2; ++i) {
        ++planners[i].count[o[i]];
        planners[i].lengthened += o[0] == CLEAN && o[1] == CLEAN && t[i] > (a_float)1.01 * t[1 - i];
    }
}

int main(void)
{
    struct planner planners[4] = {{"a_trajbell_gen", liba_bell, {0}, 0},
                                  {"atraj_bell_gen", our_bell, {0}, 0},
                                  {"a_trajtrap_gen", liba_trap, {0}, 0},
                                  {"atraj_trap_gen", our_trap, {0}, 0}};
    for (long i = 0; i != MOVES; ++i) {
        struct move const m = random_move();
        compare(planners, &m);
        compare(planners + 2, &m);
    }
    printf("\nof %d moves\n%-18s%10s%10s%10s%12s\n", MOVES, "planner", "refuses", "breaks", "misses", "lengthens");
    for (int i = 0; i != 4; ++i) {
        struct planner const *const p = planners + i;
        printf("%-18s%10ld%10ld%10ld%12ld\n", p->name, p->count[REFUSED], p->count[BREAKS], p->count[MISSES], p->lengthened);
    }
    return 0;
}
