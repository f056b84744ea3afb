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
#define EVERY 200 /* print every EVERY-th setpoint */
#endif
enum { X, Y, AXES };

static atraj_state const from[AXES] = {{0, 0, 0}, {0, 0, 0}}; /* m, m/s, m/s^2 */
static atraj_state const to[AXES] = {{0.8, 0, 0}, {0.4, 0, 0}};

/* Prints a setpoint: positions, velocities, accelerations. */
static void print(double time, atraj_state const *x, atraj_state const *y)
{
    printf("%.3f s: x %.4f m, y %.4f m, %.4f %.4f m/s, %.4f %.4f m/s^2\n", time, x->p, y->p, x->v, y->v, x->a, y->a);
}

/* Prints a move. The result is how far the gantry leaves the line, or infinite if an axis arrives elsewhere or at another time. */
static double follow(char const *name, atraj_move const axes[])
{
    int const ticks = (int)(axes[X].t / CYCLE + 0.5);
    atraj_state x = from[X], y = from[Y];
    double farthest = 0;
    printf("%s\n", name);
    for (int tick = 0; tick <= ticks; ++tick) {
        atraj_move_state(&axes[X], tick * CYCLE, &x.p, &x.v, &x.a, NULL);
        atraj_move_state(&axes[Y], tick * CYCLE, &y.p, &y.v, &y.a, NULL);
        farthest = fmax(farthest, fabs(to[X].p * y.p - to[Y].p * x.p) / hypot(to[X].p, to[Y].p));
        if (tick % EVERY == 0) { print(tick * CYCLE, &x, &y); }
    }
    print(axes[X].t, &x, &y);
    printf("off the line by at most %.4f m\n", farthest);
    return axes[X].t == axes[Y].t && x.p == to[X].p && y.p == to[Y].p ? farthest : INFINITY;
}

int main(void)
{
    atraj_limits limits[AXES];
    atraj_move axes[AXES];
    atraj_limits_init(&limits[X], 20, 4, 1); /* jerk, acceleration, velocity */
    atraj_limits_init(&limits[Y], 5, 1, 0.6);
    puts("Gantry in the plane: two axes arrive together, and stay on a straight line");
    puts("x within 1 m/s, 4 m/s^2\ny within 0.6 m/s, 1 m/s^2");
    if (atraj_moves_sync(axes, limits, from, to, AXES, 0, CYCLE) < 0) { return 1; }
    double const synchronised = follow("synchronised:", axes);
    if (atraj_moves_line(axes, limits, from, to, AXES, 0, CYCLE) < 0) { return 1; }
    double const on_line = follow("on a straight line:", axes);
    return !(synchronised < 1 && on_line < 1e-15); /* a rounding */
}
