/*
 One prefix further: 6 m to go, at 7.5 m/s, with an acceleration of 2.5 m/s^2 at most. This is too near to stop. The plan of
 a_trajbell_gen breaks the limit. atraj_bell_gen takes the same arguments and fills the same struct, and its plan passes the
 target and comes back. The same methods evaluate both plans. This program prints one setpoint in 1000.

     make dist
     c++ -Itarget/dist/include examples/05_one_prefix.cpp target/dist/lib/libatraj.a -lm -o one_prefix
*/
#include "atraj.h"
#include <cstdio>

static const a_float PERIOD = 0.001; // s

static void print(const char *name, const a::trajbell &move, a_float x)
{
    std::printf("%s%.4f m, %.4f m/s, %.4f m/s^2", name, move.pos(x), move.vel(x), move.acc(x));
}

static const char *judge(const a::trajbell &move)
{
    return atraj_bell_check(&move, 30, 2.5, 10) & ATRAJ_EXCEEDS_ACCELERATION ? "breaks the limit" : "keeps the limit";
}

int main()
{
    a::trajbell liba, ours;
    liba.gen(30, 2.5, 10, 0, 6, 7.5, 0); // jerk, acceleration, velocity; from, to; velocities there
    const a_float duration = atraj_bell_gen(&ours, 30, 2.5, 10, 0, 6, 7.5, 0);
    std::puts("Too near to stop: 6 m to go at 7.5 m/s");
    std::puts("within 10 m/s, 2.5 m/s^2, 30 m/s^3");
    for (int tick = 0; tick * PERIOD < duration; tick += 1000)
    {
        const a_float x = tick * PERIOD;
        std::printf("%.3f s: ", x);
        print("", ours, x);
        print(", a_trajbell_gen ", liba, x);
        std::puts("");
    }
    std::printf("a_trajbell_gen %s, atraj_bell_gen %s\n", judge(liba), judge(ours));
    return atraj_bell_check(&ours, 30, 2.5, 10) != ATRAJ_OVERSHOOTS;
}
