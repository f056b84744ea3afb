/*
 Tests the contract of atraj_path_plan, atraj_path_improve and atraj_path_plan_zones. Each pointer is once NULL and each number once wrong; a
 refusal leaves states and durations untouched. Then plans: the working memory is not overrun, atraj_moves_sync takes the promised
 durations, and a path that goes on while it moves. `tests/oracle` judges the motions.
 Prints the line of the first broken promise and fails.
*/
#include "atraj/path.h"
#include "promise.h"

typedef int planner(atraj_state *states, a_float *durations, const atraj_limits *limits, size_t axes, size_t sections, unsigned steps,
                    a_float *work);
static planner *const planners[] = {atraj_path_plan, atraj_path_improve, atraj_path_plan_zones};
enum { PLANNERS = 3 };

enum { AXES = 3, SECTIONS = 5, STATES = (SECTIONS + 1) * AXES, SIZE = AXES * (28 * SECTIONS - 12) + SECTIONS * (SECTIONS + 12) };

/* The way points of example 3 of Ruckig, with the limits of every section. */
struct path
{
    atraj_limits limits[SECTIONS * AXES];
    atraj_state states[STATES];
    a_float durations[SECTIONS];
};
static struct path good(void)
{
    static const double positions[STATES] = {0.2,  0,     -0.3, 1.4, -1.6, 1,    -0.6, -0.5, 0.4,
                                             -0.4, -0.35, 0,    0.8, 1.8,  -0.1, 0.5,  1,    0};
    struct path path;
    int k;
    for (k = 0; k < STATES; ++k)
    {
        const atraj_state state = {(a_float)positions[k], 0, 0};
        path.states[k] = state;
    }
    path.states[1].v = A_FLOAT_C(0.2), path.states[1].a = A_FLOAT_C(0.6);
    path.states[15].v = A_FLOAT_C(0.2), path.states[17].v = A_FLOAT_C(0.3);
    path.states[16].a = A_FLOAT_C(0.1), path.states[17].a = A_FLOAT_C(-0.1);
    for (k = 0; k < SECTIONS * AXES; k += AXES)
    {
        atraj_limits_init(&path.limits[k], 6, 3, 1);
        atraj_limits_init(&path.limits[k + 1], 10, 2, 2);
        atraj_limits_init(&path.limits[k + 2], 20, 2, 1);
    }
    for (k = 0; k < SECTIONS; ++k) { path.durations[k] = 3; }
    return path;
}
static a_float sum(const a_float *durations, size_t n)
{
    a_float t = 0;
    size_t k;
    for (k = 0; k < n; ++k) { t += durations[k]; }
    return t;
}

/* Whether a path has this answer, and an error has left states and durations untouched. */
static int answers(int expected, planner *plan, const struct path *asked)
{
    struct path path = *asked;
    a_float work[SIZE];
    const int answer = plan(path.states, path.durations, path.limits, AXES, SECTIONS, 0, work);
    const int same = !memcmp(path.states, asked->states, sizeof(path.states)) &&
                     !memcmp(path.durations, asked->durations, sizeof(path.durations));
    if (answer != expected) { printf("answer %d instead of %d\n", answer, expected); }
    return answer == expected && (answer < 0) == same;
}

static int sizes(void)
{
    PROMISE(atraj_path_size(AXES, SECTIONS) == SIZE);
    PROMISE(atraj_path_size(1, 1) == 29);
    PROMISE(atraj_path_size(0, 1) == 0 && atraj_path_size(1, 0) == 0);
    PROMISE(atraj_path_size((size_t)-1, 2) == 0 && atraj_path_size(2, (size_t)-1) == 0);
    return 0;
}

static int refused_pointers(void)
{
    const struct path asked = good();
    struct path path = asked;
    a_float work[SIZE];
    int i;
    for (i = 0; i < PLANNERS; ++i)
    {
        planner *const plan = planners[i];
        PROMISE(plan(A_NULL, path.durations, path.limits, AXES, SECTIONS, 0, work) == ATRAJ_ERR_NULL);
        PROMISE(plan(path.states, A_NULL, path.limits, AXES, SECTIONS, 0, work) == ATRAJ_ERR_NULL);
        PROMISE(plan(path.states, path.durations, A_NULL, AXES, SECTIONS, 0, work) == ATRAJ_ERR_NULL);
        PROMISE(plan(path.states, path.durations, path.limits, AXES, SECTIONS, 0, A_NULL) == ATRAJ_ERR_NULL);
        PROMISE(plan(path.states, path.durations, path.limits, 0, SECTIONS, 0, work) == ATRAJ_ERR_NULL);
        PROMISE(plan(path.states, path.durations, path.limits, AXES, 0, 0, work) == ATRAJ_ERR_NULL);
        PROMISE(plan(path.states, path.durations, path.limits, (size_t)-1, (size_t)-1, 0, work) == ATRAJ_ERR_NULL);
        PROMISE(memcmp(path.states, asked.states, sizeof(path.states)) == 0);
    }
    return 0;
}

