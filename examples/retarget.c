/*
 Gives a moving axis a new target, behind it. The axis brakes, turns round and arrives at rest; its velocity never jumps.
 A controller asks for a setpoint every millisecond; this program prints one in 500.

     make dist
     cc -Itarget/dist/include examples/retarget.c target/dist/lib/libatraj.a -lm -o retarget
*/
#include "claraty/trapezoid.h"
#include <math.h>
#include <stdio.h>

#define PERIOD 0.001 /* s */

int main(void)
{
    claraty_trapezoid axis;
    double position = 0, velocity = 0, change = 0;
    claraty_trapezoid_init(&axis);
    /* A manual clock, so that every run prints the same. A controller keeps the clock of the system. */
    claraty_trapezoid_set_clock(&axis, NULL, NULL);
    claraty_trapezoid_set(&axis, 10, 2, 4, 4); /* to 10 m at 2 m/s, speeding up and braking at 4 m/s^2 */
    claraty_trapezoid_start(&axis);
    for (int tick = 0; claraty_trapezoid_is_started(&axis); ++tick) {
        double const before = velocity;
        if (tick == 2000) {
            claraty_trapezoid_set(&axis, 1, 2, 4, 4);
            claraty_trapezoid_start(&axis);
        }
        claraty_trapezoid_get_setpoint(&axis, &position, &velocity, NULL);
        change = fmax(change, fabs(velocity - before));
        if (tick % 500 == 0) { printf("%.1f s: %.4f m, %.4f m/s\n", tick * PERIOD, position, velocity); }
        claraty_trapezoid_advance_timer_by(&axis, PERIOD);
    }
    printf("at rest at %.4f m; the velocity changed by at most %.4f m/s per period\n", position, change);
    return !(position == 1 && velocity == 0 && change < 0.0041);
}
