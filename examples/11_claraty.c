/*
 CLARAty's trapezoid: a controller moves an axis, gives it a target behind it, holds it, and resumes. The axis brakes and turns
 round; its velocity never jumps. The controller asks for a setpoint every millisecond; this program prints one in 200.

     make dist
     cc -Itarget/dist/include examples/11_claraty.c target/dist/lib/libatraj.a -lm -o claraty
*/
#include "claraty/trapezoid.h"
#include <math.h>
#include <stdio.h>

#define PERIOD 0.001 /* s */
#ifndef EVERY
#define EVERY 200 /* print every EVERY-th setpoint */
#endif

/* At 0.5 m/s, speeding up at 1 m/s^2, braking at 0.8 m/s^2. The position counts from the place where the axis rested. */
static void go_to(claraty_trapezoid *axis, double position)
{
    claraty_trapezoid_set(axis, position, 0.5, 1, 0.8);
    claraty_trapezoid_start(axis);
}

int main(void)
{
    claraty_trapezoid axis;
    double origin = 0, position = 0, velocity = 0, acceleration = 0;
    claraty_trapezoid_init(&axis);
    /* A manual clock, so that every run prints the same. A controller keeps the clock of the system. */
    claraty_trapezoid_set_clock(&axis, NULL, NULL);
    puts("Retarget and feed hold: to 0.6 m, at 0.8 s back to 0.1 m, held at 1.6 s, on at 2.4 s");
    puts("within 0.5 m/s, 1 m/s^2, 0.8 m/s^2");
    go_to(&axis, 0.6);
    for (int tick = 0; tick <= 3500; ++tick) {
        if (tick == 800) {
            puts("0.800 s -> to 0.1 m");
            go_to(&axis, 0.1);
        }
        if (tick == 1600) {
            puts("1.600 s -> hold");
            claraty_trapezoid_stop(&axis);
        }
        if (tick == 2400) {
            puts("2.400 s -> on");
            origin = position; /* the axis rests here */
            go_to(&axis, 0.1 - origin);
        }
        claraty_trapezoid_get_setpoint(&axis, &position, &velocity, &acceleration);
        position += origin;
        if (tick % EVERY == 0) { printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2\n", tick * PERIOD, position, velocity, acceleration); }
        claraty_trapezoid_advance_timer_by(&axis, PERIOD);
    }
    return !(fabs(position - 0.1) < 1e-12 && velocity == 0);
}
