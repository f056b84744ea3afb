/*
 A load hangs on an axis and swings with 1.2 Hz and 1 % of the critical damping. This program moves the axis by 0.5 m and computes what the load does, with
 a shaper and without one. The shaper keeps all limits of the move, and takes half a period longer. This program prints one setpoint in 2500 of 0.1 ms.

     make dist
     cc -Itarget/dist/include examples/21_swing.c target/dist/lib/libatraj.a -lm -o swing
*/
#include "atraj/shaper.h"
#include <math.h>
#include <stdio.h>

#define CYCLE 0.0001 /* s */
#ifndef EVERY
#define EVERY 2500 /* print every EVERY-th setpoint */
#endif

/* How far the load is ahead of the axis, m, and how fast it gets farther, m/s. */
typedef struct {
    double p, v;
} load;

/* The load swings for a cycle, while the axis has this acceleration. */
static void swing(load *z, double acceleration)
{
    double const w = 2 * 3.141592653589793 * 1.2, damping = 0.01; /* 1/s */
    z->v += CYCLE * (-acceleration - 2 * damping * w * z->v - w * w * z->p);
    z->p += CYCLE * z->v;
}

int main(void)
{
    atraj_state const from = {0, 0, 0}, to = {0.5, 0, 0}; /* m */
    atraj_limits limits;
    atraj_move move;
    atraj_shaper shaper;
    load shaped = {0, 0}, plain = {0, 0};
    double most_shaped = 0, most_plain = 0; /* m */
    atraj_limits_init(&limits, 40, 4, 1); /* jerk, acceleration, velocity */
    if (atraj_move_plan(&move, &limits, &from, &to) < 0) { return 1; }
    if (atraj_shaper_init(&shaper, ATRAJ_SHAPER_ZV, 1.2, 0.01) < 0) { return 1; }
    puts("A load that swings: with a shaper, and without one");
    puts("within 1 m/s, 4 m/s^2");
    for (int tick = 0; tick <= 25000; ++tick) {
        double const x = tick * CYCLE, end = move.t + shaper.t;
        atraj_state now;
        atraj_shaper_state(&shaper, &move, x, &now);
        if (tick % EVERY == 0) {
            double const p = atraj_move_pos(&move, x);
            printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2, load %.4f m, load without a shaper %.4f m\n", x, now.p, now.v, now.a, now.p + shaped.p, p + plain.p);
        }
        swing(&shaped, now.a);
        swing(&plain, atraj_move_acc(&move, x));
        if (x > end && fabs(shaped.p) > most_shaped) { most_shaped = fabs(shaped.p); }
        if (x > end && fabs(plain.p) > most_plain) { most_plain = fabs(plain.p); }
    }
    printf("%.3f s without a shaper, then the load swings by %.1f mm\n", move.t, 1000 * most_plain);
    printf("%.3f s with a shaper, then the load swings by %.1f mm\n", move.t + shaper.t, 1000 * most_shaped);
    return !(most_shaped < most_plain / 100);
}
