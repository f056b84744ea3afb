/*
 Plans a move and follows it: 10 m from rest to rest, within a jerk of 30 m/s^3, an acceleration of 10 m/s^2 and a velocity
 of 5 m/s. A controller tells its drive every setpoint; this program prints one in 250.

     make dist
     c++ -Itarget/dist/include examples/follow.cpp target/dist/lib/libatraj.a -lm -o follow
*/
#include "a/trajbell.h"
#include <cstdio>

static const a_float PERIOD = 0.001; // s

int main()
{
    a::trajbell move;
    if (!(move.gen(30, 10, 5, 0, 10) > 0)) // at rest at both ends, unless two velocities follow
    {
        std::puts("the limits allow no such move");
        return 1;
    }
    bool within = true;
    for (int tick = 0; tick * PERIOD < move.t; ++tick)
    {
        const a_float x = tick * PERIOD, position = move.pos(x), velocity = move.vel(x);
        within = within && velocity >= 0 && velocity <= 5;
        if (tick % 250 == 0) { std::printf("%.3f s: %.4f m, %.4f m/s\n", x, position, velocity); }
    }
    std::printf("%.3f s: arrived at %.4f m\n", move.t, move.pos(move.t));
    std::printf("within the velocity: %s\n", within ? "yes" : "no");
    return !within;
}
