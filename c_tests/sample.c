/*
 Compares sweeps through the C ABI with the single functions: every combination of NULL outputs, lengths from 0 on, outputs
 at any alignment that the type allows, times that are not finite or go backwards, a NULL context.
 Prints the line of the first broken promise and fails.
*/
#include "atraj.h"
#include "promise.h"

enum { MOST = 150, QUANTITIES = 4 };

/* A family through untyped contexts. `single` is 0 if the family, or this build, has no function for the quantity. */
struct family {
    int quantities;
    a_size (*sample)(const void *ctx, a_float x0, a_float dt, a_size n, a_float *const *out);
    void (*state)(const void *ctx, a_float x, a_float *const *out);
    a_float (*single[QUANTITIES])(const void *ctx, a_float x);
};

static int same(a_float x, a_float y) { return memcmp(&x, &y, sizeof(x)) == 0 || (isnan(x) && isnan(y)); }

/* One sweep into the outputs whose bit is set in `wanted`. Each output begins `offset` elements into its memory. */
static int sweep(const struct family *family, const void *ctx, a_float x0, a_float dt, a_size n, int wanted, int offset)
{
    static a_float memory[QUANTITIES][MOST + 8];
    a_float *out[QUANTITIES], state[QUANTITIES], *one[QUANTITIES];
    a_size k;
    int i;
    for (i = 0; i < QUANTITIES; ++i)
    {
        memset(memory[i], 0x55, sizeof(memory[i]));
        out[i] = wanted >> i & 1 ? memory[i] + offset : A_NULL;
        one[i] = wanted >> i & 1 ? &state[i] : A_NULL;
    }
    PROMISE(family->sample(ctx, x0, dt, n, out) == n);
    for (k = 0; k < n; ++k)
    {
        volatile a_float step = (a_float)k * dt;
        volatile a_float x = x0 + step;
        memset(state, 0x55, sizeof(state));
        family->state(ctx, x, one);
        for (i = 0; i < family->quantities; ++i)
        {
            if (!out[i]) { continue; }
            PROMISE(same(out[i][k], state[i]));
            PROMISE(!family->single[i] || same(state[i], family->single[i](ctx, x)));
        }
    }
    for (i = 0; i < QUANTITIES; ++i)
    {
        const unsigned char *byte = (const unsigned char *)memory[i];
        a_size written = wanted >> i & 1 && i < family->quantities ? n : 0;
        for (k = 0; k < sizeof(memory[i]); ++k)
        {
            a_size element = k / sizeof(a_float);
            PROMISE((element - (a_size)offset < written) || byte[k] == 0x55);
        }
    }
    return 0;
}

static int sweeps(const struct family *family, const void *ctx, a_float duration)
{
    const a_float times[] = {0, -(a_float)0, duration, duration / 100, -duration / 70, INFINITY, -INFINITY, (a_float)NAN};
    int wanted, i, j;
    for (wanted = 0; wanted < 1 << QUANTITIES; ++wanted)
    {
        for (i = 0; i < (int)A_LEN(times); ++i)
        {
            for (j = 0; j < (int)A_LEN(times); ++j)
            {
                a_size n = (a_size)(i == 0 && j < 5 ? MOST : i + j);
                if (sweep(family, ctx, times[i], times[j], n, wanted, j & 3)) { return 1; }
            }
        }
    }
    return 0;
}

static int null_context(const struct family *family)
{
    a_float y[QUANTITIES] = {1, 1, 1, 1}, *out[QUANTITIES];
    a_float *none[QUANTITIES] = {A_NULL, A_NULL, A_NULL, A_NULL};
    int i;
    for (i = 0; i < QUANTITIES; ++i) { out[i] = &y[i]; }
    PROMISE(family->sample(A_NULL, 0, 1, 1, out) == 0);
    for (i = 0; i < QUANTITIES; ++i) { PROMISE(y[i] == 1); }
    family->state(A_NULL, 0, none);
    family->state(A_NULL, 0, out);
    for (i = 0; i < family->quantities; ++i) { PROMISE(isnan(y[i])); }
    return 0;
}

#define SINGLE(function) \
    static a_float function##_(const void *ctx, a_float x) { return function(ctx, x); }
#define TOGETHER3(name) \
    static a_size name##_sample(const void *ctx, a_float x0, a_float dt, a_size n, a_float *const *out) \
    { \
        return atraj_##name##_sample(ctx, x0, dt, n, out[0], out[1], out[2]); \
    } \
    static void name##_state(const void *ctx, a_float x, a_float *const *out) \
    { \
        atraj_##name##_state(ctx, x, out[0], out[1], out[2]); \
    }
#define TOGETHER4(name) \
    static a_size name##_sample(const void *ctx, a_float x0, a_float dt, a_size n, a_float *const *out) \
    { \
        return atraj_##name##_sample(ctx, x0, dt, n, out[0], out[1], out[2], out[3]); \
    } \
    static void name##_state(const void *ctx, a_float x, a_float *const *out) \
    { \
        atraj_##name##_state(ctx, x, out[0], out[1], out[2], out[3]); \
    }

