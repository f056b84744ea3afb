/*
 What planning in motion is worth: an axis is retargeted and stopped, follows a sensor and meets a part on a conveyor.

     any_state SETPOINTS

 It prints a table of what the plans returned: the plans of the three pictures, and 100,000 random ones. A random plan starts wherever
 the plan before is at a random time. One in ten gets new limits, so the axis may be outside them. A plan
     refused    has no motion,
     jumps      does not start at the state of the axis, or does not end at the target,
     exceeds    leaves the limits, though it starts inside,
     outside    starts outside the limits,
     overshoots passes the target and comes back, or first moves away.
 It appends the setpoints of the three pictures to SETPOINTS, in the form of servo.c.
*/
#include "atraj/move.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PERIOD 0.001 /* s */
#define PLANS 100000

struct count {
    char const *name;
    long plans, refused, jumps, exceeds, outside, overshoots;
};

static double random_between(double low, double high)
{
    static uint64_t state = 1;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * ((double)(state >> 11) / 9007199254740992.0);
}

static int is_beyond(a_float x, a_float low, a_float high)
{
    a_float const rounding = (a_float)1e-9 * (high - low);
    return !(x >= low - rounding && x <= high + rounding);
}

static int exceeds(atraj_move const *move, atraj_limits const *l)
{
    atraj_state low, high;
    atraj_move_extremes(move, &low, &high);
    return is_beyond(low.v, l->vmin, l->vmax) || is_beyond(high.v, l->vmin, l->vmax) || is_beyond(low.a, l->amin, l->amax) ||
           is_beyond(high.a, l->amin, l->amax);
}

/* Whether the axis is in this state at the time x, up to a rounding. */
static int is_at(atraj_move const *move, a_float x, atraj_state const *state)
{
    atraj_state now;
    atraj_move_state(move, x, &now.p, &now.v, &now.a, NULL);
    return fabs(now.p - state->p) < 1e-9 && fabs(now.v - state->v) < 1e-9 && fabs(now.a - state->a) < 1e-9;
}

/* Counts what a plan from a state returned. */
static void note(struct count *count, int found, atraj_move const *move, atraj_limits const *limits, atraj_state const *from)
{
    ++count->plans;
    if (found < 0) {
        ++count->refused;
        return;
    }
    count->overshoots += (found & ATRAJ_OVERSHOOTS) != 0;
    count->outside += (found & ATRAJ_STARTS_OUTSIDE) != 0;
    count->jumps += move->t > 0 && !is_at(move, 0, from);
    count->exceeds += !(found & ATRAJ_STARTS_OUTSIDE) && exceeds(move, limits);
}

static atraj_limits random_limits(void)
{
    atraj_limits l;
    l.vmax = (a_float)pow(10, random_between(0, 1));
    l.vmin = -(a_float)pow(10, random_between(0, 1));
    l.amax = (a_float)pow(10, random_between(0, 2));
    l.amin = -(a_float)pow(10, random_between(0, 2));
    l.jmax = (a_float)pow(10, random_between(0, 2));
    l.jmin = -(a_float)pow(10, random_between(0, 2));
    return l;
}

static void plan_at_random(struct count *count)
{
    atraj_limits limits = random_limits();
    atraj_state now = {0, 0, 0};
    atraj_move move;
    while (count->plans != PLANS) {
        if (random_between(0, 10) < 1) { limits = random_limits(); }
        atraj_state const from = now, to = {(a_float)random_between(-10, 10), 0, 0};
        int const found = atraj_move_plan(&move, &limits, &from, &to);
        note(count, found, &move, &limits, &from);
        if (found >= 0) {
            count->jumps += !is_at(&move, move.t, &to);
            a_float const x = (a_float)random_between(0, 1) * move.t;
            atraj_move_state(&move, x, &now.p, &now.v, &now.a, NULL);
        }
    }
}

/* Prints setpoints, and as phases what the axis does. */
struct plotter {
    FILE *file;
    char const *phase; /* since `from`; NULL at rest */
    double from;
};

static char const *what(atraj_state const *now)
{
    if (now->a > 0 || now->a < 0) { return now->a * now->v < 0 ? "decelerate" : "accelerate"; }
    return now->v > 0 || now->v < 0 ? "cruise" : NULL;
}

static void plot_phase(struct plotter *plotter, double t, char const *phase)
{
    if (plotter->phase && phase && !strcmp(plotter->phase, phase)) { return; }
    if (plotter->phase && plotter->from < t) { fprintf(plotter->file, "phase %.17g %.17g %s\n", plotter->from, t, plotter->phase); }
    plotter->phase = phase;
    plotter->from = t;
}

static void plot(struct plotter *plotter, double t, atraj_state const *now, a_float jerk)
{
    fprintf(plotter->file, "at %.17g %.17g %.17g %.17g %.17g\n", t, (double)now->p, (double)now->v, (double)now->a, (double)jerk);
}

