/*
 Meets a part on a conveyor, tracks the part, and goes home at 1.6 s. At 0.4 s the belt gets faster, so the axis plans
 again. The axis keeps a jerk of 50 m/s^3, an acceleration of 5 m/s^2 and a velocity of 2 m/s. A controller sends its drive
 every setpoint; this program prints one in 200.

     make dist
     c++ -Itarget/dist/include examples/08_meet.cpp target/dist/lib/libatraj.a -lm -o meet
*/
#include "atraj/move.h"
#include <cstdio>

static const double PERIOD = 0.001; // s

int main()
{
    const atraj::state home = {0, 0, 0};
    atraj::state now = home, part = {0.5, 0.4, 0}; // m, m/s; the belt does not accelerate
    atraj::move move;
    int start = 0;
    bool goes_home = false;
    const atraj::limits limits = atraj::limits::symmetric(50, 5, 2);
    int found = move.meet(limits, now, part); // below 0: an error
    std::puts("Meeting a part on a conveyor: the belt gets faster, the axis tracks the part and goes home");
    std::puts("within 2 m/s, 5 m/s^2, 50 m/s^3");
    for (int tick = 0; found >= 0 && tick <= 3000; ++tick, part.p += part.v * PERIOD)
    {
        const double x = (tick - start) * PERIOD;
        now = goes_home || x < move.t ? move.state(x) : part; // the move ends at the part, and the part moves on
        if (tick % 200 == 0)
        {
            std::printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2, ", tick * PERIOD, now.p, now.v, now.a);
            std::printf("part %.4f m, %.4f m/s\n", part.p, part.v);
        }
        if (tick == 400)
        {
            std::puts("0.400 s -> faster belt");
            part.v = 0.6;
            found = move.meet(limits, now, part);
            start = tick;
        }
        if (tick == 1600)
        {
            std::puts("1.600 s -> home");
            found = move.plan(limits, now, home);
            start = tick;
            goes_home = true;
        }
    }
    return !(found >= 0 && now.p == 0 && now.v == 0);
}
