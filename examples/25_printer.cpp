/*
 Prints an octagon: points, path, clock, shaper and steps work together, as in the firmware of a printer. Two axes and an extruder stay within 0.1 mm of
 the lines between the points. A pause button holds them on their path and lets them go on. The shapers leave the frame at rest, and the extruder is
 ahead by its pressure advance. Each motor gets its steps, with a least time between two of them. This program prints one tick in 100 of
 1 ms: where the nozzle is, and how fast it and the filament are.

     make dist
     c++ -Itarget/dist/include examples/25_printer.cpp target/dist/lib/libatraj.a -lm -o printer
*/
#include "atraj/clock.h"
#include "atraj/path.h"
#include "atraj/shaper.h"
#include "atraj/steps.h"
#include <cmath>
#include <cstdio>

static const double TICK = 0.001; // s
enum { X, Y, E, AXES, SECTIONS = 8, ROOM = 128, SIZE = ATRAJ_PATH_SIZE(AXES, ROOM), LINE = 200 };

static const double corners[SECTIONS + 1][2] = {{5, 0}, {45, 0}, {50, 5}, {50, 25}, {45, 30}, {5, 30}, {0, 25}, {0, 5}, {5, 0}}; // mm
static const double steps_per_mm[AXES] = {80, 80, 400};

int main()
{
    atraj::limits planned[AXES], limits[AXES]; // 20 % are the reserve of the clock
    static atraj::state states[ROOM + 1][AXES];
    static atraj::move moves[ROOM][AXES];
    static double durations[ROOM], work[SIZE];
    size_t places[SECTIONS + 1];
    double line[AXES][LINE], filament = 0;
    atraj::shaper shapers[AXES];
    atraj::shaper_stream streams[AXES];
    atraj::step_stream motors[AXES];
    atraj::clock clock;
    for (int i = 0; i < AXES; ++i)
    {
        limits[i].init(100000, 3000, 100); // mm
        planned[i].init(80000, 2400, 80);
    }
    for (int k = 0; k <= SECTIONS; ++k)
    {
        if (k > 0) { filament += 0.05 * std::sqrt(std::pow(corners[k][X] - corners[k - 1][X], 2) + std::pow(corners[k][Y] - corners[k - 1][Y], 2)); }
        states[k][X].p = corners[k][X], states[k][Y].p = corners[k][Y], states[k][E].p = filament;
    }
    if (atraj_path_contour(*moves, *states, durations, places, planned, 0.1, AXES, SECTIONS, ROOM, 0, work) < 0) { return 1; }
    const size_t sections = places[SECTIONS];
    if (shapers[X].init(ATRAJ_SHAPER_MZV, 45, 0.1) < 0 || shapers[Y].init(ATRAJ_SHAPER_ZV, 38, 0.1) < 0) { return 1; }
    if (shapers[E].smooth(0.02) < 0) { return 1; }
    for (int i = 0; i < AXES; ++i)
    {
        if (streams[i].init(shapers[i], TICK, states[0][i], line[i], LINE) < 0) { return 1; }
        if (motors[i].init(1 / steps_per_mm[i], TICK, states[0][i]) < 0 || motors[i].wait(2e-6, 20e-6) < 0) { return 1; }
    }
    if (streams[E].advance(0.04) < 0) { return 1; }
    std::puts("Printing an octagon: points, path, clock, shaper and steps");
    std::puts("nozzle:");
    clock.start();
    int pulses[AXES] = {0, 0, 0};
    for (int tick = 0; tick <= 3000; ++tick)
    {
        const double x = tick * TICK;
        atraj::state now[AXES];
        if (tick == 600 || tick == 1200)
        {
            if (clock.rate(*moves, limits, AXES, sections, x, tick == 600 ? 0 : 1) < 0) { return 1; }
            std::printf("%.3f s -> %s\n", x, tick == 600 ? "pause" : "go on");
        }
        for (int i = 0; i < AXES; ++i)
        {
            double time; // of a pulse, s after the last tick
            int direction;
            if (streams[i].tick(clock.state(*moves + i, AXES, sections, x), line[i], LINE, now[i]) < 0) { return 1; }
            if (motors[i].tick(now[i]) < 0) { return 1; }
            while ((direction = motors[i].next(time)) != 0) { pulses[i] += direction; }
        }
        if (tick % 100 == 0)
        {
            std::printf("%.3f s: %.3f %.3f mm, %.2f %.2f mm/s, filament %.2f mm/s\n", x, now[X].p, now[Y].p, now[X].v, now[Y].v, now[E].v);
        }
    }
    std::printf("%d sections; pulses %d %d %d, motors at %d %d %d\n", int(sections), pulses[X], pulses[Y], pulses[E],
                motors[X].count(), motors[Y].count(), motors[E].count());
    return !(pulses[X] == 0 && pulses[Y] == 0 && pulses[E] == int(filament * steps_per_mm[E] + 0.5));
}
