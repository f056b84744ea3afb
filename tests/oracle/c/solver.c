/*
 The least duration of a motion of one axis from any state to any state, by a search through the durations, and the states of a
 planned motion, by integration of its phases.

 A mean of two motions within the limits keeps the limits and travels the mean. So the displacements of a duration form an
 interval. The displacement on its upper border is a closed form. The lower border is the upper one of the mirrored axis. The least
 duration is the first one whose interval holds the wanted displacement.

 The reference solver shares this theory with the library: the interval, the shapes of the border, the gap, the way inside
 (docs/planner.md). It shares no code. It looks at the border of many durations where the library solves equations, and adds phases up
 where the library has closed forms. A mistake of the theory would be a mistake of both. So `is_the_solver_right.rs` checks the theory:
 random motions, plans of rsruckig, and, for ends without acceleration, a bisection of the peak velocity, which knows no border.

 `long double` has a significand of 64 bits on x86 (x87), so its roundings are 2048 times finer than in `double`.
*/
#include <float.h>
#include <math.h>

#if LDBL_MANT_DIG < 64
#error the reference solver needs a long double finer than double
#endif

typedef long double real;

/* The axis, in the direction in which the upper border is asked for. */
struct axis {
    real up, down;                 /* time in which the acceleration rises, falls by 1: 0 if the jerk has no limit */
    real rise, fall, vmax, vmin;   /* limits, each of them may be infinite; the fall is positive */
    real h, v0, a0, v1, a1;        /* displacement and ends */
    real dv;                       /* v1 - v0, formed once: a difference of large velocities may be small */
    int brief;                     /* whether the motions are brief */
};

struct motion {
    int brief;                  /* whether the fields from `variation` on are left out */
    int shape;
    real duration, displacement;
    real slope;                 /* of the displacement on the border with respect to the duration */
    real velocity;              /* at the end */
    real variation;             /* sum of the magnitudes of all changes of the velocity */
    real changing;              /* how long the acceleration changes */
    real lowest, highest;       /* velocity */
    real trough, peak;          /* acceleration */
    real backwards;             /* the most that a phase of negative duration changes of the velocity: 0 but for roundings */
};

static real positive(real x) { return x > 0 ? x : 0; }
static real larger(real x, real y) { return x > y ? x : y; }
static real smaller(real x, real y) { return x < y ? x : y; }

static void begin(struct motion *motion, real velocity) {
    motion->brief = motion->shape = 0;
    motion->duration = motion->displacement = motion->variation = motion->changing = motion->slope = 0;
    motion->velocity = motion->lowest = motion->highest = velocity;
    motion->trough = motion->peak = motion->backwards = 0;
}

static void include_velocity(struct motion *motion, real v) {
    motion->lowest = smaller(motion->lowest, v);
    motion->highest = larger(motion->highest, v);
}

static void include_acceleration(struct motion *motion, real a) {
    motion->trough = smaller(motion->trough, a);
    motion->peak = larger(motion->peak, a);
}

/*
 Adds a phase in which the acceleration changes evenly. A negative duration continues the closed forms beyond their borders. The
 velocity is the highest at the ends of the phase or where the acceleration is 0.
*/
static void add(struct motion *motion, real duration, real from, real to) {
    const real v = motion->velocity;
    if (duration == 0) { return; }
    motion->displacement += duration * (v + duration * (from + from + to) / 6);
    motion->velocity = v + duration * (from + to) / 2;
    motion->duration += duration;
    if (motion->brief) { return; }
    motion->variation += fabsl(duration) * (fabsl(from) + fabsl(to)) / 2;
    if (from != to) { motion->changing += fabsl(duration); }
    if ((from > 0) != (to > 0) && from != to) {
        include_velocity(motion, v + duration * from / (from - to) * from / 2);
    }
    include_velocity(motion, motion->velocity);
    include_acceleration(motion, from);
    include_acceleration(motion, to);
    motion->backwards = larger(motion->backwards, -duration * (from == to ? fabsl(from) : fabsl(to - from)));
}

static real speed(const struct motion *motion) { return larger(motion->highest, -motion->lowest); }

static struct axis mirrored(const struct axis *x) {
    return (struct axis){
        .up = x->down, .down = x->up, .rise = x->fall, .fall = x->rise, .vmax = -x->vmin, .vmin = -x->vmax,
        .h = -x->h, .v0 = -x->v0, .a0 = -x->a0, .v1 = -x->v1, .a1 = -x->a1, .dv = -x->dv, .brief = x->brief};
}

