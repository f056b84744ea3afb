/*
 An arm with six axes follows waypoints and stops at each. The axes have limits of their own, arrive at a waypoint together, and
 stretch their moves to the slowest axis. The clock of the drives ticks every 4 ms, and every move ends on a tick. This program
 prints one setpoint in 50: the positions, then the velocities.

     make dist
     cc -Itarget/dist/include examples/10_arm.c target/dist/lib/libatraj.a -lm -o arm
*/
#include "atraj/move.h"
#include <stdio.h>

#define CYCLE 0.004 /* s */
#ifndef EVERY
#define EVERY 50 /* print every EVERY-th setpoint */
#endif
enum { AXES = 6, MOVES = 4 };

static atraj_state const points[MOVES + 1][AXES] = {
    {{0, 0, 0}, {-90, 0, 0}, {90, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, /* degrees, and at rest */
    {{30, 0, 0}, {-60, 0, 0}, {70, 0, 0}, {0, 0, 0}, {-40, 0, 0}, {90, 0, 0}},
    {{30, 0, 0}, {-50, 0, 0}, {75, 0, 0}, {0, 0, 0}, {-55, 0, 0}, {90, 0, 0}}, /* down */
    {{-45, 0, 0}, {-70, 0, 0}, {80, 0, 0}, {20, 0, 0}, {-30, 0, 0}, {-90, 0, 0}},
    {{0, 0, 0}, {-90, 0, 0}, {90, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, /* home */
};

/* Prints the setpoints of a move that begins at `start`. */
static void follow(atraj_move const axes[], double start)
{
    for (int tick = 0; tick * CYCLE < axes[0].t; tick += EVERY) {
        printf("%.3f s:", start + tick * CYCLE);
        for (int i = 0; i < AXES; ++i) { printf(" %.2f", atraj_move_pos(&axes[i], tick * CYCLE)); }
        printf(" deg,");
        for (int i = 0; i < AXES; ++i) { printf(" %.2f", atraj_move_vel(&axes[i], tick * CYCLE)); }
        printf(" deg/s\n");
    }
}

int main(void)
{
    atraj_limits limits[AXES];
    for (int i = 0; i < AXES; ++i) { atraj_limits_init(&limits[i], i < 3 ? 4000 : 9000, i < 3 ? 500 : 1000, i < 3 ? 120 : 250); }
    double start = 0;
    puts("Arm over waypoints: six joints arrive together at each");
    puts("joints 1 to 3 within 120 deg/s");
    puts("joints 4 to 6 within 250 deg/s");
    for (int k = 0; k < MOVES; ++k) {
        atraj_move axes[AXES];
        if (atraj_moves_sync(axes, limits, points[k], points[k + 1], AXES, 0, CYCLE) < 0) { return 1; }
        follow(axes, start);
        start += axes[0].t;
        printf("%.3f s -> point %d\n", start, k + 1);
        for (int i = 0; i < AXES; ++i) {
            atraj_state end;
            atraj_move_state(&axes[i], axes[0].t, &end.p, &end.v, &end.a, NULL);
            if (!(axes[i].t == axes[0].t && end.p == points[k + 1][i].p && end.v == 0 && end.a == 0)) { return 1; }
        }
    }
    return 0;
}
