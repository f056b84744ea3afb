/*
 Samples a whole move into arrays, in one call: 1001 positions, velocities and accelerations of a trapezoid at even times from
 the start to the end. This program prints one sample in 100.

     make dist
     cc -Itarget/dist/include examples/03_sample.c target/dist/lib/libatraj.a -lm -o sample
*/
#include "atraj.h"
#include <stdio.h>

#ifndef EVERY
#define EVERY 100 /* print every EVERY-th sample */
#endif
enum { SAMPLES = 1001 };

int main(void)
{
    static a_float position[SAMPLES], velocity[SAMPLES], acceleration[SAMPLES];
    a_trajtrap move;
    a_float const step = a_trajtrap_gen(&move, 5, 4, -8, 0, 10, 0, 0) / (SAMPLES - 1);
    size_t const count = atraj_trap_sample(&move, 0, step, SAMPLES, position, velocity, acceleration);

    int same = count == SAMPLES;
    puts("Trapezoid with cruise: 10 m from rest to rest, sampled in one call");
    puts("within 5 m/s, +4 m/s^2, -8 m/s^2");
    for (size_t k = 0; k < count; ++k) {
        a_float const x = (a_float)k * step;
        if (k % EVERY == 0) { printf("%.4f s: %.4f m, %.4f m/s, %.4f m/s^2\n", x, position[k], velocity[k], acceleration[k]); }
        same = same && position[k] == a_trajtrap_pos(&move, x);
    }
    printf("the same positions as from single calls: %s\n", same ? "yes" : "no");
    return !same;
}
