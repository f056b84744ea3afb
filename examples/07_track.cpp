/*
 Follows a sensor: a hand moves a knob back and forth and once jerks it. The sensor adds up to 1 mm of noise to the position and up to 1 cm/s
 to the velocity. Every millisecond the axis plans so as to be at the knob 0.1 s later, within a jerk of 200 m/s^3, an acceleration
 of 10 m/s^2 and a velocity of 1 m/s. The horizon of 0.1 s smooths the noise: the jerk of the motion stays far below its limit. After
 the jump the axis meets the knob as fast as it can. This program prints one setpoint in 250.

     make dist
     c++ -Itarget/dist/include examples/07_track.cpp target/dist/lib/libatraj.a -lm -o track
*/
#include "atraj/move.h"
#include <cmath>
#include <cstdio>

static const double PERIOD = 0.001, HORIZON = 0.1; // s

static unsigned seed = 1;

// A number from -1 to 1.
static double noise()
{
    seed = seed * 1664525 + 1013904223;
    return 2 * (seed / 4294967296.0) - 1;
}

// What the sensor measures at the time t: a position, m, and a velocity, m/s.
static atraj::state sensor(double t)
{
    atraj::state knob = {0, 0, 0};
    knob.p = 0.3 * std::sin(2 * t) + (t < 1.5 ? 0 : 0.3) + 0.001 * noise();
    knob.v = 0.6 * std::cos(2 * t) + 0.01 * noise();
    return knob;
}

int main()
{
    atraj::state now = {0, 0, 0};
    atraj::move move;
    int found = 0; // below 0: an error
    const atraj::limits limits = atraj::limits::symmetric(200, 10, 1);
    std::puts("Following a sensor: noise of 1 mm and 1 cm/s, a jump at 1.5 s, a plan every millisecond");
    std::puts("within 1 m/s, 10 m/s^2, 200 m/s^3");
    for (int tick = 0; found >= 0 && tick <= 3000; ++tick)
    {
        const atraj::state knob = sensor(tick * PERIOD);
        if (tick % 250 == 0)
        {
            std::printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2, sensor %.4f m\n", tick * PERIOD, now.p, now.v, now.a, knob.p);
        }
        found = move.track(limits, now, knob, 0, HORIZON);
        now = move.state(PERIOD); // one period later, the next plan starts here
    }
    return found < 0;
}
