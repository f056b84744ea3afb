/*
 Tests the contract of every function of atraj/shaper.h. Each pointer is once NULL, each number once wrong; a refusal leaves the shaper untouched.
 Then weights and delays, and shaped motions. `tests/is_a_load_left_at_rest.rs` judges what is left of a vibration.
 Prints the line of the first broken promise and fails.
*/
#include "atraj/shaper.h"
#include "promise.h"

static const atraj_limits limits = {5, -4, 10, -9, 30, -20};
static const atraj_state start = {1, 0, 0}, target = {3, 0, 0};
static atraj_shaper shaper, before;
enum { KINDS = ATRAJ_SHAPER_EI2 + 1 };

static int untouched(void) { return memcmp(&shaper, &before, sizeof(shaper)) == 0; }

static int same(atraj_state x, atraj_state y) { return x.p == y.p && x.v == y.v && x.a == y.a; }

static int is_nan(atraj_state x) { return x.p != x.p && x.v != x.v && x.a != x.a; }

static int near(a_float x, double y) { return fabs((double)x - y) < 1e-6; }

typedef int frequency_function(atraj_shaper *ctx, int kind, a_float frequency, a_float damping);

/* What init and add refuse. */
static int refused_frequencies(frequency_function *f)
{
    const a_float no_frequencies[] = {0, -(a_float)0, -1, endless, -endless, none}, no_dampings[] = {-A_FLOAT_MIN, 1, 2, endless, -endless, none};
    int i;
    for (i = 0; i < (int)A_LEN(no_frequencies); ++i) { PROMISE(f(&shaper, ATRAJ_SHAPER_ZV, no_frequencies[i], 0) == ATRAJ_ERR_DURATION); }
    for (i = 0; i < (int)A_LEN(no_dampings); ++i) { PROMISE(f(&shaper, ATRAJ_SHAPER_ZV, 5, no_dampings[i]) == ATRAJ_ERR_LIMITS); }
    PROMISE(f(&shaper, -1, 5, 0) == ATRAJ_ERR_LIMITS && f(&shaper, KINDS, 5, 0) == ATRAJ_ERR_LIMITS);
    PROMISE(f(A_NULL, ATRAJ_SHAPER_ZV, 5, 0) == ATRAJ_ERR_NULL);
    PROMISE(untouched());
    return 0;
}

static int refused(void)
{
    const a_float no_times[] = {-A_FLOAT_MIN, -1, endless, -endless, none};
    atraj_state now;
    atraj_move move;
    a_trajbell bell;
    int i;
    PROMISE(atraj_move_plan(&move, &limits, &start, &target) == 0);
    PROMISE(a_trajbell_gen(&bell, 30, 10, 5, 1, 3, 0, 0) > 0);
    memset(&before, 0x55, sizeof(before));
    shaper = before;
    PROMISE(!refused_frequencies(atraj_shaper_init));
    for (i = 0; i < (int)A_LEN(no_times); ++i) { PROMISE(atraj_shaper_smooth(&shaper, no_times[i]) == ATRAJ_ERR_DURATION); }
    PROMISE(atraj_shaper_smooth(A_NULL, 1) == ATRAJ_ERR_NULL && untouched());
    PROMISE(atraj_shaper_init(&shaper, ATRAJ_SHAPER_EI2, 5, 0) == 0);
    before = shaper;
    PROMISE(!refused_frequencies(atraj_shaper_add));
    PROMISE(atraj_shaper_add(&shaper, ATRAJ_SHAPER_EI2, 7, 0) == 0 && shaper.count == 16);
    before = shaper;
    PROMISE(atraj_shaper_add(&shaper, ATRAJ_SHAPER_ZV, 7, 0) == ATRAJ_ERR_LIMITS && untouched());

    atraj_shaper_state(&shaper, &move, 0, A_NULL);
    atraj_shaper_bell_state(&shaper, &bell, 0, A_NULL);
    now = start;
    atraj_shaper_state(A_NULL, &move, 0, &now);
    PROMISE(is_nan(now));
    now = start;
    atraj_shaper_state(&shaper, A_NULL, 0, &now);
    PROMISE(is_nan(now));
    now = start;
    atraj_shaper_bell_state(A_NULL, &bell, 0, &now);
    PROMISE(is_nan(now));
    now = start;
    atraj_shaper_bell_state(&shaper, A_NULL, 0, &now);
    PROMISE(is_nan(now));
    return 0;
}

