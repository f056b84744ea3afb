/*
 Finds home on a switch. The axis runs fast until the switch closes, runs back until it opens, and runs slowly onto it again. Where it
 closes now is known to a hundredth of a millimetre, because the axis was slow. Then the axis goes to its home, 0.1 m from the switch. Each
 change of direction is one plan from the present motion. The main loop reads the switch and plans; a timer interrupt asks for a
 setpoint every millisecond. The axis keeps a jerk of 50 m/s^3, an acceleration of 2 m/s^2 and a velocity of 0.2 m/s. This program
 prints one setpoint in 250.

     make dist
     c++ -Itarget/dist/include examples/16_homing.cpp target/dist/lib/libatraj.a -lm -o homing
*/
#include "atraj/axis.h"
#include <cstdio>

static const double PERIOD = 0.001; // s
static const unsigned LEAD = 4; // ticks that a plan takes, and one more

// The switch of the machine.
static int is_closed(a_float p) { return p <= -0.31273; }

int main()
{
    enum { FAST, BACK, SLOW, HOME } step = FAST;
    atraj::state now = {0, 0, 0}, home = {0, 0, 0}; // m, m/s, m/s^2
    atraj::axis axis;
    int found = axis.init(PERIOD, now); // below 0: an error
    const atraj::limits limits = atraj::limits::symmetric(50, 2, 0.2);
    std::puts("Homing on a switch: fast onto it, back, slowly onto it, and home, 0.1 m away");
    std::puts("within 0.2 m/s, 2 m/s^2, 50 m/s^3");
    if (found >= 0) { found = axis.reach(limits, -0.2, 0, LEAD); }
    for (int tick = 0; found >= 0 && tick <= 3200; ++tick)
    {
        // The main loop: the switch has closed or opened.
        const int closed = is_closed(now.p);
        if (step == FAST && closed)
        {
            std::printf("%.3f s -> back\n", tick * PERIOD);
            found = axis.reach(limits, 0.05, 0, LEAD);
            step = BACK;
        }
        else if (step == BACK && !closed)
        {
            std::printf("%.3f s -> slow\n", tick * PERIOD);
            found = axis.reach(limits, -0.01, 0, LEAD);
            step = SLOW;
        }
        else if (step == SLOW && closed)
        {
            std::printf("%.3f s -> home\n", tick * PERIOD);
            std::printf("the switch is at %.5f m\n", now.p);
            home.p = now.p + 0.1;
            found = axis.go(limits, home, LEAD);
            step = HOME;
        }
        // The interrupt.
        now = axis.tick();
        if (tick % 250 == 0) { std::printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2\n", tick * PERIOD, now.p, now.v, now.a); }
    }
    return !(found >= 0 && step == HOME && now.p == home.p && now.v == 0);
}
