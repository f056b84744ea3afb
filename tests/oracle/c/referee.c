/*
 The least duration of a move, by bisection, and the state of a planned move, by integration of its phases. Both are slow, follow
 the definitions, and share nothing with the library: they exist to judge it.

 `long double` has a significand of 64 bits on x86 (x87), so its roundings are 2048 times finer than those of `double`.
*/
#include <float.h>
#include <math.h>

#if LDBL_MANT_DIG < 64
#error the referee needs a long double finer than double
#endif

typedef long double real;

/* A move in the axis in which it first accelerates upwards. */
struct axis {
    real j, rise, fall, vm; /* limits, each of them may be infinite */
    real h, v0, v1;
    real dv; /* v1 - v0, formed once: a difference of large velocities may be small */
};

/* What a motion takes and covers. */
struct motion {
    real duration, displacement;
};

static real positive(real x) { return x > 0 ? x : 0; }

/* The duration of the fastest change of velocity, with no acceleration at its ends unless the jerk is infinite. */
static real ramp(real j, real a, real change)
{
    if (isinf(j)) { return change / a; }
    if (isinf(a) || change * j < a * a) { return 2 * sqrtl(change / j); }
    return a / j + change / a;
}

/* Up to the velocity `q` above the larger one of both ends, and down. A ramp covers its mean velocity times its duration. */
static struct motion by_way_of(const struct axis *axis, real q)
{
    const real up = q + positive(axis->dv), down = q + positive(-axis->dv);
    const real t0 = ramp(axis->j, axis->rise, up), t1 = ramp(axis->j, axis->fall, down);
    struct motion motion;
    motion.duration = t0 + t1;
    motion.displacement = (axis->v0 * t0 + axis->v1 * t1) + (up * t0 + down * t1) / 2;
    return motion;
}

static int gets_there(const struct axis *axis, real q) { return by_way_of(axis, q).displacement >= axis->h; }

enum { LOWEST = -4000, HIGHEST = 4000, BITS = 56 };

/* The displacement begins below `h` at q = 0 and crosses `h` once. The exponent of q is bisected, then its significand. */
static real crossing(const struct axis *axis)
{
    int low = LOWEST, high = HIGHEST, bit;
    real q, step;
    while (high - low > 1)
    {
        const int middle = (low + high) / 2;
        if (gets_there(axis, ldexpl(1, middle))) { high = middle; }
        else { low = middle; }
    }
    q = step = ldexpl(1, low);
    for (bit = 0; bit < BITS; ++bit)
    {
        step /= 2;
        if (!gets_there(axis, q + step)) { q += step; }
    }
    return q;
}

static void mirror(struct axis *axis)
{
    const real rise = axis->rise;
    axis->rise = axis->fall;
    axis->fall = rise;
    axis->h = -axis->h;
    axis->v0 = -axis->v0;
    axis->v1 = -axis->v1;
    axis->dv = -axis->dv;
}

static real limited(real v, real vm) { return v > vm ? vm : v < -vm ? -vm : v; }

enum { DURATION, SPEED, DIRECT_DURATION, BESIDE_DIRECT };

/*
 The fastest move within the limits. The target is `beside` further than p1.
 Results: its duration, its highest speed, the duration of the direct ramp, and how much further than the direct ramp the target is.
*/
void referee_fastest(const double limits[4], const double ends[4], double beside, double results[4])
{
    struct axis axis;
    struct motion direct, motion;
    real room, q, speed;
    axis.j = limits[0];
    axis.rise = limits[1];
    axis.fall = limits[2];
    axis.vm = limits[3];
    axis.h = ((real)ends[1] - (real)ends[0]) + (real)beside;
    axis.v0 = limited(ends[2], axis.vm);
    axis.v1 = limited(ends[3], axis.vm);
    axis.dv = axis.v1 - axis.v0;

    /* The direct ramp is the one by way of the larger velocity. A nearer target is a farther one in the mirrored axis. */
    direct = by_way_of(&axis, 0);
    results[BESIDE_DIRECT] = (double)(axis.h - direct.displacement);
    results[DIRECT_DURATION] = (double)direct.duration;
    if (axis.h < direct.displacement) { mirror(&axis); }

    room = axis.vm - (axis.dv > 0 ? axis.v1 : axis.v0);
    motion = by_way_of(&axis, 0);
    q = 0;
    if (motion.displacement < axis.h)
    {
        if (isinf(room) || gets_there(&axis, room))
        {
            q = crossing(&axis);
            motion = by_way_of(&axis, q);
        }
        else
        {
            q = room;
            motion = by_way_of(&axis, room);
            motion.duration += (axis.h - motion.displacement) / axis.vm;
        }
    }
    speed = fabsl(axis.dv > 0 ? axis.v1 + q : axis.v0 + q);
    results[DURATION] = (double)motion.duration;
    results[SPEED] = (double)fmaxl(speed, fmaxl(fabsl(axis.v0), fabsl(axis.v1)));
}

enum { POSITION, VELOCITY, ACCELERATION };

/* Lets a phase of constant jerk pass, at most until no time `left` remains. */
static void pass(real state[3], real duration, real jerk, real *left)
{
    const real t = *left < duration ? *left : positive(duration);
    state[POSITION] += ((jerk * t / 6 + state[ACCELERATION] / 2) * t + state[VELOCITY]) * t;
    state[VELOCITY] += (jerk * t / 2 + state[ACCELERATION]) * t;
    state[ACCELERATION] += jerk * t;
    *left -= t;
}

static void give(const real state[3], double out[3])
{
    int i;
    for (i = POSITION; i <= ACCELERATION; ++i) { out[i] = (double)state[i]; }
}

/* The state of an `a_trajbell` at time x: the jerk, which the struct holds, integrated from the start through the phases. */
void referee_bell_state(const double ctx[14], double x, double out[3])
{
    const double tv = ctx[1], ta = ctx[2], td = ctx[3], taj = ctx[4], tdj = ctx[5], p0 = ctx[6], p1 = ctx[7];
    const real jerk = p0 > p1 ? -(real)ctx[11] : (real)ctx[11];
    real state[3], left = x;
    state[POSITION] = p0;
    state[VELOCITY] = ctx[8];
    state[ACCELERATION] = 0;
    pass(state, taj, jerk, &left);
    pass(state, (real)ta - taj - taj, 0, &left);
    pass(state, taj, -jerk, &left);
    if (left > 0) { state[ACCELERATION] = 0; }
    pass(state, tv, 0, &left);
    pass(state, tdj, -jerk, &left);
    pass(state, (real)td - tdj - tdj, 0, &left);
    pass(state, tdj, jerk, &left);
    give(state, out);
}

/* The state of an `a_trajtrap` at time x: its accelerations integrated from the start through the phases. */
void referee_trap_state(const double ctx[12], double x, double out[3])
{
    const double t = ctx[0], ta = ctx[6], td = ctx[7];
    real state[3], left = x;
    state[POSITION] = ctx[1];
    state[VELOCITY] = ctx[3];
    state[ACCELERATION] = ctx[10];
    pass(state, ta, 0, &left);
    if (left > 0) { state[ACCELERATION] = 0; }
    pass(state, (real)td - ta, 0, &left);
    if (left > 0) { state[ACCELERATION] = ctx[11]; }
    pass(state, (real)t - td, 0, &left);
    give(state, out);
}
