/*
 CLARAty's trapezoid: a controller moves an axis, gives it a target behind it, holds it, and resumes. The axis brakes and turns
 round; its velocity never jumps. The controller asks for a setpoint every millisecond; this program prints one in 200.

     make dist
     c++ -Itarget/dist/include/claraty examples/11_claraty.cpp target/dist/lib/libatraj.a -lm -o claraty
*/
#include <trapezoidal_trajectory.h>

#include <cmath>
#include <cstdio>

static const double PERIOD = 0.001; // s

// At 0.5 m/s, speeding up at 1 m/s^2, braking at 0.8 m/s^2. The position counts from the place where the axis rested.
static void go_to(claraty::Trapezoidal_Trajectory &axis, double position)
{
    axis.set(position, 0.5, 1, 0.8);
    axis.start();
}

int main()
{
    claraty::Trapezoidal_Trajectory axis;
    double origin = 0, position = 0, velocity = 0, acceleration = 0;
    // A manual clock, so that every run prints the same. A controller keeps the clock of the system.
    claraty_trapezoid_set_clock(axis.handle(), 0, 0);
    std::puts("Retarget and feed hold: to 0.6 m, at 0.8 s back to 0.1 m, held at 1.6 s, on at 2.4 s");
    std::puts("within 0.5 m/s, 1 m/s^2, 0.8 m/s^2");
    go_to(axis, 0.6);
    for (int tick = 0; tick <= 3500; ++tick)
    {
        if (tick == 800)
        {
            std::puts("0.800 s -> to 0.1 m");
            go_to(axis, 0.1);
        }
        if (tick == 1600)
        {
            std::puts("1.600 s -> hold");
            axis.stop();
        }
        if (tick == 2400)
        {
            std::puts("2.400 s -> on");
            origin = position; // the axis rests here
            go_to(axis, 0.1 - origin);
        }
        axis.get_setpoint(position, velocity, acceleration);
        position += origin;
        if (tick % 200 == 0) { std::printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2\n", tick * PERIOD, position, velocity, acceleration); }
        axis.advance_timer_by(PERIOD);
    }
    return !(std::fabs(position - 0.1) < 1e-12 && velocity == 0);
}
