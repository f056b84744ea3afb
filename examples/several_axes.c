/*
 What several axes do that are planned together: a gantry arrives together and on a straight line, an arm follows way points.

     several_axes SETPOINTS

 It prints how long each move takes and by how much an axis arrives early, which is 0, and it appends the setpoints to SETPOINTS, in the
 form of plot.rs.
*/
#include "atraj/move.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define MOST 6
#define LEGS 4

struct axes
{
    char const *const *names;
    atraj_limits limits[MOST];
    size_t n;
};

static char const *const xyz[] = {"x", "y", "z"};
static char const *const joints[] = {"joint 1", "joint 2", "joint 3", "joint 4", "joint 5", "joint 6"};
static atraj_state const corner[] = {{0, 0, 0}, {0, 0, 0}, {(a_float)0.1, 0, 0}};
static atraj_state const target[] = {{(a_float)0.8, 0, 0}, {(a_float)0.4, 0, 0}, {(a_float)0.3, 0, 0}};
static atraj_state const points[LEGS + 1][MOST] = {
    {{0, 0, 0}, {(a_float)-1.6, 0, 0}, {(a_float)1.6, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
    {{(a_float)0.5, 0, 0}, {-1, 0, 0}, {(a_float)1.2, 0, 0}, {0, 0, 0}, {(a_float)-0.7, 0, 0}, {(a_float)1.6, 0, 0}},
    {{(a_float)0.5, 0, 0}, {(a_float)-0.8, 0, 0}, {(a_float)1.3, 0, 0}, {0, 0, 0}, {-1, 0, 0}, {(a_float)1.6, 0, 0}},
    {{(a_float)-0.8, 0, 0}, {(a_float)-1.2, 0, 0}, {(a_float)1.4, 0, 0}, {(a_float)0.4, 0, 0}, {(a_float)-0.5, 0, 0}, {(a_float)-1.6, 0, 0}},
    {{0, 0, 0}, {(a_float)-1.6, 0, 0}, {(a_float)1.6, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
};

/* The setpoints of one axis from a tick to a tick of a move that began at `start`. */
static void plot(FILE *file, atraj_move const *axis, double start, double cycle, int every)
{
    int const ticks = (int)(axis->t / cycle + 0.5);
    for (int tick = 0; tick <= ticks; tick += every)
    {
        atraj_state now;
        atraj_move_state(axis, (a_float)(tick * cycle), &now.p, &now.v, &now.a, NULL);
        fprintf(file, "at %.17g %.17g %.17g %.17g\n", start + tick * cycle, (double)now.p, (double)now.v, (double)now.a);
    }
}

/* Prints the duration of a move, and by how much an axis arrives early. */
static void count(char const *name, atraj_move const *axes, size_t n, double cycle)
{
    double early = 0;
    for (size_t i = 0; i != n; ++i) { early = fmax(early, fabs(axes[0].t - axes[i].t)); }
    printf("%-24s%10.3f%10d%10.17g\n", name, (double)axes[0].t, (int)(axes[0].t / cycle + 0.5), early);
}

static int gantry(FILE *file)
{
    double const cycle = 0.001;
    struct axes const gantry = {xyz, {{1, -1, 4, -4, 20, -20}, {(a_float)0.8, (a_float)-0.8, 2, -2, 10, -10}, {2, -2, 8, -8, 80, -80}}, 3};
    atraj_move together[3], line[3];
    if (atraj_moves_sync(together, gantry.limits, corner, target, 3, 0, (a_float)cycle) < 0) { return 1; }
    if (atraj_moves_line(line, gantry.limits, corner, target, 3, 0, (a_float)cycle) < 0) { return 1; }
    count("gantry, synchronised", together, 3, cycle);
    count("gantry, on a line", line, 3, cycle);
    fputs("move Gantry synchronised: three axes with limits of their own arrive together\n", file);
    for (int i = 0; i < 3; ++i)
    {
        fprintf(file, "curve %s\n", gantry.names[i]);
        plot(file, &together[i], 0, cycle, 2);
    }
    fputs("move Gantry on a straight line: within the tightest limits, every axis is as far on its way as the others\n", file);
    for (int i = 0; i < 3; ++i)
    {
        fprintf(file, "curve %s\n", gantry.names[i]);
        plot(file, &line[i], 0, cycle, 2);
    }
    fputs("path Gantry in the plane: the path of x and y\n", file);
    for (int moves = 0; moves < 2; ++moves)
    {
        atraj_move const *const axes = moves ? line : together;
        fprintf(file, "curve %s\n", moves ? "on a straight line" : "synchronised");
        for (int tick = 0; tick * cycle <= axes->t; tick += 5)
        {
            a_float const x = (a_float)(tick * cycle);
            fprintf(file, "at %.17g %.17g\n", (double)atraj_move_pos(&axes[0], x), (double)atraj_move_pos(&axes[1], x));
        }
        fprintf(file, "at %.17g %.17g\n", (double)target[0].p, (double)target[1].p);
    }
    return 0;
}

static int arm(FILE *file)
{
    double const cycle = 0.004;
    atraj_limits limits[MOST];
    atraj_move legs[LEGS][MOST];
    for (int i = 0; i < MOST; ++i)
    {
        if (i < 3) { atraj_limits_init(&limits[i], 70, 9, 2); }
        else { atraj_limits_init(&limits[i], 160, 18, 4); }
    }
    for (int leg = 0; leg < LEGS; ++leg)
    {
        char name[24];
        if (atraj_moves_sync(legs[leg], limits, points[leg], points[leg + 1], MOST, 0, (a_float)cycle) < 0) { return 1; }
        sprintf(name, "arm, leg %d", leg + 1);
        count(name, legs[leg], MOST, cycle);
    }
    fputs("move Arm over way points: six joints arrive together at each point; rad in place of m\n", file);
    for (int i = 0; i < MOST; ++i)
    {
        double start = 0;
        fprintf(file, "curve %s\n", joints[i]);
        for (int leg = 0; leg < LEGS; start += legs[leg++]->t) { plot(file, &legs[leg][i], start, cycle, 1); }
    }
    return 0;
}

int main(int argc, char *argv[])
{
    FILE *const setpoints = argc == 2 ? fopen(argv[1], "a") : NULL;
    if (!setpoints)
    {
        fprintf(stderr, "usage: several_axes setpoints.txt (a file that can be written)\n");
        return EXIT_FAILURE;
    }
    printf("\n%-24s%10s%10s%10s\n", "planned together", "s", "ticks", "apart");
    int const failed = gantry(setpoints) || arm(setpoints);
    int const written = !ferror(setpoints);
    return fclose(setpoints) == 0 && written && !failed ? EXIT_SUCCESS : EXIT_FAILURE;
}
