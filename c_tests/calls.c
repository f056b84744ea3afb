/*
 Calls every function of atraj.h but those of atraj/axis.h, which axis.c calls. Each argument shows in an answer, and each output is looked at.
 `tests/miri` asks in one table what each function refuses, and the tests in Rust ask whether motions are right.
 Prints the line of the first broken promise and fails.
*/
#include "atraj.h"
#include "promise.h"

static int near(a_float x, a_float y) { return A_ABS(x - y) <= 64 * A_FLOAT_EPSILON * (1 + A_ABS(y)); }
static int same(a_float x, a_float y) { return memcmp(&x, &y, sizeof(x)) == 0; }
static int is(atraj_state x, a_float p, a_float v, a_float a) { return x.p == p && x.v == v && x.a == a; }

/* --- sweeps */

enum { SAMPLES = 5, QUANTITIES = 4 };

/* A family through untyped contexts. `single` is 0 if the family, or a build, has no function for the quantity. */
struct family {
    int quantities;
    a_size (*sample)(const void *ctx, a_float x0, a_float dt, a_size n, a_float *const *out);
    void (*state)(const void *ctx, a_float x, a_float *const *out);
    a_float (*single[QUANTITIES])(const void *ctx, a_float x);
};

/* Each output has its own quantity, whichever of the others are NULL, and nothing is written behind it. */
static int swept(const struct family *family, const void *ctx) {
    const a_float x0 = A_FLOAT_C(0.125), dt = A_FLOAT_C(0.25);
    int wanted, i, k;
    for (wanted = 0; wanted < 1 << QUANTITIES; ++wanted) {
        a_float y[QUANTITIES][SAMPLES + 1], state[QUANTITIES], *out[QUANTITIES], *one[QUANTITIES];
        for (i = 0; i < QUANTITIES; ++i) {
            y[i][SAMPLES] = 77;
            out[i] = wanted >> i & 1 ? y[i] : A_NULL;
            one[i] = wanted >> i & 1 ? &state[i] : A_NULL;
        }
        PROMISE(family->sample(ctx, x0, dt, SAMPLES, out) == SAMPLES);
        for (k = 0; k < SAMPLES; ++k) {
            const a_float x = x0 + (a_float)k * dt;
            family->state(ctx, x, one);
            for (i = 0; i < family->quantities; ++i) {
                if (!out[i]) { continue; }
                PROMISE(same(y[i][k], state[i]) && y[i][SAMPLES] == 77);
                PROMISE(!family->single[i] || same(state[i], family->single[i](ctx, x)));
            }
        }
    }
    return 0;
}

#define SINGLE(function) \
    static a_float function##_(const void *ctx, a_float x) { return function(ctx, x); }
#define TOGETHER(name, outputs, state_outputs) \
    static a_size name##_sample(const void *ctx, a_float x0, a_float dt, a_size n, a_float *const *out) { return atraj_##name##_sample outputs; } \
    static void name##_state(const void *ctx, a_float x, a_float *const *out) { atraj_##name##_state state_outputs; }
#define TOGETHER3(name) TOGETHER(name, (ctx, x0, dt, n, out[0], out[1], out[2]), (ctx, x, out[0], out[1], out[2]))
#define TOGETHER4(name) TOGETHER(name, (ctx, x0, dt, n, out[0], out[1], out[2], out[3]), (ctx, x, out[0], out[1], out[2], out[3]))
TOGETHER4(bell) TOGETHER4(poly7) TOGETHER4(move) TOGETHER3(trap) TOGETHER3(poly3) TOGETHER3(poly5)
SINGLE(a_trajbell_pos) SINGLE(a_trajbell_vel) SINGLE(a_trajbell_acc) SINGLE(a_trajbell_jer)
SINGLE(a_trajtrap_pos) SINGLE(a_trajtrap_vel) SINGLE(a_trajtrap_acc)
SINGLE(a_trajpoly3_pos) SINGLE(a_trajpoly5_pos) SINGLE(a_trajpoly7_pos)
SINGLE(atraj_move_pos) SINGLE(atraj_move_vel) SINGLE(atraj_move_acc) SINGLE(atraj_move_jer)
static const struct family bells = {4, bell_sample, bell_state, {a_trajbell_pos_, a_trajbell_vel_, a_trajbell_acc_, a_trajbell_jer_}};
static const struct family traps = {3, trap_sample, trap_state, {a_trajtrap_pos_, a_trajtrap_vel_, a_trajtrap_acc_, 0}};
static const struct family cubics = {3, poly3_sample, poly3_state, {a_trajpoly3_pos_, 0, 0, 0}};
static const struct family quintics = {3, poly5_sample, poly5_state, {a_trajpoly5_pos_, 0, 0, 0}};
static const struct family septics = {4, poly7_sample, poly7_state, {a_trajpoly7_pos_, 0, 0, 0}};
static const struct family moves = {4, move_sample, move_state, {atraj_move_pos_, atraj_move_vel_, atraj_move_acc_, atraj_move_jer_}};

/* --- profiles */

