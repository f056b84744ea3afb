/*
 Tests the contract of every function of atraj/clock.h. Each pointer is once NULL, each number once wrong; a refusal leaves the clock untouched.
 Then a hold, a reversal and a resumption of two axes, and a hold on a path of three sections. `tests/oracle` judges the limits.
 Prints the line of the first broken promise and fails.
*/
#include "atraj/clock.h"
#include "promise.h"

static const atraj_limits planned[2] = {{4, -4, 8, -8, 24, -24}, {4, -4, 8, -8, 24, -24}}, limits[2] = {{5, -5, 10, -10, 30, -30}, {5, -5, 10, -10, 30, -30}};
static const atraj_state from[2] = {{0, 0, 0}, {0, 0, 0}}, to[2] = {{10, 0, 0}, {-3, 0, 0}};
static atraj_clock clock_, before;
static atraj_move axes[2];

static int untouched(void) { return memcmp(&clock_, &before, sizeof(clock_)) == 0; }

static atraj_state state(int axis, a_float x)
{
    atraj_state now;
    atraj_clock_state(&clock_, axes + axis, 2, 1, x, &now.p, &now.v, &now.a, A_NULL);
    return now;
}

static int near_(a_float x, a_float y) { return x - y < A_FLOAT_C(1e-5) && y - x < A_FLOAT_C(1e-5); }

static int refused(void)
{
    const atraj_limits no_limits[2] = {{5, -5, 10, -10, 30, -30}, {5, -5, 0, -10, 30, -30}}, no_numbers[2] = {{5, -5, 10, -10, 30, -30}, {none, -5, 10, -10, 30, -30}};
    const atraj_limits slow[2] = {{1, -1, 10, -10, 30, -30}, {1, -1, 10, -10, 30, -30}};
    const a_float no_times[] = {endless, -endless, none};
    a_float p = 1, v = 1, a = 1, j = 1;
    int i;
    PROMISE(atraj_moves_sync(axes, planned, from, to, 2, 0, 0) == 0);
    memset(&clock_, 0, sizeof(clock_));
    atraj_clock_start(A_NULL);
    atraj_clock_start(&clock_);
    before = clock_;
    PROMISE(atraj_clock_rate(A_NULL, axes, limits, 2, 1, 1, 0) == ATRAJ_ERR_NULL);
    PROMISE(atraj_clock_rate(&clock_, A_NULL, limits, 2, 1, 1, 0) == ATRAJ_ERR_NULL);
    PROMISE(atraj_clock_rate(&clock_, axes, A_NULL, 2, 1, 1, 0) == ATRAJ_ERR_NULL);
    PROMISE(atraj_clock_rate(&clock_, axes, limits, 0, 1, 1, 0) == ATRAJ_ERR_NULL);
    PROMISE(atraj_clock_rate(&clock_, axes, limits, 2, 0, 1, 0) == ATRAJ_ERR_NULL);
    PROMISE(atraj_clock_rate(&clock_, axes, no_limits, 2, 1, 1, 0) == ATRAJ_ERR_LIMITS);
    PROMISE(atraj_clock_rate(&clock_, axes, no_numbers, 2, 1, 1, 0) == ATRAJ_ERR_NOT_FINITE);
    for (i = 0; i < (int)A_LEN(no_times); ++i)
    {
        PROMISE(atraj_clock_rate(&clock_, axes, limits, 2, 1, no_times[i], 0) == ATRAJ_ERR_NOT_FINITE);
        PROMISE(atraj_clock_rate(&clock_, axes, limits, 2, 1, 1, no_times[i]) == ATRAJ_ERR_NOT_FINITE);
    }
    PROMISE(atraj_clock_rate(&clock_, axes, slow, 2, 1, 1, 0) == ATRAJ_ERR_TARGET); /* already too fast */
    PROMISE(untouched());
    atraj_clock_state(&clock_, axes, 2, 1, 1, A_NULL, A_NULL, A_NULL, A_NULL);
    atraj_clock_state(A_NULL, axes, 2, 1, 1, &p, &v, &a, &j);
    PROMISE(p != p && v != v && a != a && j != j);
    p = v = a = j = 1;
    atraj_clock_state(&clock_, A_NULL, 2, 1, 1, &p, &v, &a, &j);
    PROMISE(p != p && v != v && a != a && j != j);
    p = v = a = j = 1;
    atraj_clock_state(&clock_, axes, 0, 1, 1, &p, &v, A_NULL, A_NULL);
    atraj_clock_state(&clock_, axes, 2, 0, 1, A_NULL, A_NULL, &a, &j);
    PROMISE(p != p && v != v && a != a && j != j);
    v = atraj_clock_until(A_NULL), p = atraj_clock_time(A_NULL, 1);
    PROMISE(v != v && p != p);
    return 0;
}