/*
 A ramp between an acceleration and 0 on the side of the highest velocity: the acceleration `peak` that it reaches, and how long it
 holds. `change` is the change of velocity, `a` the acceleration at the other end of the ramp.
*/
static real ramp_peak(const struct axis *axis, real change, real a, real limit, real *hold) {
    const real mean = (axis->up + axis->down) / 2;
    const real beyond = positive(change + axis->up * a * a / 2);
    const real peak = mean > 0 ? sqrtl(beyond / mean) : INFINITY;
    *hold = 0;
    if (peak <= limit) { return larger(peak, positive(a)); }
    *hold = positive((beyond - mean * limit * limit) / limit);
    return larger(limit, a);
}

/* The phases from both ends to an acceleration of `peak`, which holds, and one of `trough`. Between them the axis may cruise. */
static struct motion of_phases(const struct axis *axis, real peak, real top, real cruise, real trough, real bottom) {
    struct motion motion;
    begin(&motion, axis->v0);
    motion.brief = axis->brief;
    add(&motion, axis->up * (peak - axis->a0), axis->a0, peak);
    add(&motion, top, peak, peak);
    if (cruise < 0) {
        add(&motion, axis->down * (peak - trough), peak, trough);
    } else {
        add(&motion, axis->down * peak, peak, 0);
        add(&motion, cruise, 0, 0);
        add(&motion, -axis->down * trough, 0, trough);
    }
    add(&motion, bottom, trough, trough);
    add(&motion, axis->up * (axis->a1 - trough), trough, axis->a1);
    return motion;
}

/* The motion that cruises at vmax for so long. */
static struct motion by_way_of_vmax(const struct axis *axis, real cruise) {
    struct motion motion;
    real top, bottom;
    const real peak = ramp_peak(axis, axis->vmax - axis->v0, axis->a0, axis->rise, &top);
    const real trough = -ramp_peak(axis, axis->vmax - axis->v1, -axis->a1, axis->fall, &bottom);
    motion = of_phases(axis, peak, top, cruise, trough, bottom);
    motion.shape = 5;
    motion.slope = axis->vmax;
    return motion;
}

/* How long the shortest motion that reaches vmax lasts. */
static real cruise_begins(const struct axis *axis) {
    return isinf(axis->vmax) ? INFINITY : by_way_of_vmax(axis, 0).duration;
}

enum { NO_HOLD, TOP, BOTTOM, BOTH };

/*
 The motion of this duration that covers the largest displacement, if it does not cruise: the acceleration rises to `peak`, (holds), falls to
 `trough`, (holds) and rises. Two equations determine it. The durations add up to the whole one, the changes of velocity to `dv`.
*/
static struct motion without_cruise(const struct axis *axis, real duration) {
    const real rise = axis->rise, fall = axis->fall, a0 = axis->a0, a1 = axis->a1;
    const real both = axis->up + axis->down;
    /* What the phases last, and change, besides a rise from a0 to a1. */
    const real time = duration - axis->up * (a1 - a0);
    const real change = axis->dv - axis->up * (a1 - a0) * (a1 + a0) / 2;
    real peak = INFINITY, trough = -INFINITY, top = 0, bottom = 0, u;
    struct motion motion;
    int shape = NO_HOLD;
    if (both > 0) {
        const real mean = time > 0 ? change / time : a1;
        peak = mean + time / both / 2;
        trough = mean - time / both / 2;
    }
    if (peak > rise || trough < -fall) {
        const real rest = time - both * (rise + fall);
        if (rest >= 0) {
            const real beyond = change - both / 2 * (rise - fall) * (rise + fall);
            top = (beyond + fall * rest) / (rise + fall);
            bottom = (rise * rest - beyond) / (rise + fall);
            shape = top < 0 ? BOTTOM : bottom < 0 ? TOP : BOTH;
        } else { shape = peak > rise ? TOP : BOTTOM; }
    }
    if (shape == BOTH) { peak = rise, trough = -fall; }
    else if (shape == TOP) {
        u = sqrtl(positive(2 / both * (rise * time - change)));
        peak = rise, trough = rise - u;
        top = time - both * u, bottom = 0;
    } else if (shape == BOTTOM) {
        u = sqrtl(positive(2 / both * (fall * time + change)));
        peak = u - fall, trough = -fall;
        bottom = time - both * u, top = 0;
    }
    motion = of_phases(axis, peak, top, -1, trough, bottom);
    motion.shape = shape;
    /* By the maximum principle: the weight of the velocity is 0 in the middle of the fall. */
    motion.slope = axis->v1 - axis->up * (a1 - trough) * (a1 + trough) / 2
        - trough * (axis->down * (peak - trough) / 2 + bottom);
    return motion;
}

