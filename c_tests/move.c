/*
 Tests the contract of every function of atraj/move.h. Each argument is once no number, infinite, 0 or of the wrong sign, and each
 pointer once NULL; a refusal leaves the move untouched. Then a few plans: their ends, their findings, durations that are known in closed
 form. `tests/oracle` judges the motions, `sample.c` compares the evaluations.
 Prints the line of the first broken promise and fails.
*/
#include "atraj/move.h"
#include <limits.h>
#include "promise.h"

static int near(a_float x, a_float y) { return A_ABS(x - y) <= 32 * A_FLOAT_EPSILON * (1 + A_ABS(y)); }

/* --- refusals */

/* What a plan is asked for, as twelve numbers: limits, start, end. */
struct problem
{
    atraj_limits limits;
    atraj_state from, to;
};
enum { LIMITS = 6, NUMBERS = 12 };
static const struct problem good = {{5, -4, 10, -9, 30, -20}, {1, 2, 3}, {10, -1, 2}};

typedef int planner(atraj_move *ctx, const atraj_limits *limits, const atraj_state *from, const atraj_state *to);
static int track(atraj_move *ctx, const atraj_limits *limits, const atraj_state *from, const atraj_state *to)
{
    return atraj_move_track(ctx, limits, from, to, A_FLOAT_C(0.5));
}
static int reach(atraj_move *ctx, const atraj_limits *limits, const atraj_state *from, const atraj_state *to)
{
    return atraj_move_reach(ctx, limits, from, to->v, to->a);
}
static int stop(atraj_move *ctx, const atraj_limits *limits, const atraj_state *from, const atraj_state *to)
{
    (void)to;
    return atraj_move_stop(ctx, limits, from);
}
static int within(atraj_move *ctx, const atraj_limits *limits, const atraj_state *from, const atraj_state *to)
{
    return atraj_move_within(ctx, limits, from, to, -endless, endless);
}
/* Each planner, and which of the last three numbers it is asked for: position, velocity, acceleration. */
static const struct
{
    planner *plan;
    int asks[3];
} planners[] = {{atraj_move_plan, {1, 1, 1}}, {track, {1, 1, 1}}, {within, {1, 1, 1}}, {reach, {0, 1, 1}}, {stop, {0, 0, 0}}, {atraj_move_meet, {1, 1, 1}}};
enum { MEET = 5 };

/* Whether a move has this answer, and an error has left the context untouched. */
static int answers(int expected, planner *plan, const struct problem *p)
{
    atraj_move before, ctx;
    int answer;
    memset(&before, 0x55, sizeof(before));
    ctx = before;
    answer = plan(&ctx, &p->limits, &p->from, &p->to);
    if (answer != expected) { printf("answer %d instead of %d\n", answer, expected); }
    return answer == expected && (answer < 0) == (memcmp(&ctx, &before, sizeof(ctx)) == 0);
}

/* The good problem of a planner. A target that moves on has no acceleration. */
static struct problem good_for(int i)
{
    struct problem p = good;
    if (i == MEET) { p.to.a = 0; }
    return p;
}

static struct problem with(struct problem p, int number, a_float value)
{
    a_float numbers[NUMBERS];
    memcpy(numbers, &p, sizeof(p));
    numbers[number] = value;
    memcpy(&p, numbers, sizeof(p));
    return p;
}

