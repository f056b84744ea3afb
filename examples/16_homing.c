/*
 Finds home on a switch. The axis runs fast until the switch closes, runs back until it opens, and runs slowly onto it again. Where it
 closes now is known to a hundredth of a millimetre, because the axis was slow. Then the axis goes to its home, 0.1 m from the switch. Each
 change of direction is one plan from the present motion. The main loop reads the switch and plans; a timer interrupt asks for a
 setpoint every millisecond. The axis keeps a jerk of 50 m/s^3, an acceleration of 2 m/s^2 and a velocity of 0.2 m/s. This program
 prints one setpoint in 250.

     make dist
     cc -Itarget/dist/include examples/16_homing.c target/dist/lib/libatraj.a -lm -o homing
*/
#include "atraj/axis.h"
#include <stdio.h>

#define PERIOD 0.001 /* s */
#define LEAD 4 /* ticks that a plan takes, and one more */
#ifndef EVERY
#define EVERY 250 /* print every EVERY-th setpoint */
#endif

/* The switch of the machine. */
static int is_closed(a_float p) { return p <= -0.31273; }

int main(void)
{
    enum { FAST, BACK, SLOW, HOME } step = FAST;
    atraj_state now = {0, 0, 0}, home = {0, 0, 0}; /* m, m/s, m/s^2 */
    atraj_limits limits;
    atraj_axis axis;
    int found = atraj_axis_init(&axis, PERIOD, &now); /* below 0: an error */
    atraj_limits_init(&limits, 50, 2, 0.2);
    puts("Homing on a switch: fast onto it, back, slowly onto it, and home, 0.1 m away");
    puts("within 0.2 m/s, 2 m/s^2, 50 m/s^3");
    if (found >= 0) { found = atraj_axis_reach(&axis, &limits, -0.2, 0, LEAD); }
    for (int tick = 0; found >= 0 && tick <= 3200; ++tick) {
        /* The main loop: the switch has closed or opened. */
        int const closed = is_closed(now.p);
        if (step == FAST && closed) {
            printf("%.3f s -> back\n", tick * PERIOD);
            found = atraj_axis_reach(&axis, &limits, 0.05, 0, LEAD);
            step = BACK;
        } else if (step == BACK && !closed) {
            printf("%.3f s -> slow\n", tick * PERIOD);
            found = atraj_axis_reach(&axis, &limits, -0.01, 0, LEAD);
            step = SLOW;
        } else if (step == SLOW && closed) {
            printf("%.3f s -> home\n", tick * PERIOD);
            printf("the switch is at %.5f m\n", now.p);
            home.p = now.p + 0.1;
            found = atraj_axis_go(&axis, &limits, &home, LEAD);
            step = HOME;
        }
        /* The interrupt. */
        atraj_axis_tick(&axis, &now);
        if (tick % EVERY == 0) { printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2\n", tick * PERIOD, now.p, now.v, now.a); }
    }
    return !(found >= 0 && step == HOME && now.p == home.p && now.v == 0);
}
