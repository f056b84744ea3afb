/* Moves one axis there and back, with a setpoint every millisecond. */

#include "a/trajbell.h"

#define PERIOD ((a_float)0.001) /* s */

static volatile a_float position, velocity; /* m, m/s: the drive reads them */

/* The work of the timer interrupt in its n-th period since the start of the move. */
static void give_setpoint(a_trajbell const *move, unsigned n)
{
    a_float const x = PERIOD * (a_float)n;
    position = a_trajbell_pos(move, x);
    velocity = a_trajbell_vel(move, x);
}

/* Moves within 30 m/s^3, 10 m/s^2 and 5 m/s. Returns false if these limits allow no such move. */
static int travel(a_float from, a_float to)
{
    a_trajbell move;
    a_float const duration = a_trajbell_gen(&move, 30, 10, 5, from, to, 0, 0);
    for (unsigned n = 0; PERIOD * (a_float)n < duration; ++n) { give_setpoint(&move, n); }
    return duration > 0;
}

int main(void)
{
    return travel(0, 10) && travel(10, 0) ? 0 : 1;
}
