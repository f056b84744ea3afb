/* Sends one axis to a target, then in mid-motion to another one, then stops it. The main loop plans while a timer interrupt gives a
 * setpoint every millisecond. */

#include "atraj/axis.h"

#define PERIOD ((a_float)0.001) /* s */
enum { LEAD = 4 };              /* ticks: as long as a plan takes, and one more */

static volatile a_float position, velocity; /* m, m/s: the drive reads them */
static atraj_axis axis;

/* The work of the timer interrupt. */
static void give_setpoint(void)
{
    atraj_state now;
    atraj_axis_tick(&axis, &now);
    position = now.p;
    velocity = now.v;
}

/* The work of the main loop: the commands of a host. Without a plan the axis stays on its way. */
static int obey(unsigned period, atraj_limits const *limits)
{
    atraj_state const there = {10, 0, 0}, back = {-2, 0, 0};
    switch (period) {
    case 1: return atraj_axis_go(&axis, limits, &there, LEAD) >= 0;
    case 700: return atraj_axis_go(&axis, limits, &back, LEAD) >= 0;
    case 1800: return atraj_axis_stop(&axis, limits, LEAD) >= 0;
    default: return 1;
    }
}

/* Here the main loop calls the interrupt. Returns false if a command has no plan, or if the velocity jumps. */
int main(void)
{
    atraj_state const start = {0, 0, 0};
    atraj_limits limits;
    int good;
    atraj_limits_init(&limits, 30, 10, 5); /* m/s^3, m/s^2, m/s */
    good = atraj_axis_init(&axis, PERIOD, &start) == 0;
    for (unsigned period = 1; good && period <= 3000; ++period) {
        a_float const before = velocity;
        good = obey(period, &limits);
        give_setpoint();
        good = good && A_ABS(velocity - before) < (a_float)0.01001; /* the limit times the period, and a rounding */
    }
    good = good && velocity == 0 && position > 0;
    return good ? 0 : 1;
}
