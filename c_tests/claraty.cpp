// Tests that each member of CLARAty's C++ class calls its C function. `claraty.c` replays the golden scripts.
#include <trapezoidal_trajectory.h>

#include "promises.h"
#include <cmath>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

typedef claraty::Trapezoidal_Trajectory axis;

// CLARAty's own vector has get_size() instead of size().
class Vector {
public:
    explicit Vector(int n) : _n(n) {}
    int get_size() const { return _n; }
    double &operator[](int i) { return _element[i]; }

private:
    int _n;
    double _element[8];
};

// Takes every second element of an array, so its elements do not lie side by side.
class Strided {
public:
    std::size_t size() const { return 2; }
    double &operator[](std::size_t i) { return _element[2 * i]; }

private:
    double _element[4];
};

axis manual() {
    axis x;
    claraty_trapezoid_set_clock(x.handle(), 0, 0);
    return x;
}

void members() {
    axis x = manual();
    claraty::Trajectory &base = x;
    base.set(10, 2, 2);
    base.start();
    PROMISE(base.is_started());
    base.advance_timer_by(2);
    PROMISE(base.get_position() == 3 && base.get_velocity() == 2 && base.get_acceleration() == 0);
    PROMISE(base.get_position(0.5) == 0.25 && base.get_velocity(0.5) == 1 && base.get_acceleration(0.5) == 2);
    double p, v, a;
    x.get_setpoint(p, v, a);
    PROMISE(p == 3 && v == 2 && a == 0);
    x.get_setpoint(0.5, p, v, a);
    PROMISE(p == 0.25 && v == 1 && a == 2);
    axis copy = x;
    x.stop();
    PROMISE(x.get_position(1000) == 4 && copy.get_position(1000) == 10);
    x.reset();
    PROMISE(!x.is_started() && copy.is_started());
    int position = -10, velocity = 2, accel = 4, decel = 1;
    x.set(position, velocity, accel, decel);
    x.start();
    std::ostringstream text;
    text << x;
    PROMISE(text.str() == "trapezoidal t1 0.5 t2 4.25 tf 6.25 p(t1) -0.5 p(t2) -8 p(tf) -10 v -2 a -4 d 1");
    x.set(position, velocity, accel);
    const axis::trajectory_type types[2] = {axis::TRIANGULAR, axis::TRAPEZOIDAL};
    PROMISE(types[0] == 0 && types[1] == 1);
}

template <class V>
void along(V p, V v, V a) {
    axis each = manual(), same = manual();
    p[0] = 2, p[1] = -1, p[2] = 4;
    for (int i = 0; i < 3; ++i) { v[i] = 1, a[i] = 2; }
    each.set(p, v, a);
    same.set(p, 1, 2);
    each.start();
    same.start();
    // The legs are 2, 3 and 5 units long, at 1 unit/s; each takes half a second more to speed up and brake.
    PROMISE(claraty_trapezoid_duration(each.handle()) == 11.5);
    for (double t = 0; t < 12; t += 0.1) { PROMISE(each.get_position(t) == same.get_position(t)); }
    PROMISE(each.get_position(2.5) == 2 && each.get_position(6) == -1 && each.get_position(0) == 0);
}

std::string told(void (*what)(axis &)) {
    std::ostringstream caught;
    std::streambuf *const cerr = std::cerr.rdbuf(caught.rdbuf());
    axis x = manual();
    what(x);
    std::cerr.rdbuf(cerr);
    return caught.str();
}

std::string line(const std::string &text) {
#if defined(CLARATY_NO_WARNINGS)
    return text.substr(0, 0);
#else
    return "claraty::Trajectory::" + text + "\n";
#endif
}

void nothing_to_tell(axis &x) {
    x.set(10, 2, 2);
    x.start();
    x.stop();
}
void too_small(axis &x) {
    x.set(1, 0, 0, 1);
    x.start();
}
void not_finite(axis &x) { x.set(std::sqrt(-1.0), 1, 1); }
void too_large(axis &x) { x.set(1e300, 1e150, 1e-20); }
void different_sizes(axis &x) {
    std::vector<double> p(2, 1.0), v(3, 1.0);
    x.set(p, v, p);
}
void strided(axis &x) {
    Strided p;
    p[0] = p[1] = 1;
    x.set(p, 1, 1);
}

void warnings() {
    PROMISE(told(nothing_to_tell) == "");
    PROMISE(told(too_small) == line("start: acceleration too small, raised") + line("start: maximum velocity too small, raised"));
    PROMISE(told(not_finite) == line("set: refused, not a finite number"));
    PROMISE(told(too_large) == line("set: refused, a number larger than 1e60"));
    PROMISE(told(different_sizes) == line("set: refused, vectors empty or of different size"));
    PROMISE(told(strided) == line("set: refused, elements not side by side"));
}

} // namespace

int main() {
    members();
    along(std::vector<double>(3), std::vector<double>(3), std::vector<double>(3));
    along(Vector(3), Vector(3), Vector(3));
    warnings();
    return broken;
}
