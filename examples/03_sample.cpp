/*
 Samples a whole move into arrays, in one call: 1001 positions, velocities and accelerations of a trapezoid at even times from
 the start to the end. This program prints one sample in 100.

     make dist
     c++ -Itarget/dist/include examples/03_sample.cpp target/dist/lib/libatraj.a -lm -o sample
*/
#include "atraj.h"
#include <cstdio>
#include <vector>

int main()
{
    std::vector<a_float> position(1001), velocity(1001), acceleration(1001);
    a::trajtrap move;
    const a_float step = move.gen(5, 4, -8, 0, 10) / 1000;
    const std::size_t count = atraj_trap_sample(&move, 0, step, position.size(), &position[0], &velocity[0], &acceleration[0]);

    bool same = count == position.size();
    std::puts("Trapezoid with cruise: 10 m from rest to rest, sampled in one call");
    std::puts("within 5 m/s, +4 m/s^2, -8 m/s^2");
    for (std::size_t k = 0; k < count; ++k)
    {
        const a_float x = static_cast<a_float>(k) * step;
        if (k % 100 == 0) { std::printf("%.4f s: %.4f m, %.4f m/s, %.4f m/s^2\n", x, position[k], velocity[k], acceleration[k]); }
        same = same && position[k] == move.pos(x);
    }
    std::printf("the same positions as from single calls: %s\n", same ? "yes" : "no");
    return !same;
}
