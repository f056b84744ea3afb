/*
 Tests CLARAty's trapezoid through the C handle: replays the golden scripts bit for bit and checks the header's promises.
 usage: claraty DIRECTORY
 Prints a line `what rows differing` for each replay, and the line of each broken promise. Fails on either a difference or a
 broken promise.
*/
#include "claraty/trapezoid.h"
#include "table.h"
#include <math.h>
#include <stdint.h>

typedef claraty_trapezoid axis;

static void axis_init(axis *x, claraty_clock clock, void *user)
{
    claraty_trapezoid_init(x);
    claraty_trapezoid_set_mode(x, CLARATY_LISTING);
    claraty_trapezoid_set_clock(x, clock, user);
}
static void axis_set(axis *x, double p, double v, double a, double d) { claraty_trapezoid_set(x, p, v, a, d); }
static int axis_start(axis *x) { return claraty_trapezoid_start(x); }
static int axis_stop(axis *x) { return claraty_trapezoid_stop(x); }
static void axis_reset(axis *x) { claraty_trapezoid_reset(x); }
static void axis_advance(axis *x, double seconds) { claraty_trapezoid_advance_timer_by(x, seconds); }
static int axis_is_started(const axis *x) { return claraty_trapezoid_is_started(x); }
static void axis_get(axis *x, double out[3]) { claraty_trapezoid_get_setpoint(x, &out[0], &out[1], &out[2]); }
static void axis_get_at(axis *x, double time, double out[3])
{
    claraty_trapezoid_get_setpoint_at(x, time, &out[0], &out[1], &out[2]);
}
static void axis_profile(const axis *x, claraty_profile *p) { claraty_trapezoid_get_profile(x, p); }

#include "claraty_replay.h"

static int broken;

