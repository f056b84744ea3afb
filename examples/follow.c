/*
 Plans a move and follows it: 10 m from rest to rest, within a jerk of 30 m/s^3, an acceleration of 10 m/s^2 and a velocity
 of 5 m/s. A controller tells its drive every setpoint; this program prints one in 250.

     make dist
     cc -Itarget/dist/include examples/follow.c target/dist/lib/libatraj.a -lm -o follow
*/
#include "a/trajbell.h"
#include <stdio.h>

#define PERIOD 0.001 /* s */

int main(void)
{
    a_trajbell move;
    a_float const duration = a_trajbell_gen(&move, 30, 10, 5, 0, 10, 0, 0);
    if (!(duration > 0)) {
        puts("the limits allow no such move");
        return 1;
    }
    int within = 1;
    for (int tick = 0; tick * PERIOD < duration; ++tick) {
        a_float const x = tick * PERIOD;
        a_float const position = a_trajbell_pos(&move, x);
        a_float const velocity = a_trajbell_vel(&move, x);
        within = within && velocity >= 0 && velocity <= 5;
        if (tick % 250 == 0) { printf("%.3f s: %.4f m, %.4f m/s\n", x, position, velocity); }
    }
    printf("%.3f s: arrived at %.4f m\n", duration, a_trajbell_pos(&move, duration));
    printf("within the velocity: %s\n", within ? "yes" : "no");
    return !within;
}
