/* Sends one axis to a target, then in mid-motion to another one, then tells it to stop, with a setpoint every millisecond. */

#include "atraj/move.h"

#define PERIOD ((a_float)0.001) /* s */

static volatile a_float position, velocity; /* m, m/s: the drive reads them */

struct axis {
    atraj_limits limits;
    atraj_state now;
    atraj_move move;
    unsigned n; /* periods since the start of the move */
};

/* The work of the timer interrupt. */
static void give_setpoint(struct axis *axis)
{
    a_float const x = PERIOD * (a_float)++axis->n;
    atraj_move_state(&axis->move, x, &axis->now.p, &axis->now.v, &axis->now.a, A_NULL);
    position = axis->now.p;
    velocity = axis->now.v;
}

/* Whether there is a plan. Without one the axis stays on its way. */
static int begin(struct axis *axis, int found)
{
    if (found < 0) { return 0; }
    axis->n = 0;
    return 1;
}

static int go_to(struct axis *axis, a_float target)
{
    atraj_state const to = {target, 0, 0};
    return begin(axis, atraj_move_plan(&axis->move, &axis->limits, &axis->now, &to));
}

static int stop(struct axis *axis)
{
    return begin(axis, atraj_move_stop(&axis->move, &axis->limits, &axis->now));
}

/* The commands of a host, each in a period of its own. Returns false if a command has no plan, or if a setpoint jumps. */
int main(void)
{
    static struct axis axis; /* at rest at 0 */
    int good;
    atraj_limits_init(&axis.limits, 30, 10, 5); /* m/s^3, m/s^2, m/s */
    good = go_to(&axis, 10);
    for (unsigned period = 1; good && period <= 3000; ++period) {
        atraj_state const before = axis.now;
        give_setpoint(&axis);
        /* The limits times the period, and a rounding. */
        good = A_ABS(axis.now.v - before.v) < (a_float)0.01001 && A_ABS(axis.now.a - before.a) < (a_float)0.03003;
        if (period == 700) { good = good && go_to(&axis, -2); }
        if (period == 1800) { good = good && stop(&axis); }
    }
    good = good && velocity == 0 && position > 0;
    return good ? 0 : 1;
}