static int bell(void) {
    a_float low[3], high[3], t;
    a_trajbell ctx;
    PROMISE(isnan(atraj_bell_gen(&ctx, 30, none, 5, 0, 10, 1, 0)));
    t = atraj_bell_gen(&ctx, 30, 10, 5, 0, A_FLOAT_C(0.125), 2, 0); /* too near to stop */
    PROMISE(t > 0 && t == ctx.t && a_trajbell_pos(&ctx, t) == A_FLOAT_C(0.125) && a_trajbell_vel(&ctx, t) == 0);
    PROMISE(a_trajbell_pos(&ctx, 0) == 0 && a_trajbell_vel(&ctx, 0) == 2 && atraj_bell_check(&ctx, 30, 10, 5) == ATRAJ_OVERSHOOTS);
    PROMISE(atraj_bell_gen(&ctx, 30, 10, 5, 0, 10, 0, 0) > 0 && atraj_bell_check(&ctx, 30, 10, 5) == 0 && !swept(&bells, &ctx));
    PROMISE(atraj_bell_check(&ctx, 29, 10, 5) == 1 && atraj_bell_check(&ctx, 30, 9, 5) == 2 && atraj_bell_check(&ctx, 30, 10, 4) == 4);
    atraj_bell_extremes(&ctx, low, high);
    PROMISE(low[0] == 0 && low[1] == 0 && low[2] == -10 && high[0] == 10 && high[1] == 5 && high[2] == 10);
    PROMISE(atraj_bell_gen(&ctx, 30, 10, 5, -3, 10, 0, 1) > 0 && a_trajbell_pos(&ctx, 0) == -3 && a_trajbell_vel(&ctx, ctx.t) == 1);
    return 0;
}

static int trap(void) {
    a_float low[3], high[3], t;
    a_trajtrap ctx;
    PROMISE(isnan(atraj_trap_gen(&ctx, none, 4, -2, 0, 1, 4, 0)));
    t = atraj_trap_gen(&ctx, 5, 4, -2, 0, 1, 4, 0);
    PROMISE(t > 0 && t == ctx.t && a_trajtrap_pos(&ctx, t) == 1 && a_trajtrap_vel(&ctx, t) == 0 && a_trajtrap_vel(&ctx, 0) == 4);
    PROMISE(atraj_trap_check(&ctx, 5, 4, -2) == ATRAJ_OVERSHOOTS);
    atraj_trap_extremes(&ctx, low, high);
    PROMISE(low[0] == 0 && high[0] > 1 && low[1] < 0 && high[1] == 4 && low[2] == -2 && high[2] == 4);
    PROMISE(atraj_trap_gen(&ctx, 5, 4, -2, 1, 50, 0, 3) > 0 && a_trajtrap_pos(&ctx, 0) == 1 && a_trajtrap_vel(&ctx, ctx.t) == 3);
    PROMISE(atraj_trap_check(&ctx, 5, 4, -2) == 0);
    PROMISE(atraj_trap_check(&ctx, 5, 3, -2) == 2 && atraj_trap_check(&ctx, 5, 4, -1) == 2 && atraj_trap_check(&ctx, 4, 4, -2) == 4);
    return swept(&traps, &ctx);
}

static int polynomials(void) {
    a_float low[3], high[3], p, v, a, j;
    a_trajpoly3 cubic;
    a_trajpoly5 quintic;
    a_trajpoly7 septic;
    a_trajpoly3_gen(&cubic, 2, 0, 4, 0, 0);
    a_trajpoly5_gen(&quintic, 2, 0, 4, 0, 0, 0, 0);
    a_trajpoly7_gen(&septic, 2, 0, 4, 0, 0, 0, 0, 0, 0);
    PROMISE(!swept(&cubics, &cubic) && !swept(&quintics, &quintic) && !swept(&septics, &septic));
    /* A quarter of the duration: 3u^2 - 2u^3, 10u^3 - 15u^4 + 6u^5, 35u^4 - 84u^5 + 70u^6 - 20u^7 and their derivatives. */
    atraj_poly3_state(&cubic, A_FLOAT_C(0.5), &p, &v, &a);
    PROMISE(near(p, A_FLOAT_C(0.625)) && near(v, A_FLOAT_C(2.25)) && near(a, 3));
    atraj_poly5_state(&quintic, A_FLOAT_C(0.5), &p, &v, &a);
    PROMISE(near(p, A_FLOAT_C(0.4140625)) && near(v, A_FLOAT_C(2.109375)) && near(a, A_FLOAT_C(5.625)));
    atraj_poly7_state(&septic, A_FLOAT_C(0.5), &p, &v, &a, &j);
    PROMISE(near(p, A_FLOAT_C(0.2822265625)) && near(v, A_FLOAT_C(1.845703125)) && near(a, A_FLOAT_C(7.3828125)) && near(j, A_FLOAT_C(4.921875)));
    atraj_poly3_extremes(&cubic, 2, low, high);
    PROMISE(low[0] == 0 && low[1] == 0 && low[2] == -6 && high[0] == 4 && high[1] == 3 && high[2] == 6);
    atraj_poly5_extremes(&quintic, 2, low, high);
    PROMISE(low[0] == 0 && high[0] == 4 && high[1] == A_FLOAT_C(3.75) && near(low[2], -high[2]));
    atraj_poly7_extremes(&septic, 2, low, high);
    PROMISE(near(low[0], 0) && near(high[0], 4) && near(high[1], A_FLOAT_C(4.375)) && near(low[2], -high[2]));
    return 0;
}

/* --- one axis */

static const atraj_limits limits = {5, -4, 10, -9, 30, -20};

