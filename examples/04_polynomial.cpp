/*
 Moves in a given time: a septic polynomial goes 10 m in 8 s, at rest without acceleration and jerk at both ends. Nothing limits the
 motion between the ends, so the program computes the extremes of the motion. It prints one setpoint in 500.

     make dist
     c++ -Itarget/dist/include examples/04_polynomial.cpp target/dist/lib/libatraj.a -lm -o polynomial
*/
#include "atraj.h"
#include <cstdio>

static const a_float PERIOD = 0.001; // s

int main()
{
    a::trajpoly7 move;
    a_float highest[3]; // position, velocity, acceleration
    move.gen(8, 0, 10);
    atraj_poly7_extremes(&move, 8, 0, highest);
    std::puts("Septic polynomial: 10 m in 8 s, without jerk at both ends");
    for (int tick = 0; tick <= 8000; tick += 500)
    {
        const a_float x = tick * PERIOD;
        std::printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2, %.4f m/s^3\n", x, move.pos(x), move.vel(x), move.acc(x), move.jer(x));
    }
    std::printf("reaches %.4f m/s and %.4f m/s^2\n", highest[1], highest[2]);
    return 0;
}
