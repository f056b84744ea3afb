/*
 Both libraries in one program: the original under its names, ours under names that begin with x_. Plans the same moves with
 both, evaluates both, and compares every bit. The headers are ours; the original's functions have the same types.
*/
#include "atraj.h"
#include <stdio.h>
#include <string.h>

#define ORIGINAL(function) extern __typeof__(x_##function) function
#define ORIGINALS(family) \
    ORIGINAL(family##_gen); \
    ORIGINAL(family##_pos); \
    ORIGINAL(family##_vel); \
    ORIGINAL(family##_acc)
ORIGINALS(a_trajbell); ORIGINALS(a_trajtrap); ORIGINALS(a_trajpoly3); ORIGINALS(a_trajpoly5); ORIGINALS(a_trajpoly7);
ORIGINAL(a_trajbell_jer); ORIGINAL(a_trajpoly7_jer);

/* A test plants a difference here. */
#if !defined(LIMIT)
#define LIMIT 10
#endif

static unsigned long compared, differing;

static void compare(const void *ours, const void *theirs, size_t size) {
    ++compared;
    differing += memcmp(ours, theirs, size) != 0;
}

#define EVALUATE(function, x) \
    do { \
        const a_float ours_ = x_##function(&ours, x), theirs_ = function(&theirs, x); \
        compare(&ours_, &theirs_, sizeof(ours_)); \
    } while (0)
#define EVALUATE_ALL(family) \
    do { \
        int k_; \
        compare(&ours, &theirs, sizeof(ours)); \
        for (k_ = -4; k_ < 40; ++k_) { \
            const a_float x_ = (a_float)k_ / 8; \
            EVALUATE(family##_pos, x_); \
            EVALUATE(family##_vel, x_); \
            EVALUATE(family##_acc, x_); \
        } \
    } while (0)

/* The same numbers on every machine. */
static a_float number(void) {
    static unsigned long state = 1;
    state = (state * 1103515245 + 12345) & 0x7FFFFFFF;
    return (a_float)(state >> 8) / 65536;
}

static void bell(a_float p0, a_float p1, a_float v0) {
    a_trajbell ours = {0}, theirs = {0};
    const a_float t = x_a_trajbell_gen(&ours, 30, 10, 5, p0, p1, v0, 0);
    const a_float u = a_trajbell_gen(&theirs, 30, LIMIT, 5, p0, p1, v0, 0);
    compare(&t, &u, sizeof(t));
    EVALUATE_ALL(a_trajbell);
    EVALUATE(a_trajbell_jer, t / 2);
}

static void trap(a_float p0, a_float p1, a_float v0) {
    a_trajtrap ours = {0}, theirs = {0};
    x_a_trajtrap_gen(&ours, 5, 10, -10, p0, p1, v0, 0);
    a_trajtrap_gen(&theirs, 5, 10, -10, p0, p1, v0, 0);
    EVALUATE_ALL(a_trajtrap);
}

/* Plans a polynomial with both from p0 and v0 to p1 and these ends, and evaluates all that each family has. */
#define FIT(family, ...) \
    family ours, theirs; \
    x_##family##_gen(&ours, 4, p0, p1, v0, __VA_ARGS__); \
    family##_gen(&theirs, 4, p0, p1, v0, __VA_ARGS__); \
    EVALUATE_ALL(family)
static void poly3(a_float p0, a_float p1, a_float v0) { FIT(a_trajpoly3, 0); }
static void poly5(a_float p0, a_float p1, a_float v0) { FIT(a_trajpoly5, 0, v0, 1); }
static void poly7(a_float p0, a_float p1, a_float v0) {
    FIT(a_trajpoly7, 0, v0, 1, v0, -1);
    EVALUATE(a_trajpoly7_jer, v0);
}

int main(void) {
    static void (*const families[])(a_float, a_float, a_float) = {bell, trap, poly3, poly5, poly7};
    int move;
    for (move = 0; move < 1000; ++move) {
        const a_float p0 = number(), p1 = number(), v0 = number() / 32;
        families[move % 5](p0, p1, v0);
    }
    printf("%lu values, %lu differing\n", compared, differing);
    return differing != 0;
}
