/*
 Plans a move and follows it: 10 m, within a jerk of 30 m/s^3, an acceleration of 10 m/s^2 and a velocity of 5 m/s. The axis
 moves at 1 m/s at the start and rests at the end. A controller sends every setpoint to its drive; this program prints one in 250.

     make dist
     c++ -Itarget/dist/include examples/02_follow.cpp target/dist/lib/libatraj.a -lm -o follow
*/
#include "a/trajbell.h"
#include <cstdio>

static const a_float PERIOD = 0.001; // s

int main()
{
    a::trajbell move;
    if (!(move.gen(30, 10, 5, 0, 10, 1, 0) > 0))
    {
        std::puts("the limits allow no such move");
        return 1;
    }
    std::puts("Double-S with cruise: 10 m, from 1 m/s to rest");
    std::puts("within 5 m/s, 10 m/s^2, 30 m/s^3");
    for (int tick = 0; tick * PERIOD < move.t; tick += 250)
    {
        const a_float x = tick * PERIOD;
        std::printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2, %.4f m/s^3\n", x, move.pos(x), move.vel(x), move.acc(x), move.jer(x));
    }
    std::printf("arrives at %.4f m after %.3f s\n", move.pos(move.t), move.t);
    return 0;
}
