/*
 One prefix further: 6 m to go, at 7.5 m/s, with an acceleration of 2.5 m/s^2 at most. This is too near to stop. The plan of
 a_trajbell_gen breaks the limit. atraj_bell_gen takes the same arguments and fills the same struct, and its plan passes the
 target and comes back. a_trajbell_pos and the others evaluate both plans. This program prints one setpoint in 1000.

     make dist
     cc -Itarget/dist/include examples/05_one_prefix.c target/dist/lib/libatraj.a -lm -o one_prefix
*/
#include "atraj.h"
#include <stdio.h>

#define PERIOD 0.001 /* s */
#ifndef EVERY
#define EVERY 1000 /* print every EVERY-th setpoint */
#endif

static void print(char const *name, a_trajbell const *move, a_float x)
{
    printf("%s%.4f m, %.4f m/s, %.4f m/s^2", name, a_trajbell_pos(move, x), a_trajbell_vel(move, x), a_trajbell_acc(move, x));
}

static char const *judge(a_trajbell const *move)
{
    return atraj_bell_check(move, 30, 2.5, 10) & ATRAJ_EXCEEDS_ACCELERATION ? "breaks the limit" : "keeps the limit";
}

int main(void)
{
    a_trajbell liba, ours;
    a_trajbell_gen(&liba, 30, 2.5, 10, 0, 6, 7.5, 0); /* jerk, acceleration, velocity; from, to; velocities there */
    a_float const duration = atraj_bell_gen(&ours, 30, 2.5, 10, 0, 6, 7.5, 0);
    puts("Too near to stop: 6 m to go at 7.5 m/s");
    puts("within 10 m/s, 2.5 m/s^2, 30 m/s^3");
    for (int tick = 0; tick * PERIOD < duration; tick += EVERY) {
        a_float const x = tick * PERIOD;
        printf("%.3f s: ", x);
        print("", &ours, x);
        print(", a_trajbell_gen ", &liba, x);
        puts("");
    }
    printf("a_trajbell_gen %s, atraj_bell_gen %s\n", judge(&liba), judge(&ours));
    return atraj_bell_check(&ours, 30, 2.5, 10) != ATRAJ_OVERSHOOTS;
}
