/*
 Samples a whole move into arrays, in one call: 101 positions, velocities and accelerations at even times from the start to
 the end. Jerk is not wanted, so its array is NULL.

     make dist
     cc -Itarget/dist/include examples/sample.c target/dist/lib/libatraj.a -lm -o sample
*/
#include "atraj.h"
#include <stdio.h>

enum { SAMPLES = 101 };

int main(void)
{
    static a_float position[SAMPLES], velocity[SAMPLES], acceleration[SAMPLES];
    a_trajbell move;
    a_float const duration = a_trajbell_gen(&move, 30, 10, 5, 0, 10, 0, 0);
    a_float const step = duration / (SAMPLES - 1);
    size_t const count = atraj_bell_sample(&move, 0, step, SAMPLES, position, velocity, acceleration, NULL);

    a_float fastest = 0, hardest = 0;
    int same = 1;
    for (size_t k = 0; k < count; ++k) {
        fastest = A_MAX(fastest, velocity[k]);
        hardest = A_MAX(hardest, acceleration[k]);
        same = same && position[k] == a_trajbell_pos(&move, (a_float)k * step);
    }
    printf("%d samples, %.4f s apart\n", (int)count, step);
    printf("from %.4f m to %.4f m\n", position[0], position[count - 1]);
    printf("at most %.4f m/s and %.4f m/s^2\n", fastest, hardest);
    printf("the same positions as from single calls: %s\n", same ? "yes" : "no");
    return !same;
}
