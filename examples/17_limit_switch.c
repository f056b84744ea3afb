/*
 Stops on a limit switch. A host sends the axis too far. When the axis passes the switch, it stops as hard as its drive can: the stop
 has limits of its own, which are wider than those of the work. Then the axis goes back to its range. The main loop reads the switch
 and plans; a timer interrupt asks for a setpoint every millisecond. The work keeps a jerk of 30 m/s^3, an acceleration of 3 m/s^2 and a
 velocity of 1 m/s, the stop a jerk of 500 m/s^3 and an acceleration of 15 m/s^2. This program prints one setpoint in 250.

     make dist
     cc -Itarget/dist/include examples/17_limit_switch.c target/dist/lib/libatraj.a -lm -o limit_switch
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
    a_float const at_switch = 0.8;
    atraj_state const start = {0, 0, 0}, too_far = {2, 0, 0}, back = {0.7, 0, 0}; /* m, m/s, m/s^2 */
    atraj_state now = start;
    atraj_limits work, hardest;
    atraj_axis axis;
    int found = atraj_axis_init(&axis, PERIOD, &start), has_passed = 0; /* found below 0: an error */
    atraj_limits_init(&work, 30, 3, 1);
    atraj_limits_init(&hardest, 500, 15, 1);
    puts("Stopping on a limit switch: a target too far, a stop with limits of its own, and back");
    puts("within 1 m/s");
    puts("work within 3 m/s^2, 30 m/s^3");
    puts("stop within 15 m/s^2, 500 m/s^3");
    puts("the switch is at 0.8 m");
    if (found >= 0) { found = atraj_axis_go(&axis, &work, &too_far, LEAD); }
    for (int tick = 0; found >= 0 && tick <= 3000; ++tick) {
        /* The main loop: the switch closes. Later the axis is sent back. */
        if (!has_passed && now.p >= at_switch) {
            printf("%.3f s -> stop\n", tick * PERIOD);
            found = atraj_axis_stop(&axis, &hardest, LEAD);
            has_passed = 1;
        }
        if (tick == 2000) {
            printf("2.000 s -> back\n%.4f m past the switch\n", now.p - at_switch);
            found = atraj_axis_go(&axis, &work, &back, LEAD);
        }
        /* The interrupt. */
        atraj_axis_tick(&axis, &now);
        if (tick % EVERY == 0) { printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2\n", tick * PERIOD, now.p, now.v, now.a); }
    }
    return !(found >= 0 && now.p == back.p && now.v == 0);
}
