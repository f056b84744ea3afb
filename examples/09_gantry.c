/*
 Moves the two axes of a gantry, each with limits of its own, twice: so that they arrive together, and on a straight line. The clock
 of the drives ticks every millisecond, and both moves end on a tick. This program prints one setpoint in 200.

     make dist
     cc -Itarget/dist/include examples/09_gantry.c target/dist/lib/libatraj.a -lm -o gantry
*/
#include "atraj/move.h"
#include <math.h>
#include <stdio.h>

#define CYCLE 0.001 /* s */
#ifndef EVERY
#define EVERY 200 /* one setpoint in so many is printed */
#endif
enum { X, Y, AXES };

static atraj_state const from[AXES] = {{0, 0, 0}, {0, 0, 0}}; /* m, m/s, m/s^2 */
static atraj_state const to[AXES] = {{0.8, 0, 0}, {0.4, 0, 0}};

/* Prints a move. The result is how far the gantry leaves the line, or infinite if an axis arrives elsewhere or at another time. */
static double follow(char const *name, atraj_move const axes[])
{
    int const ticks = (int)(axes[X].t / CYCLE + 0.5);
    double farthest = 0, x = 0, y = 0;
    printf("%s\n", name);
    for (int tick = 0; tick <= ticks; ++tick) {
        x = atraj_move_pos(&axes[X], tick * CYCLE);
        y = atraj_move_pos(&axes[Y], tick * CYCLE);
        farthest = fmax(farthest, fabs(to[X].p * y - to[Y].p * x) / hypot(to[X].p, to[Y].p));
        if (tick % EVERY == 0) { printf("%.3f s: x %.4f m, y %.4f m\n", tick * CYCLE, x, y); }
    }
    printf("%.3f s: x %.4f m, y %.4f m\n", axes[X].t, x, y);
    printf("off the line by at most %.4f m\n", farthest);
    return axes[X].t == axes[Y].t && x == to[X].p && y == to[Y].p ? farthest : INFINITY;
}

int main(void)
{
    atraj_limits limits[AXES];
    atraj_move axes[AXES];
    atraj_limits_init(&limits[X], 20, 4, 1); /* jerk, acceleration, velocity */
    atraj_limits_init(&limits[Y], 5, 1, 0.6);
    puts("Gantry in the plane: two axes arrive together, and stay on a straight line");
    if (atraj_moves_sync(axes, limits, from, to, AXES, 0, CYCLE) < 0) { return 1; }
    double const beside = follow("synchronised:", axes);
    if (atraj_moves_line(axes, limits, from, to, AXES, 0, CYCLE) < 0) { return 1; }
    double const on_line = follow("on a straight line:", axes);
    return !(beside < 1 && on_line < 1e-15); /* a rounding */
}