static int refused_numbers(void)
{
    int i, k, number;
    PROMISE(sizeof(struct problem) == NUMBERS * sizeof(a_float));
    for (i = 0; i < (int)A_LEN(planners); ++i)
    {
        planner *const plan = planners[i].plan;
        const struct problem p = good_for(i);
        const int findings = plan(&(atraj_move){0}, &p.limits, &p.from, &p.to);
        PROMISE(findings >= 0);
        for (number = 0; number < NUMBERS; ++number)
        {
            const int is_limit = number < LIMITS;
            const int is_asked = number < LIMITS + 3 || planners[i].asks[number - LIMITS - 3];
            const a_float sign = number % 2 ? (a_float)-1 : (a_float)1; /* of a limit */
            const int no_number = is_asked ? ATRAJ_ERR_NOT_FINITE : findings;
            const a_float no_states[] = {endless, -endless}, no_limits[] = {0, -(a_float)0, -sign, -sign * endless};
            struct problem bad = with(p, number, none);
            PROMISE(answers(no_number, plan, &bad));
            for (k = 0; k < (is_limit ? 4 : 2); ++k)
            {
                bad = with(p, number, is_limit ? no_limits[k] : no_states[k]);
                PROMISE(answers(is_limit ? ATRAJ_ERR_LIMITS : no_number, plan, &bad));
            }
        }
        {
            /* A jerk or both accelerations are finite. */
            struct problem bad = with(with(with(p, 4, endless), 5, -endless), 2, endless);
            PROMISE(answers(ATRAJ_ERR_LIMITS, plan, &bad));
            bad = with(with(with(p, 4, endless), 5, -endless), 3, -endless);
            PROMISE(answers(ATRAJ_ERR_LIMITS, plan, &bad));
        }
    }
    return 0;
}

static int refused_pointers(void)
{
    const struct problem p = good_for(MEET);
    int i;
    PROMISE(ATRAJ_ERR_NULL == -1 && ATRAJ_ERR_NOT_FINITE == -2 && ATRAJ_ERR_LIMITS == -3 && ATRAJ_ERR_TARGET == -4);
    for (i = 0; i < (int)A_LEN(planners); ++i)
    {
        planner *const plan = planners[i].plan;
        const int has_target = plan == atraj_move_plan || plan == within || plan == track || plan == atraj_move_meet;
        atraj_move before, ctx;
        memset(&before, 0x55, sizeof(before));
        ctx = before;
        PROMISE(plan(A_NULL, &p.limits, &p.from, &p.to) == ATRAJ_ERR_NULL);
        PROMISE(plan(&ctx, A_NULL, &p.from, &p.to) == ATRAJ_ERR_NULL);
        PROMISE(plan(&ctx, &p.limits, A_NULL, &p.to) == ATRAJ_ERR_NULL);
        if (has_target) { PROMISE(plan(&ctx, &p.limits, &p.from, A_NULL) == ATRAJ_ERR_NULL); }
        PROMISE(memcmp(&ctx, &before, sizeof(ctx)) == 0);
    }
    atraj_limits_init(A_NULL, 30, 10, 5);
    return 0;
}

/* Targets outside the limits, or whose acceleration cannot have been built up, which no planner takes. Then targets too fast to meet. */
static int refused_targets(void)
{
    static const a_float targets[][2] = {{6, 0}, {-5, 0}, {0, 11}, {0, -10}, {5, -1}, {-4, 1}, {5, 0}, {-4, 0}, {1, 1}, {1, -1}};
    struct problem p = good;
    int i;
    for (i = 0; i < (int)A_LEN(targets); ++i)
    {
        p.to.v = targets[i][0];
        p.to.a = targets[i][1];
        PROMISE(i >= 6 || answers(ATRAJ_ERR_TARGET, atraj_move_plan, &p));
        PROMISE(i >= 6 || answers(ATRAJ_ERR_TARGET, reach, &p));
        PROMISE(answers(ATRAJ_ERR_TARGET, atraj_move_meet, &p));
    }
    return 0;
}

/* What comes after a target is no reason to refuse it. */
static int leaves_afterwards(void)
{
    static const a_float targets[][2] = {{5, 1}, {-4, -1}, {A_FLOAT_C(4.5), 9}, {4, 2}, {-3, -2}};
    struct problem p = good;
    int i;
    PROMISE(ATRAJ_ENDS_LEAVING == 64);
    for (i = 0; i < (int)A_LEN(targets); ++i)
    {
        const int expected = i < 3 ? ATRAJ_ENDS_LEAVING : 0;
        atraj_move ctx;
        p.to.v = targets[i][0];
        p.to.a = targets[i][1];
        PROMISE((atraj_move_plan(&ctx, &p.limits, &p.from, &p.to) & ~ATRAJ_OVERSHOOTS) == expected);
        PROMISE(atraj_move_pos(&ctx, ctx.t) == p.to.p && atraj_move_vel(&ctx, ctx.t) == p.to.v && atraj_move_acc(&ctx, ctx.t) == p.to.a);
        PROMISE((reach(&ctx, &p.limits, &p.from, &p.to) & ~ATRAJ_OVERSHOOTS) == expected);
    }
    return 0;
}

