/* Prints moves that atraj.h plans on this host, in the form of the golden tables: moves bell > FILE, or moves trap > FILE.
 * The firmware must compute the same bits. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "atraj.h"

enum { FAMILIES = 6, MOVES = 40 * FAMILIES };

static double random_between(double low, double high)
{
    static uint32_t state = 1;
    state = state * 1664525u + 1013904223u;
    return low + (high - low) * (state / 4294967296.0);
}

/* How far an axis goes from the velocity v until it stops. */
static double way_to_stop(double jm, double am, double v)
{
    double const ramp = fabs(v) < am * am / jm ? 2 * sqrt(fabs(v) / jm) : am / jm + fabs(v) / am;
    return 0.5 * v * ramp;
}

/* Displacement and velocities at both ends, for one move of a family. */
static void ends(unsigned family, double jm, double am, double vm, double *h, double *v0, double *v1)
{
    *h = random_between(-1, 1) * random_between(0, 15);
    *v0 = random_between(-vm, vm);
    *v1 = random_between(-vm, vm);
    switch (family) {
    case 0: *v0 = *v1 = 0; break; /* at rest */
    case 1: break; /* moving ends */
    case 2: *h = copysign(random_between(0, 0.9), *v0) * fabs(way_to_stop(jm, am, *v0)), *v1 = 0; break; /* too near to stop */
    case 3: *h = 0; break; /* to where it is */
    case 4: *h = way_to_stop(jm, am, *v0), *v1 = 0; break; /* at the way to stop, up to rounding */
    default: *v1 = *v0, *h *= 1e-3; break; /* a small step at full speed */
    }
}

static void print_reals(a_float const *value, a_size count)
{
    for (a_size i = 0; i != count; ++i) {
        unsigned char bytes[sizeof(a_float)];
        memcpy(bytes, value + i, sizeof(bytes));
        putchar(',');
        for (a_size k = sizeof(bytes); k--;) { printf("%02x", bytes[k]); }
    }
}

int main(int argc, char *argv[])
{
    int const bell = argc == 2 && !strcmp(argv[1], "bell");
    puts(bell ? "case,jm,am,vm,p0,p1,v0,v1,duration,t,tv,ta,td,taj,tdj,p0,p1,v0,v1,vm,jm,am,dm"
              : "case,vm,ac,de,p0,p1,v0,v1,duration,t,p0,p1,v0,v1,vc,ta,td,pa,pd,ac,de");
    for (unsigned move = 0; move != MOVES; ++move) {
        double const jm = random_between(10, 50), am = random_between(4, 12), vm = random_between(2, 6);
        double const p0 = random_between(-5, 5);
        double h, v0, v1;
        /* Four moves in a row are of one family, so a board with room for every fifth move meets each family too. */
        ends(move / 4 % FAMILIES, bell ? jm : INFINITY, am, vm, &h, &v0, &v1);
        double const arguments[2][7] = {{vm, 0.5 * jm, -am, p0, p0 + h, v0, v1}, {jm, am, vm, p0, p0 + h, v0, v1}};
        a_float a[7];
        for (int i = 0; i != 7; ++i) { a[i] = (a_float)arguments[bell][i]; }
        a_trajbell b;
        a_trajtrap c;
        a_float const t = bell ? atraj_bell_gen(&b, a[0], a[1], a[2], a[3], a[4], a[5], a[6])
                               : atraj_trap_gen(&c, a[0], a[1], a[2], a[3], a[4], a[5], a[6]);
        printf("%u", move);
        print_reals(a, 7);
        print_reals(&t, 1);
        print_reals(bell ? (a_float *)&b : (a_float *)&c, (bell ? sizeof(b) : sizeof(c)) / sizeof(a_float));
        putchar('\n');
    }
    return 0;
}
