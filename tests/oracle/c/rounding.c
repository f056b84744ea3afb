/*
 Plans the same ordinary moves with both libraries in every rounding mode, and once with subnormal numbers flushed to zero.
 The original's functions are called original_a_traj*. Each line has the mode, how many plans differ from the original's in
 the same mode, and how many differ from our own plans in the default mode.
*/
#include "a/trajbell.h"
#include "a/trajtrap.h"
#include <fenv.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

a_float original_a_trajbell_gen(a_trajbell *, a_float, a_float, a_float, a_float, a_float, a_float, a_float);
a_float original_a_trajtrap_gen(a_trajtrap *, a_float, a_float, a_float, a_float, a_float, a_float, a_float);

enum { MOVES = 100000 };

static uint64_t state = 88172645463325252u;

static double between(double low, double high) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return low + (high - low) * ((double)(state >> 11) / 9007199254740992.0);
}

struct plans {
    a_trajbell bell;
    a_trajtrap trap;
};

static int differ(struct plans const *a, struct plans const *b) {
    return (memcmp(&a->bell, &b->bell, sizeof(a->bell)) != 0) + (memcmp(&a->trap, &b->trap, sizeof(a->trap)) != 0);
}

static void flush_subnormals(int flush) {
#if defined(__SSE2__)
    unsigned const flags = 0x8040; /* flush to zero, denormals are zero */
    _mm_setcsr(flush ? _mm_getcsr() | flags : _mm_getcsr() & ~flags);
#else
    (void)flush;
#endif
}

static void compare(char const *name, int mode, int flush) {
    long from_original = 0, from_default = 0;
    for (int i = 0; i < MOVES; ++i) {
        struct plans usual = {{0}, {0}}, ours = usual, original = usual;
        double const jm = between(1, 100), am = between(1, 20), vm = between(1, 10);
        double const p0 = between(-10, 10), p1 = between(-10, 10), v0 = between(-1, 1), v1 = between(-1, 1);
        a_trajbell_gen(&usual.bell, jm, am, vm, p0, p1, v0, v1);
        a_trajtrap_gen(&usual.trap, vm, am, -am, p0, p1, v0, v1);
        fesetround(mode);
        flush_subnormals(flush);
        a_trajbell_gen(&ours.bell, jm, am, vm, p0, p1, v0, v1);
        a_trajtrap_gen(&ours.trap, vm, am, -am, p0, p1, v0, v1);
        original_a_trajbell_gen(&original.bell, jm, am, vm, p0, p1, v0, v1);
        original_a_trajtrap_gen(&original.trap, vm, am, -am, p0, p1, v0, v1);
        flush_subnormals(0);
        fesetround(FE_TONEAREST);
        from_original += differ(&ours, &original);
        from_default += differ(&ours, &usual);
    }
    printf("%s %ld %ld\n", name, from_original, from_default);
}

static void compare_nan_signs(void) {
    a_trajtrap ours, original;
    a_float const of_ours = a_trajtrap_gen(&ours, NAN, NAN, 0, 0, 0, 0, 0);
    a_float const of_original = original_a_trajtrap_gen(&original, NAN, NAN, 0, 0, 0, 0, 0);
    printf("nan %d %d\n", !!signbit(of_ours), !!signbit(of_original));
}

int main(void) {
    printf("plans %d 0\n", 2 * MOVES);
    compare("nearest", FE_TONEAREST, 0);
    compare("flushed", FE_TONEAREST, 1);
    compare("zero", FE_TOWARDZERO, 0);
    compare("up", FE_UPWARD, 0);
    compare("down", FE_DOWNWARD, 0);
    compare_nan_signs();
    return 0;
}