/* Between two positions: the fastest move or a refusal. */
static int between(void)
{
    const struct problem p = good;
    const a_float far[][2] = {{0, 11}, {-endless, 11}, {0, endless}, {-endless, endless}};
    const a_float near_to[][2] = {{0, 10}, {2, 11}, {1, 9}, {-endless, 10}};
    const a_float bad[][2] = {{10, 10}, {11, 0}, {endless, endless}, {-endless, -endless}, {endless, -endless}};
    const a_float no_numbers[][2] = {{none, 11}, {0, none}, {none, none}};
    atraj_move before, ctx, fastest;
    int i;
    memset(&before, 0x55, sizeof(before));
    memset(&fastest, 0, sizeof(fastest));
    PROMISE(ATRAJ_ERR_POSITION == -7 && atraj_move_plan(&fastest, &p.limits, &p.from, &p.to) >= 0);
    for (i = 0; i < (int)A_LEN(far); ++i)
    {
        memset(&ctx, 0, sizeof(ctx));
        PROMISE(atraj_move_within(&ctx, &p.limits, &p.from, &p.to, far[i][0], far[i][1]) >= 0);
        PROMISE(ctx.t == fastest.t && ctx.phases == fastest.phases);
    }
    ctx = before;
    /* The velocity at the end is below 0, so the axis comes to 10 from beyond. */
    for (i = 0; i < (int)A_LEN(near_to); ++i)
    {
        PROMISE(atraj_move_within(&ctx, &p.limits, &p.from, &p.to, near_to[i][0], near_to[i][1]) == ATRAJ_ERR_POSITION);
    }
    for (i = 0; i < (int)A_LEN(bad); ++i)
    {
        PROMISE(atraj_move_within(&ctx, &p.limits, &p.from, &p.to, bad[i][0], bad[i][1]) == ATRAJ_ERR_LIMITS);
    }
    for (i = 0; i < (int)A_LEN(no_numbers); ++i)
    {
        PROMISE(atraj_move_within(&ctx, &p.limits, &p.from, &p.to, no_numbers[i][0], no_numbers[i][1]) == ATRAJ_ERR_NOT_FINITE);
    }
    PROMISE(memcmp(&ctx, &before, sizeof(ctx)) == 0);
    return 0;
}

/* Beside a signal after the horizon, or later; the horizon is a time above 0. */
static int tracks(void)
{
    const atraj_state from = {1, 1, 0}, near_by = {A_FLOAT_C(1.01), 1, A_FLOAT_C(0.5)}, far = {9, 1, 2}, fast = {1, 20, 0};
    const a_float h = A_FLOAT_C(0.5), bad[] = {0, -(a_float)0, -1, none, endless, -endless};
    atraj_move before, ctx;
    atraj_limits limits;
    int i;
    atraj_limits_init(&limits, 30, 10, 5);
    PROMISE(atraj_move_track(&ctx, &limits, &from, &near_by, h) >= 0 && ctx.t == h);
    PROMISE(near(atraj_move_pos(&ctx, h), near_by.p + h * near_by.v + near_by.a * h * h / 2));
    PROMISE(near(atraj_move_vel(&ctx, h), near_by.v + near_by.a * h) && atraj_move_acc(&ctx, h) == near_by.a);
    PROMISE(atraj_move_check(&ctx, &limits) == 0);
    PROMISE(atraj_move_track(&ctx, &limits, &from, &far, h) >= 0 && ctx.t > h);
    PROMISE(near(atraj_move_pos(&ctx, ctx.t), far.p + far.v * ctx.t) && atraj_move_acc(&ctx, ctx.t) == 0);
    PROMISE(atraj_move_track(&ctx, &limits, &from, &fast, h) >= 0 && atraj_move_vel(&ctx, ctx.t) == 5);
    memset(&before, 0x55, sizeof(before));
    ctx = before;
    for (i = 0; i < (int)A_LEN(bad); ++i) { PROMISE(atraj_move_track(&ctx, &limits, &from, &near_by, bad[i]) == ATRAJ_ERR_DURATION); }
    PROMISE(memcmp(&ctx, &before, sizeof(ctx)) == 0);
    return 0;
}

