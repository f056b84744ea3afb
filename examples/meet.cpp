/*
 Meets a part on a conveyor, rides beside the part, and goes home at 1.6 s. At 0.4 s the belt gets faster, so the axis plans
 again. The axis keeps a jerk of 50 m/s^3, an acceleration of 5 m/s^2 and a velocity of 2 m/s. A controller tells its drive
 every setpoint; this program prints one in 200.

     make dist
     c++ -Itarget/dist/include examples/meet.cpp target/dist/lib/libatraj.a -lm -o meet
*/
#include "atraj/move.h"
#include <algorithm>
#include <cmath>
#include <cstdio>

static const double PERIOD = 0.001; // s

int main()
{
    const atraj::state home = {0, 0, 0};
    atraj::state now = home, part = {0.5, 0.4, 0}; // m, m/s; the belt does not accelerate
    atraj::limits limits;
    atraj::move move;
    double position_step = 0, velocity_step = 0, acceleration_step = 0;
    int start = 0, ridden = 0;
    bool goes_home = false;
    limits.init(50, 5, 2);
    int found = move.meet(limits, now, part); // below 0: an error
    for (int tick = 0; found >= 0 && tick <= 3000; ++tick, part.p += part.v * PERIOD)
    {
        const double x = (tick - start) * PERIOD;
        const atraj::state before = now;
        if (goes_home || x < move.t) { now = move.state(x); }
        else
        {
            now = part; // the move has ended beside the part, and the part moves on
            ++ridden;
        }
        position_step = std::max(position_step, std::fabs(now.p - before.p));
        velocity_step = std::max(velocity_step, std::fabs(now.v - before.v));
        acceleration_step = std::max(acceleration_step, std::fabs(now.a - before.a));
        if (tick % 200 == 0)
        {
            std::printf("%.1f s: part %.4f m, axis %.4f m, %.4f m/s\n", tick * PERIOD, part.p, now.p, now.v);
        }
        if (tick == 400)
        {
            part.v = 0.6;
            found = move.meet(limits, now, part);
            start = tick;
        }
        if (tick == 1600)
        {
            found = move.plan(limits, now, home);
            start = tick;
            goes_home = true;
        }
    }
    std::printf("beside the part for %.3f s\n", ridden * PERIOD);
    std::printf("from one setpoint to the next at most %.4f m, %.4f m/s, %.4f m/s^2\n", position_step, velocity_step,
                acceleration_step);
    // The limits times the period, and a rounding.
    const bool smooth = position_step < 0.002001 && velocity_step < 0.005001 && acceleration_step < 0.050001;
    return !(found >= 0 && smooth && ridden > 0 && now.p == 0 && now.v == 0);
}