/* The motion of this duration that covers the largest displacement. */
static struct motion border(const struct axis *axis, real duration, real cruise) {
    return duration >= cruise ? by_way_of_vmax(axis, duration - cruise) : without_cruise(axis, duration);
}

/* The straight change from a0 to a1, by jerk alone. */
struct straight {
    real duration, change;
};

static struct straight straight(const struct axis *axis) {
    const real time = axis->a1 > axis->a0 ? axis->up : axis->down;
    const real duration = fabsl(axis->a1 - axis->a0) * time;
    return (struct straight){duration, duration * (axis->a0 + axis->a1) / 2};
}

/* The change of velocity by way of an acceleration that is `excess` above both ends, and there holds. */
static struct motion excursion(const struct axis *axis, real excess, real hold) {
    const real peak = larger(axis->a0, axis->a1) + excess;
    struct motion motion;
    begin(&motion, axis->v0);
    add(&motion, axis->up * (peak - axis->a0), axis->a0, peak);
    add(&motion, hold, peak, peak);
    add(&motion, axis->down * (peak - axis->a1), peak, axis->a1);
    return motion;
}

/*
 An excursion by `e` above the larger acceleration `m` lasts `both e` longer than the straight change, and changes the velocity by
 `both (m e + e^2/2)` more. This is the larger `e` for a change, cut at the limit.
*/
static struct motion upwards(const struct axis *axis) {
    const real both = axis->up + axis->down, m = larger(axis->a0, axis->a1), most = positive(axis->rise - m);
    const real beyond = axis->dv - straight(axis).change;
    const real d = both > 0 ? m * m + 2 * beyond / both : INFINITY;
    const real root = sqrtl(positive(d));
    real excess, hold = 0;
    if (beyond == 0) { excess = positive(-2 * m); }
    else { excess = both > 0 ? m > 0 ? 2 * beyond / both / (m + root) : root - m : INFINITY; }
    if (excess > most) {
        excess = most;
        hold = positive((beyond - both * most * (m + most / 2)) / (m + most));
    }
    return excursion(axis, positive(excess), hold);
}

/* The durations in which the end can be reached: from T0 to T1, and from T2 on. Without a gap T1 is infinite. */
struct pieces {
    real t0, t1, t2;
    struct motion at[3];
};

/* The same for a change of velocity that is not below the straight one. */
static void pieces_upwards(const struct axis *axis, struct pieces *pieces) {
    const real both = axis->up + axis->down;
    const real beyond = axis->dv - straight(axis).change;
    const real m = smaller(axis->a0, axis->a1);
    const real r = both > 0 ? m * m - 2 * beyond / both : -1;
    pieces->at[0] = upwards(axis);
    pieces->t1 = INFINITY;
    if (m > 0 && r >= 0) {
        /* A dip below both accelerations: in the mirrored axis an excursion above them. */
        const struct axis other = mirrored(axis);
        const real dip = 2 * beyond / both / (m + sqrtl(r));
        pieces->at[1] = excursion(&other, dip, 0);
        pieces->at[2] = upwards(&other);
        pieces->t1 = larger(pieces->at[1].duration, pieces->at[0].duration);
        pieces->t2 = pieces->at[2].duration;
        pieces->at[1].displacement = -pieces->at[1].displacement;
        pieces->at[2].displacement = -pieces->at[2].displacement;
    }
    pieces->t0 = pieces->at[0].duration;
}

static struct pieces pieces_of(const struct axis *axis) {
    struct pieces pieces;
    int i;
    if (axis->dv >= straight(axis).change && !(axis->dv == straight(axis).change && axis->a0 < 0 && axis->a1 < 0)) {
        pieces_upwards(axis, &pieces);
    } else {
        const struct axis other = mirrored(axis);
        pieces_upwards(&other, &pieces);
        for (i = 0; i < (isinf(pieces.t1) ? 1 : 3); ++i) { pieces.at[i].displacement = -pieces.at[i].displacement; }
    }
    return pieces;
}

