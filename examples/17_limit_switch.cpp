/*
 Stops on a limit switch. A host sends the axis too far. When the axis passes the switch, it stops as hard as its drive can: the stop
 has limits of its own, which are wider than those of the work. Then the axis goes back to its range. The main loop reads the switch
 and plans; a timer interrupt asks for a setpoint every millisecond. The work keeps a jerk of 30 m/s^3, an acceleration of 3 m/s^2 and a
 velocity of 1 m/s, the stop a jerk of 500 m/s^3 and an acceleration of 15 m/s^2. This program prints one setpoint in 250.

     make dist
     c++ -Itarget/dist/include examples/17_limit_switch.cpp target/dist/lib/libatraj.a -lm -o limit_switch
*/
#include "atraj/axis.h"
#include <cstdio>

static const double PERIOD = 0.001; // s
static const unsigned LEAD = 4; // ticks that a plan takes, and one more

int main()
{
    const a_float at_switch = 0.8;
    const atraj::state start = {0, 0, 0}, too_far = {2, 0, 0}, back = {0.7, 0, 0}; // m, m/s, m/s^2
    atraj::state now = start;
    atraj::limits work, hardest;
    atraj::axis axis;
    int found = axis.init(PERIOD, start), has_passed = 0; // found below 0: an error
    work.init(30, 3, 1);
    hardest.init(500, 15, 1);
    std::puts("Stopping on a limit switch: a target too far, a stop with limits of its own, and back");
    std::puts("within 1 m/s");
    std::puts("work within 3 m/s^2, 30 m/s^3");
    std::puts("stop within 15 m/s^2, 500 m/s^3");
    std::puts("the switch is at 0.8 m");
    if (found >= 0) { found = axis.go(work, too_far, LEAD); }
    for (int tick = 0; found >= 0 && tick <= 3000; ++tick)
    {
        // The main loop: the switch closes. Later the axis is sent back.
        if (!has_passed && now.p >= at_switch)
        {
            std::printf("%.3f s -> stop\n", tick * PERIOD);
            found = axis.stop(hardest, LEAD);
            has_passed = 1;
        }
        if (tick == 2000)
        {
            std::printf("2.000 s -> back\n%.4f m past the switch\n", now.p - at_switch);
            found = axis.go(work, back, LEAD);
        }
        // The interrupt.
        now = axis.tick();
        if (tick % 250 == 0) { std::printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2\n", tick * PERIOD, now.p, now.v, now.a); }
    }
    return !(found >= 0 && now.p == back.p && now.v == 0);
}
