/*
 An arm with six axes follows waypoints and stops at each. The axes have limits of their own, arrive at a waypoint together, and
 stretch their moves to the slowest axis. The clock of the drives ticks every 4 ms, and every move ends on a tick. This program
 prints one setpoint in 50: the positions, then the velocities.

     make dist
     c++ -Itarget/dist/include examples/10_arm.cpp target/dist/lib/libatraj.a -lm -o arm
*/
#include "atraj/move.h"
#include <cstdio>

static const double CYCLE = 0.004; // s
enum { AXES = 6, MOVES = 4 };

static const atraj::state points[MOVES + 1][AXES] = {
    {{0, 0, 0}, {-90, 0, 0}, {90, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, // degrees, and at rest
    {{30, 0, 0}, {-60, 0, 0}, {70, 0, 0}, {0, 0, 0}, {-40, 0, 0}, {90, 0, 0}},
    {{30, 0, 0}, {-50, 0, 0}, {75, 0, 0}, {0, 0, 0}, {-55, 0, 0}, {90, 0, 0}}, // down
    {{-45, 0, 0}, {-70, 0, 0}, {80, 0, 0}, {20, 0, 0}, {-30, 0, 0}, {-90, 0, 0}},
    {{0, 0, 0}, {-90, 0, 0}, {90, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, // home
};

// Prints the setpoints of a move that begins at `start`.
static void follow(const atraj::move axes[], double start)
{
    for (int tick = 0; tick * CYCLE < axes[0].t; tick += 50)
    {
        std::printf("%.3f s:", start + tick * CYCLE);
        for (int i = 0; i < AXES; ++i) { std::printf(" %.2f", axes[i].pos(tick * CYCLE)); }
        std::printf(" deg,");
        for (int i = 0; i < AXES; ++i) { std::printf(" %.2f", axes[i].vel(tick * CYCLE)); }
        std::printf(" deg/s\n");
    }
}

int main()
{
    atraj::limits limits[AXES];
    for (int i = 0; i < AXES; ++i)
    {
        if (i < 3) { limits[i].init(4000, 500, 120); }
        else { limits[i].init(9000, 1000, 250); }
    }
    double start = 0;
    std::puts("Arm over waypoints: six joints arrive together at each");
    std::puts("joints 1 to 3 within 120 deg/s");
    std::puts("joints 4 to 6 within 250 deg/s");
    for (int k = 0; k < MOVES; ++k)
    {
        atraj::move axes[AXES];
        if (atraj_moves_sync(axes, limits, points[k], points[k + 1], AXES, 0, CYCLE) < 0) { return 1; }
        follow(axes, start);
        start += axes[0].t;
        std::printf("%.3f s -> point %d\n", start, k + 1);
        for (int i = 0; i < AXES; ++i)
        {
            const atraj::state end = axes[i].state(axes[0].t);
            if (!(axes[i].t == axes[0].t && end.p == points[k + 1][i].p && end.v == 0 && end.a == 0)) { return 1; }
        }
    }
    return 0;
}
