/*
 A 1 kHz controller of one axis, in the style of CLARAty's users: a move, a new target in mid-motion, a feed hold, and the
 rest of the way. It prints the setpoints for the drive in the form of `servo.c`, and `plot.rs` draws them.
*/
#include <trapezoidal_trajectory.h>

#include <algorithm>
#include <cstdio>

namespace
{

const double PERIOD = 1e-3;                            // s
const double VELOCITY = 0.5, ACCEL = 1.0, DECEL = 0.8; // m/s, m/s^2

class Axis
{
public:
    Axis() : _ticks(0), _begun(0), _origin(0), _position(0)
    {
        // The manual clock moves one period per tick, so every run is the same. A real controller keeps the system's clock.
        claraty_trapezoid_set_clock(_trajectory.handle(), 0, 0);
    }

    void go_to(double position)
    {
        print_phases();
        // Positions count from the place where the trajectory started from rest. A retarget in motion keeps that origin.
        if (!_trajectory.is_started()) { _origin = _position; }
        _trajectory.set(position - _origin, VELOCITY, ACCEL, DECEL);
        _trajectory.start();
    }

    void hold()
    {
        print_phases();
        _trajectory.stop();
    }

    // One control period: prints the setpoint and returns whether the motion goes on.
    bool tick()
    {
        double position, velocity, accel;
        _trajectory.get_setpoint(position, velocity, accel);
        _position = _origin + position;
        std::printf("at %.17g %.17g %.17g %.17g\n", now(), _position, velocity, accel);
        _trajectory.advance_timer_by(PERIOD);
        ++_ticks;
        return _trajectory.is_started();
    }

    // Prints the phases of the motion since the last command.
    void print_phases()
    {
        claraty_profile p;
        claraty_trapezoid_get_profile(_trajectory.handle(), &p);
        print_phase(0, p.t1, "accelerate");
        print_phase(p.t1, p.t2, "cruise");
        print_phase(p.t2, p.tf, "decelerate");
        _begun = now();
    }

private:
    claraty::Trapezoidal_Trajectory _trajectory;
    long _ticks;
    double _begun, _origin, _position;

    double now() const { return static_cast<double>(_ticks) * PERIOD; }

    void print_phase(double from, double to, const char *name) const
    {
        from += _begun;
        to = std::min(to + _begun, now());
        if (from < to) { std::printf("phase %.17g %.17g %s\n", from, to, name); }
    }
};

} // namespace

int main()
{
    std::puts("move Retarget and feed hold: to 0.6 m, at 0.8 s back to 0.1 m, held at 1.6 s, on at 2.4 s");
    Axis axis;
    bool moving = true;
    for (int tick = 0; moving || tick <= 2400; ++tick)
    {
        switch (tick)
        {
        case 0: axis.go_to(0.6); break;
        case 800: axis.go_to(0.1); break;
        case 1600: axis.hold(); break;
        case 2400: axis.go_to(0.1); break;
        default: break;
        }
        moving = axis.tick();
    }
    axis.print_phases();
    return 0;
}
