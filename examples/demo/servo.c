/*
 A servo program in the style of liba's users. It plans the moves that it reads and prints setpoints for the drive.

     servo < requests.txt

 Each line is one request, and gets one line for an answer: the planner's result and struct, in the order of the struct; or a setpoint.
 Numbers have so many digits that reading them gives the same bits.
     bell  jm am vm p0 p1 v0 v1          plan a double-S
     trap  vm ac de p0 p1 v0 v1          plan a trapezoid
     poly7 ts p0 p1 v0 v1 a0 a1 j0 j1    plan a septic polynomial
     at x                                pos vel acc [jer] of the last plan, x seconds after its start
*/
#include "a/trajbell.h"
#include "a/trajtrap.h"
#include "a/trajpoly7.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static a_trajbell bell;
static a_trajtrap trap;
static a_trajpoly7 poly7;

/* Prints numbers that stand in a row: those of a struct or an array. */
static void print(void const *numbers, a_size size)
{
    a_float number[26];
    memcpy(number, numbers, size);
    for (a_size i = 0; i != size / sizeof(a_float); ++i) { printf(i ? " %.17g" : "%.17g", (double)number[i]); }
    putchar('\n');
}

static void plan_bell(a_float const *n)
{
    memset(&bell, 0, sizeof(bell));
    printf("%.17g ", (double)a_trajbell_gen(&bell, n[0], n[1], n[2], n[3], n[4], n[5], n[6]));
    print(&bell, sizeof(bell));
}

static void at_bell(a_float x)
{
    a_float const point[] = {a_trajbell_pos(&bell, x), a_trajbell_vel(&bell, x), a_trajbell_acc(&bell, x), a_trajbell_jer(&bell, x)};
    print(point, sizeof(point));
}

static void plan_trap(a_float const *n)
{
    memset(&trap, 0, sizeof(trap));
    printf("%.17g ", (double)a_trajtrap_gen(&trap, n[0], n[1], n[2], n[3], n[4], n[5], n[6]));
    print(&trap, sizeof(trap));
}

static void at_trap(a_float x)
{
    a_float const point[] = {a_trajtrap_pos(&trap, x), a_trajtrap_vel(&trap, x), a_trajtrap_acc(&trap, x)};
    print(point, sizeof(point));
}

static void plan_poly7(a_float const *n)
{
    memset(&poly7, 0, sizeof(poly7));
    a_trajpoly7_gen(&poly7, n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8]);
    print(&poly7, sizeof(poly7));
}

static void at_poly7(a_float x)
{
    a_float const point[] = {a_trajpoly7_pos(&poly7, x), a_trajpoly7_vel(&poly7, x), a_trajpoly7_acc(&poly7, x), a_trajpoly7_jer(&poly7, x)};
    print(point, sizeof(point));
}

static struct profile {
    char const *name;
    a_size arguments;
    void (*plan)(a_float const *number);
    void (*at)(a_float x);
} const profiles[] = {{"bell", 7, plan_bell, at_bell}, {"trap", 7, plan_trap, at_trap}, {"poly7", 9, plan_poly7, at_poly7}};

/* Whether the request was understood. */
static int serve(char *request)
{
    static struct profile const *planned;
    a_float number[9] = {0};
    a_size count = 0;
    char const *const name = strtok(request, " \n");
    for (char const *text; count != A_LEN(number) && (text = strtok(NULL, " \n")) != NULL; ++count) { number[count] = (a_float)atof(text); }
    if (name && planned && count == 1 && !strcmp(name, "at")) {
        planned->at(number[0]);
        return 1;
    }
    planned = NULL;
    for (a_size i = 0; name && i != A_LEN(profiles); ++i) {
        if (count == profiles[i].arguments && !strcmp(name, profiles[i].name)) { planned = &profiles[i]; }
    }
    if (planned) { planned->plan(number); }
    return planned != NULL;
}

int main(void)
{
    char request[512];
    while (fgets(request, sizeof(request), stdin)) {
        if (!serve(request)) {
            fprintf(stderr, "servo: no such request: %s\n", request);
            return EXIT_FAILURE;
        }
    }
    return fflush(stdout) == 0 && !ferror(stdin) ? EXIT_SUCCESS : EXIT_FAILURE;
}
