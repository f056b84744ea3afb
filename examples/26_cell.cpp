/*
 A cell of two axes: the main loop plans, and the interrupt ticks. The axes move on a line. An operator presses the pause button, goes on at
 half the speed, sends the axes elsewhere in mid-motion, and opens the door. Then they go home. A plan takes over four ticks after the call.
 Here one loop is main loop and interrupt. This program prints one setpoint in 125 of a clock of 2 ms: positions, velocities, accelerations.

     make dist
     c++ -Itarget/dist/include examples/26_cell.cpp target/dist/lib/libatraj.a -lm -o cell
*/
#include "atraj/group.h"
#include <cstdio>

static const double CYCLE = 0.002; // s
enum { AXES = 2, LEAD = 4 };

static atraj::limits limits[AXES], planned[AXES];

static int command(atraj::group &cell, int tick, const char *&what)
{
    static const atraj::state part[AXES] = {{0.8, 0, 0}, {0.4, 0, 0}}, bin[AXES] = {{0.2, 0, 0}, {0.5, 0, 0}}, home[AXES] = {{0, 0, 0}, {0, 0, 0}}; // m
    switch (tick)
    {
    case 0: what = "line to the part"; return cell.line(planned, part, LEAD);
    case 250: what = "feed hold"; return cell.rate(limits, 0, LEAD);
    case 600: what = "override 50 %"; return cell.rate(limits, 0.5, LEAD);
    case 900: what = "to the bin"; return cell.sync(planned, bin, LEAD);
    case 1000: what = "stop"; return cell.stop(limits, LEAD);
    case 1500: what = "line home"; return cell.line(planned, home, LEAD);
    default: return 0;
    }
}

int main()
{
    atraj::state states[AXES] = {{0, 0, 0}, {0, 0, 0}}, now[AXES];
    atraj::move room[3 * AXES];
    atraj::group cell;
    for (int i = 0; i < AXES; ++i)
    {
        limits[i].init(20, 4, 1); // jerk, acceleration, velocity
        planned[i].init(0.85 * 20, 0.85 * 4, 0.85 * 1);
    }
    if (cell.init(CYCLE, states, room, AXES) < 0) { return 1; }
    std::puts("Working in a cell: hold, override, retarget, stop");
    std::puts("within 1 m/s, 4 m/s^2");
    for (int tick = 0, event = 0; tick < 1500 || !(event & ATRAJ_TICK_ENDS); ++tick)
    {
        const char *what = 0;
        event = cell.tick(now); // the interrupt
        if (command(cell, tick, what) < 0) { return 1; } // the main loop
        if (what) { std::printf("%.3f s -> %s\n", tick * CYCLE, what); }
        if (tick % 125 == 0)
        {
            std::printf("%.3f s: %.4f %.4f m, %.4f %.4f m/s, %.4f %.4f m/s^2\n", tick * CYCLE, now[0].p, now[1].p, now[0].v, now[1].v, now[0].a, now[1].a);
        }
    }
    std::printf("home at %.4f %.4f m\n", now[0].p, now[1].p);
    return 0;
}