/* Count, the first two weights and the duration without damping, for 5 Hz; MZV and EI2 as in the papers. */
static int impulses(void)
{
    static const double wanted[KINDS][4] = {
        {2, 0.5, 0.5, 0.1}, {3, 0.25, 0.5, 0.2}, {3, 0.2928932, 0.4142136, 0.15}, {3, 0.2625, 0.475, 0.2}, {4, 0.1597964, 0.3402036, 0.3}};
    int kind;
    for (kind = 0; kind < KINDS; ++kind)
    {
        double sum = 0;
        unsigned i;
        PROMISE(atraj_shaper_init(&shaper, kind, 5, 0) == 0 && shaper.count == (unsigned)wanted[kind][0]);
        PROMISE(near(shaper.weights[0], wanted[kind][1]) && near(shaper.weights[1], wanted[kind][2]) && near(shaper.t, wanted[kind][3]));
        PROMISE(shaper.delays[0] == 0 && near(shaper.delays[shaper.count - 1], wanted[kind][3]) && shaper.smoothing == 0);
        PROMISE(atraj_shaper_init(&shaper, kind, 5, A_FLOAT_C(0.2)) == 0);
        for (i = 0; i != shaper.count; ++i) { sum += (double)shaper.weights[i]; }
        PROMISE(fabs(sum - 1) < 1e-6);
    }
    /* K = exp(-0.1 pi/sqrt(1 - 0.01)) */
    PROMISE(atraj_shaper_init(&shaper, ATRAJ_SHAPER_ZV, 5, A_FLOAT_C(0.1)) == 0);
    PROMISE(near(shaper.weights[0], 0.5782862) && near(shaper.weights[1], 0.4217138) && near(shaper.t, 0.1005038));
    return 0;
}

static int shaped(void)
{
    atraj_move move;
    a_trajbell bell;
    atraj_state now, one, other;
    PROMISE(atraj_move_plan(&move, &limits, &start, &target) == 0);
    PROMISE(a_trajbell_gen(&bell, 30, 10, 5, 1, 3, 0, 0) > 0);
    PROMISE(atraj_shaper_smooth(&shaper, 0) == 0 && shaper.t == 0 && shaper.count == 1);
    atraj_shaper_state(&shaper, &move, A_FLOAT_C(0.3), &now);
    atraj_move_state(&move, A_FLOAT_C(0.3), &one.p, &one.v, &one.a, A_NULL);
    PROMISE(same(now, one));
    PROMISE(atraj_shaper_init(&shaper, ATRAJ_SHAPER_ZV, 5, 0) == 0);
    atraj_shaper_state(&shaper, &move, A_FLOAT_C(0.3), &now);
    atraj_move_state(&move, A_FLOAT_C(0.3) - shaper.t, &other.p, &other.v, &other.a, A_NULL);
    PROMISE(near(now.p, (double)(one.p + other.p) / 2) && near(now.v, (double)(one.v + other.v) / 2));
    PROMISE(atraj_shaper_smooth(&shaper, A_FLOAT_C(0.2)) == 0 && atraj_shaper_add(&shaper, ATRAJ_SHAPER_ZVD, 3, A_FLOAT_C(0.1)) == 0);
    PROMISE(near(shaper.t, 0.2 + 1 / (3 * sqrt(0.99))) && shaper.count == 3);
    atraj_shaper_state(&shaper, &move, 0, &now);
    PROMISE(same(now, start));
    atraj_shaper_state(&shaper, &move, -1, &now);
    PROMISE(same(now, start));
    atraj_shaper_state(&shaper, &move, move.t + shaper.t + 1, &now);
    PROMISE(same(now, target));
    atraj_shaper_state(&shaper, &move, none, &now);
    PROMISE(same(now, target));
    atraj_shaper_bell_state(&shaper, &bell, 0, &now);
    PROMISE(same(now, start));
    atraj_shaper_bell_state(&shaper, &bell, bell.t + shaper.t, &now);
    PROMISE(near(now.p, (double)target.p) && near(now.v, 0) && fabs((double)now.a) < 1e-4); /* the sum of the times may be rounded down */
    atraj_shaper_bell_state(&shaper, &bell, bell.t + shaper.t + 1, &now);
    PROMISE(same(now, target));
    memset(&shaper, 0xff, sizeof(shaper)); /* whatever a struct holds, the call ends */
    atraj_shaper_state(&shaper, &move, A_FLOAT_C(0.3), &now);
    memset(&shaper, 0x3f, sizeof(shaper));
    atraj_shaper_state(&shaper, &move, A_FLOAT_C(0.3), &now);
    return 0;
}

int main(void) { return refused() || impulses() || shaped(); }
