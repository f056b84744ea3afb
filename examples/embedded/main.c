/* One axis, there and back, with a set-point every millisecond. */

#include "a/trajbell.h"

#define PERIOD ((a_float)0.001) /* s */

static volatile a_float position, velocity; /* m, m/s: what the drive is told */

/* What the timer interrupt does in its n-th period since the start of the move. */
static void set_point(a_trajbell const *move, unsigned n)
{
    a_float const x = PERIOD * (a_float)n;
    position = a_trajbell_pos(move, x);
    velocity = a_trajbell_vel(move, x);
}

/* Within 30 m/s^3, 10 m/s^2 and 5 m/s; false if these limits allow no such move. */
static int travel(a_float from, a_float to)
{
    a_trajbell move;
    a_float const duration = a_trajbell_gen(&move, 30, 10, 5, from, to, 0, 0);
    for (unsigned n = 0; PERIOD * (a_float)n < duration; ++n) { set_point(&move, n); }
    return duration > 0;
}

int main(void)
{
    return travel(0, 10) && travel(10, 0) ? 0 : 1;
}
