/*
 The arm of example 12 flies by its waypoints: each joint may be 5 degrees off its point above the part, and 15
 degrees on the way home; at the part it is exact. This program prints one setpoint in 50 of a clock of 4 ms: the positions, then the
 velocities. Then it prints where each point is passed, and how much time the zones save.

     make dist
     cc -Itarget/dist/include examples/24_zones.c target/dist/lib/libatraj.a -lm -o zones
*/
#include "atraj/path.h"
#include <math.h>
#include <stdio.h>

#define CYCLE 0.004 /* s */
#ifndef EVERY
#define EVERY 50 /* print every EVERY-th setpoint */
#endif
enum { AXES = 6, SECTIONS = 4, SIZE = ATRAJ_PATH_SIZE_NEAR(AXES, SECTIONS) };

static double const points[SECTIONS + 1][AXES] = {
    {0, -90, 90, 0, 0, 0}, /* degrees */
    {30, -60, 70, 0, -40, 90}, /* above the part */
    {30, -50, 75, 0, -55, 90}, /* at the part */
    {-45, -70, 80, 20, -30, -90},
    {0, -90, 90, 0, 0, 0}, /* home */
};
static double const tolerances[SECTIONS - 1][AXES] = {{5, 5, 5, 5, 5, 5}, {0, 0, 0, 0, 0, 0}, {15, 15, 15, 15, 15, 15}};
static double work[SIZE];

/* Sets the states to the points, at rest. */
static void begin(atraj_state states[][AXES])
{
    for (int k = 0; k <= SECTIONS; ++k) {
        for (int i = 0; i < AXES; ++i) { states[k][i].p = points[k][i], states[k][i].v = states[k][i].a = 0; }
    }
}

static double sum(double const durations[])
{
    double t = 0;
    for (int k = 0; k < SECTIONS; ++k) { t += durations[k]; }
    return t;
}

int main(void)
{
    atraj_limits limits[AXES];
    for (int i = 0; i < AXES; ++i) { atraj_limits_init(&limits[i], i < 3 ? 4000 : 9000, i < 3 ? 500 : 1000, i < 3 ? 120 : 250); }
    atraj_state states[SECTIONS + 1][AXES];
    atraj_move moves[SECTIONS][AXES];
    double durations[SECTIONS], start = 0;
    begin(states);
    if (atraj_path_plan(states[0], durations, limits, AXES, SECTIONS, 0, work) < 0) { return 1; }
    double const exact = sum(durations);
    begin(states);
    if (atraj_path_plan_near(states[0], durations, limits, tolerances[0], AXES, SECTIONS, 0, work) < 0) { return 1; }
    if (atraj_path_moves(moves[0], limits, states[0], durations, AXES, SECTIONS) < 0) { return 1; }
    puts("Arm through zones: six joints fly by above the part, and are exact at it");
    puts("joints 1 to 3 within 120 deg/s");
    puts("joints 4 to 6 within 250 deg/s");
    for (int k = 0, tick = 0; k < SECTIONS; ++k) {
        for (; tick * CYCLE < start + durations[k]; ++tick) {
            if (tick % EVERY != 0) { continue; }
            printf("%.3f s:", tick * CYCLE);
            for (int i = 0; i < AXES; ++i) { printf(" %.2f", atraj_move_pos(&moves[k][i], tick * CYCLE - start)); }
            printf(" deg,");
            for (int i = 0; i < AXES; ++i) { printf(" %.2f", atraj_move_vel(&moves[k][i], tick * CYCLE - start)); }
            printf(" deg/s\n");
        }
        start += durations[k];
        double off = 0;
        for (int i = 0; i < AXES; ++i) { off = fmax(off, fabs(states[k + 1][i].p - points[k + 1][i])); }
        printf("%.3f s -> point %d, %.2f deg off\n", start, k + 1, off);
        if (off > (k + 1 < SECTIONS ? tolerances[k][0] : 0)) { return 1; }
    }
    printf("%.3f s through the points, %.3f s through the zones: %.0f %% saved\n", exact, start, 100 * (1 - start / exact));
    return !(start < exact);
}
