/* A controller that takes its PID from the original and its trajectories from whichever library the linker prefers. */
#include "a/pid.h"
#include "a/trajbell.h"
#include "a/trajpoly5.h"
#include "a/trajtrap.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

int main(int argc, char **argv) {
    /* The compiler cannot know these sizes, so it calls sqrt and memcpy. */
    const size_t size = (size_t)(argc > 0) * sizeof(a_trajbell);
    volatile double four = 4.0 * argc;
    a_trajbell bell, copy;
    a_trajtrap trap;
    a_trajpoly5 poly;
    a_pid pid;
    int i;
    (void)argv;
    memset(&pid, 0, sizeof(pid));
    pid.summax = pid.outmax = 100;
    pid.summin = pid.outmin = -100;
    a_pid_set_kpid(&pid, 3, 0.25, 0.125);
    a_trajbell_gen(&bell, 30, 10, 5, 0, 10, 1, 0);
    a_trajtrap_gen(&trap, 5, 4, -2, 0, 50, 0, 0);
    a_trajpoly5_gen(&poly, 8, 0, 10, 0, 0, 0, 0);
    memcpy(&copy, &bell, size);
    printf("%a %a\n", sqrt(four), copy.t);
    for (i = 0; i < 100; ++i) {
        const a_float x = (a_float)0.03125 * (a_float)i;
        const a_float set = a_trajbell_pos(&copy, x);
        printf("%a %a %a %a\n", set, a_trajtrap_pos(&trap, x), a_trajpoly5_vel(&poly, x), a_pid_pos(&pid, set, pid.out));
    }
    return 0;
}