/* Whether the end cannot be reached in a duration: it is before the first one, or in the gap. */
static int is_out(const struct pieces *pieces, real duration) {
    return duration < pieces->t0 || (!isinf(pieces->t1) && duration > pieces->t1 && duration < pieces->t2);
}

/* When the search looks: first this part of the beginning later, then always this factor later. */
struct grid {
    double part, factor;
};

/* A part of the upper border from the duration `from` on, up to `span` later. Its motions are brief. */
struct search {
    struct axis axis;
    real from, span, cruise;
};

static struct motion at(const struct search *search, real x) {
    return border(&search->axis, search->from + x, search->cruise);
}

enum { BITS = 46 };

/*
 Where the displacement, which is below `h` at `low`, reaches it before `high`. The secant finds it soon. An end that stays counts half
 the next time (Illinois), so that both ends come near, and every fourth round halves.
*/
static real crossing(const struct search *search, real low, real high) {
    const real h = search->axis.h;
    real below = h - at(search, low).displacement, above = at(search, high).displacement - h;
    real under = below, over = above, part;
    int round, last = 0;
    for (round = 1; round < 4 * BITS; ++round) {
        const real little = ldexpl(search->from + high, -BITS);
        real middle = low + (high - low) / 2, displacement;
        if (!(high - low > little)) { break; }
        if (round % 4 && under + over > 0) { middle = low + (high - low) * (under / (under + over)); }
        middle = larger(low + little / 2, smaller(high - little / 2, middle));
        displacement = at(search, middle).displacement;
        if (displacement >= h) {
            high = middle, over = above = displacement - h;
            if (last > 0) { under /= 2; }
            last = 1;
        } else {
            low = middle, under = below = h - displacement;
            if (last < 0) { over /= 2; }
            last = -1;
        }
    }
    part = below / (below + above);
    return below + above > 0 ? low + (high - low) * smaller(1, positive(part)) : high;
}

/* Where the displacement, which rises at `low` and falls at `high`, is the highest. */
static real highest(const struct search *search, real low, real high) {
    int round;
    for (round = 0; round < BITS; ++round) {
        const real middle = low + (high - low) / 2;
        if (at(search, middle).slope > 0) { low = middle; }
        else { high = middle; }
    }
    return low;
}

enum { MOST_STEPS = 100000 };

/*
 Where the displacement, which is below `h` at the beginning of the part, first reaches it. Durations of the grid are tried. Where the
 displacement stops to rise between two of them, its highest value is looked at. Negative if there is no such place up to the end of
 the part.
*/
static real first(const struct search *search, const struct grid *grid) {
    const real h = search->axis.h;
    real low = 0, x = search->from > 0 ? search->from * grid->part : 1;
    real slope;
    int step;
    if (!(search->span > 0)) { return -1; }
    while (search->from == 0 && at(search, x).displacement >= h && x > LDBL_MIN * 1024) { x /= 256; }
    slope = at(search, 0).slope;
    for (step = 0; step < MOST_STEPS; ++step, x *= grid->factor) {
        const real high = smaller(x, search->span);
        const struct motion motion = at(search, high);
        if (motion.displacement >= h) { return crossing(search, low, high); }
        if (slope > 0 && motion.slope <= 0) {
            const real top = highest(search, low, high);
            if (at(search, top).displacement >= h) { return crossing(search, low, top); }
        }
        if (high == search->span) { return -1; }
        low = high;
        slope = motion.slope;
    }
    return -1;
}

/*
 The fastest motion of a duration from `from` up to `to`; `base` has the duration `from`. The motion is seen from the other side if the
 target is nearer than the end of `base`. Returns 0 if there is none.
*/
static int first_of_piece(
    const struct axis *axis, real from, real to, const struct motion *base, const struct grid *grid, struct motion *found) {
    const struct axis seen = axis->h < base->displacement ? mirrored(axis) : *axis;
    struct search search;
    real x;
    if (axis->h == base->displacement) { *found = *base; return 1; }
    search = (struct search){seen, from, 0, cruise_begins(&seen)};
    search.axis.brief = 1;
    search.span = smaller(search.cruise, to) - from;
    x = first(&search, grid);
    if (x < 0 && to < INFINITY) { return 0; }
    if (x < 0) {
        /* The axis cruises. */
        x = larger(search.cruise, from) - from;
        x += positive((seen.h - at(&search, x).displacement) / seen.vmax);
    }
    *found = border(&seen, from + x, search.cruise);
    return 1;
}

