/*
 Plans a move and follows it: 10 m, within a jerk of 30 m/s^3, an acceleration of 10 m/s^2 and a velocity of 5 m/s. The axis
 moves at 1 m/s at the start and rests at the end. A controller sends every setpoint to its drive; this program prints one in 250.

     make dist
     cc -Itarget/dist/include examples/02_follow.c target/dist/lib/libatraj.a -lm -o follow
*/
#include "a/trajbell.h"
#include <stdio.h>

#define PERIOD 0.001 /* s */
#ifndef EVERY
#define EVERY 250 /* print every EVERY-th setpoint */
#endif

int main(void)
{
    a_trajbell move;
    a_float const duration = a_trajbell_gen(&move, 30, 10, 5, 0, 10, 1, 0);
    if (!(duration > 0)) {
        puts("the limits allow no such move");
        return 1;
    }
    puts("Double-S with cruise: 10 m, from 1 m/s to rest");
    puts("within 5 m/s, 10 m/s^2, 30 m/s^3");
    for (int tick = 0; tick * PERIOD < duration; tick += EVERY) {
        a_float const x = tick * PERIOD;
        printf("%.3f s: %.4f m, %.4f m/s, ", x, a_trajbell_pos(&move, x), a_trajbell_vel(&move, x));
        printf("%.4f m/s^2, %.4f m/s^3\n", a_trajbell_acc(&move, x), a_trajbell_jer(&move, x));
    }
    printf("arrives at %.4f m after %.3f s\n", a_trajbell_pos(&move, duration), duration);
    return 0;
}