static int move(void) {
    const atraj_state rest = {0, 0, 0}, far = {100, 0, 0}, back = {-100, 0, 0}, from = {1, 2, 3}, to = {10, -1, 2}, part = {2, 1, 0};
    atraj_limits init, tight = limits;
    atraj_state low, high;
    atraj_move ctx, plain;
    a_float t;
    PROMISE(strcmp(atraj_message(ATRAJ_ERR_LINE), "the states do not lie on the straight line from their start to their end") == 0);
    atraj_limits_init(&init, -30, 10, -5);
    PROMISE(init.vmax == 5 && init.vmin == -5 && init.amax == 10 && init.amin == -10 && init.jmax == 30 && init.jmin == -30);

    /* Each limit is reached. */
    PROMISE(atraj_move_plan(&ctx, &limits, &rest, &far) == 0 && ctx.phases <= 15 && ctx.phase[ctx.phases].t == ctx.t);
    atraj_move_extremes(&ctx, &low, &high);
    PROMISE(near(high.p, 100) && near(high.v, 5) && near(high.a, 10) && near(low.a, -9) && near(low.p, 0));
    PROMISE(atraj_move_jer(&ctx, ctx.t / 1000) == 30 && near(atraj_move_time_at(&ctx, 0), 0) && isnan(atraj_move_time_at(&ctx, 101)));
    PROMISE(atraj_move_plan(&ctx, &limits, &rest, &back) == 0 && atraj_move_jer(&ctx, ctx.t / 1000) == -20);
    atraj_move_extremes(&ctx, &low, &high);
    PROMISE(near(low.v, -4) && near(low.a, -9) && high.a > 9);

    PROMISE(atraj_move_plan(&ctx, &limits, &from, &to) >= 0 && atraj_move_check(&ctx, &limits) == ATRAJ_OVERSHOOTS);
    PROMISE(is(from, atraj_move_pos(&ctx, -1), atraj_move_vel(&ctx, -1), atraj_move_acc(&ctx, -1)));
    PROMISE(is(to, atraj_move_pos(&ctx, ctx.t), atraj_move_vel(&ctx, ctx.t), atraj_move_acc(&ctx, ctx.t)) && !swept(&moves, &ctx));
    t = atraj_move_time_at(&ctx, 5);
    PROMISE(t > 0 && near(atraj_move_pos(&ctx, t), 5));
    tight.jmax = 29;
    PROMISE(atraj_move_check(&ctx, &tight) == (ATRAJ_OVERSHOOTS | ATRAJ_EXCEEDS_JERK));
    plain = ctx;
    PROMISE(atraj_move_within(&ctx, &limits, &from, &to, -99, 99) >= 0 && ctx.t == plain.t);
    PROMISE(atraj_move_within(&ctx, &limits, &from, &to, -99, 10) == ATRAJ_ERR_POSITION && atraj_move_within(&ctx, &limits, &from, &to, 2, 99) == ATRAJ_ERR_POSITION);
    PROMISE(ctx.t == plain.t);

    PROMISE(atraj_move_reach(&ctx, &limits, &from, -3, 2) >= 0 && atraj_move_pos(&ctx, 0) == 1);
    PROMISE(atraj_move_vel(&ctx, ctx.t) == -3 && atraj_move_acc(&ctx, ctx.t) == 2);
    PROMISE(atraj_move_stop(&ctx, &limits, &from) == 0 && atraj_move_vel(&ctx, 0) == 2 && atraj_move_vel(&ctx, ctx.t) == 0);
    PROMISE(atraj_move_meet(&ctx, &limits, &from, &part) >= 0 && near(atraj_move_pos(&ctx, ctx.t), 2 + ctx.t));
    PROMISE(atraj_move_track(&ctx, &limits, &part, &part, 1, A_FLOAT_C(0.5)) >= 0 && ctx.t == A_FLOAT_C(0.5));
    PROMISE(near(atraj_move_pos(&ctx, ctx.t), A_FLOAT_C(2.5) + 1 / (a_float)48) && near(atraj_move_acc(&ctx, ctx.t), A_FLOAT_C(0.5)) && atraj_move_pos(&ctx, 0) == 2);
    return 0;
}

static int steps(void) {
    const atraj_state from = {1, 4, 0}, to = {0, 0, 0};
    const a_float step = A_FLOAT_C(0.125), half = A_FLOAT_C(0.0625);
    a_float time = -1, last = 0;
    int direction, sum = 0;
    atraj_steps ctx;
    atraj_move move;
    PROMISE(atraj_move_plan(&move, &limits, &from, &to) == ATRAJ_OVERSHOOTS);
    PROMISE(atraj_steps_init(&ctx, &move, 0, step) == 0 && ctx.count == 8);
    PROMISE(atraj_steps_init(&ctx, &move, half, step) == 0 && ctx.count == 7);
    while ((direction = atraj_steps_next(&ctx, &move, &time)) != 0) {
        const a_float line = half + step * (a_float)(direction > 0 ? ctx.count : ctx.count + 1);
        PROMISE((direction == 1 || direction == -1) && time >= last && time <= move.t);
        PROMISE(fabs((double)(atraj_move_pos(&move, time) - line)) < 1e-5);
        last = time, sum += direction;
    }
    PROMISE(sum == -8 && ctx.count == -1);
    /* A move begins where the other one was given up, not where the motor is. */
    PROMISE(atraj_steps_follow(&ctx, &move) == 0 && ctx.count == -1 && atraj_steps_next(&ctx, &move, &time) == 1);
    return 0;
}

