/*
 Plans while the axis moves: at 0.7 s the axis gets a target behind it, at 1.8 s it must stop. Each plan starts from the
 state of the plan before, so neither velocity nor acceleration jumps. The axis keeps a jerk of 30 m/s^3, an acceleration of
 10 m/s^2 and a velocity of 5 m/s. A controller sends every setpoint to its drive; this program prints one in 200.

     make dist
     c++ -Itarget/dist/include examples/06_retarget.cpp target/dist/lib/libatraj.a -lm -o retarget
*/
#include "atraj/move.h"
#include <cstdio>

static const double PERIOD = 0.001; // s

int main()
{
    const atraj::state ahead = {10, 0, 0}, behind = {-2, 0, 0}; // m, m/s, m/s^2
    atraj::state now = {0, 0, 0};
    atraj::move move;
    const atraj::limits limits = atraj::limits::symmetric(30, 10, 5);
    int found = move.plan(limits, now, ahead); // below 0: an error
    std::puts("Retargeted and stopped: to 10 m, at 0.7 s to -2 m, at 1.8 s to a stop");
    std::puts("within 5 m/s, 10 m/s^2, 30 m/s^3");
    for (int tick = 0, start = 0; found >= 0 && tick <= 3000; ++tick)
    {
        const double x = (tick - start) * PERIOD, jerk = move.jer(x);
        now = move.state(x);
        if (tick % 200 == 0)
        {
            std::printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2, %.4f m/s^3\n", tick * PERIOD, now.p, now.v, now.a, jerk);
        }
        if (tick == 700)
        {
            std::puts("0.700 s -> to -2 m");
            found = move.plan(limits, now, behind);
            start = tick;
        }
        if (tick == 1800)
        {
            std::puts("1.800 s -> stop");
            found = move.stop(limits, now);
            start = tick;
        }
    }
    return !(found >= 0 && now.v == 0 && now.a == 0);
}
