/*
 Overrides the feed. A knob sets what share of 0.5 m/s the axis may use: each turn of the knob is a plan to the same target within a
 new limit of the velocity. An axis that is too fast for the new limit returns within it in minimum time. A share of 0 is a hold: the
 axis stops. The main loop reads the knob and plans; a timer interrupt asks for a setpoint every millisecond. The axis keeps a jerk of
 30 m/s^3 and an acceleration of 3 m/s^2. This program prints one setpoint in 250.

     make dist
     cc -Itarget/dist/include examples/18_override.c target/dist/lib/libatraj.a -lm -o override
*/
#include "atraj/axis.h"
#include <stdio.h>

#define PERIOD 0.001 /* s */
#define LEAD 4 /* ticks that a plan takes, and one more */
#ifndef EVERY
#define EVERY 250 /* print every EVERY-th setpoint */
#endif

enum { TURNS = 5 };

int main(void)
{
    int const turns[TURNS] = {0, 1000, 2200, 3200, 4000}, percent[TURNS] = {100, 40, 120, 0, 100}; /* when, and how much */
    atraj_state const target = {2, 0, 0}; /* m, m/s, m/s^2 */
    atraj_state now = {0, 0, 0};
    atraj_limits limits;
    atraj_axis axis;
    double feed = 0; /* m/s */
    int found = atraj_axis_init(&axis, PERIOD, &now); /* below 0: an error */
    puts("Overriding the feed: 100 %, 40 %, 120 %, a hold, and 100 % again");
    puts("within 0.6 m/s, 3 m/s^2, 30 m/s^3");
    for (int tick = 0, turn = 0; found >= 0 && tick <= 6000; ++tick) {
        /* The main loop: the knob is turned. */
        if (turn < TURNS && tick == turns[turn]) {
            printf("%.3f s -> %d %%\n", tick * PERIOD, percent[turn]);
            feed = 0.5 * percent[turn] / 100;
            if (feed > 0) {
                atraj_limits_init(&limits, 30, 3, feed);
                found = atraj_axis_go(&axis, &limits, &target, LEAD);
            } else { /* a limit is never 0 */
                found = atraj_axis_stop(&axis, &limits, LEAD);
            }
            ++turn;
        }
        /* The interrupt. */
        atraj_axis_tick(&axis, &now);
        if (tick % EVERY == 0) {
            printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2, feed %.4f m/s\n", tick * PERIOD, now.p, now.v, now.a, feed);
        }
    }
    return !(found >= 0 && now.p == target.p && now.v == 0);
}