static int shaper(void) {
    static const struct {
        int kind;
        unsigned count;
        double t;
    } kinds[] = {{ATRAJ_SHAPER_ZV, 2, 0.1}, {ATRAJ_SHAPER_ZVD, 3, 0.2}, {ATRAJ_SHAPER_MZV, 3, 0.15}, {ATRAJ_SHAPER_EI, 3, 0.2}, {ATRAJ_SHAPER_EI2, 4, 0.3}};
    const atraj_state from = {1, 0, 0}, to = {3, 0, 0};
    atraj_state now, one, other;
    atraj_shaper ctx;
    atraj_move move;
    a_trajbell bell;
    int i;
    for (i = 0; i < (int)A_LEN(kinds); ++i) {
        PROMISE(atraj_shaper_init(&ctx, kinds[i].kind, 5, 0) == 0 && ctx.count == kinds[i].count && fabs((double)ctx.t - kinds[i].t) < 1e-6);
    }
    PROMISE(atraj_shaper_init(&ctx, -1, 5, 0) == ATRAJ_ERR_LIMITS && atraj_shaper_init(&ctx, ATRAJ_SHAPER_EI2 + 1, 5, 0) == ATRAJ_ERR_LIMITS);
    PROMISE(atraj_move_plan(&move, &limits, &from, &to) == 0 && a_trajbell_gen(&bell, 30, 10, 5, 1, 3, 0, 0) > 0);
    PROMISE(atraj_shaper_init(&ctx, ATRAJ_SHAPER_ZV, 5, 0) == 0);
    atraj_shaper_state(&ctx, &move, A_FLOAT_C(0.3), &now);
    atraj_move_state(&move, A_FLOAT_C(0.3), &one.p, &one.v, &one.a, A_NULL);
    atraj_move_state(&move, A_FLOAT_C(0.3) - ctx.t, &other.p, &other.v, &other.a, A_NULL);
    PROMISE(near(now.p, (one.p + other.p) / 2) && near(now.v, (one.v + other.v) / 2) && near(now.a, (one.a + other.a) / 2));
    atraj_shaper_bell_state(&ctx, &bell, A_FLOAT_C(0.3), &now);
    PROMISE(near(now.p, (a_trajbell_pos(&bell, A_FLOAT_C(0.3)) + a_trajbell_pos(&bell, A_FLOAT_C(0.3) - ctx.t)) / 2));
    PROMISE(atraj_shaper_smooth(&ctx, A_FLOAT_C(0.2)) == 0 && atraj_shaper_add(&ctx, ATRAJ_SHAPER_ZVD, 3, A_FLOAT_C(0.1)) == 0);
    PROMISE(fabs((double)ctx.t - 0.2 - 1 / (3 * sqrt(0.99))) < 1e-6 && ctx.count == 3);
    atraj_shaper_state(&ctx, &move, move.t + ctx.t + 1, &now);
    PROMISE(is(now, 3, 0, 0));
    return 0;
}

/* A ramp of the velocity through a shaper and to a motor: half a period at 5 Hz is 100 ticks. */
static int streams(void) {
    enum { SIZE = 3 * 103 };
    const a_float period = A_FLOAT_C(0.001), step = A_FLOAT_C(0.125);
    const atraj_state rest = {1, 0, 0};
    atraj_state now = rest, shaped;
    a_float line[SIZE + 1], time;
    atraj_shaper shaper, slow;
    atraj_shaper_stream stream;
    atraj_step_stream motor;
    int k, direction, sum = 0;
    line[SIZE] = 77;
    PROMISE(atraj_shaper_init(&shaper, ATRAJ_SHAPER_ZV, 5, 0) == 0 && atraj_shaper_size(&shaper, period) == SIZE && atraj_shaper_size(&shaper, 0) == 0);
    PROMISE(atraj_shaper_stream_init(&stream, &shaper, period, &rest, line, SIZE - 1) == ATRAJ_ERR_NULL);
    PROMISE(atraj_shaper_stream_init(&stream, &shaper, 0, &rest, line, SIZE) == ATRAJ_ERR_DURATION);
    /* The ticks of a smoothing below 0 wrapped to no room at all, and were counted for ever. */
    slow = shaper, slow.smoothing = -102 * period;
    PROMISE(atraj_shaper_size(&slow, period) == 0 && atraj_shaper_stream_init(&stream, &slow, period, &rest, line, SIZE) == ATRAJ_ERR_DURATION);
    PROMISE(atraj_shaper_stream_init(&stream, &shaper, period, &rest, line, SIZE) == 0);
    PROMISE(atraj_step_stream_init(&motor, step, period, &rest) == 0 && atraj_step_stream_count(&motor) == 8);
    for (k = 1; k <= 1000; ++k) {
        now.p = 1 + (a_float)k / 1000, now.v = 1;
        PROMISE(atraj_shaper_stream_tick(&stream, &now, line, SIZE, &shaped) == 0 && line[SIZE] == 77);
        PROMISE(k < 100 ? near(shaped.v, A_FLOAT_C(0.5)) : k < 103 || near(shaped.p, now.p - A_FLOAT_C(0.05)));
        PROMISE(atraj_step_stream_tick(&motor, &shaped) == 0);
        while ((direction = atraj_step_stream_next(&motor, &time)) != 0) {
            PROMISE(direction == 1 && time >= 0 && time <= period);
            ++sum;
        }
    }
    PROMISE(sum == 8 && atraj_step_stream_count(&motor) == 16);
    PROMISE(atraj_shaper_stream_change(&stream, &shaper, line, SIZE) == ATRAJ_ERR_MOVING && atraj_shaper_stream_advance(&stream, 1) == ATRAJ_ERR_MOVING);
    now.v = 0;
    for (k = 0; k < 200; ++k) { PROMISE(atraj_shaper_stream_tick(&stream, &now, line, SIZE, &shaped) == 0); }
    PROMISE(is(shaped, 2, 0, 0) && atraj_shaper_stream_advance(&stream, A_FLOAT_C(0.5)) == 0);
    PROMISE(atraj_shaper_init(&slow, ATRAJ_SHAPER_ZV, 2, 0) == 0 && atraj_shaper_stream_change(&stream, &slow, line, SIZE) == ATRAJ_ERR_NULL);
    PROMISE(atraj_shaper_init(&slow, ATRAJ_SHAPER_ZV, 50, 0) == 0 && atraj_shaper_stream_change(&stream, &slow, line, SIZE) == 0);
    now.v = 1;
    PROMISE(atraj_shaper_stream_tick(&stream, &now, line, SIZE, &shaped) == 0 && near(shaped.p, A_FLOAT_C(2.25)));
    now.v = none;
    PROMISE(atraj_shaper_stream_tick(&stream, &now, line, SIZE, &shaped) == ATRAJ_ERR_NOT_FINITE && isnan(shaped.p));
    PROMISE(atraj_step_stream_wait(&motor, -1, 0) == ATRAJ_ERR_DURATION && atraj_step_stream_wait(&motor, A_FLOAT_C(0.0004), 0) == 0);
    now.p = 3, now.v = 0;
    PROMISE(atraj_step_stream_tick(&motor, &now) == 0);
    for (sum = 0; atraj_step_stream_next(&motor, &time) != 0; ++sum) {}
    PROMISE(sum == 2 && atraj_step_stream_count(&motor) == 18);
    return 0;
}

