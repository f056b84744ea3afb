/* Prints the bits of a few moves, as move.cpp and move.rs do. */

#include "a/trajbell.h"
#include "a/trajpoly7.h"
#include "a/trajtrap.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static void show(const char *name, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof(bits));
    printf("%s %016" PRIx64 "\n", name, bits);
}

int main(void) {
    a_trajbell bell;
    show("bell duration", a_trajbell_gen(&bell, 30, 10, 5, 0, 1, 0, 0));
    show("bell position", a_trajbell_pos(&bell, (a_float)0.3));
    show("bell jerk", a_trajbell_jer(&bell, (a_float)0.3));

    a_trajtrap trap;
    show("trap duration", a_trajtrap_gen(&trap, 5, 4, -3, 0, 50, 0, 0));
    show("trap velocity", a_trajtrap_vel(&trap, (a_float)0.7));

    a_trajpoly7 poly;
    a_trajpoly7_gen(&poly, 3, 0, 10, 1, 0, 0, 0, 0, 0);
    show("poly7 acceleration", a_trajpoly7_acc(&poly, (a_float)0.9));
    return 0;
}
