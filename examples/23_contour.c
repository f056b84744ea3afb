/*
 Follows the contour of a part, whose corners are the rows of a CSV file, and leaves the lines between them by 0.02 mm at most. The planner
 adds points where the path would leave a line too far. This program prints one setpoint in 10 of a clock of 1 ms: the positions and the
 speed; and how far the path leaves the lines.

     make dist
     cc -Itarget/dist/include examples/23_contour.c target/dist/lib/libatraj.a -lm -o contour
     ./contour examples/23_contour.csv
*/
#include "atraj/path.h"
#include <math.h>
#include <stdio.h>

#define CYCLE 0.001 /* s */
#ifndef EVERY
#define EVERY 10 /* print every EVERY-th setpoint */
#endif
enum { X, Y, AXES };
enum { ROOM = 200, SIZE = ATRAJ_PATH_SIZE(AXES, ROOM) };

static atraj_state states[ROOM + 1][AXES];
static atraj_move moves[ROOM][AXES];
static double durations[ROOM], work[SIZE];
static size_t places[ROOM + 1];

/* Reads the corners, mm. The result is how many there are. */
static int read_corners(char const *name)
{
    FILE *const file = fopen(name, "r");
    int count = 0;
    if (file == NULL) { return 0; }
    if (fscanf(file, "x,y") == 0) {
        while (count <= ROOM && fscanf(file, "%lf,%lf", &states[count][X].p, &states[count][Y].p) == 2) { ++count; }
    }
    fclose(file);
    return count;
}

int main(int argc, char *argv[])
{
    atraj_limits limits[AXES];
    for (int i = 0; i < AXES; ++i) { atraj_limits_init(&limits[i], 60000, 3000, 100); }
    int const corners = read_corners(argc > 1 ? argv[1] : "examples/23_contour.csv");
    if (corners < 2) { return 1; }
    if (atraj_path_contour(moves[0], states[0], durations, places, limits, 0.02, AXES, (size_t)corners - 1, ROOM, 0, work) < 0) { return 1; }
    size_t const sections = places[corners - 1];
    puts("Contour of a part: its corners come from a CSV file, and the colour is the speed");
    puts("each axis keeps 100 mm/s, 3000 mm/s^2 and 60000 mm/s^3\ncontour:");
    double start = 0;
    int tick = 0;
    for (size_t k = 0; k < sections; ++k) {
        for (; tick * CYCLE < start + durations[k]; ++tick) {
            if (tick % EVERY != 0) { continue; }
            double p[AXES], v[AXES];
            for (int i = 0; i < AXES; ++i) { atraj_move_state(&moves[k][i], tick * CYCLE - start, &p[i], &v[i], NULL, NULL); }
            printf("%.3f s: %.3f %.3f mm, %.2f mm/s\n", tick * CYCLE, p[X], p[Y], sqrt(v[X] * v[X] + v[Y] * v[Y]));
        }
        start += durations[k];
    }
    printf("%.3f s: %.3f %.3f mm, 0.00 mm/s\n", start, states[sections][X].p, states[sections][Y].p);
    double const deviation = atraj_path_deviation(moves[0], AXES, sections);
    printf("%d corners, %d points: at most %.4f mm from the lines\n", corners, (int)sections + 1, deviation);
    return deviation > 0.02;
}
