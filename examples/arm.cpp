/*
 An arm with six axes follows way points and stops at each. The axes have limits of their own, arrive at a way point together, and
 stretch their moves to the slowest axis. The clock of the drives ticks every 4 ms, and every move ends on a tick.

     make dist
     c++ -Itarget/dist/include examples/arm.cpp target/dist/lib/libatraj.a -lm -o arm
*/
#include "atraj/move.h"
#include <cstdio>

static const double CYCLE = 0.004; // s
enum { AXES = 6, LEGS = 4 };

static const atraj::state points[LEGS + 1][AXES] = {
    {{0, 0, 0}, {-90, 0, 0}, {90, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, // degrees, and at rest
    {{30, 0, 0}, {-60, 0, 0}, {70, 0, 0}, {0, 0, 0}, {-40, 0, 0}, {90, 0, 0}},
    {{30, 0, 0}, {-50, 0, 0}, {75, 0, 0}, {0, 0, 0}, {-55, 0, 0}, {90, 0, 0}}, // down
    {{-45, 0, 0}, {-70, 0, 0}, {80, 0, 0}, {20, 0, 0}, {-30, 0, 0}, {-90, 0, 0}},
    {{0, 0, 0}, {-90, 0, 0}, {90, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, // home
};

int main()
{
    atraj::limits limits[AXES];
    for (int i = 0; i < AXES; ++i)
    {
        if (i < 3) { limits[i].init(4000, 500, 120); }
        else { limits[i].init(9000, 1000, 250); }
    }
    double start = 0;
    for (int leg = 0; leg < LEGS; ++leg)
    {
        const atraj::state *const from = points[leg], *const to = points[leg + 1];
        atraj::move axes[AXES];
        if (atraj_moves_sync(axes, limits, from, to, AXES, 0, CYCLE) < 0) { return 1; }
        const double t = axes[0].t;
        const int ticks = static_cast<int>(t / CYCLE + 0.5);
        std::printf("way point %d after %.3f s, %d ticks\n", leg + 1, start + t, ticks);
        for (int quarter = 1; quarter <= 4; ++quarter)
        {
            const double x = ticks * quarter / 4 * CYCLE;
            std::printf("  %.3f s:", start + x);
            for (int i = 0; i < AXES; ++i) { std::printf(" %7.2f", axes[i].pos(x)); }
            std::printf("\n");
        }
        for (int i = 0; i < AXES; ++i)
        {
            const atraj::state end = axes[i].state(ticks * CYCLE);
            if (!(axes[i].t == t && end.p == to[i].p && end.v == 0 && end.a == 0)) { return 1; }
        }
        start += t;
    }
    return 0;
}
