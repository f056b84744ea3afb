// Prints the bits of a few moves, as move.c and move.rs do.

#include "a/trajbell.h"
#include "a/trajpoly7.h"
#include "a/trajtrap.h"
#include <cstring>
#include <iomanip>
#include <iostream>

static void show(const char *name, double value) {
    a_u64 bits;
    std::memcpy(&bits, &value, sizeof(bits));
    std::cout << name << ' ' << std::hex << std::setfill('0') << std::setw(16) << bits << '\n';
}

int main() {
    a::trajbell bell;
    show("bell duration", bell.gen(30, 10, 5, 0, 1));
    show("bell position", bell.pos(a_float(0.3)));
    show("bell jerk", bell.jer(a_float(0.3)));

    a::trajtrap trap;
    show("trap duration", trap.gen(5, 4, -3, 0, 50));
    show("trap velocity", trap.vel(a_float(0.7)));

    a::trajpoly7 poly;
    poly.gen(3, 0, 10, 1, 0, 0, 0, 0, 0);
    show("poly7 acceleration", poly.acc(a_float(0.9)));
}
