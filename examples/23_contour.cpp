/*
 Follows the contour of a part, whose corners are the rows of a CSV file, and leaves the lines between them by 0.02 mm at most. The planner
 adds points where the path would leave a line too far. This program prints one setpoint in 10 of a clock of 1 ms: the positions and the
 speed; and how far the path leaves the lines.

     make dist
     c++ -Itarget/dist/include examples/23_contour.cpp target/dist/lib/libatraj.a -lm -o contour
     ./contour examples/23_contour.csv
*/
#include "atraj/path.h"
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

static const double CYCLE = 0.001; // s
enum { X, Y, AXES };
enum { ROOM = 200 };

int main(int argc, char *argv[])
{
    std::ifstream file(argc > 1 ? argv[1] : "examples/23_contour.csv");
    std::vector<atraj::state> states;
    std::string heading;
    std::getline(file, heading);
    double x, y;
    for (char comma; file >> x >> comma >> y;)
    {
        const atraj::state corner[AXES] = {{x, 0, 0}, {y, 0, 0}}; // mm
        states.insert(states.end(), corner, corner + AXES);
    }
    const std::size_t corners = states.size() / AXES;
    if (corners < 2 || corners > ROOM) { return 1; }
    states.resize(AXES * (ROOM + 1));
    atraj::limits limits[AXES];
    for (int i = 0; i < AXES; ++i) { limits[i].init(60000, 3000, 100); }
    std::vector<atraj::move> moves(AXES * ROOM);
    std::vector<double> durations(ROOM), work(atraj_path_size(AXES, ROOM));
    std::vector<std::size_t> places(corners);
    if (atraj_path_contour(&moves[0], &states[0], &durations[0], &places[0], limits, 0.02, AXES, corners - 1, ROOM, 0, &work[0]) < 0)
    {
        return 1;
    }
    const std::size_t sections = places.back();
    std::puts("Contour of a part: its corners come from a CSV file, and the colour is the speed");
    std::puts("each axis keeps 100 mm/s, 3000 mm/s^2 and 60000 mm/s^3\ncontour:");
    double start = 0;
    int tick = 0;
    for (std::size_t k = 0; k < sections; ++k)
    {
        const atraj::move *axes = &moves[AXES * k];
        for (; tick * CYCLE < start + durations[k]; ++tick)
        {
            if (tick % 10 != 0) { continue; }
            const double now = tick * CYCLE - start, vx = axes[X].vel(now), vy = axes[Y].vel(now);
            std::printf("%.3f s: %.3f %.3f mm, %.2f mm/s\n", tick * CYCLE, axes[X].pos(now), axes[Y].pos(now), std::sqrt(vx * vx + vy * vy));
        }
        start += durations[k];
    }
    std::printf("%.3f s: %.3f %.3f mm, 0.00 mm/s\n", start, states[AXES * sections + X].p, states[AXES * sections + Y].p);
    const double deviation = atraj_path_deviation(&moves[0], AXES, sections);
    std::printf("%d corners, %d points: at most %.4f mm from the lines\n", int(corners), int(sections) + 1, deviation);
    return deviation > 0.02;
}
