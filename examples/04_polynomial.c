/*
 Moves in a given time: a septic polynomial goes 10 m in 8 s, at rest without acceleration and jerk at both ends. Nothing limits the
 motion between the ends, so the program computes the extremes of the motion. It prints one setpoint in 500.

     make dist
     cc -Itarget/dist/include examples/04_polynomial.c target/dist/lib/libatraj.a -lm -o polynomial
*/
#include "atraj.h"
#include <stdio.h>

#define PERIOD 0.001 /* s */
#ifndef EVERY
#define EVERY 500 /* print every EVERY-th setpoint */
#endif

int main(void)
{
    a_trajpoly7 move;
    a_float highest[3]; /* position, velocity, acceleration */
    a_trajpoly7_gen(&move, 8, 0, 10, 0, 0, 0, 0, 0, 0);
    atraj_poly7_extremes(&move, 8, NULL, highest);
    puts("Septic polynomial: 10 m in 8 s, without jerk at both ends");
    for (int tick = 0; tick <= 8000; tick += EVERY) {
        a_float const x = tick * PERIOD;
        printf("%.3f s: %.4f m, %.4f m/s, ", x, a_trajpoly7_pos(&move, x), a_trajpoly7_vel(&move, x));
        printf("%.4f m/s^2, %.4f m/s^3\n", a_trajpoly7_acc(&move, x), a_trajpoly7_jer(&move, x));
    }
    printf("reaches %.4f m/s and %.4f m/s^2\n", highest[1], highest[2]);
    return 0;
}
