/*
 A load hangs on an axis and swings with 1.2 Hz and 1 % of the critical damping. This program moves the axis by 0.5 m and computes what the load does, with
 a shaper and without one. The shaper keeps all limits of the move, and takes half a period longer. This program prints one setpoint in 2500 of 0.1 ms.

     make dist
     c++ -Itarget/dist/include examples/21_swing.cpp target/dist/lib/libatraj.a -lm -o swing
*/
#include "atraj/shaper.h"
#include <algorithm>
#include <cmath>
#include <cstdio>

static const double CYCLE = 0.0001; // s

// How far the load is ahead of the axis, m, and how fast it gets farther, m/s.
struct load
{
    double p, v;

    // The load swings for a cycle, while the axis has this acceleration.
    void swing(double acceleration)
    {
        const double w = 2 * 3.141592653589793 * 1.2, damping = 0.01; // 1/s
        v += CYCLE * (-acceleration - 2 * damping * w * v - w * w * p);
        p += CYCLE * v;
    }
};

int main()
{
    const atraj::state from = {0, 0, 0}, to = {0.5, 0, 0}; // m
    atraj::move move;
    atraj::shaper shaper;
    load shaped = {0, 0}, plain = {0, 0};
    double most_shaped = 0, most_plain = 0; // m
    const atraj::limits limits = atraj::limits::symmetric(40, 4, 1); // jerk, acceleration, velocity
    if (move.plan(limits, from, to) < 0) { return 1; }
    if (shaper.init(ATRAJ_SHAPER_ZV, 1.2, 0.01) < 0) { return 1; }
    std::puts("A load that swings: with a shaper, and without one");
    std::puts("within 1 m/s, 4 m/s^2");
    for (int tick = 0; tick <= 25000; ++tick)
    {
        const double x = tick * CYCLE, end = move.t + shaper.t;
        const atraj::state now = shaper.state(move, x);
        if (tick % 2500 == 0)
        {
            const double p = move.pos(x);
            std::printf("%.3f s: %.4f m, %.4f m/s, %.4f m/s^2, load %.4f m, load without a shaper %.4f m\n", x, now.p, now.v, now.a, now.p + shaped.p, p + plain.p);
        }
        shaped.swing(now.a);
        plain.swing(move.acc(x));
        if (x > end)
        {
            most_shaped = std::max(most_shaped, std::fabs(shaped.p));
            most_plain = std::max(most_plain, std::fabs(plain.p));
        }
    }
    std::printf("%.3f s without a shaper, then the load swings by %.1f mm\n", move.t, 1000 * most_plain);
    std::printf("%.3f s with a shaper, then the load swings by %.1f mm\n", move.t + shaper.t, 1000 * most_shaped);
    return !(most_shaped < most_plain / 100);
}
