/*
 Tests CLARAty's trapezoid through the C handle: replays the golden scripts bit for bit and checks the header's promises.
 usage: claraty DIRECTORY
 Prints a line `what rows differing` for each replay, and the line of each broken promise. Fails on either a difference or a
 broken promise.
*/
#include "claraty/trapezoid.h"
#include "promises.h"
#include "table.h"
#include <math.h>
#include <stdint.h>

typedef claraty_trapezoid axis;

enum { SCRIPTS = 90, COLUMNS = 21, PROFILE = 6, TYPE = 15, STARTED = 16, WARNINGS = 17, SETPOINT = 18 };

static double real_of_hex(const char *hex) {
    uint64_t bits = 0;
    double x;
    if (strcmp(hex, "nan") == 0) { hex = "7ff8000000000000"; }
    for (; *hex; ++hex) { bits = bits << 4 | (uint64_t)(*hex <= '9' ? *hex - '0' : *hex - 'a' + 10); }
    memcpy(&x, &bits, sizeof(x));
    return x;
}

static int differ(const struct table *table, int column, const double *got, int count) {
    int i, bad = 0;
    for (i = 0; i < count; ++i) {
        const double want = real_of_hex(table->cells[column + i]);
        if (memcmp(&got[i], &want, sizeof(want)) == 0 || (got[i] != got[i] && want != want)) { continue; }
        printf("%s:%d: column %d is %.17g, golden %.17g\n", table->name, table->line, column + i, got[i], want);
        bad = 1;
    }
    return bad;
}

static int number_differs(const struct table *table, int column, int got) {
    if (atoi(table->cells[column]) == got) { return 0; }
    printf("%s:%d: column %d is %d, golden %s\n", table->name, table->line, column, got, table->cells[column]);
    return 1;
}

static double clock_of(void *user) { return *(const double *)user; }

/* Plays the operation of a row. `advance` moves the axis's timer if its clock stands still, else it moves the clock. Returns
   whether something differs from the row. */
static int play(axis *x, const struct table *table, double *now, int stands_still) {
    const char *const op = table->cells[1];
    const double argument = real_of_hex(table->cells[2]);
    double setpoint[3];
    int warnings = -1, bad = 0;
    if (strcmp(op, "set") == 0) {
        claraty_trapezoid_set(x, argument, real_of_hex(table->cells[3]), real_of_hex(table->cells[4]), real_of_hex(table->cells[5]));
    } else if (strcmp(op, "start") == 0) { warnings = claraty_trapezoid_start(x); }
    else if (strcmp(op, "stop") == 0) { warnings = claraty_trapezoid_stop(x); }
    else if (strcmp(op, "reset") == 0) { claraty_trapezoid_reset(x); }
    else if (strcmp(op, "advance") == 0 && stands_still) { claraty_trapezoid_advance_timer_by(x, argument); }
    else if (strcmp(op, "advance") == 0) { *now += argument; }
    else if (strcmp(op, "get") == 0) { claraty_trapezoid_get_setpoint(x, &setpoint[0], &setpoint[1], &setpoint[2]); }
    else if (strcmp(op, "get_at") == 0) {
        claraty_trapezoid_get_setpoint_at(x, argument, &setpoint[0], &setpoint[1], &setpoint[2]);
    } else {
        fprintf(stderr, "%s:%d: unknown operation %s\n", table->name, table->line, op);
        exit(2);
    }
    if (*table->cells[PROFILE]) {
        claraty_profile p;
        double got[9];
        claraty_trapezoid_get_profile(x, &p);
        got[0] = p.t1, got[1] = p.t2, got[2] = p.tf, got[3] = p.p_at_t1, got[4] = p.p_at_t2;
        got[5] = p.final_position, got[6] = p.velocity, got[7] = p.accel, got[8] = p.decel;
        bad |= differ(table, PROFILE, got, 9) | number_differs(table, TYPE, p.type);
        bad |= number_differs(table, WARNINGS, warnings);
    }
    if (*table->cells[SETPOINT]) { bad |= differ(table, SETPOINT, setpoint, 3); }
    return bad | number_differs(table, STARTED, claraty_trapezoid_is_started(x));
}

/* Prints `how rows differing`. Returns whether all scripts were there and nothing differs. */
static int replay_listing(const char *directory, const char *how, int stands_still) {
    struct table table = open_golden(directory, "claraty_listing_f64.csv");
    int rows = 0, differing = 0, scripts = 0;
    double now = 0;
    axis x;
    while (next_row(&table, COLUMNS)) {
        if (atoi(table.cells[0]) == scripts) {
            ++scripts;
            now = 0;
            claraty_trapezoid_init(&x);
            claraty_trapezoid_set_mode(&x, CLARATY_LISTING);
            claraty_trapezoid_set_clock(&x, stands_still ? NULL : clock_of, &now);
        }
        differing += play(&x, &table, &now, stands_still);
        ++rows;
    }
    printf("%s %d %d\n", how, rows, differing);
    return scripts == SCRIPTS && differing == 0;
}