/* Seconds of the motion inside, and its changes of the state. */
struct inside {
    real duration, displacement, speed, variation, changing, acceleration;
};

/*
 Brings the start of the axis to a state from which the limits can be kept: the acceleration within its limits, and once it is 0 it leaves
 the velocity within its limits. The jerk and the acceleration are the highest. `high` and `low` tell whether the axis is bound to
 leave, `at_zero_a` is the velocity once the acceleration is 0.
*/
static struct inside come_inside(struct axis *axis) {
    const real a = axis->a0, both = axis->up + axis->down;
    const real high = axis->v0 + (a > 0 ? axis->down : -axis->up) * a * a / 2 - axis->vmax;
    struct motion motion;
    begin(&motion, axis->v0);
    if (high > 0) {
        /* Down to the acceleration -e at which rising to 0 ends at vmax. */
        const real beyond = axis->v0 + axis->down * a * a / 2 - axis->vmax;
        const real e = both > 0 ? sqrtl(2 * beyond / both) : INFINITY;
        const real limited = smaller(e, axis->fall);
        add(&motion, (-a < limited ? axis->down : axis->up) * fabsl(a + limited), a, -limited);
        axis->a0 = -limited;
        if (e > axis->fall) {
            const real over = motion.velocity - axis->up * limited * limited / 2 - axis->vmax;
            add(&motion, positive(over / limited), -limited, -limited);
        }
    } else if (a > axis->rise && axis->v0 + axis->down * a * a / 2 >= axis->vmin) {
        add(&motion, axis->down * (a - axis->rise), a, axis->rise);
        axis->a0 = axis->rise;
    }
    axis->dv -= motion.velocity - axis->v0;
    axis->h -= motion.displacement;
    axis->v0 = motion.velocity;
    if (both == 0) { axis->a0 = 0; }
    return (struct inside){motion.duration, motion.displacement, speed(&motion), motion.variation, motion.changing,
                           larger(fabsl(a), larger(motion.peak, -motion.trough))};
}

/*
 The axis of a problem, seen from a frame that moves at `frame`. The target is `offset[0]` further and `offset[1]` faster, and the start
 is `offset[2]` faster.
*/
static struct axis axis_of(const double limits[6], const double start[3], const double target[3], const double offset[3], double frame) {
    struct axis axis = {
        .up = 1 / (real)limits[4], .down = -1 / (real)limits[5], .rise = limits[2], .fall = -(real)limits[3],
        .vmax = (real)limits[0] - frame, .vmin = (real)limits[1] - frame,
        .h = ((real)target[0] - (real)start[0]) + offset[0],
        .v0 = ((real)start[1] - frame) + offset[2], .v1 = ((real)target[1] - frame) + offset[1],
        .dv = ((real)target[1] - (real)start[1]) + ((real)offset[1] - offset[2]),
        .a0 = start[2], .a1 = target[2]};
    /* Without jerk limits accelerations do not count. */
    if (axis.up + axis.down == 0) { axis.a0 = axis.a1 = 0; }
    return axis;
}

static const double none[3] = {0, 0, 0};

static struct inside bring_inside(struct axis *axis) {
    struct inside inside = come_inside(axis);
    if (inside.duration == 0) {
        struct axis other = mirrored(axis);
        inside = come_inside(&other);
        inside.displacement = -inside.displacement;
        *axis = mirrored(&other);
    }
    return inside;
}

enum {
    DURATION, SPEED, VARIATION, CHANGING, INSIDE, T0, T1, T2, PAST_T0, PAST_T1, PAST_T2,
    STRAIGHT, PAST_STRAIGHT, FASTER, WRONG, RESULTS
};

