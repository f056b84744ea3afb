/*
 Two axes pass waypoints, and an operator turns the override knob and presses the pause button. The axes stay on their path: the clock
 of the path slows down, holds, and goes on. The path is planned within 85 % of the limits, and the clock has all of them, because braking on
 a path takes more than the plan. This program prints one setpoint in 125 of a clock of 2 ms: positions, velocities, accelerations.

     make dist
     cc -Itarget/dist/include examples/20_hold.c target/dist/lib/libatraj.a -lm -o hold
*/
#include "atraj/clock.h"
#include "atraj/path.h"
#include <stdio.h>

#define CYCLE 0.002 /* s */
#ifndef EVERY
#define EVERY 125 /* print every EVERY-th setpoint */
#endif
enum { AXES = 2, SECTIONS = 3, SIZE = ATRAJ_PATH_SIZE(AXES, SECTIONS), EVENTS = 3 };

int main(void)
{
    int const ticks[EVENTS] = {200, 500, 1000}, percents[EVENTS] = {50, 0, 100}; /* when, and the knob; 0 is the button */
    atraj_state states[SECTIONS + 1][AXES] = {{{0, 0, 0}, {0, 0, 0}}, {{0.4, 0, 0}, {0.3, 0, 0}}, {{0.8, 0, 0}, {-0.1, 0, 0}}, {{1.2, 0, 0}, {0.2, 0, 0}}}; /* m */
    double durations[SECTIONS], work[SIZE], end = 0;
    atraj_limits planned[AXES], limits[AXES];
    atraj_move path[SECTIONS][AXES];
    atraj_clock clock;
    for (int i = 0; i < AXES; ++i) {
        atraj_limits_init(&limits[i], 20, 4, 1); /* jerk, acceleration, velocity */
        atraj_limits_init(&planned[i], 0.85 * 20, 0.85 * 4, 0.85 * 1);
    }
    if (atraj_path_plan(*states, durations, planned, AXES, SECTIONS, 0, work) < 0) { return 1; }
    if (atraj_path_moves(*path, planned, *states, durations, AXES, SECTIONS) < 0) { return 1; }
    for (int k = 0; k < SECTIONS; ++k) { end += path[k][0].t; }
    puts("Holding on a path: the knob at 50 %, the pause button, and on");
    puts("within 1 m/s, 4 m/s^2");
    atraj_clock_start(&clock);
    for (int tick = 0, event = 0; atraj_clock_time(&clock, tick * CYCLE) < end; ++tick) {
        double const x = tick * CYCLE;
        if (event < EVENTS && tick == ticks[event]) {
            if (atraj_clock_rate(&clock, *path, limits, AXES, SECTIONS, x, percents[event] / 100.0) < 0) { return 1; }
            printf("%.3f s -> %d %%\n", x, percents[event]);
            ++event;
        }
        if (tick % EVERY == 0) {
            double p[AXES], v[AXES], a[AXES];
            for (int i = 0; i < AXES; ++i) { atraj_clock_state(&clock, *path + i, AXES, SECTIONS, x, &p[i], &v[i], &a[i], NULL); }
            printf("%.3f s: %.4f %.4f m, %.4f %.4f m/s, %.4f %.4f m/s^2\n", x, p[0], p[1], v[0], v[1], a[0], a[1]);
        }
    }
    printf("planned for %.3f s\n", end);
    return 0;
}
