/*
 Moves the three axes of a gantry, each with limits of its own, twice: so that they arrive together, and on a straight line. The
 clock of the drives ticks every millisecond, and both moves end on a tick. The z axis is the fastest and has the shortest way, so
 it must not hurry.

     make dist
     c++ -Itarget/dist/include examples/gantry.cpp target/dist/lib/libatraj.a -lm -o gantry
*/
#include "atraj/move.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

static const double CYCLE = 0.001; // s
enum { X, Y, Z, AXES };

static const atraj::state from[AXES] = {{0, 0, 0}, {0, 0, 0}, {0.1, 0, 0}}; // m, m/s, m/s^2
static const atraj::state to[AXES] = {{0.8, 0, 0}, {0.5, 0, 0}, {0.3, 0, 0}};

// How far the gantry is off the straight line from its start to its end.
static double off_line(const double p[])
{
    double along = 0, length = 0, off = 0;
    for (int i = 0; i < AXES; ++i)
    {
        along += (p[i] - from[i].p) * (to[i].p - from[i].p);
        length += (to[i].p - from[i].p) * (to[i].p - from[i].p);
    }
    for (int i = 0; i < AXES; ++i) { off += std::pow(p[i] - from[i].p - along / length * (to[i].p - from[i].p), 2); }
    return std::sqrt(off);
}

// Prints a move. The result is how far the gantry leaves the line, or infinite if an axis arrives elsewhere or at another time.
static double follow(const char *name, const atraj::move axes[])
{
    const double t = axes[X].t;
    const int ticks = static_cast<int>(t / CYCLE + 0.5);
    double farthest = 0;
    std::printf("%s: %.3f s\n", name, t);
    for (int tick = 0; tick <= ticks; ++tick)
    {
        double p[AXES];
        for (int i = 0; i < AXES; ++i) { p[i] = axes[i].pos(tick * CYCLE); }
        farthest = std::max(farthest, off_line(p));
        if (tick % 200 == 0) { std::printf("  %.1f s: x %.4f m, y %.4f m, z %.4f m\n", tick * CYCLE, p[X], p[Y], p[Z]); }
    }
    for (int i = 0; i < AXES; ++i)
    {
        if (axes[i].t != t || axes[i].pos(ticks * CYCLE) != to[i].p) { return std::numeric_limits<double>::infinity(); }
    }
    std::printf("  off the line by at most %.4f m\n", farthest);
    return farthest;
}

int main()
{
    atraj::limits limits[AXES];
    atraj::move axes[AXES];
    limits[X].init(20, 4, 1); // jerk, acceleration, velocity
    limits[Y].init(10, 2, 0.8);
    limits[Z].init(80, 8, 2);
    if (atraj_moves_sync(axes, limits, from, to, AXES, 0, CYCLE) < 0) { return 1; }
    const double beside = follow("synchronised", axes);
    if (atraj_moves_line(axes, limits, from, to, AXES, 0, CYCLE) < 0) { return 1; }
    const double on_line = follow("on a straight line", axes);
    return !(beside < 1 && on_line < 1e-15); // a rounding
}
