/*
 Plans while the axis moves: at 0.7 s the axis gets a target behind it, at 1.8 s it is told to stop. Each plan starts from the
 state of the plan before, so neither velocity nor acceleration jumps. The axis keeps a jerk of 30 m/s^3, an acceleration of
 10 m/s^2 and a velocity of 5 m/s. A controller tells its drive every setpoint; this program prints one in 200.

     make dist
     cc -Itarget/dist/include examples/jog.c target/dist/lib/libatraj.a -lm -o jog
*/
#include "atraj/move.h"
#include <math.h>
#include <stdio.h>

#define PERIOD 0.001 /* s */

int main(void)
{
    atraj_limits limits;
    atraj_state const ahead = {10, 0, 0}, behind = {-2, 0, 0}; /* m, m/s, m/s^2 */
    atraj_state now = {0, 0, 0};
    atraj_move move;
    double velocity_step = 0, acceleration_step = 0;
    atraj_limits_init(&limits, 30, 10, 5);
    int found = atraj_move_plan(&move, &limits, &now, &ahead); /* below 0: an error */
    for (int tick = 0, start = 0; found >= 0 && tick <= 3000; ++tick) {
        atraj_state const before = now;
        atraj_move_state(&move, (tick - start) * PERIOD, &now.p, &now.v, &now.a, NULL);
        velocity_step = fmax(velocity_step, fabs(now.v - before.v));
        acceleration_step = fmax(acceleration_step, fabs(now.a - before.a));
        if (tick % 200 == 0) { printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2\n", tick * PERIOD, now.p, now.v, now.a); }
        if (tick == 700) {
            found = atraj_move_plan(&move, &limits, &now, &behind);
            start = tick;
        }
        if (tick == 1800) {
            found = atraj_move_stop(&move, &limits, &now);
            start = tick;
        }
    }
    printf("from one setpoint to the next at most %.4f m/s, %.4f m/s^2\n", velocity_step, acceleration_step);
    /* The limits times the period, and a rounding. */
    return !(found >= 0 && now.v == 0 && now.a == 0 && velocity_step < 0.010001 && acceleration_step < 0.030001);
}