static int too_far(void)
{
    struct problem p = good;
    p.from.p = -A_FLOAT_MAX;
    p.to.p = A_FLOAT_MAX;
    PROMISE(answers(ATRAJ_ERR_NOT_FINITE, atraj_move_plan, &p));
    return 0;
}

/* --- plans */

static int limits(void)
{
    atraj_limits limits;
    atraj_limits_init(&limits, -30, 10, -5);
    PROMISE(limits.vmax == 5 && limits.vmin == -5 && limits.amax == 10 && limits.amin == -10);
    PROMISE(limits.jmax == 30 && limits.jmin == -30);
    return 0;
}

/* Ends exactly where it is told, has few phases in order of time, and keeps the limits. */
static int is_good(const atraj_move *ctx, const atraj_limits *limits, const atraj_state *from, const atraj_state *to)
{
    atraj_state lowest, highest;
    const a_float over = 1 + 32 * A_FLOAT_EPSILON;
    unsigned i;
    PROMISE(ctx->t >= 0 && ctx->t < endless && ctx->phases <= 15);
    PROMISE(ctx->phase[0].t == 0 && ctx->phase[ctx->phases].t == ctx->t && ctx->phase[ctx->phases].duration == 0);
    for (i = 0; i < ctx->phases; ++i)
    {
        PROMISE(ctx->phase[i].duration >= 0 && ctx->phase[i + 1].t >= ctx->phase[i].t);
        PROMISE(ctx->phase[i].j >= limits->jmin && ctx->phase[i].j <= limits->jmax);
    }
    PROMISE(atraj_move_pos(ctx, ctx->t) == to->p && atraj_move_vel(ctx, ctx->t) == to->v && atraj_move_acc(ctx, ctx->t) == to->a);
    PROMISE(atraj_move_pos(ctx, -1) == from->p && atraj_move_vel(ctx, -1) == from->v && atraj_move_acc(ctx, -1) == from->a);
    atraj_move_extremes(ctx, &lowest, &highest);
    PROMISE(lowest.v >= limits->vmin * over && highest.v <= limits->vmax * over);
    PROMISE(lowest.a >= limits->amin * over && highest.a <= limits->amax * over);
    return 0;
}

static int plans(void)
{
    atraj_limits limits;
    atraj_state from = {0, 0, 0}, to = {10, 0, 0};
    atraj_move ctx;
    PROMISE(ATRAJ_OVERSHOOTS == 16 && ATRAJ_STARTS_OUTSIDE == 32);
    PROMISE(sizeof(ctx) <= (sizeof(a_float) == sizeof(float) ? 400 : 800));
    atraj_limits_init(&limits, 30, 10, 5);

    PROMISE(atraj_move_plan(&ctx, &limits, &from, &to) == 0);
    PROMISE(near(ctx.t, A_FLOAT_C(17.0) / 6)); /* 10/5 + 5/10 + 10/30 */
    if (is_good(&ctx, &limits, &from, &to)) { return 1; }

    from.v = 2;
    to.p = A_FLOAT_C(0.125); /* too near to stop */
    PROMISE(atraj_move_plan(&ctx, &limits, &from, &to) == ATRAJ_OVERSHOOTS);
    if (is_good(&ctx, &limits, &from, &to)) { return 1; }

    /* In motion to a state in motion, and no displacement. */
    from = (atraj_state){1, 4, -6};
    to = (atraj_state){-3, -1, 2};
    PROMISE(atraj_move_plan(&ctx, &limits, &from, &to) >= 0);
    if (is_good(&ctx, &limits, &from, &to)) { return 1; }
    PROMISE(atraj_move_plan(&ctx, &limits, &to, &to) == 0 && ctx.t == 0);
    PROMISE(atraj_move_pos(&ctx, 0) == -3 && atraj_move_vel(&ctx, 1) == 1 && atraj_move_acc(&ctx, none) == 2);
    PROMISE(atraj_move_jer(&ctx, 0) == 0);
    return 0;
}

