/*
 What JavaScript lacks to call the library: places for the structs, and their fields. The page calls every other function of the
 C ABI itself.
*/
#include "atraj.h"

#define NAN __builtin_nan("")

enum { PLANS = 2, AXES = 3, MOVES = 16, PATH_AXES = 2, POINTS = MOVES / PATH_AXES + 1, SAMPLES = 2000, QUANTITIES = 4 };

static union {
    a_trajbell bell;
    a_trajtrap trap;
    a_trajpoly3 poly3;
    a_trajpoly5 poly5;
    a_trajpoly7 poly7;
} plans[PLANS];
static atraj_move moves[MOVES];
static atraj_group groups[2];
static atraj_limits limits[AXES];
static atraj_move room[3 * AXES];
static atraj_state from[AXES], to[AXES], own[AXES], now[AXES], states[POINTS * PATH_AXES];
static a_float durations[POINTS - 1];
static a_float tolerances[(POINTS - 2) * PATH_AXES];
static a_float work[ATRAJ_PATH_SIZE_NEAR(PATH_AXES, POINTS - 1)];
static a_float samples[QUANTITIES][SAMPLES];

int axis_count(void) { return AXES; }
int move_count(void) { return MOVES; }
int point_count(void) { return POINTS; }
int sample_count(void) { return SAMPLES; }

/* Whether a finding is a fault of the move; the others are properties of it. A finding that is not named here fails the build. */
int is_fault(enum atraj_finding finding)
{
    switch (finding)
    {
        case ATRAJ_EXCEEDS_JERK:
        case ATRAJ_EXCEEDS_ACCELERATION:
        case ATRAJ_EXCEEDS_VELOCITY:
        case ATRAJ_JUMPS: return 1;
        case ATRAJ_OVERSHOOTS:
        case ATRAJ_STARTS_OUTSIDE:
        case ATRAJ_ENDS_LEAVING:
        case ATRAJ_RATE_NOT_REACHED: return 0;
    }
    return 0;
}

int starts_outside(void) { return ATRAJ_STARTS_OUTSIDE; }
int limits_refused(void) { return ATRAJ_ERR_LIMITS; }
int unreachable(void) { return ATRAJ_ERR_UNREACHABLE; }
int tick_ends(void) { return ATRAJ_TICK_ENDS; }

/* Places. The page asks for no index beyond the counts above. */
void *plan_at(int i) { return &plans[i]; }
atraj_move *move_at(int i) { return &moves[i]; }
atraj_limits *limits_at(int i) { return &limits[i]; }
atraj_state *from_at(int i) { return &from[i]; }
atraj_state *to_at(int i) { return &to[i]; }
/* The group that runs and its copy, the memory of both, and the states of its axes in a tick. */
atraj_group *group_at(int i) { return &groups[i]; }
atraj_move *room_at(void) { return room; }
atraj_state *own_at(int i) { return &own[i]; }
atraj_state *now_at(void) { return now; }
/* The state of an axis at a waypoint, the durations of the sections between them, and the memory to plan them. */
atraj_state *state_at(int point, int axis) { return &states[point * PATH_AXES + axis]; }
a_float *durations_at(void) { return durations; }
/* The zones of all axes and waypoints become `size`. */
a_float *zones_at(a_float size)
{
    for (size_t i = 0; i < A_LEN(tolerances); ++i) { tolerances[i] = size; }
    return tolerances;
}
a_float *work_at(void) { return work; }
a_float duration_of(int section) { return durations[section]; }
a_float *samples_at(int quantity) { return samples[quantity]; }

void set_limits(atraj_limits *ctx, a_float vmax, a_float vmin, a_float amax, a_float amin, a_float jmax, a_float jmin)
{
    atraj_limits const given = {vmax, vmin, amax, amin, jmax, jmin};
    *ctx = given;
}

void set_state(atraj_state *ctx, a_float p, a_float v, a_float a)
{
    atraj_state const given = {p, v, a};
    *ctx = given;
}

void copy_group(atraj_group *ctx, atraj_group const *other) { *ctx = *other; }

a_float move_duration(atraj_move const *ctx) { return ctx->t; }

/* The time at which phase `i` ends; NaN behind the last one. In liba's double-S `td` is a duration, in its trapezoid a time. */
a_float move_border(atraj_move const *ctx, unsigned int i)
{
    return i < ctx->phases ? ctx->phase[i].t + ctx->phase[i].duration : NAN;
}

a_float bell_border(a_trajbell const *ctx, unsigned int i)
{
    a_float const borders[] = {
        ctx->taj, ctx->ta - ctx->taj, ctx->ta, ctx->t - ctx->td, ctx->t - ctx->td + ctx->tdj, ctx->t - ctx->tdj, ctx->t};
    return i < A_LEN(borders) ? borders[i] : NAN;
}

a_float trap_border(a_trajtrap const *ctx, unsigned int i)
{
    a_float const borders[] = {ctx->ta, ctx->td, ctx->t};
    return i < A_LEN(borders) ? borders[i] : NAN;
}
