/*
 Samples a whole move into arrays, in one call: 101 positions, velocities and accelerations at even times from the start to
 the end. Jerk is not wanted, so its array is 0.

     make dist
     c++ -Itarget/dist/include examples/sample.cpp target/dist/lib/libatraj.a -lm -o sample
*/
#include "atraj.h"
#include <algorithm>
#include <cstdio>
#include <vector>

int main()
{
    std::vector<a_float> position(101), velocity(101), acceleration(101);
    a::trajbell move;
    const a_float step = move.gen(30, 10, 5, 0, 10) / 100;
    const std::size_t count = atraj_bell_sample(&move, 0, step, position.size(), &position[0], &velocity[0], &acceleration[0], 0);

    bool same = true;
    for (std::size_t k = 0; k < count; ++k)
    {
        same = same && position[k] == move.pos(static_cast<a_float>(k) * step);
    }
    std::printf("%d samples, %.4f s apart\n", static_cast<int>(count), step);
    std::printf("from %.4f m to %.4f m\n", position.front(), position.back());
    std::printf("at most %.4f m/s and %.4f m/s^2\n", *std::max_element(velocity.begin(), velocity.end()),
                *std::max_element(acceleration.begin(), acceleration.end()));
    std::printf("the same positions as from single calls: %s\n", same ? "yes" : "no");
    return !same;
}
