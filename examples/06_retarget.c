/*
 Plans while the axis moves: at 0.7 s the axis gets a target behind it, at 1.8 s it must stop. Each plan starts from the
 state of the plan before, so neither velocity nor acceleration jumps. The axis keeps a jerk of 30 m/s^3, an acceleration of
 10 m/s^2 and a velocity of 5 m/s. A controller sends every setpoint to its drive; this program prints one in 200.

     make dist
     cc -Itarget/dist/include examples/06_retarget.c target/dist/lib/libatraj.a -lm -o retarget
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
    atraj_state const ahead = {10, 0, 0}, behind = {-2, 0, 0}; /* m, m/s, m/s^2 */
    atraj_state now = {0, 0, 0};
    atraj_move move;
    a_float jerk;
    atraj_limits_init(&limits, 30, 10, 5);
    int found = atraj_move_plan(&move, &limits, &now, &ahead); /* below 0: an error */
    puts("Retargeted and stopped: to 10 m, at 0.7 s to -2 m, at 1.8 s to a stop");
    puts("within 5 m/s, 10 m/s^2, 30 m/s^3");
    for (int tick = 0, start = 0; found >= 0 && tick <= 3000; ++tick) {
        atraj_move_state(&move, (tick - start) * PERIOD, &now.p, &now.v, &now.a, &jerk);
        if (tick % EVERY == 0) { printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2, %.4f m/s^3\n", tick * PERIOD, now.p, now.v, now.a, jerk); }
        if (tick == 700) {
            puts("0.700 s -> to -2 m");
            found = atraj_move_plan(&move, &limits, &now, &behind);
            start = tick;
        }
        if (tick == 1800) {
            puts("1.800 s -> stop");
            found = atraj_move_stop(&move, &limits, &now);
            start = tick;
        }
    }
    return !(found >= 0 && now.v == 0 && now.a == 0);
}