static int refused_numbers(void)
{
    const struct path asked = good();
    int i, k;
    for (i = 0; i < PLANNERS; ++i)
    {
        planner *const plan = planners[i];
        for (k = 0; k < STATES; ++k)
        {
            struct path bad = asked;
            bad.states[k].p = k % 2 ? none : endless;
            PROMISE(answers(ATRAJ_ERR_NOT_FINITE, plan, &bad));
            bad = asked;
            bad.states[k].v = k % 2 ? none : -endless;
            /* A plan writes the states between. */
            PROMISE(answers(i == 1 || k < AXES || k >= SECTIONS * AXES ? ATRAJ_ERR_NOT_FINITE : 0, plan, &bad));
        }
        for (k = 0; k < AXES; ++k)
        {
            struct path bad = asked;
            bad.limits[k].jmin = 0;
            PROMISE(answers(ATRAJ_ERR_LIMITS, plan, &bad));
            bad.limits[k].jmin = none;
            PROMISE(answers(ATRAJ_ERR_NOT_FINITE, plan, &bad));
            bad = asked;
            bad.states[SECTIONS * AXES + k].v = 8;
            PROMISE(answers(ATRAJ_ERR_TARGET, plan, &bad));
            bad = asked;
            bad.states[k].v = 8;
            PROMISE(answers(ATRAJ_STARTS_OUTSIDE, plan, &bad));
            bad = asked;
            bad.states[SECTIONS * AXES + k].v = asked.limits[k].vmax;
            bad.states[SECTIONS * AXES + k].a = asked.limits[k].amax / 2;
            PROMISE(answers(ATRAJ_ENDS_LEAVING, plan, &bad));
        }
    }
    for (k = 0; k < SECTIONS; ++k)
    {
        struct path bad = asked;
        bad.durations[k] = k % 3 == 0 ? -1 : k % 3 == 1 ? endless : none;
        PROMISE(answers(ATRAJ_ERR_DURATION, atraj_path_improve, &bad));
        PROMISE(answers(0, atraj_path_plan, &bad));
    }
    return 0;
}

static int possible(const atraj_state *states, const a_float *durations, const atraj_limits *limits, size_t step, size_t sections)
{
    size_t k;
    for (k = 0; k < sections; ++k)
    {
        atraj_move moves[AXES];
        const a_float t = durations[k];
        PROMISE(atraj_moves_sync(moves, limits + k * step, states + k * AXES, states + (k + 1) * AXES, AXES, t, 0) >= 0);
        PROMISE(A_ABS(moves[0].t - t) <= A_FLOAT_C(1e-3) * t);
    }
    return 0;
}

/* The memory has room for exactly as many numbers as the size says. */
static int plans(void)
{
    struct path path = good();
    a_float work[SIZE + 1];
    a_float t;
    work[SIZE] = 77;
    PROMISE(atraj_path_plan(path.states, path.durations, path.limits, AXES, SECTIONS, 0, work) == 0);
    PROMISE(work[SIZE] == 77);
    PROMISE(!possible(path.states, path.durations, path.limits, 0, SECTIONS));
    t = sum(path.durations, SECTIONS);
    PROMISE(t > A_FLOAT_C(7.73) && t < A_FLOAT_C(7.74));
    PROMISE(atraj_path_plan(path.states, path.durations, path.limits, AXES, SECTIONS, 1, work) == 0);
    PROMISE(sum(path.durations, SECTIONS) > 9);
    PROMISE(atraj_path_improve(path.states, path.durations, path.limits, AXES, SECTIONS, 0, work) == 0);
    PROMISE(work[SIZE] == 77);
    PROMISE(!possible(path.states, path.durations, path.limits, 0, SECTIONS));
    PROMISE(sum(path.durations, SECTIONS) < A_FLOAT_C(7.74));
    return 0;
}

/* The window moves on by a section: drop the first one, append one that is at rest at both ends. */
static int goes_on(void)
{
    struct path path = good();
    a_float work[SIZE], t;
    int round, k;
    for (k = 0; k < AXES; ++k) { path.states[SECTIONS * AXES + k].v = path.states[SECTIONS * AXES + k].a = 0; }
    PROMISE(atraj_path_plan(path.states, path.durations, path.limits, AXES, SECTIONS, 0, work) == 0);
    for (round = 0; round < 10; ++round)
    {
        memmove(path.states, path.states + AXES, sizeof(path.states) - AXES * sizeof(path.states[0]));
        memmove(path.durations, path.durations + 1, sizeof(path.durations) - sizeof(path.durations[0]));
        for (k = 0; k < AXES; ++k) { path.states[SECTIONS * AXES + k].p += (a_float)((round + k) % 3 - 1) / 2; }
        path.durations[SECTIONS - 1] = 0;
        PROMISE(atraj_path_improve(path.states, path.durations, path.limits, AXES, SECTIONS, 4, work) == 0);
        PROMISE(!possible(path.states, path.durations, path.limits, 0, SECTIONS));
        t = sum(path.durations, SECTIONS);
        PROMISE(atraj_path_improve(path.states, path.durations, path.limits, AXES, SECTIONS, 4, work) == 0);
        PROMISE(sum(path.durations, SECTIONS) <= t);
        PROMISE(!possible(path.states, path.durations, path.limits, 0, SECTIONS));
    }
    return 0;
}

static int zones(void)
{
    struct path path = good();
    a_float work[SIZE], t;
    int k;
    PROMISE(atraj_path_plan_zones(path.states, path.durations, path.limits, AXES, SECTIONS, 0, work) == 0);
    t = path.durations[1];
    for (k = 0; k < AXES; ++k) { path.limits[AXES + k].vmax /= 4, path.limits[AXES + k].vmin /= 4; }
    PROMISE(atraj_path_plan_zones(path.states, path.durations, path.limits, AXES, SECTIONS, 0, work) == 0);
    PROMISE(!possible(path.states, path.durations, path.limits, AXES, SECTIONS));
    PROMISE(path.durations[1] > 2 * t);
    for (k = AXES; k < 3 * AXES; ++k) { PROMISE(A_ABS(path.states[k].v) <= path.limits[AXES + k % AXES].vmax); }
    return 0;
}

int main(void)
{
    return sizes() || refused_pointers() || refused_numbers() || plans() || goes_on() || zones();
}
