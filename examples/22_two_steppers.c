/*
 Drives two stepper motors together. Both have 80 steps for a millimetre. `atraj_steps_next` returns the time of the next step of each motor, and the earlier
 one is next: a timer would be set to it. The motors move by 40 mm and by 12.5 mm in the same time. This program prints one pulse in 400, and where
 both motors are then.

     make dist
     cc -Itarget/dist/include examples/22_two_steppers.c target/dist/lib/libatraj.a -lm -o two_steppers
*/
#include "atraj/steps.h"
#include <stdio.h>

#define STEP 0.0125 /* mm */
#ifndef EVERY
#define EVERY 400 /* print every EVERY-th pulse */
#endif
enum { X, Y, MOTORS };

int main(void)
{
    atraj_state const from[MOTORS] = {{0, 0, 0}, {0, 0, 0}}, to[MOTORS] = {{40, 0, 0}, {-12.5, 0, 0}}; /* mm */
    atraj_limits limits[MOTORS];
    atraj_move axes[MOTORS];
    atraj_steps steps[MOTORS];
    double times[MOTORS], last[MOTORS] = {0, 0}, shortest = 1; /* s */
    int directions[MOTORS], places[MOTORS] = {0, 0}, pulses = 0;
    for (int i = 0; i < MOTORS; ++i) { atraj_limits_init(&limits[i], 20000, 1000, 100); } /* jerk, acceleration, velocity */
    if (atraj_moves_sync(axes, limits, from, to, MOTORS, 0, 0) < 0) { return 1; }
    for (int i = 0; i < MOTORS; ++i) {
        if (atraj_steps_init(&steps[i], &axes[i], -STEP / 2, STEP) < 0) { return 1; }
        directions[i] = atraj_steps_next(&steps[i], &axes[i], &times[i]);
    }
    puts("Pulses for two stepper motors: 40 mm and -12.5 mm in the same time");
    while (directions[X] || directions[Y]) {
        int const i = !directions[Y] || (directions[X] && times[X] <= times[Y]) ? X : Y;
        places[i] += directions[i];
        if (places[i] != directions[i] && times[i] - last[i] < shortest) { shortest = times[i] - last[i]; }
        last[i] = times[i];
        if (++pulses % EVERY == 0) { printf("%.6f s: %.4f %.4f mm\n", times[i], places[X] * STEP, places[Y] * STEP); }
        directions[i] = atraj_steps_next(&steps[i], &axes[i], &times[i]);
    }
    printf("%d and %d steps in %.3f s, up to %.0f steps/s\n", places[X], places[Y], axes[X].t, 1 / shortest);
    return !(places[X] == 3200 && places[Y] == -1000);
}