/*
 What is wrong with the motion that was found: the largest relative error of its end and of its limits, and what phases of negative
 duration change of the velocity. A closed form outside of its range has a large error. The velocities on the way inside leave roundings
 in those behind it.
*/
static real wrong(const struct axis *axis, const struct inside *inside, const struct motion *found, int mirror) {
    const struct axis other = mirrored(axis);
    const struct axis *seen = mirror ? &other : axis;
    const real v = larger(1e-4000L, larger(inside->speed, speed(found) + found->variation));
    const real a = larger(1e-4000L, larger(found->peak, -found->trough));
    real most = fabsl(found->velocity - seen->v1) / v;
    most = larger(most, fabsl(found->displacement - seen->h) / larger(1e-4000L, v * found->duration));
    most = larger(most, (found->highest - larger(seen->vmax, seen->v0)) / v);
    most = larger(most, (smaller(seen->vmin, seen->v0) - found->lowest) / v);
    most = larger(most, larger(found->peak - seen->rise, -seen->fall - found->trough) / a);
    return larger(most, found->backwards / v);
}

/*
 The fastest motion. Results: its duration, its highest speed, the sum of the magnitudes of all its changes of velocity; its highest
 acceleration times how long the acceleration changes; how long the recovery lasts; the durations T0, T1, T2 from the start on (T1 and T2
 infinite without a gap), and how much further than the displacements there the target is; the duration of the straight change of the
 acceleration, and how much further and faster than its end the target is.
*/
void solver_fastest(
    const double limits[6], const double start[3], const double target[3], const double offset[3], double frame, const struct grid *grid,
    double results[RESULTS]) {
    struct axis axis = axis_of(limits, start, target, offset, frame);
    const struct inside inside = bring_inside(&axis);
    const struct pieces pieces = pieces_of(&axis);
    const int gap = !isinf(pieces.t1);
    const struct motion *base = &pieces.at[0];
    const struct straight line = straight(&axis);
    struct motion found, ramp;
    if (!first_of_piece(&axis, pieces.t0, pieces.t1, base, grid, &found)) {
        base = &pieces.at[2];
        first_of_piece(&axis, pieces.t2, INFINITY, base, grid, &found);
    }
    results[DURATION] = (double)(inside.duration + found.duration);
    results[SPEED] = (double)(larger(inside.speed, speed(&found)) + fabsl(frame));
    results[VARIATION] = (double)(inside.variation + found.variation);
    results[CHANGING] = (double)(larger(inside.acceleration, larger(found.peak, -found.trough)) * (inside.changing + found.changing));
    results[INSIDE] = (double)inside.duration;
    results[T0] = (double)(inside.duration + pieces.t0);
    results[T1] = gap ? (double)(inside.duration + pieces.t1) : INFINITY;
    results[T2] = gap ? (double)(inside.duration + pieces.t2) : INFINITY;
    begin(&ramp, axis.v0);
    add(&ramp, line.duration, axis.a0, axis.a1);
    results[STRAIGHT] = (double)(inside.duration + line.duration);
    results[PAST_STRAIGHT] = (double)(axis.h - ramp.displacement);
    results[FASTER] = (double)(axis.dv - line.change);
    results[WRONG] = axis.h == base->displacement ? 0 : (double)wrong(&axis, &inside, &found, axis.h < base->displacement);
    results[PAST_T0] = (double)(axis.h - pieces.at[0].displacement);
    results[PAST_T1] = gap ? (double)(axis.h - pieces.at[1].displacement) : INFINITY;
    results[PAST_T2] = gap ? (double)(axis.h - pieces.at[2].displacement) : INFINITY;
}

/* The lowest and the highest displacement in which an axis within its limits can take a duration. Returns 0 if there is none. */
static int displacements(const struct axis *axis, real duration, real interval[2]) {
    const struct pieces pieces = pieces_of(axis);
    const struct axis other = mirrored(axis);
    if (is_out(&pieces, duration)) { return 0; }
    interval[0] = -border(&other, duration, cruise_begins(&other)).displacement;
    interval[1] = border(axis, duration, cruise_begins(axis)).displacement;
    return 1;
}

/*
 How much further the target is than the displacements of this duration: negative if it is nearer, 0 if it is among them, infinite if the
 duration is before the first possible one or in the gap. The target is `offset[0]` further and `offset[1]` faster, and the start is
 `offset[2]` faster.
*/
double solver_possible(
    const double limits[6], const double start[3], const double target[3], const double offset[3], double duration) {
    struct axis axis = axis_of(limits, start, target, offset, 0);
    const struct inside inside = bring_inside(&axis);
    real all[2];
    axis.brief = 1;
    if (!displacements(&axis, duration - inside.duration, all)) { return INFINITY; }
    return (double)(axis.h > all[1] ? axis.h - all[1] : axis.h < all[0] ? axis.h - all[0] : 0);
}