static void retarget_and_stop(FILE *file, struct count *count)
{
    struct plotter plotter = {file, NULL, 0};
    atraj_limits limits;
    atraj_state const ahead = {10, 0, 0}, behind = {-2, 0, 0};
    atraj_state now = {0, 0, 0};
    atraj_move move, first;
    double start = 0;
    a_float jerk;
    /* No phase of these plans ends at a setpoint, where a rounding would change the picture. */
    atraj_limits_init(&limits, 28, 9, (a_float)4.6);
    note(count, atraj_move_plan(&move, &limits, &now, &ahead), &move, &limits, &now);
    first = move;
    fputs("move Retargeted and stopped: to 10 m, at 0.7 s back to -2 m, stopped at 1.8 s\n", file);
    for (int tick = 0; tick <= 3000; ++tick) {
        double const t = tick * PERIOD;
        atraj_move_state(&move, (a_float)(t - start), &now.p, &now.v, &now.a, &jerk);
        if (tick % 2 == 0) { plot(&plotter, t, &now, jerk); } /* README has this picture, so it is small */
        plot_phase(&plotter, t, what(&now));
        if (tick == 700) { note(count, atraj_move_plan(&move, &limits, &now, &behind), &move, &limits, &now); }
        if (tick == 1800) { note(count, atraj_move_stop(&move, &limits, &now), &move, &limits, &now); }
        if (tick == 700 || tick == 1800) { start = t; }
    }
    plot_phase(&plotter, 3, NULL);
    fputs("beside the first plan\n", file);
    for (int tick = 0; tick * PERIOD < first.t; tick += 2) {
        a_float const x = (a_float)(tick * PERIOD);
        atraj_move_state(&first, x, &now.p, &now.v, &now.a, &jerk);
        plot(&plotter, tick * PERIOD, &now, jerk);
    }
}

static void follow_sensor(FILE *file, struct count *count)
{
    struct plotter plotter = {file, NULL, 0};
    static double sensor[3001];
    atraj_limits limits;
    atraj_state now = {0, 0, 0};
    atraj_move move;
    a_float jerk = 0;
    atraj_limits_init(&limits, 200, 10, 1);
    fputs("move Following a sensor: 1 mm of noise and a step at 1.5 s; a plan every millisecond keeps 1 m/s, 10 m/s², 200 m/s³\n", file);
    for (int tick = 0; tick <= 3000; ++tick) {
        double const t = tick * PERIOD;
        sensor[tick] = 0.3 * sin(2 * t) + (t < 1.5 ? 0 : 0.3) + random_between(-0.001, 0.001);
        atraj_state const target = {(a_float)sensor[tick], 0, 0};
        plot(&plotter, t, &now, jerk);
        note(count, atraj_move_plan(&move, &limits, &now, &target), &move, &limits, &now);
        atraj_move_state(&move, (a_float)PERIOD, &now.p, &now.v, &now.a, &jerk);
    }
    fputs("beside the sensor\n", file);
    for (int tick = 0; tick <= 3000; ++tick) { fprintf(file, "at %.17g %.17g\n", tick * PERIOD, sensor[tick]); }
}

static void meet_part(FILE *file, struct count *count)
{
    struct plotter plotter = {file, NULL, 0};
    atraj_limits limits;
    atraj_state const home = {0, 0, 0}, part = {(a_float)0.5, (a_float)0.5, 0};
    atraj_state now = home;
    atraj_move move;
    double start = 0;
    a_float jerk = 0;
    atraj_limits_init(&limits, 50, 5, 3);
    note(count, atraj_move_meet(&move, &limits, &now, &part), &move, &limits, &now);
    fputs("move Meeting a part on a conveyor: the axis rides beside the part until 1.6 s and goes home\n", file);
    for (int tick = 0; tick <= 3000; ++tick) {
        double const t = tick * PERIOD;
        int const rides = start == 0 && t >= move.t;
        if (rides) {
            now = part;
            now.p += part.v * (a_float)t;
            jerk = 0;
        } else {
            atraj_move_state(&move, (a_float)(t - start), &now.p, &now.v, &now.a, &jerk);
        }
        plot(&plotter, t, &now, jerk);
        plot_phase(&plotter, t, rides ? "ride" : what(&now));
        if (tick == 1600) {
            note(count, atraj_move_plan(&move, &limits, &now, &home), &move, &limits, &now);
            start = t;
        }
    }
    plot_phase(&plotter, 3, NULL);
    fputs("beside the part\n", file);
    for (int tick = 0; tick <= 2000; tick += 2000) {
        double const t = tick * PERIOD;
        fprintf(file, "at %.17g %.17g %.17g\n", t, (double)(part.p + part.v * (a_float)t), (double)part.v);
    }
}

int main(int argc, char *argv[])
{
    FILE *const setpoints = argc == 2 ? fopen(argv[1], "a") : NULL;
    if (!setpoints) {
        fprintf(stderr, "usage: any_state setpoints.txt (a file that can be written)\n");
        return EXIT_FAILURE;
    }
    struct count counts[] = {{"retargeted and stopped", 0, 0, 0, 0, 0, 0},
                             {"following a sensor", 0, 0, 0, 0, 0, 0},
                             {"meeting a part", 0, 0, 0, 0, 0, 0},
                             {"random", 0, 0, 0, 0, 0, 0}};
    retarget_and_stop(setpoints, &counts[0]);
    follow_sensor(setpoints, &counts[1]);
    meet_part(setpoints, &counts[2]);
    plan_at_random(&counts[3]);
    printf("\n%-24s%10s%10s%10s%10s%10s%12s\n", "planned in motion", "plans", "refused", "jumps", "exceeds", "outside", "overshoots");
    for (size_t i = 0; i != sizeof(counts) / sizeof(counts[0]); ++i) {
        struct count const *const c = counts + i;
        printf("%-24s%10ld%10ld%10ld%10ld%10ld%12ld\n", c->name, c->plans, c->refused, c->jumps, c->exceeds, c->outside, c->overshoots);
    }
    int const written = !ferror(setpoints);
    return fclose(setpoints) == 0 && written ? EXIT_SUCCESS : EXIT_FAILURE;
}
