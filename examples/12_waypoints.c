/*
 The arm of example 10 passes its waypoints without stops. The planner finds the velocities and accelerations at the points, and how
 long each section takes; `atraj_path_moves` makes the motions. This program prints one setpoint in 50 of a clock of
 4 ms: the positions, then the velocities. Then it prints how much time a stop at every point would cost.

     make dist
     cc -Itarget/dist/include examples/12_waypoints.c target/dist/lib/libatraj.a -lm -o waypoints
*/
#include "atraj/path.h"
#include <stdio.h>

#define CYCLE 0.004 /* s */
#ifndef EVERY
#define EVERY 50 /* print every EVERY-th setpoint */
#endif
enum { AXES = 6, SECTIONS = 4, SIZE = ATRAJ_PATH_SIZE(AXES, SECTIONS) };

static atraj_state const points[SECTIONS + 1][AXES] = {
    {{0, 0, 0}, {-90, 0, 0}, {90, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, /* degrees, and at rest */
    {{30, 0, 0}, {-60, 0, 0}, {70, 0, 0}, {0, 0, 0}, {-40, 0, 0}, {90, 0, 0}},
    {{30, 0, 0}, {-50, 0, 0}, {75, 0, 0}, {0, 0, 0}, {-55, 0, 0}, {90, 0, 0}}, /* down */
    {{-45, 0, 0}, {-70, 0, 0}, {80, 0, 0}, {20, 0, 0}, {-30, 0, 0}, {-90, 0, 0}},
    {{0, 0, 0}, {-90, 0, 0}, {90, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, /* home */
};

/* Prints the setpoints of a section that begins at `start`, from this tick on. The result is the first tick after the section. */
static int follow(atraj_move const axes[], double start, int tick)
{
    for (; tick * CYCLE < start + axes[0].t; ++tick) {
        if (tick % EVERY != 0) { continue; }
        printf("%.3f s:", tick * CYCLE);
        for (int i = 0; i < AXES; ++i) { printf(" %.2f", atraj_move_pos(&axes[i], tick * CYCLE - start)); }
        printf(" deg,");
        for (int i = 0; i < AXES; ++i) { printf(" %.2f", atraj_move_vel(&axes[i], tick * CYCLE - start)); }
        printf(" deg/s\n");
    }
    return tick;
}

int main(void)
{
    atraj_limits limits[AXES];
    for (int i = 0; i < AXES; ++i) { atraj_limits_init(&limits[i], i < 3 ? 4000 : 9000, i < 3 ? 500 : 1000, i < 3 ? 120 : 250); }
    atraj_move moves[SECTIONS][AXES];
    double stopping = 0, start = 0;
    for (int k = 0; k < SECTIONS; ++k) {
        if (atraj_moves_sync(moves[k], limits, points[k], points[k + 1], AXES, 0, 0) < 0) { return 1; }
        stopping += moves[k][0].t;
    }
    atraj_state states[SECTIONS + 1][AXES];
    for (int k = 0; k <= SECTIONS; ++k) {
        for (int i = 0; i < AXES; ++i) { states[k][i] = points[k][i]; }
    }
    double durations[SECTIONS], work[SIZE];
    if (atraj_path_plan(&states[0][0], durations, limits, AXES, SECTIONS, 0, work) < 0) { return 1; }
    if (atraj_path_moves(moves[0], limits, states[0], durations, AXES, SECTIONS) < 0) { return 1; }
    puts("Arm through waypoints: six joints pass each together and do not stop");
    puts("joints 1 to 3 within 120 deg/s");
    puts("joints 4 to 6 within 250 deg/s");
    for (int k = 0, tick = 0; k < SECTIONS; ++k) {
        tick = follow(moves[k], start, tick);
        start += moves[k][0].t;
        printf("%.3f s -> point %d\n", start, k + 1);
        for (int i = 0; i < AXES; ++i) {
            if (atraj_move_pos(&moves[k][i], moves[k][i].t) != points[k + 1][i].p) { return 1; }
        }
    }
    printf("%.3f s with a stop at every point, %.3f s without: %.0f %% saved\n", stopping, start, 100 * (1 - start / stopping));
    return 0;
}