/* Holds, goes back, and goes on to the end. */
static int runs(void)
{
    atraj_state now;
    a_float until, t;
    atraj_clock_start(&clock_);
    now = state(0, 1);
    PROMISE(now.p == atraj_move_pos(axes, 1) && now.v == atraj_move_vel(axes, 1) && now.a == atraj_move_acc(axes, 1));
    PROMISE(atraj_clock_rate(&clock_, axes, limits, 2, 1, 1, 0) == 0);
    until = atraj_clock_until(&clock_);
    PROMISE(until > 1 && until < 4);
    t = atraj_clock_time(&clock_, until);
    PROMISE(t > 1 && atraj_clock_time(&clock_, until + 3) == t);
    now = state(0, until + 3);
    PROMISE(now.v == 0 && now.a == 0 && now.p == atraj_move_pos(axes, t));
    PROMISE(atraj_clock_rate(&clock_, axes, limits, 2, 1, until + 3, -A_FLOAT_C(0.5)) == 0);
    until = atraj_clock_until(&clock_);
    PROMISE(atraj_clock_time(&clock_, until + 1) < t && state(0, until).v < 0 && state(1, until).v > 0);
    now = state(1, until + 50);
    PROMISE(now.p == 0 && now.v == 0);
    PROMISE(atraj_clock_rate(&clock_, axes, limits, 2, 1, until, 1) == 0);
    until = atraj_clock_until(&clock_) + 20;
    PROMISE(state(0, until).p == 10 && state(1, until).p == -3 && state(0, until).v == 0);
    return 0;
}

/* A path of three sections, one of which takes no time. It passes 3 with a velocity; the second axis stays, and sets off behind the point. */
static int passes(void)
{
    const atraj_state points[4][2] = {{{0, 0, 0}, {1, 0, 0}}, {{3, 2, 0}, {1, 0, 0}}, {{3, 2, 0}, {1, 0, 0}}, {{9, 0, 0}, {-1, 0, 0}}};
    atraj_move path[3][2];
    atraj_state now;
    a_float until, end = 0;
    int i;
    for (i = 0; i < 3; ++i)
    {
        PROMISE(atraj_moves_sync(path[i], planned, points[i], points[i + 1], 2, 0, 0) == 0);
        end += path[i][0].t;
    }
    atraj_clock_start(&clock_);
    atraj_clock_state(&clock_, *path, 2, 3, path[0][0].t + A_FLOAT_C(0.25), &now.p, &now.v, &now.a, A_NULL);
    PROMISE(near_(now.p, atraj_move_pos(path[2], A_FLOAT_C(0.25))) && near_(now.v, atraj_move_vel(path[2], A_FLOAT_C(0.25))));
    /* The hold begins before the point and ends behind it. */
    PROMISE(atraj_clock_rate(&clock_, *path, limits, 2, 3, path[0][0].t - A_FLOAT_C(0.25), 0) == 0);
    until = atraj_clock_until(&clock_);
    PROMISE(atraj_clock_time(&clock_, until) > path[0][0].t);
    atraj_clock_state(&clock_, *path, 2, 3, until + 1, &now.p, &now.v, &now.a, A_NULL);
    PROMISE(now.p > 3 && now.p < 9 && now.v == 0 && now.a == 0);
    atraj_clock_state(&clock_, *path + 1, 2, 3, until, &now.p, A_NULL, A_NULL, A_NULL);
    PROMISE(now.p < 1 && now.p > -1);
    PROMISE(atraj_clock_rate(&clock_, *path, limits, 2, 3, until + 2, 1) == 0);
    until = atraj_clock_until(&clock_) + end;
    atraj_clock_state(&clock_, *path, 2, 3, until, &now.p, &now.v, &now.a, A_NULL);
    PROMISE(now.p == 9 && now.v == 0 && now.a == 0);
    atraj_clock_state(&clock_, *path + 1, 2, 3, until, &now.p, &now.v, A_NULL, A_NULL);
    PROMISE(now.p == -1 && now.v == 0);
    return 0;
}

int main(void) { return refused() || runs() || passes(); }