#define PROMISE(condition) \
    if (!(condition)) \
    { \
        printf("broken: line %d: %s\n", __LINE__, #condition); \
        broken = 1; \
    }

/* A new axis on the manual clock, in corrected mode. */
static axis manual(void)
{
    axis x;
    claraty_trapezoid_init(&x);
    claraty_trapezoid_set_clock(&x, NULL, NULL);
    return x;
}

static void null_pointers(void)
{
    axis x = manual();
    const double p[1] = {1};
    PROMISE(claraty_trapezoid_set_mode(NULL, CLARATY_LISTING) == CLARATY_ERR_NULL);
    PROMISE(claraty_trapezoid_set(NULL, 1, 1, 1, 1) == CLARATY_ERR_NULL);
    PROMISE(claraty_trapezoid_set_waypoints(NULL, p, p, p, 1) == CLARATY_ERR_NULL);
    PROMISE(claraty_trapezoid_set_waypoints(&x, NULL, p, p, 1) == CLARATY_ERR_NULL);
    PROMISE(claraty_trapezoid_set_waypoints(&x, p, NULL, p, 1) == CLARATY_ERR_NULL);
    PROMISE(claraty_trapezoid_set_waypoints(&x, p, p, NULL, 1) == CLARATY_ERR_NULL);
    PROMISE(claraty_trapezoid_set_uniform_waypoints(NULL, p, 1, 1, 1) == CLARATY_ERR_NULL);
    PROMISE(claraty_trapezoid_set_uniform_waypoints(&x, NULL, 1, 1, 1) == CLARATY_ERR_NULL);
    PROMISE(claraty_trapezoid_start(NULL) == CLARATY_ERR_NULL);
    PROMISE(claraty_trapezoid_stop(NULL) == CLARATY_ERR_NULL);
    PROMISE(claraty_trapezoid_is_started(NULL) == CLARATY_ERR_NULL);
    PROMISE(claraty_trapezoid_get_setpoint(NULL, NULL, NULL, NULL) == CLARATY_ERR_NULL);
    PROMISE(claraty_trapezoid_get_setpoint_at(NULL, 0, NULL, NULL, NULL) == CLARATY_ERR_NULL);
    PROMISE(claraty_trapezoid_get_profile(NULL, NULL) == CLARATY_ERR_NULL);
    PROMISE(isnan(claraty_trapezoid_elapsed(NULL)) && isnan(claraty_trapezoid_duration(NULL)));
    PROMISE(isnan(claraty_trapezoid_get_position(NULL)) && isnan(claraty_trapezoid_get_position_at(NULL, 0)));
    PROMISE(isnan(claraty_trapezoid_get_velocity(NULL)) && isnan(claraty_trapezoid_get_velocity_at(NULL, 0)));
    PROMISE(isnan(claraty_trapezoid_get_acceleration(NULL)) && isnan(claraty_trapezoid_get_acceleration_at(NULL, 0)));
    claraty_trapezoid_init(NULL);
    claraty_trapezoid_set_clock(NULL, NULL, NULL);
    claraty_trapezoid_reset(NULL);
    claraty_trapezoid_advance_timer_by(NULL, 1);
    PROMISE(claraty_trapezoid_get_setpoint(&x, NULL, NULL, NULL) == CLARATY_OK);
    PROMISE(claraty_trapezoid_get_setpoint_at(&x, 1, NULL, NULL, NULL) == CLARATY_OK);
    PROMISE(claraty_trapezoid_get_profile(&x, NULL) == CLARATY_OK);
}

/* Whether two axes are in the same motion and would start the same next motion. */
static int alike(axis x, axis y)
{
    int same = claraty_trapezoid_elapsed(&x) == claraty_trapezoid_elapsed(&y)
        && claraty_trapezoid_duration(&x) == claraty_trapezoid_duration(&y)
        && claraty_trapezoid_get_position(&x) == claraty_trapezoid_get_position(&y)
        && claraty_trapezoid_is_started(&x) == claraty_trapezoid_is_started(&y);
    claraty_trapezoid_start(&x);
    claraty_trapezoid_start(&y);
    return same && claraty_trapezoid_duration(&x) == claraty_trapezoid_duration(&y)
        && claraty_trapezoid_get_position_at(&x, 1e9) == claraty_trapezoid_get_position_at(&y, 1e9);
}

static double no_number(void *user)
{
    (void)user;
    return NAN;
}

static void refusals(void)
{
    const double bad[3] = {NAN, INFINITY, -INFINITY}, good[2] = {1, 2};
    axis x = manual(), before;
    int i;
    PROMISE(claraty_trapezoid_set(&x, 10, 2, 2, 2) == CLARATY_OK);
    PROMISE(claraty_trapezoid_start(&x) == 0);
    claraty_trapezoid_advance_timer_by(&x, 1.5);
    before = x;
    for (i = 0; i < 3; ++i)
    {
        const double wrong[2] = {1, bad[i]};
        PROMISE(claraty_trapezoid_set(&x, bad[i], 1, 1, 1) == CLARATY_ERR_NOT_FINITE);
        PROMISE(claraty_trapezoid_set(&x, 1, bad[i], 1, 1) == CLARATY_ERR_NOT_FINITE);
        PROMISE(claraty_trapezoid_set(&x, 1, 1, bad[i], 1) == CLARATY_ERR_NOT_FINITE);
        PROMISE(claraty_trapezoid_set(&x, 1, 1, 1, bad[i]) == CLARATY_ERR_NOT_FINITE);
        PROMISE(claraty_trapezoid_set_waypoints(&x, wrong, good, good, 2) == CLARATY_ERR_NOT_FINITE);
        PROMISE(claraty_trapezoid_set_waypoints(&x, good, wrong, good, 2) == CLARATY_ERR_NOT_FINITE);
        PROMISE(claraty_trapezoid_set_waypoints(&x, good, good, wrong, 2) == CLARATY_ERR_NOT_FINITE);
        PROMISE(claraty_trapezoid_set_uniform_waypoints(&x, wrong, 2, 1, 1) == CLARATY_ERR_NOT_FINITE);
        PROMISE(claraty_trapezoid_set_uniform_waypoints(&x, good, 2, bad[i], 1) == CLARATY_ERR_NOT_FINITE);
        PROMISE(claraty_trapezoid_set_uniform_waypoints(&x, good, 2, 1, bad[i]) == CLARATY_ERR_NOT_FINITE);
        PROMISE(claraty_trapezoid_get_setpoint_at(&x, bad[i], NULL, NULL, NULL) == CLARATY_ERR_NOT_FINITE);
        PROMISE(isnan(claraty_trapezoid_get_position_at(&x, bad[i])));
        claraty_trapezoid_advance_timer_by(&x, bad[i]);
    }
    PROMISE(claraty_trapezoid_set_waypoints(&x, good, good, good, 0) == CLARATY_ERR_WAYPOINTS);
    PROMISE(claraty_trapezoid_set_waypoints(&x, good, good, good, (size_t)-1) == CLARATY_ERR_WAYPOINTS);
    PROMISE(claraty_trapezoid_set_uniform_waypoints(&x, good, 0, 1, 1) == CLARATY_ERR_WAYPOINTS);
    PROMISE(claraty_trapezoid_set_mode(&x, 2) == CLARATY_ERR_MODE);
    PROMISE(claraty_trapezoid_set_mode(&x, -1) == CLARATY_ERR_MODE);
    PROMISE(claraty_trapezoid_set(&x, 1e300, 1e150, 1e-20, 1e-20) == CLARATY_ERR_RANGE);
    for (i = 0; i < 2; ++i)
    {
        const double large = i ? -1.001e60 : 1e300;
        const double wrong[2] = {1, large};
        PROMISE(claraty_trapezoid_set(&x, large, 1, 1, 1) == CLARATY_ERR_RANGE);
        PROMISE(claraty_trapezoid_set(&x, 1, large, 1, 1) == CLARATY_ERR_RANGE);
        PROMISE(claraty_trapezoid_set(&x, 1, 1, large, 1) == CLARATY_ERR_RANGE);
        PROMISE(claraty_trapezoid_set(&x, 1, 1, 1, large) == CLARATY_ERR_RANGE);
        PROMISE(claraty_trapezoid_set_waypoints(&x, wrong, good, good, 2) == CLARATY_ERR_RANGE);
        PROMISE(claraty_trapezoid_set_waypoints(&x, good, wrong, good, 2) == CLARATY_ERR_RANGE);
        PROMISE(claraty_trapezoid_set_waypoints(&x, good, good, wrong, 2) == CLARATY_ERR_RANGE);
        PROMISE(claraty_trapezoid_set_uniform_waypoints(&x, wrong, 2, 1, 1) == CLARATY_ERR_RANGE);
        PROMISE(claraty_trapezoid_set_uniform_waypoints(&x, good, 2, large, 1) == CLARATY_ERR_RANGE);
        PROMISE(claraty_trapezoid_set_uniform_waypoints(&x, good, 2, 1, large) == CLARATY_ERR_RANGE);
    }
    PROMISE(alike(x, before));

    claraty_trapezoid_set_clock(&x, no_number, NULL);
    PROMISE(claraty_trapezoid_start(&x) == CLARATY_ERR_NOT_FINITE);
    PROMISE(claraty_trapezoid_stop(&x) == CLARATY_ERR_NOT_FINITE);
    PROMISE(claraty_trapezoid_set(&x, 1, 1, 1, 1) == CLARATY_ERR_NOT_FINITE);
    PROMISE(claraty_trapezoid_get_setpoint(&x, NULL, NULL, NULL) == CLARATY_ERR_NOT_FINITE);
    PROMISE(isnan(claraty_trapezoid_get_position(&x)));
}

/* One reading of the clock that is no number, or a huge advance, must not outlast the next start. */
static void recoveries(void)
{
    double now = 5;
    axis x = manual();
    claraty_trapezoid_set_clock(&x, clock_of, &now);
    PROMISE(claraty_trapezoid_set(&x, 10, 2, 2, 2) == CLARATY_OK && claraty_trapezoid_start(&x) == 0);
    now = NAN;
    claraty_trapezoid_reset(&x);
    now = 7;
    PROMISE(!claraty_trapezoid_is_started(&x) && claraty_trapezoid_elapsed(&x) == 2);
    PROMISE(claraty_trapezoid_start(&x) == 0 && claraty_trapezoid_elapsed(&x) == 0);
    claraty_trapezoid_advance_timer_by(&x, 1e308);
    claraty_trapezoid_advance_timer_by(&x, 1e308);
    PROMISE(claraty_trapezoid_get_position(&x) == 10 && claraty_trapezoid_start(&x) == 0);
    claraty_trapezoid_advance_timer_by(&x, 1e17);
    PROMISE(claraty_trapezoid_get_position(&x) == 10 && claraty_trapezoid_start(&x) == 0);
    now += 1;
    PROMISE(claraty_trapezoid_elapsed(&x) == 1 && claraty_trapezoid_get_position(&x) == 1);
    now = NAN;
    claraty_trapezoid_set_clock(&x, NULL, NULL);
    PROMISE(!claraty_trapezoid_is_started(&x) && claraty_trapezoid_start(&x) == 0);
    claraty_trapezoid_advance_timer_by(&x, 1);
    PROMISE(claraty_trapezoid_elapsed(&x) == 1 && claraty_trapezoid_get_position(&x) == 1);
}

/* A mode counts from the next start or stop. */
static void modes(void)
{
    axis x = manual();
    PROMISE(claraty_trapezoid_set(&x, 10, 2, 2, 2) == CLARATY_OK && claraty_trapezoid_start(&x) == 0);
    PROMISE(claraty_trapezoid_set_mode(&x, CLARATY_LISTING) == CLARATY_OK);
    PROMISE(claraty_trapezoid_get_position_at(&x, 1000) == 10 && claraty_trapezoid_is_started(&x));
    PROMISE(claraty_trapezoid_get_setpoint_at(&x, NAN, NULL, NULL, NULL) == CLARATY_ERR_NOT_FINITE);
    PROMISE(claraty_trapezoid_start(&x) == 0 && claraty_trapezoid_set_mode(&x, CLARATY_CORRECTED) == CLARATY_OK);
    PROMISE(claraty_trapezoid_get_setpoint_at(&x, NAN, NULL, NULL, NULL) == CLARATY_OK);
    PROMISE(!claraty_trapezoid_is_started(&x));
}

static void getters(void)
{
    axis x = manual();
    claraty_profile p;
    double s[3];
    PROMISE(claraty_trapezoid_set(&x, -10, -2, -4, -1) == CLARATY_OK);
    PROMISE(claraty_trapezoid_start(&x) == 0 && claraty_trapezoid_is_started(&x) == 1);
    PROMISE(claraty_trapezoid_elapsed(&x) == 0);
    claraty_trapezoid_advance_timer_by(&x, 1);
    PROMISE(claraty_trapezoid_elapsed(&x) == 1);
    PROMISE(claraty_trapezoid_get_profile(&x, &p) == CLARATY_OK);
    PROMISE(p.t1 == 0.5 && p.type == CLARATY_TRAPEZOIDAL && p.velocity == -2 && p.accel == -4 && p.decel == 1);
    PROMISE(p.final_position == -10 && p.tf == claraty_trapezoid_duration(&x));
    PROMISE(claraty_trapezoid_get_setpoint(&x, &s[0], &s[1], &s[2]) == CLARATY_OK);
    PROMISE(s[0] == -1.5 && s[1] == -2 && s[2] == 0);
    PROMISE(claraty_trapezoid_get_position(&x) == s[0] && claraty_trapezoid_get_velocity(&x) == s[1]);
    PROMISE(claraty_trapezoid_get_acceleration(&x) == s[2]);
    PROMISE(claraty_trapezoid_get_setpoint_at(&x, 0.25, &s[0], &s[1], &s[2]) == CLARATY_OK);
    PROMISE(s[0] == -0.125 && s[1] == -1 && s[2] == -4);
    PROMISE(claraty_trapezoid_get_position_at(&x, 0.25) == s[0] && claraty_trapezoid_get_velocity_at(&x, 0.25) == s[1]);
    PROMISE(claraty_trapezoid_get_acceleration_at(&x, 0.25) == s[2]);
    PROMISE(claraty_trapezoid_set(&x, 5, 0, 0, 0) == CLARATY_OK);
    PROMISE(claraty_trapezoid_start(&x) == (CLARATY_WARN_ACCEL | CLARATY_WARN_DECEL | CLARATY_WARN_VELOCITY));
    claraty_trapezoid_reset(&x);
    PROMISE(claraty_trapezoid_is_started(&x) == 0);
}

/* Two axes take turns; one is copied in mid-motion. Neither the other axis nor the copy may change a motion. */
static void many_axes(void)
{
    axis x = manual(), y = manual(), alone = manual(), copy;
    int i;
    claraty_trapezoid_set(&x, 10, 2, 2, 1);
    claraty_trapezoid_set(&y, -3, 1, 1, 4);
    claraty_trapezoid_set(&alone, 10, 2, 2, 1);
    claraty_trapezoid_start(&x);
    claraty_trapezoid_start(&y);
    claraty_trapezoid_start(&alone);
    copy = x;
    for (i = 0; i < 800; ++i)
    {
        if (i == 300)
        {
            copy = x;
            claraty_trapezoid_stop(&y);
        }
        claraty_trapezoid_advance_timer_by(&x, 0.01);
        claraty_trapezoid_advance_timer_by(&y, 0.02);
        claraty_trapezoid_advance_timer_by(&alone, 0.01);
        if (i >= 300) { claraty_trapezoid_advance_timer_by(&copy, 0.01); }
        PROMISE(claraty_trapezoid_get_position(&x) == claraty_trapezoid_get_position(&alone));
        PROMISE(i < 300 || claraty_trapezoid_get_position(&copy) == claraty_trapezoid_get_position(&alone));
        claraty_trapezoid_get_position(&y);
    }
    PROMISE(!claraty_trapezoid_is_started(&x) && !claraty_trapezoid_is_started(&copy));
    PROMISE(claraty_trapezoid_get_position(&copy) == 10);
}

static void waypoints(void)
{
    double p[3] = {2, -1, 4}, v[3] = {1, 1, 1}, a[3] = {2, 2, 2};
    axis x = manual(), y = manual(), single = manual();
    double sum = 0, from = 0;
    int i;
    PROMISE(claraty_trapezoid_set_waypoints(&x, p, v, a, 3) == CLARATY_OK && claraty_trapezoid_start(&x) == 0);
    PROMISE(claraty_trapezoid_set_uniform_waypoints(&y, p, 3, 1, 2) == CLARATY_OK && claraty_trapezoid_start(&y) == 0);
    for (i = 0; i < 3; ++i)
    {
        double t;
        claraty_trapezoid_reset(&single);
        claraty_trapezoid_set(&single, p[i] - from, v[i], a[i], a[i]);
        claraty_trapezoid_start(&single);
        for (t = 0.01; t < claraty_trapezoid_duration(&single); t += 0.1)
        {
            const double want = from + claraty_trapezoid_get_position_at(&single, t);
            PROMISE(fabs(claraty_trapezoid_get_position_at(&x, sum + t) - want) < 1e-12);
            PROMISE(claraty_trapezoid_get_position_at(&x, 0) == 0);
            PROMISE(claraty_trapezoid_get_position_at(&y, sum + t) == claraty_trapezoid_get_position_at(&x, sum + t));
        }
        sum += claraty_trapezoid_duration(&single);
        from = p[i];
    }
    PROMISE(claraty_trapezoid_duration(&x) == sum);
    /* After the next set the library no longer reads the arrays. */
    claraty_trapezoid_advance_timer_by(&x, 0.5);
    PROMISE(claraty_trapezoid_set(&x, 0, 1, 2, 2) == CLARATY_OK);
    p[0] = p[1] = p[2] = NAN;
    claraty_trapezoid_advance_timer_by(&x, 100);
    PROMISE(claraty_trapezoid_get_position(&x) == 2);
}

static void clocks(void)
{
    double now = 1000;
    axis x;
    claraty_trapezoid_init(&x);
    claraty_trapezoid_set(&x, 1, 1000, 1e6, 1e6);
    claraty_trapezoid_start(&x);
    while (claraty_trapezoid_is_started(&x)) { claraty_trapezoid_get_position(&x); }
    PROMISE(claraty_trapezoid_elapsed(&x) >= claraty_trapezoid_duration(&x));
    PROMISE(claraty_trapezoid_get_position(&x) == 1);

    claraty_trapezoid_set_clock(&x, clock_of, &now);
    claraty_trapezoid_set(&x, 10, 2, 2, 2);
    claraty_trapezoid_start(&x);
    now += 1.5;
    claraty_trapezoid_advance_timer_by(&x, 0.5);
    PROMISE(claraty_trapezoid_elapsed(&x) == 2 && claraty_trapezoid_get_position(&x) == 3);
    claraty_trapezoid_set_clock(&x, NULL, NULL);
    now += 100;
    PROMISE(claraty_trapezoid_elapsed(&x) == 2);
}

int main(int argc, char **argv)
{
    int same;
    if (argc != 2) { return 2; }
    same = replay_listing(argv[1], "listing-on-a-clock", 0);
    same &= replay_listing(argv[1], "listing-advanced", 1);
    null_pointers();
    refusals();
    recoveries();
    modes();
    getters();
    many_axes();
    waypoints();
    clocks();
    return same && !broken ? 0 : 1;
}
