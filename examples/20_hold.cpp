/*
 Two axes pass waypoints, and an operator turns the override knob and presses the pause button. The axes stay on their path: the clock
 of the path slows down, holds, and goes on. The path is planned within 85 % of the limits, and the clock has all of them, because braking on
 a path takes more than the plan. This program prints one setpoint in 125 of a clock of 2 ms: positions, velocities, accelerations.

     make dist
     c++ -Itarget/dist/include examples/20_hold.cpp target/dist/lib/libatraj.a -lm -o hold
*/
#include "atraj/clock.h"
#include "atraj/path.h"
#include <cstdio>

static const double CYCLE = 0.002; // s
enum { AXES = 2, SECTIONS = 3, SIZE = ATRAJ_PATH_SIZE(AXES, SECTIONS), EVENTS = 3 };

int main()
{
    const int ticks[EVENTS] = {200, 500, 1000}, percents[EVENTS] = {50, 0, 100}; // when, and the knob; 0 is the button
    atraj::state states[SECTIONS + 1][AXES] = {{{0, 0, 0}, {0, 0, 0}}, {{0.4, 0, 0}, {0.3, 0, 0}}, {{0.8, 0, 0}, {-0.1, 0, 0}}, {{1.2, 0, 0}, {0.2, 0, 0}}}; // m
    double durations[SECTIONS], work[SIZE], end = 0;
    atraj::limits planned[AXES], limits[AXES];
    atraj::move path[SECTIONS][AXES];
    atraj::clock clock;
    for (int i = 0; i < AXES; ++i)
    {
        limits[i].init(20, 4, 1); // jerk, acceleration, velocity
        planned[i].init(0.85 * 20, 0.85 * 4, 0.85 * 1);
    }
    if (atraj_path_plan(*states, durations, planned, AXES, SECTIONS, 0, work) < 0) { return 1; }
    if (atraj_path_moves(*path, planned, *states, durations, AXES, SECTIONS) < 0) { return 1; }
    for (int k = 0; k < SECTIONS; ++k) { end += path[k][0].t; }
    std::puts("Holding on a path: the knob at 50 %, the pause button, and on");
    std::puts("within 1 m/s, 4 m/s^2");
    clock.start();
    for (int tick = 0, event = 0; atraj_clock_time(&clock, tick * CYCLE) < end; ++tick)
    {
        const double x = tick * CYCLE;
        if (event < EVENTS && tick == ticks[event])
        {
            if (clock.rate(*path, limits, AXES, SECTIONS, x, percents[event] / 100.0) < 0) { return 1; }
            std::printf("%.3f s -> %d %%\n", x, percents[event]);
            ++event;
        }
        if (tick % 125 == 0)
        {
            const atraj::state first = clock.state(*path, AXES, SECTIONS, x), second = clock.state(*path + 1, AXES, SECTIONS, x);
            std::printf("%.3f s: %.4f %.4f m, %.4f %.4f m/s, %.4f %.4f m/s^2\n", x, first.p, second.p, first.v, second.v, first.a, second.a);
        }
    }
    std::printf("planned for %.3f s\n", end);
    return 0;
}