/* --- several axes */

/* Velocities and accelerations that point along the line from (1, 2, -1) to (9, -2, 1). */
static const atraj_limits set[3] = {{5, -4, 10, -9, 30, -20}, {3, -6, 12, -8, 25, -40}, {7, -2, 9, -15, 50, -35}};
static const atraj_state starts[3] = {{1, 2, 2}, {2, -1, -1}, {-1, A_FLOAT_C(0.5), A_FLOAT_C(0.5)}};
static const atraj_state ends[3] = {{9, 1, -2}, {-2, A_FLOAT_C(-0.5), 1}, {1, A_FLOAT_C(0.25), A_FLOAT_C(-0.5)}};

typedef int planner(atraj_move *axes, const atraj_limits *limits, const atraj_state *from, const atraj_state *to, size_t n, a_float duration, a_float cycle);

static int between(atraj_move *axes, const atraj_limits *l, const atraj_state *from, const atraj_state *to, size_t n, a_float duration, a_float cycle)
{
    const a_float lowest[3] = {0, -3, -2}, highest[3] = {12, 4, 2};
    return atraj_moves_sync_within(axes, l, from, to, lowest, highest, n, duration, cycle);
}

static int axes(void) {
    static planner *const planners[] = {atraj_moves_sync, atraj_moves_line, between};
    const a_float lowest[3] = {0, -3, -2}, highest[3] = {12, 4, 2}, low[3] = {0, -1, -2}, high[3] = {12, 4, 0};
    atraj_move moved[3];
    a_float p;
    int i, k;
    for (i = 0; i < 3; ++i) {
        memset(moved, 0x55, sizeof(moved));
        p = moved[2].t;
        PROMISE(planners[i](moved, set, starts, ends, 2, 20, 0) == 0 && moved[1].t == 20 && same(moved[2].t, p));
        PROMISE(planners[i](moved, set, starts, ends, 3, A_FLOAT_C(19.75), A_FLOAT_C(0.5)) == 0);
        for (k = 0; k < 3; ++k) {
            PROMISE(moved[k].t == 20 && is(starts[k], atraj_move_pos(&moved[k], 0), atraj_move_vel(&moved[k], 0), atraj_move_acc(&moved[k], 0)));
            PROMISE(is(ends[k], atraj_move_pos(&moved[k], 20), atraj_move_vel(&moved[k], 20), atraj_move_acc(&moved[k], 20)));
            PROMISE(atraj_move_check(&moved[k], &set[k]) == 0);
        }
    }
    PROMISE(atraj_moves_sync_within(moved, set, starts, ends, lowest, high, 3, 0, 0) == ATRAJ_ERR_POSITION);
    PROMISE(atraj_moves_sync_within(moved, set, starts, ends, low, highest, 3, 0, 0) == ATRAJ_ERR_POSITION);

    PROMISE(atraj_moves_line(moved, set, starts, ends, 3, 0, 0) == 0);
    p = atraj_move_pos(moved, 1);
    PROMISE(atraj_moves_line_stop(moved, set, 3, 1) == 0 && moved[0].phase[0].p == p && atraj_move_vel(&moved[2], moved[2].t) == 0);
    PROMISE(fabs((double)(atraj_move_pos(&moved[0], moved[0].t) + 2 * atraj_move_pos(&moved[1], moved[0].t) - 5)) < 1e-4);
    return 0;
}

/* The waypoints of example 3 of Ruckig. */
enum { AXES = 3, SECTIONS = 5, SIZE = ATRAJ_PATH_SIZE(AXES, SECTIONS) };
static const atraj_limits of_axes[AXES] = {{1, -1, 3, -3, 6, -6}, {2, -2, 2, -2, 10, -10}, {1, -1, 2, -2, 20, -20}};
static const atraj_state points[(SECTIONS + 1) * AXES] = {
    {A_FLOAT_C(0.2), 0, 0}, {0, A_FLOAT_C(0.2), A_FLOAT_C(0.6)}, {A_FLOAT_C(-0.3), 0, 0}, {A_FLOAT_C(1.4), 0, 0}, {A_FLOAT_C(-1.6), 0, 0}, {1, 0, 0},
    {A_FLOAT_C(-0.6), 0, 0}, {A_FLOAT_C(-0.5), 0, 0}, {A_FLOAT_C(0.4), 0, 0}, {A_FLOAT_C(-0.4), 0, 0}, {A_FLOAT_C(-0.35), 0, 0}, {0, 0, 0},
    {A_FLOAT_C(0.8), 0, 0}, {A_FLOAT_C(1.8), 0, 0}, {A_FLOAT_C(-0.1), 0, 0},
    {A_FLOAT_C(0.5), A_FLOAT_C(0.2), 0}, {1, 0, A_FLOAT_C(0.1)}, {0, A_FLOAT_C(0.3), A_FLOAT_C(-0.1)}};

