/*
 Follows a sensor: a hand moves a knob to and fro and once jerks it, and the sensor adds up to 1 mm of noise. Every millisecond the
 axis plans again, from its state to the newest value. The plan keeps a jerk of 200 m/s^3, an acceleration of 10 m/s^2 and a velocity
 of 1 m/s whatever the sensor says. This program prints one setpoint in 250.

     make dist
     c++ -Itarget/dist/include examples/07_track.cpp target/dist/lib/libatraj.a -lm -o track
*/
#include "atraj/move.h"
#include <cmath>
#include <cstdio>

static const double PERIOD = 0.001; // s

static unsigned seed = 1;

// The value of the sensor at the time t, m.
static double sensor(double t)
{
    seed = seed * 1664525 + 1013904223;
    return 0.3 * std::sin(2 * t) + (t < 1.5 ? 0 : 0.3) + 0.002 * (seed / 4294967296.0 - 0.5);
}

int main()
{
    atraj::state now = {0, 0, 0};
    atraj::limits limits;
    atraj::move move;
    int found = 0; // below 0: an error
    limits.init(200, 10, 1);
    std::puts("Following a sensor: noise of 1 mm, a jump at 1.5 s, and a plan every millisecond");
    std::puts("within 1 m/s, 10 m/s^2, 200 m/s^3");
    for (int tick = 0; found >= 0 && tick <= 3000; ++tick)
    {
        const atraj::state target = {sensor(tick * PERIOD), 0, 0};
        if (tick % 250 == 0)
        {
            std::printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2, sensor %.4f m\n", tick * PERIOD, now.p, now.v, now.a, target.p);
        }
        found = move.plan(limits, now, target);
        now = move.state(PERIOD); // one period later, the next plan starts here
    }
    return found < 0;
}