/* A plan passes the check, a spoiled one does not. `tests/is_a_bad_move_seen.rs` plants more faults. */
static int checked(void)
{
    const atraj_state from = {0, 0, 0}, to = {10, 0, 0};
    atraj_limits limits, bad;
    atraj_move ctx, spoiled;
    atraj_limits_init(&limits, 30, 10, 5);
    PROMISE(atraj_move_plan(&ctx, &limits, &from, &to) == 0 && atraj_move_check(&ctx, &limits) == 0);
    PROMISE(atraj_move_check(A_NULL, &limits) == ATRAJ_ERR_NULL && atraj_move_check(&ctx, A_NULL) == ATRAJ_ERR_NULL);
    bad = limits;
    bad.vmax = A_FLOAT_C(4.9);
    PROMISE(atraj_move_check(&ctx, &bad) == ATRAJ_EXCEEDS_VELOCITY);
    bad = limits;
    bad.amin = A_FLOAT_C(-9.9);
    PROMISE(atraj_move_check(&ctx, &bad) == ATRAJ_EXCEEDS_ACCELERATION);
    bad = limits;
    bad.jmax = 29;
    PROMISE(atraj_move_check(&ctx, &bad) == ATRAJ_EXCEEDS_JERK);
    bad.jmax = 0;
    PROMISE(atraj_move_check(&ctx, &bad) == ATRAJ_ERR_LIMITS);
    bad.jmax = none;
    PROMISE(atraj_move_check(&ctx, &bad) == ATRAJ_ERR_NOT_FINITE);
    spoiled = ctx;
    spoiled.phase[spoiled.phases].p = 11;
    PROMISE(atraj_move_check(&spoiled, &limits) == ATRAJ_JUMPS);
    spoiled = ctx;
    spoiled.phase[2].duration = none;
    PROMISE(atraj_move_check(&spoiled, &limits) == ATRAJ_ERR_NOT_FINITE);
    spoiled = ctx;
    spoiled.phases = UINT_MAX;
    PROMISE(atraj_move_check(&spoiled, &limits) == ATRAJ_ERR_NOT_FINITE || atraj_move_check(&spoiled, &limits) & ATRAJ_JUMPS);
    return 0;
}

static int starts_outside(void)
{
    static const atraj_state from[] = {{0, 6, 0}, {0, -6, 0}, {0, 0, 11}, {0, 5, 5}, {0, 9, 20}}, to = {1000, 0, 0};
    atraj_limits limits;
    atraj_move ctx;
    int i;
    atraj_limits_init(&limits, 30, 10, 5);
    for (i = 0; i < (int)A_LEN(from); ++i)
    {
        PROMISE(atraj_move_plan(&ctx, &limits, &from[i], &to) & ATRAJ_STARTS_OUTSIDE);
        PROMISE(atraj_move_stop(&ctx, &limits, &from[i]) & ATRAJ_STARTS_OUTSIDE);
        PROMISE(atraj_move_vel(&ctx, ctx.t) == 0 && atraj_move_acc(&ctx, ctx.t) == 0);
    }
    return 0;
}

/* An infinite limit is no limit. Each duration is known in closed form. */
static int infinite_limits(void)
{
    const struct
    {
        a_float jmax, jmin, amax, vmax, p, t;
    } moves[] = {
        {1, -1, endless, endless, 2, 4}, /* (32 p/j)^(1/3) */
        {1, -1, endless, 1, 4, 6}, /* p/v + 2 sqrt(v/j) */
        {endless, -endless, 1, endless, 4, 4}, /* 2 sqrt(p/a) */
        {endless, -endless, 1, 1, 4, 5}, /* p/v + v/a */
        {1, -1, 1, endless, 4, 1 + (a_float)sqrt(17.0)}, /* a/j + sqrt((a/j)^2 + 4 p/a) */
        {endless, -1, endless, endless, A_FLOAT_C(2.0) / 3, 2}, /* The acceleration jumps up, falls for 2 s, and jumps up again. */
        {1, -endless, endless, endless, A_FLOAT_C(-2.0) / 3, 2}, /* the mirrored move */
    };
    const atraj_state from = {0, 0, 0};
    int i;
    for (i = 0; i < (int)A_LEN(moves); ++i)
    {
        const atraj_state to = {moves[i].p, 0, 0};
        atraj_limits limits;
        atraj_move ctx;
        atraj_limits_init(&limits, 1, moves[i].amax, moves[i].vmax);
        limits.jmax = moves[i].jmax;
        limits.jmin = moves[i].jmin;
        PROMISE(atraj_move_plan(&ctx, &limits, &from, &to) == 0 && near(ctx.t, moves[i].t));
        if (is_good(&ctx, &limits, &from, &to)) { return 1; }
    }
    return 0;
}