static a_float sum(const a_float *durations) {
    return durations[0] + durations[1] + durations[2] + durations[3] + durations[4];
}

/* Each section is the one that is planned alone, and the path is off its lines. */
static int motions_of_a_path(const atraj_limits *zones, const atraj_state *states, a_float *durations) {
    atraj_move moves[SECTIONS * AXES], alone[AXES];
    int k;
    PROMISE(atraj_path_moves_zones(moves, zones, states, durations, AXES, SECTIONS) == ATRAJ_OVERSHOOTS);
    for (k = 0; k < SECTIONS; ++k) {
        PROMISE(atraj_moves_sync(alone, zones + k * AXES, states + k * AXES, states + (k + 1) * AXES, AXES, durations[k], 0) >= 0);
        PROMISE(moves[k * AXES + 2].t == alone[2].t && moves[k * AXES + 2].phase[3].p == alone[2].phase[3].p);
    }
    PROMISE(atraj_path_deviation(moves, AXES, SECTIONS) > A_FLOAT_C(0.01) && atraj_path_deviation(moves, AXES, SECTIONS) < 2);
    PROMISE(isnan(atraj_path_deviation(moves, AXES, 0)) && isnan(atraj_path_deviation(A_NULL, AXES, SECTIONS)));
    PROMISE(atraj_path_moves(moves, of_axes, states, durations, AXES, SECTIONS) >= 0);
    durations[1] /= 2, moves[0].t = 77;
    PROMISE(atraj_path_moves_zones(moves, zones, states, durations, AXES, SECTIONS) == ATRAJ_ERR_DURATION && moves[0].t < 77);
    durations[1] = -1, moves[0].t = 77;
    PROMISE(atraj_path_moves_zones(moves, zones, states, durations, AXES, SECTIONS) == ATRAJ_ERR_DURATION && moves[0].t == 77);
    return 0;
}

static int path(void) {
    atraj_limits zones[SECTIONS * AXES];
    atraj_state states[(SECTIONS + 1) * AXES];
    a_float durations[SECTIONS] = {0}, work[SIZE + 1], t, second;
    int k;
    work[SIZE] = 77;
    memcpy(states, points, sizeof(states));
    PROMISE(atraj_path_size(AXES, SECTIONS) == SIZE && atraj_path_size(1, 1) == 44 && atraj_path_size(0, 1) == 0 && atraj_path_size((size_t)-1, 2) == 0);
    PROMISE(atraj_path_plan(states, durations, of_axes, AXES, SECTIONS, 0, work) == 0 && work[SIZE] == 77);
    t = sum(durations), second = durations[1];
    PROMISE(t > A_FLOAT_C(7.73) && t < A_FLOAT_C(7.74) && memcmp(&states[0], &points[0], sizeof(states[0])) == 0);
    PROMISE(atraj_path_plan(states, durations, of_axes, AXES, SECTIONS, 1, work) == 0 && sum(durations) > 9);
    PROMISE(atraj_path_improve(states, durations, of_axes, AXES, SECTIONS, 0, work) == 0 && work[SIZE] == 77 && sum(durations) < A_FLOAT_C(7.74));
    for (k = 0; k < SECTIONS * AXES; ++k) { zones[k] = of_axes[k % AXES]; }
    PROMISE(atraj_path_plan_zones(states, durations, zones, AXES, SECTIONS, 0, work) == 0 && near(sum(durations), t));
    for (k = AXES; k < 2 * AXES; ++k) { zones[k].vmax /= 4, zones[k].vmin /= 4; }
    PROMISE(atraj_path_plan_zones(states, durations, zones, AXES, SECTIONS, 0, work) == 0 && durations[1] > 2 * second && work[SIZE] == 77);
    for (k = AXES; k < 3 * AXES; ++k) { PROMISE(A_ABS(states[k].v) <= zones[AXES + k % AXES].vmax); }
    return motions_of_a_path(zones, states, durations);
}

/* The same points with a tolerance, but for the second axis. */
static int path_near(void) {
    enum { NEAR = ATRAJ_PATH_SIZE_NEAR(AXES, SECTIONS) };
    atraj_state states[(SECTIONS + 1) * AXES];
    a_float durations[SECTIONS], tolerances[(SECTIONS - 1) * AXES], work[NEAR + 1], t;
    int k;
    work[NEAR] = 77;
    memcpy(states, points, sizeof(states));
    PROMISE(atraj_path_size_near(AXES, SECTIONS) == NEAR && atraj_path_size_near(AXES, 40000) == 0 && atraj_path_size_near(101, 1) == 0);
    PROMISE(atraj_path_plan(states, durations, of_axes, AXES, SECTIONS, 0, work) == 0);
    t = sum(durations);
    for (k = 0; k < (SECTIONS - 1) * AXES; ++k) { tolerances[k] = k % AXES == 1 ? 0 : A_FLOAT_C(0.0625); }
    PROMISE(atraj_path_plan_near(states, durations, of_axes, tolerances, AXES, SECTIONS, 0, work) == 0 && work[NEAR] == 77);
    PROMISE(sum(durations) < A_FLOAT_C(0.98) * t && states[AXES].p != points[AXES].p);
    for (k = AXES; k < SECTIONS * AXES; ++k) { PROMISE(A_ABS(states[k].p - points[k].p) <= tolerances[k - AXES]); }
    tolerances[0] = A_FLOAT_C(-0.0625);
    PROMISE(atraj_path_plan_near(states, durations, of_axes, tolerances, AXES, SECTIONS, 0, work) == ATRAJ_ERR_LIMITS);
    PROMISE(atraj_path_plan_near(states, durations, of_axes, A_NULL, AXES, SECTIONS, 0, work) == ATRAJ_ERR_NULL);
    return 0;
}

