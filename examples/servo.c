/*
 A servo program in the style of liba's users. It plans the moves of a file and prints every setpoint for the drive.

     servo moves.txt

 Each line is one request; the text after # is the title of the move.
     bell  jm am vm p0 p1 v0 v1          plan a double-S
     trap  vm ac de p0 p1 v0 v1          plan a trapezoid
     poly7 ts p0 p1 v0 v1 a0 a1 j0 j1    plan a septic polynomial
     at x                                print one setpoint of the last plan, x seconds after its start
     every dt                            print its setpoints from start to end, dt seconds apart, and one on each side of
                                         every border of a phase, where the jerk or the acceleration jumps
 The answer has these lines. Numbers have so many digits that reading them gives the same bits.
     move TITLE
     plan ...                            the planner's result and struct, in the order of the struct
     phase FROM TO NAME
     at x pos vel acc [jer]
*/
#include "a/trajbell.h"
#include "a/trajtrap.h"
#include "a/trajpoly7.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX_SETPOINTS 1e6
#define MAX_PHASES 7
#define BESIDE 1e-9 /* how far a setpoint is from a border, in durations of the move */

struct axis {
    enum { IDLE, BELL, TRAP, POLY7 } profile;
    a_float t; /* duration, s */
    a_float border[MAX_PHASES]; /* the ends of the phases, s */
    a_size borders;
    union {
        a_trajbell bell;
        a_trajtrap trap;
        a_trajpoly7 poly7;
    } u;
};

static void print(char const *what, a_float const *value, a_size count)
{
    fputs(what, stdout);
    for (a_size i = 0; i != count; ++i) { printf(" %.17g", (double)value[i]); }
}

static void print_phase(struct axis *axis, a_float from, a_float to, char const *name)
{
    if (!(from < to)) { return; }
    axis->border[axis->borders++] = to;
    printf("phase %.17g %.17g %s\n", (double)from, (double)to, name);
}

static void plan_bell(struct axis *axis, a_float const *n)
{
    a_trajbell *const b = &axis->u.bell;
    axis->t = a_trajbell_gen(b, n[0], n[1], n[2], n[3], n[4], n[5], n[6]);
    a_float const plan[] = {axis->t, b->t, b->tv, b->ta, b->td, b->taj, b->tdj, b->p0, b->p1,
                            b->v0, b->v1, b->vm, b->jm, b->am, b->dm};
    print("plan", plan, A_LEN(plan));
    putchar('\n');
    print_phase(axis, 0, b->taj, "accelerate");
    print_phase(axis, b->taj, b->ta - b->taj, "accelerate");
    print_phase(axis, b->ta - b->taj, b->ta, "accelerate");
    print_phase(axis, b->ta, b->t - b->td, "cruise");
    print_phase(axis, b->t - b->td, b->t - b->td + b->tdj, "decelerate");
    print_phase(axis, b->t - b->td + b->tdj, b->t - b->tdj, "decelerate");
    print_phase(axis, b->t - b->tdj, b->t, "decelerate");
}

static void plan_trap(struct axis *axis, a_float const *n)
{
    a_trajtrap *const c = &axis->u.trap;
    axis->t = a_trajtrap_gen(c, n[0], n[1], n[2], n[3], n[4], n[5], n[6]);
    a_float const plan[] = {axis->t, c->t, c->p0, c->p1, c->v0, c->v1, c->vc, c->ta, c->td,
                            c->pa, c->pd, c->ac, c->de};
    print("plan", plan, A_LEN(plan));
    putchar('\n');
    print_phase(axis, 0, c->ta, "accelerate");
    print_phase(axis, c->ta, c->td, "cruise");
    print_phase(axis, c->td, c->t, "decelerate");
}

static void plan_poly7(struct axis *axis, a_float const *n)
{
    a_trajpoly7 *const c = &axis->u.poly7;
    a_trajpoly7_gen(c, n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8]);
    axis->t = n[0];
    print("plan", c->p, A_LEN(c->p));
    print("", c->v, A_LEN(c->v));
    print("", c->a, A_LEN(c->a));
    print("", c->j, A_LEN(c->j));
    putchar('\n');
    print_phase(axis, 0, axis->t, "polynomial");
}