/* A new axis on the manual clock, in corrected mode. */
static axis manual(void) {
    axis x;
    claraty_trapezoid_init(&x);
    claraty_trapezoid_set_clock(&x, NULL, NULL);
    return x;
}

/* The codes; `tests/miri` asks for NULL and NaN in each place, `tests/is_claraty_right_off_script.rs` that a refusal changes nothing. */
static double no_number(void *user) {
    (void)user;
    return NAN;
}

static void refusals(void) {
    const double good[2] = {1, 2};
    axis x = manual();
    PROMISE(claraty_trapezoid_set(&x, 1e300, 1, 1, 1) == CLARATY_ERR_RANGE && claraty_trapezoid_set(&x, 1, 1, 1, -1.001e60) == CLARATY_ERR_RANGE);
    PROMISE(claraty_trapezoid_set(&x, INFINITY, 1, 1, 1) == CLARATY_ERR_NOT_FINITE);
    PROMISE(claraty_trapezoid_set_waypoints(&x, good, good, good, 0) == CLARATY_ERR_WAYPOINTS);
    PROMISE(claraty_trapezoid_set_mode(&x, 2) == CLARATY_ERR_MODE && claraty_trapezoid_set_mode(&x, -1) == CLARATY_ERR_MODE);
    PROMISE(isnan(claraty_trapezoid_get_position_at(&x, INFINITY)));
    claraty_trapezoid_set_clock(&x, no_number, NULL);
    PROMISE(claraty_trapezoid_start(&x) == CLARATY_ERR_NOT_FINITE && claraty_trapezoid_stop(&x) == CLARATY_ERR_NOT_FINITE);
    PROMISE(claraty_trapezoid_set(&x, 1, 1, 1, 1) == CLARATY_ERR_NOT_FINITE);
    PROMISE(claraty_trapezoid_get_setpoint(&x, NULL, NULL, NULL) == CLARATY_ERR_NOT_FINITE && isnan(claraty_trapezoid_get_position(&x)));
}

/* A mode counts from the next start or stop. */
static void modes(void) {
    axis x = manual();
    PROMISE(claraty_trapezoid_set(&x, 10, 2, 2, 2) == CLARATY_OK && claraty_trapezoid_start(&x) == 0);
    PROMISE(claraty_trapezoid_set_mode(&x, CLARATY_LISTING) == CLARATY_OK);
    PROMISE(claraty_trapezoid_get_position_at(&x, 1000) == 10 && claraty_trapezoid_is_started(&x));
    PROMISE(claraty_trapezoid_get_setpoint_at(&x, NAN, NULL, NULL, NULL) == CLARATY_ERR_NOT_FINITE);
    PROMISE(claraty_trapezoid_start(&x) == 0 && claraty_trapezoid_set_mode(&x, CLARATY_CORRECTED) == CLARATY_OK);
    PROMISE(claraty_trapezoid_get_setpoint_at(&x, NAN, NULL, NULL, NULL) == CLARATY_OK);
    PROMISE(!claraty_trapezoid_is_started(&x));
}

static void getters(void) {
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

static void waypoints(void) {
    double p[3] = {2, -1, 4}, v[3] = {1, 1, 1}, a[3] = {2, 2, 2}, t;
    axis x = manual(), y = manual();
    PROMISE(claraty_trapezoid_set_waypoints(&x, p, v, a, 3) == CLARATY_OK && claraty_trapezoid_start(&x) == 0);
    PROMISE(claraty_trapezoid_set_uniform_waypoints(&y, p, 3, 1, 2) == CLARATY_OK && claraty_trapezoid_start(&y) == 0);
    /* The legs are 2, 3 and 5 units long, at 1 unit/s; each takes half a second more to speed up and brake. */
    PROMISE(claraty_trapezoid_duration(&x) == 11.5);
    for (t = 0; t < 12; t += 0.1) { PROMISE(claraty_trapezoid_get_position_at(&x, t) == claraty_trapezoid_get_position_at(&y, t)); }
    PROMISE(claraty_trapezoid_get_position_at(&x, 2.5) == 2 && claraty_trapezoid_get_position_at(&x, 6) == -1);
    /* After the next set the library no longer reads the arrays. */
    claraty_trapezoid_advance_timer_by(&x, 0.5);
    PROMISE(claraty_trapezoid_set(&x, 0, 1, 2, 2) == CLARATY_OK);
    p[0] = p[1] = p[2] = NAN;
    claraty_trapezoid_advance_timer_by(&x, 100);
    PROMISE(claraty_trapezoid_get_position(&x) == 2);
}

static void clocks(void) {
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

int main(int argc, char **argv) {
    int same;
    if (argc != 2) { return 2; }
    same = replay_listing(argv[1], "listing-on-a-clock", 0);
    same &= replay_listing(argv[1], "listing-advanced", 1);
    refusals(), modes(), getters(), waypoints(), clocks();
    return same && !broken ? 0 : 1;
}