/* A corner of two lines: a contour with room and without, with limits for each section, and with a feed. */
static int path_contour(void) {
    enum { ROOM = 32, WORK = ATRAJ_PATH_SIZE(2, ROOM) };
    static const a_float given[6] = {0, 0, 3, 1, 4, 5};
    atraj_limits zones[4];
    atraj_state states[2 * (ROOM + 1)];
    atraj_move moves[2 * ROOM];
    a_float durations[ROOM], work[WORK + 1], feeds[2] = {2, 1}, t = 0;
    size_t places[3], k;
    work[WORK] = 77;
    for (k = 0; k < 4; ++k) { atraj_limits_init(&zones[k], 30, 10, 5); }
    for (k = 0; k < 6; ++k) { states[k].p = given[k], states[k].v = states[k].a = 0; }
    PROMISE(atraj_path_contour(moves, states, durations, places, zones, A_FLOAT_C(0.05), 2, 2, 3, 0, work) == ATRAJ_ERR_POSITION && places[2] == 2);
    PROMISE(atraj_path_contour(moves, states, durations, places, zones, A_FLOAT_C(0.05), 2, 2, ROOM, 0, work) >= 0 && work[WORK] == 77);
    PROMISE(places[0] == 0 && places[1] > 1 && places[2] > 3 && places[2] < ROOM);
    PROMISE(states[2 * places[1]].p == 3 && states[2 * places[2] + 1].p == 5);
    PROMISE(atraj_path_deviation(moves, 2, places[2]) <= A_FLOAT_C(0.05));
    for (k = 0; k < 6; ++k) { states[k].p = given[k], states[k].v = states[k].a = 0; }
    PROMISE(atraj_path_feed(zones, states, feeds, 2, 2) == 0 && zones[0].vmax < 2 && zones[3].vmin > -1);
    PROMISE(atraj_path_contour_zones(moves, states, durations, places, zones, A_FLOAT_C(0.05), 2, 2, ROOM, 0, work) >= 0 && work[WORK] == 77);
    for (k = 0; k < places[1]; ++k) { t += durations[k]; }
    PROMISE(t > A_FLOAT_C(1.58) && t < A_FLOAT_C(2.5));
    feeds[1] = 0;
    PROMISE(atraj_path_feed(zones, states, feeds, 2, 2) == ATRAJ_ERR_LIMITS && atraj_path_feed(A_NULL, states, feeds, 2, 2) == ATRAJ_ERR_NULL);
    return 0;
}

static const atraj_limits planned[2] = {{4, -4, 8, -8, 24, -24}, {4, -4, 8, -8, 24, -24}}, reserve[2] = {{5, -5, 10, -10, 30, -30}, {6, -6, 12, -12, 36, -36}};

/* A path of two axes and two sections: a hold in the first one, a way back, and on to the end. */
static int clock_of_a_path(void) {
    const atraj_state way[3][2] = {{{0, 0, 0}, {0, 0, 0}}, {{5, 2, 0}, {-1, 0, 0}}, {{10, 0, 0}, {-3, 0, 0}}};
    atraj_move moved[2][2];
    atraj_state now;
    atraj_clock ctx;
    a_float until, t, jerk;
    PROMISE(atraj_moves_sync(moved[0], planned, way[0], way[1], 2, 0, 0) == 0 && atraj_moves_sync(moved[1], planned, way[1], way[2], 2, 0, 0) == 0);
    atraj_clock_start(&ctx);
    PROMISE(atraj_clock_time(&ctx, 2) == 2);
    t = moved[0][0].t + A_FLOAT_C(0.25);
    atraj_clock_state(&ctx, *moved + 1, 2, 2, t, &now.p, &now.v, &now.a, &jerk);
    PROMISE(fabs((double)(now.p - atraj_move_pos(&moved[1][1], A_FLOAT_C(0.25)))) < 1e-5 && fabs((double)(now.v - atraj_move_vel(&moved[1][1], A_FLOAT_C(0.25)))) < 1e-4);
    PROMISE(jerk != 0 && now.a != 0);
    PROMISE(atraj_clock_rate(&ctx, *moved, reserve, 2, 2, A_FLOAT_C(0.5), 0) == 0);
    until = atraj_clock_until(&ctx), t = atraj_clock_time(&ctx, until);
    PROMISE(until > A_FLOAT_C(0.5) && t > A_FLOAT_C(0.5) && atraj_clock_time(&ctx, until + 3) == t);
    atraj_clock_state(&ctx, *moved, 2, 2, until + 3, &now.p, &now.v, &now.a, A_NULL);
    PROMISE(is(now, atraj_move_pos(moved[0], t), 0, 0));
    PROMISE(atraj_clock_rate(&ctx, *moved, reserve, 2, 2, until + 3, -A_FLOAT_C(0.5)) == 0);
    until = atraj_clock_until(&ctx);
    PROMISE(atraj_clock_time(&ctx, until + A_FLOAT_C(0.125)) < t);
    PROMISE(atraj_clock_rate(&ctx, *moved, reserve, 2, 2, until, 1) == 0);
    atraj_clock_state(&ctx, *moved, 2, 2, until + 50, &now.p, &now.v, &now.a, A_NULL);
    PROMISE(is(now, 10, 0, 0));
    atraj_clock_rebase(&ctx, until), until = 0;
    PROMISE(atraj_clock_rate(&ctx, *moved, reserve, 2, 2, 50, 1) == ATRAJ_RATE_NOT_REACHED && atraj_clock_until(&ctx) == 50);
    PROMISE(atraj_clock_rate(&ctx, *moved, reserve, 2, 2, 49, 0) == ATRAJ_ERR_LATE);
    return 0;
}

