/*
 Two axes follow points that arrive while they move, 20 each second; the drives take a setpoint every millisecond. The axes pass the
 points without stops, and 6 points are known at the start. The plan ends at rest at the newest point, so the axes can stop if no point
 follows. A new point is appended, and 8 steps improve the plan after the current section. This program prints one setpoint in 50:
 the positions, then the velocities and accelerations.

     make dist
     c++ -Itarget/dist/include examples/14_horizon.cpp target/dist/lib/libatraj.a -lm -o horizon
*/
#include "atraj/path.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

static const double CYCLE = 0.001; // s
enum { EVERY = 50 }; // print every EVERY-th setpoint
enum { AXES = 2, POINTS = 60, AHEAD = 6, PERIOD = 50, STEPS = 8 };
enum { MOST = 12, SIZE = ATRAJ_PATH_SIZE(AXES, MOST) };

// The plan. Its first section is under way.
static atraj::limits limits[AXES];
static atraj::state states[MOST + 1][AXES];
static double durations[MOST];
static size_t sections;
// The motions of the first section, and when it began, s.
static atraj::move axes[AXES];
static double start;

// A point of a slalom: 20 mm further, and 40 mm to each side.
static void slalom(int k, atraj::state point[])
{
    const double u = k % 20 / 20.0, side = k / 20 % 2 ? -0.16 : 0.16;
    point[0].p = 0.02 * k, point[1].p = side * u * (1 - u);
    point[0].v = point[0].a = point[1].v = point[1].a = 0;
}

static int begin_section(double now)
{
    start = now;
    return atraj_path_moves(axes, limits, states[0], durations, AXES, 1);
}

static void drop_section(void)
{
    --sections;
    std::memmove(states, states + 1, (sections + 1) * sizeof(states[0]));
    std::memmove(durations, durations + 1, sections * sizeof(durations[0]));
}

// Appends a point, and improves all sections after the current one.
static int append(const atraj::state point[])
{
    static double work[SIZE];
    if (sections == MOST) { return ATRAJ_ERR_TARGET; }
    std::memcpy(states[sections + 1], point, sizeof(states[0]));
    durations[sections] = 0;
    return atraj_path_improve(&states[1][0], durations + 1, limits, AXES, sections++, STEPS, work);
}

int main()
{
    static double work[SIZE];
    double slowest = HUGE_VAL;
    size_t longest = 0;
    int fed = 0;
    limits[0].init(100, 8, 0.42); // jerk, acceleration, velocity
    limits[1].init(20, 8, 0.42); // y has time to spare: a lower jerk keeps its acceleration smooth
    std::puts("Receding horizon: two axes pass points that arrive while they move");
    std::puts("within 0.42 m/s, 8 m/s^2");
    for (; fed <= AHEAD; ++fed) { slalom(fed, states[fed]); }
    sections = AHEAD;
    if (atraj_path_plan(&states[0][0], durations, limits, AXES, sections, 0, work) < 0 || begin_section(0) < 0) { return 1; }
    for (int tick = 0; sections > 0; ++tick)
    {
        const double now = tick * CYCLE;
        atraj::state at[AXES];
        for (int i = 0; i < AXES; ++i)
        {
            at[i] = axes[i].state(now - start);
            if (std::fabs(at[i].v) > 0.42 + 1e-9 || std::fabs(at[i].a) > 8 + 1e-9) { return 1; } // a rounding
        }
        if (tick % EVERY == 0)
        {
            std::printf("%.3f s: %.4f %.4f m, %.4f %.4f m/s, %.4f %.4f m/s^2\n", now, at[0].p, at[1].p, at[0].v, at[1].v, at[0].a,
                at[1].a);
        }
        if (tick > 300 && fed <= POINTS) { slowest = std::min(slowest, at[0].v); }
        if (tick % PERIOD == PERIOD - 1 && fed <= POINTS)
        {
            atraj::state point[AXES];
            slalom(fed++, point);
            if (append(point) < 0) { return 1; }
            if (longest < sections) { longest = sections; }
        }
        if (now + CYCLE >= start + axes[0].t)
        {
            const double end = start + axes[0].t;
            drop_section();
            if (sections > 0 && begin_section(end) < 0) { return 1; }
        }
    }
    std::printf("at most %d sections ahead, at least %.2f m/s along the slalom\n", (int)longest, slowest);
    return !(slowest > 0.3 && states[0][0].p == 0.02 * POINTS);
}