TOGETHER4(bell)
SINGLE(a_trajbell_pos)
SINGLE(a_trajbell_vel)
SINGLE(a_trajbell_acc)
SINGLE(a_trajbell_jer)

static int bell(void)
{
    static const struct family family = {
        4, bell_sample, bell_state, {a_trajbell_pos_, a_trajbell_vel_, a_trajbell_acc_, a_trajbell_jer_}};
    a_trajbell ctx;
    a_float t = a_trajbell_gen(&ctx, 30, 10, 5, 0, 10, 1, 0);
    PROMISE(t > 0);
    if (null_context(&family) || sweeps(&family, &ctx, t)) { return 1; }
    t = a_trajbell_gen(&ctx, 30, 10, 5, 1, -1, 0, 1);
    PROMISE(t > 0);
    return sweeps(&family, &ctx, t);
}

TOGETHER3(trap)
SINGLE(a_trajtrap_pos)
SINGLE(a_trajtrap_vel)
SINGLE(a_trajtrap_acc)

static int trap(void)
{
    static const struct family family = {
        3, trap_sample, trap_state, {a_trajtrap_pos_, a_trajtrap_vel_, a_trajtrap_acc_, 0}};
    a_trajtrap ctx;
    a_float t = a_trajtrap_gen(&ctx, 5, 4, -3, 0, 50, 0, 1);
    PROMISE(t > 0);
    return null_context(&family) || sweeps(&family, &ctx, t);
}

/* The single functions of this build's levels. */
SINGLE(a_trajpoly3_pos)
SINGLE(a_trajpoly5_pos)
SINGLE(a_trajpoly7_pos)
#if A_TRAJPOLY3 > 2
SINGLE(a_trajpoly3_vel)
SINGLE(a_trajpoly3_acc)
#define SINGLES3 {a_trajpoly3_pos_, a_trajpoly3_vel_, a_trajpoly3_acc_, 0}
#else
#define SINGLES3 {a_trajpoly3_pos_, 0, 0, 0}
#endif
#if A_TRAJPOLY5 > 2
SINGLE(a_trajpoly5_vel)
SINGLE(a_trajpoly5_acc)
#define SINGLES5 {a_trajpoly5_pos_, a_trajpoly5_vel_, a_trajpoly5_acc_, 0}
#else
#define SINGLES5 {a_trajpoly5_pos_, 0, 0, 0}
#endif
#if A_TRAJPOLY7 > 3
SINGLE(a_trajpoly7_vel)
SINGLE(a_trajpoly7_acc)
SINGLE(a_trajpoly7_jer)
#define SINGLES7 {a_trajpoly7_pos_, a_trajpoly7_vel_, a_trajpoly7_acc_, a_trajpoly7_jer_}
#else
#define SINGLES7 {a_trajpoly7_pos_, 0, 0, 0}
#endif

TOGETHER3(poly3)
TOGETHER3(poly5)
TOGETHER4(poly7)

static int polynomials(void)
{
    static const struct family cubic = {3, poly3_sample, poly3_state, SINGLES3};
    static const struct family quintic = {3, poly5_sample, poly5_state, SINGLES5};
    static const struct family septic = {4, poly7_sample, poly7_state, SINGLES7};
    a_trajpoly3 poly3;
    a_trajpoly5 poly5;
    a_trajpoly7 poly7;
    a_trajpoly3_gen(&poly3, 3, 1, 2, -1, 1);
    a_trajpoly5_gen(&poly5, 3, 1, 2, -1, 1, 2, -2);
    a_trajpoly7_gen(&poly7, 3, 1, 2, -1, 1, 2, -2, 3, -3);
    return null_context(&cubic) || sweeps(&cubic, &poly3, 3) || null_context(&quintic) || sweeps(&quintic, &poly5, 3) ||
           null_context(&septic) || sweeps(&septic, &poly7, 3);
}

TOGETHER4(move)
SINGLE(atraj_move_pos)
SINGLE(atraj_move_vel)
SINGLE(atraj_move_acc)
SINGLE(atraj_move_jer)

static int move(void)
{
    static const struct family family = {
        4, move_sample, move_state, {atraj_move_pos_, atraj_move_vel_, atraj_move_acc_, atraj_move_jer_}};
    const atraj_state from = {0, 6, 3}, to = {-1, 1, -2};
    atraj_limits limits;
    atraj_move ctx;
    atraj_limits_init(&limits, 30, 10, 5);
    PROMISE(atraj_move_plan(&ctx, &limits, &from, &to) >= 0);
    return null_context(&family) || sweeps(&family, &ctx, ctx.t);
}

int main(void) { return bell() || trap() || polynomials() || move(); }
