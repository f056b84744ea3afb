/*
 A liba program, relinked: neither its source nor its object file changes. It prints every digit, and every digit is the same
 with either library.

 With liba:
     cc examples/01_relink.c -la -lm -o relink
 With atraj; the archive stands before liba, because the linker takes a function from the first archive that has it:
     cc -Itarget/dist/include examples/01_relink.c target/dist/lib/libatraj.a -la -lm -o relink
 Whether the relink took:
     make identify FILE=relink
 This program uses nothing else of liba, so it needs no -la. Keep liba's headers or take ours: the ABI is the same.
*/
#include "a/trajbell.h"
#include <stdio.h>

#ifndef EVERY
#define EVERY 250 /* print every EVERY-th of 1000 setpoints */
#endif

int main(void)
{
    a_trajbell move;
    a_float const duration = a_trajbell_gen(&move, 30, 10, 10, 0, 10, 1, 0);
    puts("Relinked: a double-S without cruise, every digit as from liba");
    puts("within 10 m/s, 10 m/s^2, 30 m/s^3");
    for (int i = 0; i <= 1000; i += EVERY) {
        a_float const x = duration / 1000 * i;
        printf("%.17f s: %.17f m, %.17f m/s, ", x, a_trajbell_pos(&move, x), a_trajbell_vel(&move, x));
        printf("%.17f m/s^2, %.17f m/s^3\n", a_trajbell_acc(&move, x), a_trajbell_jer(&move, x));
    }
    return !(duration > 0);
}