static void print_setpoint(struct axis const *axis, a_float x)
{
    a_float point[5] = {x};
    a_size count = A_LEN(point);
    switch (axis->profile) {
    case BELL:
        point[1] = a_trajbell_pos(&axis->u.bell, x);
        point[2] = a_trajbell_vel(&axis->u.bell, x);
        point[3] = a_trajbell_acc(&axis->u.bell, x);
        point[4] = a_trajbell_jer(&axis->u.bell, x);
        break;
    case TRAP:
        point[1] = a_trajtrap_pos(&axis->u.trap, x);
        point[2] = a_trajtrap_vel(&axis->u.trap, x);
        point[3] = a_trajtrap_acc(&axis->u.trap, x);
        count = 4;
        break;
    case POLY7:
        point[1] = a_trajpoly7_pos(&axis->u.poly7, x);
        point[2] = a_trajpoly7_vel(&axis->u.poly7, x);
        point[3] = a_trajpoly7_acc(&axis->u.poly7, x);
        point[4] = a_trajpoly7_jer(&axis->u.poly7, x);
        break;
    case IDLE:
        break;
    }
    print("at", point, count);
    putchar('\n');
}

static int print_setpoints(struct axis const *axis, a_float dt)
{
    if (!(dt > 0 && axis->t > 0 && axis->t / dt < MAX_SETPOINTS)) { return 0; }
    a_float const beside = axis->t * (a_float)BESIDE;
    a_float last = -1;
    a_size next = 0;
    for (long i = 0; (a_float)i * dt < axis->t - beside; ++i) {
        a_float const x = (a_float)i * dt;
        for (; next != axis->borders && axis->border[next] - beside <= x; ++next) {
            print_setpoint(axis, axis->border[next] - beside);
            print_setpoint(axis, last = axis->border[next] + beside);
        }
        if (last < x) { print_setpoint(axis, x); }
    }
    for (; next + 1 < axis->borders; ++next) {
        print_setpoint(axis, axis->border[next] - beside);
        print_setpoint(axis, axis->border[next] + beside);
    }
    print_setpoint(axis, axis->t - beside);
    print_setpoint(axis, axis->t);
    return 1;
}

static a_size read_numbers(char *text, a_float *number, a_size room)
{
    a_size count = 0;
    for (char *end; count != room; ++count, text = end) {
        double const value = strtod(text, &end);
        if (end == text) { break; }
        number[count] = (a_float)value;
    }
    return text[strspn(text, " \t")] == '\0' ? count : 0;
}

/* Cuts the title off the request and returns it. */
static char const *title_of(char *request)
{
    request[strcspn(request, "\r\n")] = '\0';
    char *const title = strchr(request, '#');
    if (!title) { return ""; }
    *title = '\0';
    return title + 1 + strspn(title + 1, " ");
}

/* Whether the request was understood and could be met. */
static int serve(struct axis *axis, char *request)
{
    static struct {
        char const *name;
        int profile;
        a_size arguments;
        void (*plan)(struct axis *axis, a_float const *number);
    } const profiles[] = {{"bell", BELL, 7, plan_bell}, {"trap", TRAP, 7, plan_trap}, {"poly7", POLY7, 9, plan_poly7}};

    char const *const title = title_of(request);
    char name[8] = "";
    int length = 0;
    if (sscanf(request, "%7s%n", name, &length) != 1) { return 1; }

    a_float number[9];
    a_size const count = read_numbers(request + length, number, A_LEN(number));
    if (axis->profile != IDLE && count == 1 && !strcmp(name, "every")) { return print_setpoints(axis, number[0]); }
    if (axis->profile != IDLE && count == 1 && !strcmp(name, "at")) {
        print_setpoint(axis, number[0]);
        return 1;
    }
    for (a_size i = 0; i != A_LEN(profiles); ++i) {
        if (count == profiles[i].arguments && !strcmp(name, profiles[i].name)) {
            memset(axis, 0, sizeof(*axis));
            axis->profile = profiles[i].profile;
            printf("move %s\n", *title ? title : request);
            profiles[i].plan(axis, number);
            return 1;
        }
    }
    return 0;
}

int main(int argc, char *argv[])
{
    FILE *const moves = argc == 2 ? fopen(argv[1], "r") : NULL;
    if (!moves) {
        fprintf(stderr, "usage: servo moves.txt (a file that can be read)\n");
        return EXIT_FAILURE;
    }
    static struct axis axis; /* idle */
    char request[512];
    for (long line = 1; fgets(request, sizeof(request), moves); ++line) {
        if (!serve(&axis, request)) {
            fprintf(stderr, "%s:%ld: cannot serve: %s\n", argv[1], line, request);
            fclose(moves);
            return EXIT_FAILURE;
        }
    }
    int const read = !ferror(moves);
    fclose(moves);
    return read && fflush(stdout) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
