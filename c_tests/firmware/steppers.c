/* The pulses of example 22 on bare metal: two stepper motors that arrive together. QEMU's -icount ties the board's timer to the instructions, so this counts how
 * many a pulse takes: the next step of its motor, and the choice of the earlier one of both motors. Prints the count, and the rate of pulses if the processor does
 * 100 million instructions a second and nothing else. Fails if a step is lost. */
#define NS_PER_INSTRUCTION 1024 /* -icount shift=10 */
#include "atraj/steps.h"
#include "semihost.h"
#include "timer.h"

enum { X, Y, MOTORS };

int main(void) {
    static const atraj_state from[MOTORS] = {{0, 0, 0}, {0, 0, 0}}, to[MOTORS] = {{40, 0, 0}, {(a_float)-12.5, 0, 0}}; /* mm */
    static atraj_move axes[MOTORS];
    a_float const step = (a_float)0.0125; /* mm */
    atraj_limits limits[MOTORS];
    atraj_steps steps[MOTORS];
    a_float times[MOTORS];
    int directions[MOTORS], places[MOTORS] = {0, 0};
    uint32_t pulses = 0, most = 0;
    for (int i = 0; i != MOTORS; ++i) { atraj_limits_init(&limits[i], 20000, 1000, 100); } /* jerk, acceleration, velocity */
    if (atraj_moves_sync(axes, limits, from, to, MOTORS, 0, 0) < 0) { semihost_exit(1); }
    for (int i = 0; i != MOTORS; ++i) {
        if (atraj_steps_init(&steps[i], &axes[i], -step / 2, step) < 0) { semihost_exit(1); }
        directions[i] = atraj_steps_next(&steps[i], &axes[i], &times[i]);
    }
    start_timer();
    uint32_t const start = TIMER[VALUE];
    for (uint32_t last = start; directions[X] || directions[Y]; ++pulses) {
        int const i = !directions[Y] || (directions[X] && times[X] <= times[Y]) ? X : Y;
        places[i] += directions[i];
        directions[i] = atraj_steps_next(&steps[i], &axes[i], &times[i]);
        uint32_t const now = TIMER[VALUE];
        if (most < last - now) { most = last - now; }
        last = now;
    }
    uint32_t const each = instructions(start - TIMER[VALUE]) / pulses;
    semihost_count(pulses, " pulses, ");
    semihost_count(each, " instructions each, ");
    semihost_count(instructions(most), " at most; ");
    semihost_count(100000000 / each, " pulses/s of 100 million instructions/s\n");
    semihost_exit(!(places[X] == 3200 && places[Y] == -1000));
}
