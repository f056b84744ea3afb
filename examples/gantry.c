/*
 Moves the three axes of a gantry, each with limits of its own, twice: so that they arrive together, and on a straight line. The
 clock of the drives ticks every millisecond, and both moves end on a tick. The z axis is the fastest and has the shortest way, so
 it must not hurry.

     make dist
     cc -Itarget/dist/include examples/gantry.c target/dist/lib/libatraj.a -lm -o gantry
*/
#include "atraj/move.h"
#include <math.h>
#include <stdio.h>

#define CYCLE 0.001 /* s */
enum { X, Y, Z, AXES };

static atraj_state const from[AXES] = {{0, 0, 0}, {0, 0, 0}, {0.1, 0, 0}}; /* m, m/s, m/s^2 */
static atraj_state const to[AXES] = {{0.8, 0, 0}, {0.5, 0, 0}, {0.3, 0, 0}};

/* How far the gantry is off the straight line from its start to its end. */
static double off_line(double const p[])
{
    double along = 0, length = 0, off = 0;
    for (int i = 0; i < AXES; ++i) {
        along += (p[i] - from[i].p) * (to[i].p - from[i].p);
        length += (to[i].p - from[i].p) * (to[i].p - from[i].p);
    }
    for (int i = 0; i < AXES; ++i) { off += pow(p[i] - from[i].p - along / length * (to[i].p - from[i].p), 2); }
    return sqrt(off);
}

/* Prints a move. The result is how far the gantry leaves the line, or infinite if an axis arrives elsewhere or at another time. */
static double follow(char const *name, atraj_move const axes[])
{
    double const t = axes[X].t;
    int const ticks = (int)(t / CYCLE + 0.5);
    double farthest = 0;
    printf("%s: %.3f s\n", name, t);
    for (int tick = 0; tick <= ticks; ++tick) {
        double p[AXES];
        for (int i = 0; i < AXES; ++i) { p[i] = atraj_move_pos(&axes[i], tick * CYCLE); }
        farthest = fmax(farthest, off_line(p));
        if (tick % 200 == 0) { printf("  %.1f s: x %.4f m, y %.4f m, z %.4f m\n", tick * CYCLE, p[X], p[Y], p[Z]); }
    }
    for (int i = 0; i < AXES; ++i) {
        if (axes[i].t != t || atraj_move_pos(&axes[i], ticks * CYCLE) != to[i].p) { return INFINITY; }
    }
    printf("  off the line by at most %.4f m\n", farthest);
    return farthest;
}

int main(void)
{
    atraj_limits limits[AXES];
    atraj_move axes[AXES];
    atraj_limits_init(&limits[X], 20, 4, 1); /* jerk, acceleration, velocity */
    atraj_limits_init(&limits[Y], 10, 2, 0.8);
    atraj_limits_init(&limits[Z], 80, 8, 2);
    if (atraj_moves_sync(axes, limits, from, to, AXES, 0, CYCLE) < 0) { return 1; }
    double const beside = follow("synchronised", axes);
    if (atraj_moves_line(axes, limits, from, to, AXES, 0, CYCLE) < 0) { return 1; }
    double const on_line = follow("on a straight line", axes);
    return !(beside < 1 && on_line < 1e-15); /* a rounding */
}
