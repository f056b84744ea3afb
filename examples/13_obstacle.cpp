/*
 Moves the two axes of a gantry round an obstacle, by way of two points next to it: without stops, and with a stop at each point. Each
 axis has limits of its own. This program prints one setpoint in 100 of a clock of 1 ms, and which part of its limits an axis uses.

     make dist
     c++ -Itarget/dist/include examples/13_obstacle.cpp target/dist/lib/libatraj.a -lm -o obstacle
*/
#include "atraj/path.h"
#include <algorithm>
#include <cmath>
#include <cstdio>

static const double CYCLE = 0.001; // s
enum { EVERY = 100 }; // print every EVERY-th setpoint
enum { X, Y, AXES };
enum { SECTIONS = 3, SIZE = ATRAJ_PATH_SIZE(AXES, SECTIONS) };

static const double left = 0.4, right = 0.6, top = 0.3; // the obstacle stands at y = 0, m
static const atraj::state points[SECTIONS + 1][AXES] = {
    {{0, 0, 0}, {0, 0, 0}},
    {{0.36, 0, 0}, {0.32, 0, 0}},
    {{0.64, 0, 0}, {0.32, 0, 0}},
    {{1, 0, 0}, {0, 0, 0}},
};

// Prints a setpoint: positions, velocities, accelerations.
static void print(double time, const atraj::state now[])
{
    std::printf("%.3f s: x %.4f m, y %.4f m, ", time, now[X].p, now[Y].p);
    std::printf("%.4f %.4f m/s, %.4f %.4f m/s^2\n", now[X].v, now[Y].v, now[X].a, now[Y].a);
}

// Prints a path. The result is its duration, s, or infinite if the gantry hits the obstacle.
static double follow(const char *name, const atraj::limits limits[], const atraj::move moves[][AXES])
{
    double start = 0, v[AXES] = {0, 0}, a[AXES] = {0, 0};
    int tick = 0;
    std::printf("%s\n", name);
    for (int k = 0; k < SECTIONS; ++k)
    {
        const atraj::move *const axes = moves[k];
        if (k > 0) { std::printf("%.3f s -> point %d\n", start, k); }
        for (; tick * CYCLE < start + axes[X].t; ++tick)
        {
            atraj::state now[AXES];
            for (int i = 0; i < AXES; ++i)
            {
                now[i] = axes[i].state(tick * CYCLE - start);
                v[i] = std::max(v[i], std::fabs(now[i].v) / limits[i].vmax);
                a[i] = std::max(a[i], std::fabs(now[i].a) / limits[i].amax);
            }
            if (tick % EVERY == 0) { print(tick * CYCLE, now); }
            if (now[X].p > left && now[X].p < right && now[Y].p < top) { return HUGE_VAL; }
        }
        start += axes[X].t;
    }
    print(start, points[SECTIONS]);
    for (int i = 0; i < AXES; ++i)
    {
        std::printf("%c uses %.0f %% of %g m/s and %.0f %% of %g m/s^2\n", i == X ? 'x' : 'y', 100 * v[i], limits[i].vmax, 100 * a[i],
            limits[i].amax);
        if (v[i] > 1 + 1e-12 || a[i] > 1 + 1e-12) { return HUGE_VAL; } // a rounding
    }
    return start;
}

int main()
{
    atraj::limits limits[AXES];
    atraj::state states[SECTIONS + 1][AXES];
    atraj::move moves[SECTIONS][AXES];
    double durations[SECTIONS], work[SIZE];
    limits[X].init(40, 4, 1); // jerk, acceleration, velocity
    limits[Y].init(20, 2, 0.8);
    std::puts("Round an obstacle: a gantry passes two points next to it without stops");
    std::puts("x within 1 m/s, 4 m/s^2\ny within 0.8 m/s, 2 m/s^2");
    std::printf("obstacle:\n0 s: x %g m, y 0 m\n0 s: x %g m, y %g m\n0 s: x %g m, y %g m\n0 s: x %g m, y 0 m\n", left, left, top, right, top, right);
    for (int k = 0; k < SECTIONS; ++k)
    {
        if (atraj::sync(moves[k], limits, points[k], points[k + 1], AXES, 0, 0) < 0) { return 1; }
    }
    const double stopping = follow("with stops:", limits, moves);
    for (int k = 0; k <= SECTIONS; ++k) { states[k][X] = points[k][X], states[k][Y] = points[k][Y]; }
    if (atraj_path_plan(&states[0][0], durations, limits, AXES, SECTIONS, 0, work) < 0) { return 1; }
    if (atraj_path_moves(moves[0], limits, states[0], durations, AXES, SECTIONS) < 0) { return 1; }
    const double passing = follow("without stops:", limits, moves);
    std::printf("%.3f s with stops, %.3f s without\n", stopping, passing);
    return !(passing < stopping);
}
