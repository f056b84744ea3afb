/*
 Meets a part on a conveyor, rides beside the part, and goes home at 1.6 s. At 0.4 s the belt gets faster, so the axis plans
 again. The axis keeps a jerk of 50 m/s^3, an acceleration of 5 m/s^2 and a velocity of 2 m/s. A controller tells its drive
 every setpoint; this program prints one in 200.

     make dist
     cc -Itarget/dist/include examples/meet.c target/dist/lib/libatraj.a -lm -o meet
*/
#include "atraj/move.h"
#include <math.h>
#include <stdio.h>

#define PERIOD 0.001 /* s */

int main(void)
{
    atraj_limits limits;
    atraj_state const home = {0, 0, 0};
    atraj_state now = home, part = {0.5, 0.4, 0}; /* m, m/s; the belt does not accelerate */
    atraj_move move;
    double position_step = 0, velocity_step = 0, acceleration_step = 0;
    int start = 0, goes_home = 0, ridden = 0;
    atraj_limits_init(&limits, 50, 5, 2);
    int found = atraj_move_meet(&move, &limits, &now, &part); /* below 0: an error */
    for (int tick = 0; found >= 0 && tick <= 3000; ++tick, part.p += part.v * PERIOD) {
        double const x = (tick - start) * PERIOD;
        atraj_state const before = now;
        if (goes_home || x < move.t) { atraj_move_state(&move, x, &now.p, &now.v, &now.a, NULL); }
        else {
            now = part; /* the move has ended beside the part, and the part moves on */
            ++ridden;
        }
        position_step = fmax(position_step, fabs(now.p - before.p));
        velocity_step = fmax(velocity_step, fabs(now.v - before.v));
        acceleration_step = fmax(acceleration_step, fabs(now.a - before.a));
        if (tick % 200 == 0) { printf("%.1f s: part %.4f m, axis %.4f m, %.4f m/s\n", tick * PERIOD, part.p, now.p, now.v); }
        if (tick == 400) {
            part.v = 0.6;
            found = atraj_move_meet(&move, &limits, &now, &part);
            start = tick;
        }
        if (tick == 1600) {
            found = atraj_move_plan(&move, &limits, &now, &home);
            start = tick;
            goes_home = 1;
        }
    }
    printf("beside the part for %.3f s\n", ridden * PERIOD);
    printf("from one setpoint to the next at most %.4f m, %.4f m/s, %.4f m/s^2\n", position_step, velocity_step, acceleration_step);
    /* The limits times the period, and a rounding. */
    int const smooth = position_step < 0.002001 && velocity_step < 0.005001 && acceleration_step < 0.050001;
    return !(found >= 0 && smooth && ridden > 0 && now.p == 0 && now.v == 0);
}
