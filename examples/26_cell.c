/*
 A cell of two axes: the main loop plans, and the interrupt ticks. The axes move on a line. An operator presses the pause button, goes on at
 half the speed, sends the axes elsewhere in mid-motion, and opens the door. Then they go home. A plan takes over four ticks after the call.
 Here one loop is main loop and interrupt. This program prints one setpoint in 125 of a clock of 2 ms: positions, velocities, accelerations.

     make dist
     cc -Itarget/dist/include examples/26_cell.c target/dist/lib/libatraj.a -lm -o cell
*/
#include "atraj/group.h"
#include <stdio.h>

#define CYCLE 0.002 /* s */
#ifndef EVERY
#define EVERY 125 /* print every EVERY-th setpoint */
#endif
enum { AXES = 2, LEAD = 4 };

static atraj_limits limits[AXES], planned[AXES];

static int command(atraj_group *cell, int tick, char const **what)
{
    static atraj_state const part[AXES] = {{0.8, 0, 0}, {0.4, 0, 0}}, bin[AXES] = {{0.2, 0, 0}, {0.5, 0, 0}}, home[AXES] = {{0, 0, 0}, {0, 0, 0}}; /* m */
    switch (tick)
    {
    case 0: *what = "line to the part"; return atraj_group_line(cell, planned, part, LEAD);
    case 250: *what = "feed hold"; return atraj_group_rate(cell, limits, 0, LEAD);
    case 600: *what = "override 50 %"; return atraj_group_rate(cell, limits, 0.5, LEAD);
    case 900: *what = "to the bin"; return atraj_group_sync(cell, planned, bin, LEAD);
    case 1000: *what = "stop"; return atraj_group_stop(cell, limits, LEAD);
    case 1500: *what = "line home"; return atraj_group_line(cell, planned, home, LEAD);
    default: return 0;
    }
}

int main(void)
{
    atraj_state states[AXES] = {{0, 0, 0}, {0, 0, 0}}, now[AXES];
    atraj_move room[3 * AXES];
    atraj_group cell;
    for (int i = 0; i < AXES; ++i) {
        atraj_limits_init(&limits[i], 20, 4, 1); /* jerk, acceleration, velocity */
        atraj_limits_init(&planned[i], 0.85 * 20, 0.85 * 4, 0.85 * 1);
    }
    if (atraj_group_init(&cell, CYCLE, states, room, AXES) < 0) { return 1; }
    puts("Working in a cell: hold, override, retarget, stop");
    puts("within 1 m/s, 4 m/s^2");
    for (int tick = 0, event = 0; tick < 1500 || !(event & ATRAJ_TICK_ENDS); ++tick) {
        char const *what = NULL;
        event = atraj_group_tick(&cell, now); /* the interrupt */
        if (command(&cell, tick, &what) < 0) { return 1; } /* the main loop */
        if (what) { printf("%.3f s -> %s\n", tick * CYCLE, what); }
        if (tick % EVERY == 0) {
            printf("%.3f s: %.4f %.4f m, %.4f %.4f m/s, %.4f %.4f m/s^2\n", tick * CYCLE, now[0].p, now[1].p, now[0].v, now[1].v, now[0].a, now[1].a);
        }
    }
    printf("home at %.4f %.4f m\n", now[0].p, now[1].p);
    return 0;
}
