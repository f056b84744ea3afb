/*
 A liba program, relinked: neither its source nor its object file changes. It prints every digit, and every digit is the same
 with either library.

 With liba:
     c++ examples/01_relink.cpp -la -lm -o relink
 With atraj; the archive stands before liba, because the linker takes a function from the first archive that has it:
     c++ -Itarget/dist/include examples/01_relink.cpp target/dist/lib/libatraj.a -la -lm -o relink
 This program uses nothing else of liba, so it needs no -la. Keep liba's headers or take ours: the ABI is the same.
*/
#include "a/trajbell.h"
#include <cstdio>

int main()
{
    a::trajbell move;
    const a_float duration = move.gen(30, 10, 10, 0, 10, 1, 0);
    std::puts("Relinked: a double-S without cruise, every digit as from liba");
    std::puts("within 10 m/s, 10 m/s^2, 30 m/s^3");
    for (int i = 0; i <= 1000; i += 250) // of 1000 setpoints, one in 250 is printed
    {
        const a_float x = duration / 1000 * i;
        std::printf("%.17f s: %.17f m, %.17f m/s, ", x, move.pos(x), move.vel(x));
        std::printf("%.17f m/s^2, %.17f m/s^3\n", move.acc(x), move.jer(x));
    }
    return !(duration > 0);
}