/* Two axes on a line: a hold, the rest of it, a path there and back, and each axis for itself. */
static int group(void) {
    const atraj_state way[3][2] = {{{5, 0, 0}, {-1, 0, 0}}, {{6, 1, 0}, {-3, 1, 0}}, {{5, 0, 0}, {-1, 0, 0}}};
    const a_float period = A_FLOAT_C(0.0078125), low[2] = {-1, -2}, high[2] = {7, 1}, odd[2] = {none, 0};
    atraj_state states[2] = {{0, 0, 0}, {0, 0, 0}}, now[2];
    atraj_move room[6], path[2][2];
    atraj_group ctx;
    int n;
    PROMISE(atraj_group_init(&ctx, 0, states, room, 2) == ATRAJ_ERR_DURATION && atraj_group_init(&ctx, period, states, room, 0) == ATRAJ_ERR_NULL);
    PROMISE(atraj_group_init(&ctx, period, states, room, 2) == 0 && atraj_group_rate(&ctx, reserve, 1, 1) == ATRAJ_RATE_NOT_REACHED);
    PROMISE(atraj_group_rate(&ctx, reserve, 0, 1) == 0 && atraj_group_tick(&ctx, now) == ATRAJ_TICK_BEGINS + ATRAJ_TICK_ENDS);
    PROMISE(atraj_group_line(&ctx, planned, way[0], 0) == ATRAJ_ERR_LATE && atraj_group_line(&ctx, planned, way[0], 2) == 0);
    PROMISE(atraj_group_tick(&ctx, now) == 0 && is(now[1], 0, 0, 0) && atraj_group_tick(&ctx, now) == ATRAJ_TICK_BEGINS);
    for (n = 0; n != 60; ++n) { PROMISE(atraj_group_tick(&ctx, now) == 0); }
    PROMISE(now[0].p > 0 && fabs((double)(now[0].p + 5 * now[1].p)) < 1e-5);
    PROMISE(atraj_group_rate(&ctx, reserve, 0, 1) == 0 && atraj_group_tick(&ctx, now) == ATRAJ_TICK_BEGINS && now[0].v > 0);
    while (atraj_group_tick(&ctx, now) != ATRAJ_TICK_ENDS) {}
    PROMISE(now[0].p < 5 && now[0].v == 0 && fabs((double)(now[0].p + 5 * now[1].p)) < 1e-5);
    PROMISE(atraj_group_rate(&ctx, reserve, 1, 1) == 0);
    while (atraj_group_tick(&ctx, now) != ATRAJ_TICK_ENDS) {}
    PROMISE(is(now[0], 5, 0, 0) && is(now[1], -1, 0, 0));
    PROMISE(atraj_moves_sync(path[0], planned, way[0], way[1], 2, 0, 0) >= 0 && atraj_moves_sync(path[1], planned, way[1], way[2], 2, 0, 0) >= 0);
    PROMISE(atraj_group_path(&ctx, reserve, *path, 2, 1, 1) == ATRAJ_ERR_TARGET && atraj_group_path(&ctx, reserve, *path, 2, 0, 1) == 0);
    for (n = 0; n != 60; ++n) { atraj_group_tick(&ctx, now); }
    PROMISE(atraj_group_time(&ctx, 0) != atraj_group_time(&ctx, 0) && atraj_group_path(&ctx, reserve, *path, 2, atraj_group_time(&ctx, 9), 9) == 0);
    PROMISE(is(now[1], atraj_move_pos(&path[0][1], period * 59), atraj_move_vel(&path[0][1], period * 59), atraj_move_acc(&path[0][1], period * 59)));
    PROMISE(atraj_group_within(NULL, low, high) == ATRAJ_ERR_NULL && atraj_group_within(&ctx, low, NULL) == ATRAJ_ERR_NULL);
    PROMISE(atraj_group_within(&ctx, high, low) == ATRAJ_ERR_LIMITS && atraj_group_within(&ctx, odd, high) == ATRAJ_ERR_NOT_FINITE);
    PROMISE(atraj_group_within(&ctx, low, high) == 0 && atraj_group_go(&ctx, reserve, way[1], 1) == ATRAJ_ERR_POSITION);
    PROMISE(atraj_group_sync(&ctx, reserve, way[1], 1) == ATRAJ_ERR_POSITION && atraj_group_stop(&ctx, reserve, 1) == 0);
    PROMISE(atraj_group_within(&ctx, NULL, NULL) == 0);
    PROMISE(atraj_group_go(&ctx, reserve, way[1], 1) >= 0 && atraj_group_tick(&ctx, now) == ATRAJ_TICK_BEGINS);
    PROMISE(atraj_group_sync(&ctx, reserve, way[2], 1) >= 0 && atraj_group_tick(&ctx, now) == ATRAJ_TICK_BEGINS);
    PROMISE(atraj_group_stop(&ctx, reserve, 1) == 0 && atraj_group_tick(&ctx, now) == ATRAJ_TICK_BEGINS);
    while (atraj_group_tick(&ctx, now) != ATRAJ_TICK_ENDS) {}
    PROMISE(now[0].v == 0 && now[1].v == 0);
    return 0;
}

int main(void) {
    return bell() || trap() || polynomials() || move() || steps() || shaper() || streams() || axes() || path() || path_near() || path_contour() || clock_of_a_path() || group();
}