/* The displacements from the start that can be reached in this duration: the lowest and the highest. Returns 0 if none can. */
int solver_interval(
    const double limits[6], const double start[3], const double target[3], double duration, double interval[2]) {
    struct axis axis = axis_of(limits, start, target, none, 0);
    const struct inside inside = bring_inside(&axis);
    real all[2];
    if (!displacements(&axis, duration - inside.duration, all)) { return 0; }
    interval[0] = (double)(inside.displacement + all[0]), interval[1] = (double)(inside.displacement + all[1]);
    return 1;
}

/*
 The displacements from the start at which the border changes its shape: on the upper border, or on the lower one if `lower`. Returns
 how many there are, at most 8. The last one is where the axis begins to cruise.
*/
int solver_knees(const double limits[6], const double start[3], const double target[3], int lower, double knees[8]) {
    struct axis axis = axis_of(limits, start, target, none, 0);
    const struct inside inside = bring_inside(&axis);
    const struct pieces pieces = pieces_of(&axis);
    const real sign = lower ? -1 : 1;
    real low = pieces.t0, cruise, end;
    int count = 0, shape, step;
    if (lower) { axis = mirrored(&axis); }
    axis.brief = 1;
    cruise = cruise_begins(&axis);
    if (!isinf(pieces.t1)) { low = pieces.t2; }
    end = isinf(cruise) ? 2 * low + 1 : cruise;
    shape = border(&axis, low, cruise).shape;
    for (step = 1; step <= 64 && count < 8; ++step) {
        real high = step == 64 ? end : low + (end - low) / (65 - step);
        const real next = high;
        int round;
        if (border(&axis, high, cruise).shape == shape) { low = next; continue; }
        for (round = 0; round < 64; ++round) {
            const real middle = low + (high - low) / 2;
            if (border(&axis, middle, cruise).shape == shape) { low = middle; }
            else { high = middle; }
        }
        knees[count++] = (double)(inside.displacement * sign + border(&axis, high, cruise).displacement) * (double)sign;
        shape = border(&axis, next, cruise).shape;
        low = next;
    }
    return count;
}

/* Time, position, velocity and acceleration. */
struct knot {
    real t, p, v, a;
};

static void note(double knots[][4], int *count, const struct knot *knot) {
    double *out = knots[(*count)++];
    out[0] = (double)knot->t, out[1] = (double)knot->p, out[2] = (double)knot->v, out[3] = (double)knot->a;
}

static struct knot later(const struct knot *knot, real jerk, real t) {
    const real p = knot->p + ((jerk * t / 6 + knot->a / 2) * t + knot->v) * t;
    return (struct knot){knot->t + t, p, knot->v + (jerk * t / 2 + knot->a) * t, knot->a + jerk * t};
}

/* Where in a phase the velocity or the acceleration is 0: up to three times in order. */
static int turns(const struct knot *knot, real jerk, real duration, real out[3]) {
    const real d = knot->a * knot->a - 2 * knot->v * jerk;
    const real sum = -(knot->a + copysignl(sqrtl(positive(d)), knot->a));
    const real times[3] = {-knot->a / jerk, d >= 0 ? 2 * knot->v / sum : 0, d >= 0 ? sum / jerk : 0};
    int i, k, count = 0;
    for (i = 0; i < 3; ++i) {
        if (!(times[i] > 0 && times[i] < duration)) { continue; }
        for (k = count++; k > 0 && out[k - 1] > times[i]; --k) { out[k] = out[k - 1]; }
        out[k] = times[i];
    }
    return count;
}

