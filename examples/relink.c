/*
 A liba program, relinked: neither its source nor its object file changes. It prints every digit, and every digit is the same
 with either library.

 With liba:
     cc examples/relink.c -la -lm -o relink
 With atraj; the archive stands before liba, because the linker takes a function from the first archive that has it:
     cc -Itarget/dist/include examples/relink.c target/dist/lib/libatraj.a -la -lm -o relink
 Whether the relink took:
     make identify FILE=relink
 This program uses nothing else of liba, so it needs no -la. Keep liba's headers or take ours: the ABI is the same.
*/
#include "a/trajbell.h"
#include <stdio.h>

int main(void)
{
    a_trajbell move;
    a_float const duration = a_trajbell_gen(&move, 30, 10, 10, 0, 10, 1, 0);
    a_float const x = duration / 3;
    printf("duration     %.17f s\n", duration);
    printf("position     %.17f m\n", a_trajbell_pos(&move, x));
    printf("velocity     %.17f m/s\n", a_trajbell_vel(&move, x));
    printf("acceleration %.17f m/s^2\n", a_trajbell_acc(&move, x));
    printf("jerk         %.17f m/s^3\n", a_trajbell_jer(&move, x));
    return !(duration > 0);
}
