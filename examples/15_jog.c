/*
 Jogs between two soft stops: while a key is pressed the axis runs, and when the key is released the axis stops. A jog is a plan to the
 soft stop with the jog's speed as the limit of the velocity. So the axis brakes in time and stands at the stop, however long the key
 is pressed. The main loop reads the keys and plans; a timer interrupt asks for a setpoint every millisecond. The axis keeps a jerk of
 30 m/s^3, an acceleration of 3 m/s^2 and a velocity of 0.5 m/s. This program prints one setpoint in 250.

     make dist
     cc -Itarget/dist/include examples/15_jog.c target/dist/lib/libatraj.a -lm -o jog
*/
#include "atraj/axis.h"
#include <stdio.h>

#define PERIOD 0.001 /* s */
#define LEAD 4 /* ticks that a plan takes, and one more */
#ifndef EVERY
#define EVERY 250 /* print every EVERY-th setpoint */
#endif

int main(void)
{
    atraj_state const start = {0, 0, 0}, lowest = {-0.2, 0, 0}, highest = {1, 0, 0}; /* m, m/s, m/s^2 */
    atraj_state now = start;
    atraj_limits limits;
    atraj_axis axis;
    int found = atraj_axis_init(&axis, PERIOD, &start); /* below 0: an error */
    atraj_limits_init(&limits, 30, 3, 0.5);
    puts("Jogging between soft stops: up and let go, up to the stop, down to the other one");
    puts("within -0.2 m, +1 m, 0.5 m/s, 3 m/s^2, 30 m/s^3");
    for (int tick = 0; found >= 0 && tick <= 7000; ++tick) {
        /* The main loop: a key is pressed or released. */
        if (tick == 200 || tick == 1600) {
            printf("%.3f s -> up\n", tick * PERIOD);
            found = atraj_axis_go(&axis, &limits, &highest, LEAD);
        }
        if (tick == 1000) {
            puts("1.000 s -> let go");
            found = atraj_axis_stop(&axis, &limits, LEAD);
        }
        if (tick == 3600) {
            puts("3.600 s -> down");
            found = atraj_axis_go(&axis, &limits, &lowest, LEAD);
        }
        /* The interrupt. */
        atraj_axis_tick(&axis, &now);
        if (tick % EVERY == 0) { printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2\n", tick * PERIOD, now.p, now.v, now.a); }
    }
    return !(found >= 0 && now.p == lowest.p && now.v == 0);
}
