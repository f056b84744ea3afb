/*
 Moves the two axes of a gantry, each with limits of its own, twice: so that they arrive together, and on a straight line. The clock
 of the drives ticks every millisecond, and both moves end on a tick. This program prints one setpoint in 200.

     make dist
     c++ -Itarget/dist/include examples/09_gantry.cpp target/dist/lib/libatraj.a -lm -o gantry
*/
#include "atraj/move.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

static const double CYCLE = 0.001; // s
enum { X, Y, AXES };

static const atraj::state from[AXES] = {{0, 0, 0}, {0, 0, 0}}; // m, m/s, m/s^2
static const atraj::state to[AXES] = {{0.8, 0, 0}, {0.4, 0, 0}};

// Prints a setpoint: positions, velocities, accelerations.
static void print(double time, const atraj::state &x, const atraj::state &y)
{
    std::printf("%.3f s: x %.4f m, y %.4f m, %.4f %.4f m/s, %.4f %.4f m/s^2\n", time, x.p, y.p, x.v, y.v, x.a, y.a);
}

// Prints a move. The result is how far the gantry leaves the line, or infinite if an axis arrives elsewhere or at another time.
static double follow(const char *name, const atraj::move axes[])
{
    const int ticks = static_cast<int>(axes[X].t / CYCLE + 0.5);
    const double length = std::sqrt(to[X].p * to[X].p + to[Y].p * to[Y].p);
    atraj::state x = from[X], y = from[Y];
    double farthest = 0;
    std::printf("%s\n", name);
    for (int tick = 0; tick <= ticks; ++tick)
    {
        x = axes[X].state(tick * CYCLE);
        y = axes[Y].state(tick * CYCLE);
        farthest = std::max(farthest, std::fabs(to[X].p * y.p - to[Y].p * x.p) / length);
        if (tick % 200 == 0) { print(tick * CYCLE, x, y); }
    }
    print(axes[X].t, x, y);
    std::printf("off the line by at most %.4f m\n", farthest);
    return axes[X].t == axes[Y].t && x.p == to[X].p && y.p == to[Y].p ? farthest : std::numeric_limits<double>::infinity();
}

int main()
{
    atraj::limits limits[AXES];
    atraj::move axes[AXES];
    limits[X].init(20, 4, 1); // jerk, acceleration, velocity
    limits[Y].init(5, 1, 0.6);
    std::puts("Gantry in the plane: two axes arrive together, and stay on a straight line");
    std::puts("x within 1 m/s, 4 m/s^2\ny within 0.6 m/s, 1 m/s^2");
    if (atraj_moves_sync(axes, limits, from, to, AXES, 0, CYCLE) < 0) { return 1; }
    const double synchronised = follow("synchronised:", axes);
    if (atraj_moves_line(axes, limits, from, to, AXES, 0, CYCLE) < 0) { return 1; }
    const double on_line = follow("on a straight line:", axes);
    return !(synchronised < 1 && on_line < 1e-15); // a rounding
}
