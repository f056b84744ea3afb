/*
 What is wrong with the steps of a motor that follows a move, in 80 bits. The motor stands at the line `offset + count * step` while the axis
 is between this line and the next one. So it is wrong if at any time the axis is outside of this band.
*/
#include <math.h>

typedef long double real;

/* Start, duration, position, velocity, acceleration and jerk. */
enum { START, DURATION, POSITION, VELOCITY, ACCELERATION, JERK };

static real position(const double *phase, real z) {
    return phase[POSITION] + z * (phase[VELOCITY] + z * ((real)phase[ACCELERATION] / 2 + z * phase[JERK] / 6));
}

static real velocity(const double *phase, real z) { return phase[VELOCITY] + z * (phase[ACCELERATION] + z * phase[JERK] / 2); }

/* What may be wrong by rounding: a time, s; a position. */
struct rounding {
    double time, position;
};

/* The steps so far, and where they must have brought the motor. */
struct motor {
    const double *times;
    const int *directions;
    long left, count;
    double offset, step, before;
};

/* Takes the steps up to a time. Each must be at its line. 1: at another place; 2: out of order. */
static int take(struct motor *motor, const double *phase, real z, const struct rounding *rounding) {
    const real until = phase[START] + z;
    for (; motor->left && motor->times[0] <= until; --motor->left, ++motor->times, ++motor->directions) {
        const int up = motor->directions[0] > 0;
        const real time = motor->times[0] - (real)phase[START];
        const real line = motor->offset + (real)motor->step * (motor->count + up);
        const real slack = rounding->position + fabsl(velocity(phase, time)) * rounding->time;
        if (motor->times[0] < motor->before) { return 2; }
        if (!(fabsl(position(phase, time) - line) <= slack)) { return 1; }
        motor->before = motor->times[0];
        motor->count += up ? 1 : -1;
    }
    return 0;
}

/* 3: the axis is outside of the motor's band. */
static int outside(const struct motor *motor, const double *phase, real z, const struct rounding *rounding) {
    const real low = motor->offset + (real)motor->step * motor->count, p = position(phase, z);
    const real slack = rounding->position + fabsl(velocity(phase, z)) * rounding->time;
    return p >= low - slack && p <= low + motor->step + slack ? 0 : 3;
}

/* Follows a move of `count` phases from the line `first` on. Asks at the ends, at the turns and at `samples` times of each phase. Returns 0, or
 what is wrong: 1 to 3 as above, 4 if steps are left. */
int steps_wrong(const double phases[][6], int count, const double lines[2], long first, const double *times, const int *directions, long n,
                int samples, const double roundings[2]) {
    struct motor motor = {times, directions, n, first, lines[0], lines[1], 0};
    const struct rounding rounding = {roundings[0], roundings[1]};
    int i, k, wrong = 0;
    for (i = 0; i < count; ++i) {
        const double *phase = phases[i];
        for (k = 0; k <= samples && !wrong; ++k) {
            const real z = (real)phase[DURATION] * k / samples, next = (real)phase[DURATION] * (k + 1) / samples;
            wrong = take(&motor, phase, z, &rounding);
            if (!wrong) { wrong = outside(&motor, phase, z, &rounding); }
            if (!wrong && k < samples && (velocity(phase, z) < 0) != (velocity(phase, next) < 0)) {
                real low = z, high = next;
                int halves;
                for (halves = 0; halves < 80; ++halves) {
                    const real middle = (low + high) / 2;
                    if ((velocity(phase, middle) < 0) == (velocity(phase, z) < 0)) { low = middle; }
                    else { high = middle; }
                }
                wrong = take(&motor, phase, low, &rounding);
                if (!wrong) { wrong = outside(&motor, phase, low, &rounding); }
            }
        }
    }
    return wrong ? wrong : motor.left ? 4 : 0;
}
