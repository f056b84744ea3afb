/*
 Gives a moving axis a new target, behind it. The axis brakes, turns round and arrives at rest; its velocity never jumps.
 A controller asks for a setpoint every millisecond; this program prints one in 500.

     make dist
     c++ -Itarget/dist/include/claraty examples/retarget.cpp target/dist/lib/libatraj.a -lm -o retarget
*/
#include <trapezoidal_trajectory.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

static const double PERIOD = 0.001; // s

int main()
{
    claraty::Trapezoidal_Trajectory axis;
    double position = 0, velocity = 0, acceleration = 0, change = 0;
    // A manual clock, so that every run prints the same. A controller keeps the clock of the system.
    claraty_trapezoid_set_clock(axis.handle(), 0, 0);
    axis.set(10, 2, 4, 4); // to 10 m at 2 m/s, speeding up and braking at 4 m/s^2
    axis.start();
    for (int tick = 0; axis.is_started(); ++tick)
    {
        const double before = velocity;
        if (tick == 2000)
        {
            axis.set(1, 2, 4, 4);
            axis.start();
        }
        axis.get_setpoint(position, velocity, acceleration);
        change = std::max(change, std::fabs(velocity - before));
        if (tick % 500 == 0) { std::printf("%.1f s: %.4f m, %.4f m/s\n", tick * PERIOD, position, velocity); }
        axis.advance_timer_by(PERIOD);
    }
    std::printf("at rest at %.4f m; the velocity changed by at most %.4f m/s per period\n", position, change);
    return !(position == 1 && velocity == 0 && change < 0.0041);
}