static int other_plans(void)
{
    const atraj_state from = {1, 2, 3}, part = {2, 1, 0}, rest = {7, 0, 0};
    atraj_limits limits;
    atraj_move ctx;
    atraj_state to;
    atraj_limits_init(&limits, 30, 10, 5);

    PROMISE(atraj_move_reach(&ctx, &limits, &from, -3, 2) >= 0 && ctx.t > 0);
    to = (atraj_state){atraj_move_pos(&ctx, ctx.t), -3, 2};
    if (is_good(&ctx, &limits, &from, &to)) { return 1; }

    PROMISE(atraj_move_stop(&ctx, &limits, &from) == 0 && ctx.t > 0);
    to = (atraj_state){atraj_move_pos(&ctx, ctx.t), 0, 0};
    if (is_good(&ctx, &limits, &from, &to)) { return 1; }
    PROMISE(atraj_move_stop(&ctx, &limits, &rest) == 0 && ctx.t == 0 && atraj_move_pos(&ctx, 1) == 7);

    PROMISE(atraj_move_meet(&ctx, &limits, &from, &part) >= 0 && ctx.t > 0);
    to = (atraj_state){atraj_move_pos(&ctx, ctx.t), 1, 0};
    PROMISE(near(to.p, part.p + part.v * ctx.t));
    if (is_good(&ctx, &limits, &from, &to)) { return 1; }
    /* Already beside the target. */
    PROMISE(atraj_move_meet(&ctx, &limits, &part, &part) == 0 && ctx.t == 0 && atraj_move_pos(&ctx, 0) == 2);
    return 0;
}

/* --- evaluation */

/* Before the start, after the end, with NULL, and of a move that no plan made. */
static int evaluation(void)
{
    const atraj_state from = {1, 2, 3}, to = {10, -1, 2};
    atraj_limits limits;
    atraj_move ctx;
    int i;
    atraj_limits_init(&limits, 30, 10, 5);
    PROMISE(atraj_move_plan(&ctx, &limits, &from, &to) >= 0);
    {
        const a_float before[] = {0, -A_FLOAT_MIN, -1, -endless};
        const a_float ends[] = {ctx.t, endless, -none, none};
        for (i = 0; i < 4; ++i)
        {
            PROMISE(atraj_move_pos(&ctx, before[i]) == 1 && atraj_move_vel(&ctx, before[i]) == 2);
            PROMISE(atraj_move_acc(&ctx, before[i]) == 3 && (i == 0 || atraj_move_jer(&ctx, before[i]) == 0));
            PROMISE(atraj_move_pos(&ctx, ends[i]) == 10 && atraj_move_vel(&ctx, ends[i]) == -1);
            PROMISE(atraj_move_acc(&ctx, ends[i]) == 2 && atraj_move_jer(&ctx, ends[i]) == 0);
        }
    }
    /* After the end the axis moves on: 3 s later it is at 10 - 3 + 9, with the velocity -1 + 6. */
    PROMISE(near(atraj_move_pos(&ctx, ctx.t + 3), 16) && near(atraj_move_vel(&ctx, ctx.t + 3), 5));
    PROMISE(atraj_move_acc(&ctx, ctx.t + 3) == 2 && atraj_move_jer(&ctx, ctx.t + 3) == 0);
    PROMISE(A_ABS(atraj_move_jer(&ctx, ctx.t / 1000)) == 30);
    PROMISE(isnan(atraj_move_pos(A_NULL, 0)) && isnan(atraj_move_vel(A_NULL, 0)));
    PROMISE(isnan(atraj_move_acc(A_NULL, 0)) && isnan(atraj_move_jer(A_NULL, 0)));

    /* A move of zeros is at rest at 0. A number of phases that no plan gives is read as the highest. */
    memset(&ctx, 0, sizeof(ctx));
    PROMISE(atraj_move_pos(&ctx, 1) == 0 && atraj_move_vel(&ctx, 0) == 0 && atraj_move_time_at(&ctx, 0) == 0);
    ctx.phases = UINT_MAX;
    PROMISE(atraj_move_pos(&ctx, 1) == 0);
    return 0;
}

