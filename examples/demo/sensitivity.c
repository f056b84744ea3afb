/*
 What each kind of shaper leaves of a vibration, if the load has another frequency than the shaper: the swing of a simulated load after a shaped move, as
 a part of its swing after the same move without a shaper. The shapers are for 1 Hz, and the load has no damping. `make demo` draws it.
*/
#include "atraj/shaper.h"
#include <math.h>
#include <stdio.h>

#define CYCLE 0.0005 /* s */
enum { KINDS = 5 };

static char const *const names[KINDS] = {"ZV", "MZV", "ZVD", "EI", "EI2"};
static int const kinds[KINDS] = {ATRAJ_SHAPER_ZV, ATRAJ_SHAPER_MZV, ATRAJ_SHAPER_ZVD, ATRAJ_SHAPER_EI, ATRAJ_SHAPER_EI2};

/* How much a load of this frequency, Hz, swings after the shaped move. Its position and its velocity, divided by `w`, turn by `w` times the time. */
static double swing(atraj_shaper const *shaper, atraj_move const *move, double frequency)
{
    double const w = 2 * 3.141592653589793 * frequency, c = cos(w * CYCLE), s = sin(w * CYCLE);
    double p = 0, q = 0;
    for (int tick = 0; tick * CYCLE < move->t + shaper->t; ++tick) {
        atraj_state now;
        atraj_shaper_state(shaper, move, (tick + 0.5) * CYCLE, &now);
        double const rest = -now.a / (w * w), turned = c * (p - rest) + s * q;
        q = c * q - s * (p - rest);
        p = turned + rest;
    }
    return hypot(p, q);
}

int main(void)
{
    atraj_state const from = {0, 0, 0}, to = {0.1, 0, 0};
    atraj_limits limits;
    atraj_move move;
    atraj_shaper none, shapers[KINDS];
    atraj_limits_init(&limits, 1e4, 100, 10);
    if (atraj_move_plan(&move, &limits, &from, &to) < 0 || atraj_shaper_smooth(&none, 0) < 0) { return 1; }
    for (int i = 0; i < KINDS; ++i) {
        if (atraj_shaper_init(&shapers[i], kinds[i], 1, 0) < 0) { return 1; }
    }
    puts("Vibration that a shaper leaves: of a simulated load, with shapers for 1 Hz");
    puts("the tolerance of EI is at 5 %");
    for (int step = 50; step <= 150; ++step) {
        double const frequency = step / 100.0, alone = swing(&none, &move, frequency);
        printf("%.2f Hz:", frequency);
        for (int i = 0; i < KINDS; ++i) { printf("%s %s %.2f %%", i ? "," : "", names[i], 100 * swing(&shapers[i], &move, frequency) / alone); }
        puts("");
    }
    return 0;
}
