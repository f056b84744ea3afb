/*
 Meets a part on a conveyor, tracks the part, and goes home at 1.6 s. At 0.4 s the belt gets faster, so the axis plans
 again. The axis keeps a jerk of 50 m/s^3, an acceleration of 5 m/s^2 and a velocity of 2 m/s. A controller sends its drive
 every setpoint; this program prints one in 200.

     make dist
     cc -Itarget/dist/include examples/08_meet.c target/dist/lib/libatraj.a -lm -o meet
*/
#include "atraj/move.h"
#include <stdio.h>

#define PERIOD 0.001 /* s */
#ifndef EVERY
#define EVERY 200 /* print every EVERY-th setpoint */
#endif

int main(void)
{
    atraj_limits limits;
    atraj_state const home = {0, 0, 0};
    atraj_state now = home, part = {0.5, 0.4, 0}; /* m, m/s; the belt does not accelerate */
    atraj_move move;
    int start = 0, goes_home = 0;
    atraj_limits_init(&limits, 50, 5, 2);
    int found = atraj_move_meet(&move, &limits, &now, &part); /* below 0: an error */
    puts("Meeting a part on a conveyor: the belt gets faster, the axis tracks the part and goes home");
    puts("within 2 m/s, 5 m/s^2, 50 m/s^3");
    for (int tick = 0; found >= 0 && tick <= 3000; ++tick, part.p += part.v * PERIOD) {
        double const x = (tick - start) * PERIOD;
        if (goes_home || x < move.t) { atraj_move_state(&move, x, &now.p, &now.v, &now.a, NULL); }
        else { now = part; } /* the move has ended at the part, and the part moves on */
        if (tick % EVERY == 0) {
            printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2, part %.4f m, %.4f m/s\n", tick * PERIOD, now.p, now.v, now.a, part.p, part.v);
        }
        if (tick == 400) {
            puts("0.400 s -> faster belt");
            part.v = 0.6;
            found = atraj_move_meet(&move, &limits, &now, &part);
            start = tick;
        }
        if (tick == 1600) {
            puts("1.600 s -> home");
            found = atraj_move_plan(&move, &limits, &now, &home);
            start = tick;
            goes_home = 1;
        }
    }
    return !(found >= 0 && now.p == 0 && now.v == 0);
}