/*
 Integrates phases, each `duration, acceleration at its start, jerk`, from the start of a motion. Each phase begins with its own
 acceleration: a rounding of the phase before would grow with the time.
 Results: the state where each phase begins, as the phases before it leave the axis, and the state at the end; and the knots in order
 of time: these states, once more with the acceleration of the phase, the highest and the lowest velocities, and where the axis turns.
 Returns the number of knots.
*/
int solver_walk(
    const double start[3], const double phases[][3], int count, double borders[][3], double knots[][4]) {
    struct knot knot = {0, start[0], start[1], start[2]};
    int i, k, noted = 0;
    for (i = 0; i <= count; ++i) {
        borders[i][0] = (double)knot.p, borders[i][1] = (double)knot.v, borders[i][2] = (double)knot.a;
        note(knots, &noted, &knot);
        knot.a = phases[i][1];
        note(knots, &noted, &knot);
        if (i < count) {
            const real duration = phases[i][0], jerk = phases[i][2];
            real turn[3];
            const int turned = turns(&knot, jerk, duration, turn);
            for (k = 0; k < turned; ++k) {
                const struct knot turning = later(&knot, jerk, turn[k]);
                note(knots, &noted, &turning);
            }
            knot = later(&knot, jerk, duration);
        }
    }
    return noted;
}

/* Velocity and acceleration at both ends, and the duration. */
enum { POINT = 5 };

/* How far a motion gets from the state `point[0], point[1]` to `point[2], point[3]` in the duration `point[4]`, and the shape of the motion. */
static real farthest(struct axis axis, const real point[POINT], int *shape) {
    real cruise;
    struct motion motion;
    axis.v0 = point[0], axis.a0 = point[1], axis.v1 = point[2], axis.a1 = point[3];
    axis.dv = axis.v1 - axis.v0;
    cruise = cruise_begins(&axis);
    motion = border(&axis, point[4], cruise);
    *shape = point[4] < cruise ? motion.shape : 4 + 2 * (motion.peak >= axis.rise) + (motion.trough <= -axis.fall);
    return motion.displacement;
}

/* The same near a point: `i` is `x` larger, and then `j` is `y` larger. Clears `same` if the shape is another one. */
static real near(const struct axis *axis, const real point[POINT], int i, real x, int j, real y, int shape, int *same) {
    real moved[POINT], displacement;
    int k, found;
    for (k = 0; k < POINT; ++k) { moved[k] = point[k]; }
    moved[i] += x;
    moved[j] += y;
    displacement = farthest(*axis, moved, &found);
    *same = *same && found == shape;
    return displacement;
}

/*
 The derivatives of how far the upper border is from the start, or the lower one in the other direction, by velocity and acceleration at
 the start, at the end, and by the duration; and those by two of them, row by row up to the diagonal. They are differences. Returns the
 shape, or -1 where it changes or no motion has this duration.
*/
int solver_derivatives(
    const double limits[6], const double start[3], const double target[3], double duration, int lower, double first[5], double second[15]) {
    struct axis axis = axis_of(limits, start, target, none, 0);
    const struct pieces pieces = pieces_of(&axis);
    const real sign = lower ? -1 : 1, step = 1 / 32768.0L;
    real point[POINT];
    int i, j, shape, same = 1, entry = 0;
    if (bring_inside(&axis).duration > 0 || is_out(&pieces, duration)) { return -1; }
    if (lower) { axis = mirrored(&axis); }
    point[0] = axis.v0, point[1] = axis.a0, point[2] = axis.v1, point[3] = axis.a1, point[4] = duration;
    farthest(axis, point, &shape);
    for (i = 0; i < POINT; ++i) {
        real slopes[2];
        for (j = 0; j < 2; ++j) {
            const real x = step / (1 + j);
            slopes[j] = (near(&axis, point, i, x, i, 0, shape, &same) - near(&axis, point, i, -x, i, 0, shape, &same)) / (2 * x);
        }
        /* The error of a difference is about a multiple of the square of the step. */
        first[i] = (double)((i < 4 ? sign : 1) * (4 * slopes[1] - slopes[0]) / 3);
        for (j = 0; j <= i; ++j, ++entry) {
            real bends[2];
            int k;
            for (k = 0; k < 2; ++k) {
                const real x = step / (1 + k);
                const real up = near(&axis, point, i, x, j, x, shape, &same) - near(&axis, point, i, x, j, -x, shape, &same);
                const real down = near(&axis, point, i, -x, j, x, shape, &same) - near(&axis, point, i, -x, j, -x, shape, &same);
                bends[k] = (up - down) / (4 * x * x);
            }
            second[entry] = (double)((i == 4 && j < 4 ? sign : 1) * (4 * bends[1] - bends[0]) / 3);
        }
    }
    return same ? shape : -1;
}
