/*
 Plans while the axis moves: at 0.7 s the axis gets a target behind it, at 1.8 s it is told to stop. Each plan starts from the
 state of the plan before, so neither velocity nor acceleration jumps. The axis keeps a jerk of 30 m/s^3, an acceleration of
 10 m/s^2 and a velocity of 5 m/s. A controller tells its drive every setpoint; this program prints one in 200.

     make dist
     c++ -Itarget/dist/include examples/jog.cpp target/dist/lib/libatraj.a -lm -o jog
*/
#include "atraj/move.h"
#include <algorithm>
#include <cmath>
#include <cstdio>

static const double PERIOD = 0.001; // s

int main()
{
    const atraj::state ahead = {10, 0, 0}, behind = {-2, 0, 0}; // m, m/s, m/s^2
    atraj::state now = {0, 0, 0};
    atraj::limits limits;
    atraj::move move;
    double velocity_step = 0, acceleration_step = 0;
    limits.init(30, 10, 5);
    int found = move.plan(limits, now, ahead); // below 0: an error
    for (int tick = 0, start = 0; found >= 0 && tick <= 3000; ++tick)
    {
        const atraj::state before = now;
        now = move.state((tick - start) * PERIOD);
        velocity_step = std::max(velocity_step, std::fabs(now.v - before.v));
        acceleration_step = std::max(acceleration_step, std::fabs(now.a - before.a));
        if (tick % 200 == 0) { std::printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2\n", tick * PERIOD, now.p, now.v, now.a); }
        if (tick == 700)
        {
            found = move.plan(limits, now, behind);
            start = tick;
        }
        if (tick == 1800)
        {
            found = move.stop(limits, now);
            start = tick;
        }
    }
    std::printf("from one setpoint to the next at most %.4f m/s, %.4f m/s^2\n", velocity_step, acceleration_step);
    // The limits times the period, and a rounding.
    return !(found >= 0 && now.v == 0 && now.a == 0 && velocity_step < 0.010001 && acceleration_step < 0.030001);
}
