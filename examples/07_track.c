/*
 Follows a sensor: a hand moves a knob to and fro and once jerks it, and the sensor adds up to 1 mm of noise. Every millisecond the
 axis plans again, from its state to the newest value. The plan keeps a jerk of 200 m/s^3, an acceleration of 10 m/s^2 and a velocity
 of 1 m/s whatever the sensor says. This program prints one setpoint in 250.

     make dist
     cc -Itarget/dist/include examples/07_track.c target/dist/lib/libatraj.a -lm -o track
*/
#include "atraj/move.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>

#define PERIOD 0.001 /* s */
#ifndef EVERY
#define EVERY 250 /* one setpoint in so many is printed */
#endif

static uint32_t seed = 1;

/* The value of the sensor at the time t, m. */
static double sensor(double t)
{
    seed = seed * 1664525 + 1013904223;
    return 0.3 * sin(2 * t) + (t < 1.5 ? 0 : 0.3) + 0.002 * (seed / 4294967296.0 - 0.5);
}

int main(void)
{
    atraj_limits limits;
    atraj_state now = {0, 0, 0};
    atraj_move move;
    int found = 0; /* below 0: an error */
    atraj_limits_init(&limits, 200, 10, 1);
    puts("Following a sensor: noise of 1 mm, a jump at 1.5 s, and a plan every millisecond");
    puts("within 1 m/s, 10 m/s^2, 200 m/s^3");
    for (int tick = 0; found >= 0 && tick <= 3000; ++tick) {
        atraj_state const target = {sensor(tick * PERIOD), 0, 0};
        if (tick % EVERY == 0) {
            printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2, sensor %.4f m\n", tick * PERIOD, now.p, now.v, now.a, target.p);
        }
        found = atraj_move_plan(&move, &limits, &now, &target);
        /* One period later, the next plan starts here. */
        atraj_move_state(&move, PERIOD, &now.p, &now.v, &now.a, NULL);
    }
    return found < 0;
}
