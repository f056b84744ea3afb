/*
 Drives a stepper motor. A step is 1.8 degrees, and the driver wants a pulse for each step: `atraj_move_time_at` returns when the move is at
 the position of a step. The motor turns by half a revolution and a quarter back, so the direction changes once. It keeps a jerk of
 200,000 deg/s^3, an acceleration of 10,000 deg/s^2 and a velocity of 1,000 deg/s. This program prints one pulse in 10, with the velocity
 since the pulse before.

     make dist
     cc -Itarget/dist/include examples/19_steps.c target/dist/lib/libatraj.a -lm -o steps
*/
#include "atraj/move.h"
#include <stdio.h>

#define STEP 1.8 /* deg */
#ifndef EVERY
#define EVERY 10 /* print every EVERY-th pulse */
#endif

/* Gives the pulses of a move that begins at the time `start`, from one step to another. */
static void give_pulses(atraj_move const *move, double start, int from, int to)
{
    int const direction = to > from ? 1 : -1;
    double last = 0; /* s */
    for (int step = from + direction; step != to + direction; step += direction) {
        double const x = atraj_move_time_at(move, step * STEP);
        if (step % EVERY == 0) {
            printf("%.6f s: %.1f deg, %.1f deg/s\n", start + x, step * STEP, direction * STEP / (x - last));
        }
        last = x;
    }
}

int main(void)
{
    int const there = 100, back = 50; /* steps */
    atraj_state const home = {0, 0, 0}, half = {100 * STEP, 0, 0}, quarter = {50 * STEP, 0, 0}; /* deg */
    double const wait = 0.05; /* s */
    atraj_limits limits;
    atraj_move move;
    int found; /* below 0: an error */
    atraj_limits_init(&limits, 200000, 10000, 1000);
    puts("Pulses for a stepper motor: half a revolution, and a quarter back");
    puts("within 1000 deg/s");
    found = atraj_move_plan(&move, &limits, &home, &half);
    if (found >= 0) {
        puts("0.000 s -> forward");
        give_pulses(&move, 0, 0, there);
        double const start = move.t + wait;
        found = atraj_move_plan(&move, &limits, &half, &quarter);
        printf("%.3f s -> backward\n", start);
        if (found >= 0) { give_pulses(&move, start, there, back); }
    }
    return found < 0;
}
