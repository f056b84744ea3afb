/*
 Follows a sensor: a hand moves a knob to and fro, and the sensor adds up to 1 mm of noise. Every millisecond the axis plans again,
 from its state to the newest value. The plan keeps a jerk of 200 m/s^3, an acceleration of 10 m/s^2 and a velocity of 1 m/s
 whatever the sensor says. This program prints one setpoint in 250.

     make dist
     cc -Itarget/dist/include examples/track.c target/dist/lib/libatraj.a -lm -o track
*/
#include "atraj/move.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>

#define PERIOD 0.001 /* s */

static uint32_t seed = 1;

/* The value of the sensor at the time t, m. */
static double sensor(double t)
{
    seed = seed * 1664525 + 1013904223;
    return 0.3 * sin(2 * t) + 0.002 * (seed / 4294967296.0 - 0.5);
}

int main(void)
{
    atraj_limits limits;
    atraj_state now = {0, 0, 0};
    atraj_move move;
    double farthest = 0, fastest = 0, acceleration_step = 0;
    int found = 0; /* below 0: an error */
    atraj_limits_init(&limits, 200, 10, 1);
    for (int tick = 0; found >= 0 && tick <= 3000; ++tick) {
        atraj_state const target = {sensor(tick * PERIOD), 0, 0}, before = now;
        if (tick % 250 == 0) { printf("%.3f s: sensor %.4f m, axis %.4f m, %.4f m/s\n", tick * PERIOD, target.p, now.p, now.v); }
        found = atraj_move_plan(&move, &limits, &now, &target);
        /* One period later, the next plan starts here. */
        atraj_move_state(&move, PERIOD, &now.p, &now.v, &now.a, NULL);
        farthest = fmax(farthest, fabs(target.p - now.p));
        fastest = fmax(fastest, fabs(now.v));
        acceleration_step = fmax(acceleration_step, fabs(now.a - before.a));
    }
    printf("at most %.4f m behind the sensor, at most %.4f m/s\n", farthest, fastest);
    printf("from one setpoint to the next at most %.4f m/s^2\n", acceleration_step);
    /* The limits and a rounding. */
    return !(found >= 0 && farthest < 0.1 && fastest < 1.000001 && acceleration_step < 0.200001);
}
