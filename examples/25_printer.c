/*
 Prints an octagon: points, path, clock, shaper and steps work together, as in the firmware of a printer. Two axes and an extruder stay within 0.1 mm of
 the lines between the points. A pause button holds them on their path and lets them go on. The shapers leave the frame at rest, and the extruder is
 ahead by its pressure advance. Each motor gets its steps, with a least time between two of them. This program prints one tick in 100 of
 1 ms: where the nozzle is, and how fast it and the filament are.

     make dist
     cc -Itarget/dist/include examples/25_printer.c target/dist/lib/libatraj.a -lm -o printer
*/
#include "atraj/clock.h"
#include "atraj/path.h"
#include "atraj/shaper.h"
#include "atraj/steps.h"
#include <math.h>
#include <stdio.h>

#define TICK 0.001 /* s */
#ifndef EVERY
#define EVERY 100 /* print every EVERY-th tick */
#endif
enum { X, Y, E, AXES, SECTIONS = 8, ROOM = 128, SIZE = ATRAJ_PATH_SIZE(AXES, ROOM), LINE = 200 };

static double const corners[SECTIONS + 1][2] = {{5, 0}, {45, 0}, {50, 5}, {50, 25}, {45, 30}, {5, 30}, {0, 25}, {0, 5}, {5, 0}}; /* mm */
static double const steps_per_mm[AXES] = {80, 80, 400};

int main(void)
{
    atraj_limits planned[AXES], limits[AXES]; /* 20 % are the reserve of the clock */
    static atraj_state states[ROOM + 1][AXES];
    static atraj_move moves[ROOM][AXES];
    static double durations[ROOM], work[SIZE];
    size_t places[SECTIONS + 1];
    double line[AXES][LINE], filament = 0;
    atraj_shaper shapers[AXES];
    atraj_shaper_stream streams[AXES];
    atraj_step_stream motors[AXES];
    atraj_clock clock;
    for (int i = 0; i < AXES; ++i) {
        atraj_limits_init(&limits[i], 100000, 3000, 100); /* mm */
        atraj_limits_init(&planned[i], 80000, 2400, 80);
    }
    for (int k = 0; k <= SECTIONS; ++k) {
        if (k > 0) { filament += 0.05 * hypot(corners[k][X] - corners[k - 1][X], corners[k][Y] - corners[k - 1][Y]); }
        states[k][X].p = corners[k][X], states[k][Y].p = corners[k][Y], states[k][E].p = filament;
    }
    if (atraj_path_contour(moves[0], states[0], durations, places, planned, 0.1, AXES, SECTIONS, ROOM, 0, work) < 0) { return 1; }
    size_t const sections = places[SECTIONS];
    if (atraj_shaper_init(&shapers[X], ATRAJ_SHAPER_MZV, 45, 0.1) < 0 || atraj_shaper_init(&shapers[Y], ATRAJ_SHAPER_ZV, 38, 0.1) < 0) { return 1; }
    if (atraj_shaper_smooth(&shapers[E], 0.02) < 0) { return 1; }
    for (int i = 0; i < AXES; ++i) {
        if (atraj_shaper_size(&shapers[i], TICK) > LINE) { return 1; }
        if (atraj_shaper_stream_init(&streams[i], &shapers[i], TICK, &states[0][i], line[i], LINE) < 0) { return 1; }
        if (atraj_step_stream_init(&motors[i], 1 / steps_per_mm[i], TICK, &states[0][i]) < 0) { return 1; }
        if (atraj_step_stream_wait(&motors[i], 2e-6, 20e-6) < 0) { return 1; }
    }
    if (atraj_shaper_stream_advance(&streams[E], 0.04) < 0) { return 1; }
    puts("Printing an octagon: points, path, clock, shaper and steps");
    puts("nozzle:");
    atraj_clock_start(&clock);
    int pulses[AXES] = {0, 0, 0};
    for (int tick = 0; tick <= 3000; ++tick) {
        double const x = tick * TICK;
        atraj_state now[AXES];
        if (tick == 600 || tick == 1200) {
            if (atraj_clock_rate(&clock, moves[0], limits, AXES, sections, x, tick == 600 ? 0 : 1) < 0) { return 1; }
            printf("%.3f s -> %s\n", x, tick == 600 ? "pause" : "go on");
        }
        for (int i = 0; i < AXES; ++i) {
            double time; /* of a pulse, s after the last tick */
            int direction;
            atraj_clock_state(&clock, &moves[0][i], AXES, sections, x, &now[i].p, &now[i].v, &now[i].a, A_NULL);
            if (atraj_shaper_stream_tick(&streams[i], &now[i], line[i], LINE, &now[i]) < 0) { return 1; }
            if (atraj_step_stream_tick(&motors[i], &now[i]) < 0) { return 1; }
            while ((direction = atraj_step_stream_next(&motors[i], &time)) != 0) { pulses[i] += direction; }
        }
        if (tick % EVERY == 0) {
            printf("%.3f s: %.3f %.3f mm, %.2f %.2f mm/s, filament %.2f mm/s\n", x, now[X].p, now[Y].p, now[X].v, now[Y].v, now[E].v);
        }
    }
    printf("%d sections; pulses %d %d %d, motors at %d %d %d\n", (int)sections, pulses[X], pulses[Y], pulses[E],
           atraj_step_stream_count(&motors[X]), atraj_step_stream_count(&motors[Y]), atraj_step_stream_count(&motors[E]));
    return !(pulses[X] == 0 && pulses[Y] == 0 && pulses[E] == (int)(filament * steps_per_mm[E] + 0.5));
}
