/*
 Replays the scripts of the published listing. The program that includes this file includes "table.h" and <stdint.h> before
 and defines an axis:
     axis                                             its type
     axis_init(axis *, claraty_clock, void *user)     makes it new, in listing mode, on this clock
     axis_set axis_start axis_stop axis_reset axis_advance axis_is_started
     axis_get(axis *, double out[3]), axis_get_at(axis *, double time, double out[3])
     axis_profile(const axis *, claraty_profile *)
 axis_start and axis_stop return the warnings, or -1 if the axis cannot return them.
*/

enum { SCRIPTS = 270, COLUMNS = 21, PROFILE = 6, TYPE = 15, STARTED = 16, WARNINGS = 17, SETPOINT = 18 };

static double real_of_hex(const char *hex)
{
    uint64_t bits = 0;
    double x;
    if (strcmp(hex, "nan") == 0) { hex = "7ff8000000000000"; }
    for (; *hex; ++hex) { bits = bits << 4 | (uint64_t)(*hex <= '9' ? *hex - '0' : *hex - 'a' + 10); }
    memcpy(&x, &bits, sizeof(x));
    return x;
}

static int differ(const struct table *table, int column, const double *got, int count)
{
    int i, bad = 0;
    for (i = 0; i < count; ++i)
    {
        const double want = real_of_hex(table->cells[column + i]);
        if (memcmp(&got[i], &want, sizeof(want)) == 0 || (got[i] != got[i] && want != want)) { continue; }
        printf("%s:%d: column %d is %.17g, golden %.17g\n", table->name, table->line, column + i, got[i], want);
        bad = 1;
    }
    return bad;
}

static int number_differs(const struct table *table, int column, int got)
{
    if (atoi(table->cells[column]) == got) { return 0; }
    printf("%s:%d: column %d is %d, golden %s\n", table->name, table->line, column, got, table->cells[column]);
    return 1;
}

static double clock_of(void *user) { return *(const double *)user; }

/* Plays the operation of a row. `advance` moves the axis's timer if its clock stands still, else it moves the clock. Returns
   whether something differs from the row. */
static int play(axis *x, const struct table *table, double *now, int stands_still)
{
    const char *const op = table->cells[1];
    const double argument = real_of_hex(table->cells[2]);
    double setpoint[3];
    int warnings = -1, bad = 0;
    if (strcmp(op, "set") == 0)
    {
        axis_set(x, argument, real_of_hex(table->cells[3]), real_of_hex(table->cells[4]), real_of_hex(table->cells[5]));
    }
    else if (strcmp(op, "start") == 0) { warnings = axis_start(x); }
    else if (strcmp(op, "stop") == 0) { warnings = axis_stop(x); }
    else if (strcmp(op, "reset") == 0) { axis_reset(x); }
    else if (strcmp(op, "advance") == 0 && stands_still) { axis_advance(x, argument); }
    else if (strcmp(op, "advance") == 0) { *now += argument; }
    else if (strcmp(op, "get") == 0) { axis_get(x, setpoint); }
    else if (strcmp(op, "get_at") == 0) { axis_get_at(x, argument, setpoint); }
    else
    {
        fprintf(stderr, "%s:%d: unknown operation %s\n", table->name, table->line, op);
        exit(2);
    }
    if (*table->cells[PROFILE])
    {
        claraty_profile p;
        double got[9];
        axis_profile(x, &p);
        got[0] = p.t1, got[1] = p.t2, got[2] = p.tf, got[3] = p.p_at_t1, got[4] = p.p_at_t2;
        got[5] = p.final_position, got[6] = p.velocity, got[7] = p.accel, got[8] = p.decel;
        bad |= differ(table, PROFILE, got, 9) | number_differs(table, TYPE, p.type);
        if (warnings >= 0) { bad |= number_differs(table, WARNINGS, warnings); }
    }
    if (*table->cells[SETPOINT]) { bad |= differ(table, SETPOINT, setpoint, 3); }
    return bad | number_differs(table, STARTED, axis_is_started(x));
}

/* Prints `how rows differing`. Returns whether all 270 scripts were there and nothing differs. */
static int replay_listing(const char *directory, const char *how, int stands_still)
{
    struct table table = open_golden(directory, "claraty_listing_f64.csv");
    int rows = 0, differing = 0, scripts = 0;
    double now = 0;
    axis x;
    while (next_row(&table, COLUMNS))
    {
        if (atoi(table.cells[0]) == scripts)
        {
            ++scripts;
            now = 0;
            axis_init(&x, stands_still ? NULL : clock_of, &now);
        }
        differing += play(&x, &table, &now, stands_still);
        ++rows;
    }
    printf("%s %d %d\n", how, rows, differing);
    return scripts == SCRIPTS && differing == 0;
}