/* The extremes, and the times at which the axis is at a position. */
static int reached(void)
{
    const atraj_state from = {0, 0, 0}, to = {10, 0, 0}, fast = {0, 4, 0}, close = {1, 0, 0};
    atraj_state lowest, highest, before;
    atraj_limits limits;
    atraj_move ctx;
    a_float x;
    memset(&lowest, 0x55, sizeof(lowest));
    before = highest = lowest;
    atraj_move_extremes(A_NULL, &lowest, &highest);
    PROMISE(memcmp(&lowest, &before, sizeof(before)) == 0 && memcmp(&highest, &before, sizeof(before)) == 0);
    PROMISE(isnan(atraj_move_time_at(A_NULL, 0)));

    atraj_limits_init(&limits, 30, 10, 5);
    PROMISE(atraj_move_plan(&ctx, &limits, &from, &to) == 0);
    atraj_move_extremes(&ctx, A_NULL, A_NULL);
    atraj_move_extremes(&ctx, &lowest, A_NULL);
    atraj_move_extremes(&ctx, A_NULL, &highest);
    PROMISE(near(lowest.p, 0) && near(lowest.v, 0) && near(lowest.a, -10));
    PROMISE(near(highest.p, 10) && near(highest.v, 5) && near(highest.a, 10));
    PROMISE(atraj_move_time_at(&ctx, 0) == 0 && near(atraj_move_time_at(&ctx, 5), ctx.t / 2));
    PROMISE(isnan(atraj_move_time_at(&ctx, -1)) && isnan(atraj_move_time_at(&ctx, 11)) && isnan(atraj_move_time_at(&ctx, none)));
    PROMISE(isnan(atraj_move_time_at(&ctx, endless)) && isnan(atraj_move_time_at(&ctx, -endless)));

    /* The axis passes 1, turns and comes back: the first time counts. */
    PROMISE(atraj_move_plan(&ctx, &limits, &fast, &close) == ATRAJ_OVERSHOOTS);
    atraj_move_extremes(&ctx, &lowest, &highest);
    PROMISE(near(lowest.p, 0) && highest.p > 1 && lowest.v < 0 && near(highest.v, 4));
    x = atraj_move_time_at(&ctx, 1);
    PROMISE(x > 0 && x < ctx.t / 2 && near(atraj_move_pos(&ctx, x), 1) && atraj_move_vel(&ctx, x) > 0);
    return 0;
}

/* Each code has a sentence of its own, a sum of findings has the one of the lowest, and any other number is unknown. */
static int sentences(void)
{
    int const codes[] = {0, ATRAJ_ERR_NULL, ATRAJ_ERR_NOT_FINITE, ATRAJ_ERR_LIMITS, ATRAJ_ERR_TARGET, ATRAJ_ERR_DURATION, ATRAJ_ERR_LINE, ATRAJ_ERR_POSITION,
                         ATRAJ_ERR_UNREACHABLE, 1, 2, 4, 8, 16, 32, 64, -100};
    size_t const count = sizeof codes / sizeof *codes;
    size_t k, other;
    for (k = 0; k < count; ++k)
    {
        for (other = k + 1; other < count; ++other) { PROMISE(strcmp(atraj_message(codes[k]), atraj_message(codes[other])) != 0); }
        if (codes[k] > 0) { PROMISE(strcmp(atraj_message(codes[k] | 64), atraj_message(codes[k])) == 0); }
    }
    return 0;
}

int main(void)
{
    return refused_numbers() || refused_pointers() || refused_targets() || leaves_afterwards() || between() || tracks() || limits() || plans() || checked() || starts_outside() ||
           infinite_limits() || other_plans() || evaluation() || reached() || too_far() ||
           sentences();
}
