/*
 A liba program, relinked: neither its source nor its object file changes. It prints every digit, and every digit is the same
 with either library.

 With liba:
     c++ examples/relink.cpp -la -lm -o relink
 With atraj; the archive stands before liba, because the linker takes a function from the first archive that has it:
     c++ -Itarget/dist/include examples/relink.cpp target/dist/lib/libatraj.a -la -lm -o relink
 This program uses nothing else of liba, so it needs no -la. Keep liba's headers or take ours: the ABI is the same.
*/
#include "a/trajbell.h"
#include <cstdio>

int main()
{
    a::trajbell move;
    const a_float duration = move.gen(30, 10, 10, 0, 10, 1, 0);
    const a_float x = duration / 3;
    std::printf("duration     %.17f s\n", duration);
    std::printf("position     %.17f m\n", move.pos(x));
    std::printf("velocity     %.17f m/s\n", move.vel(x));
    std::printf("acceleration %.17f m/s^2\n", move.acc(x));
    std::printf("jerk         %.17f m/s^3\n", move.jer(x));
    return !(duration > 0);
}
