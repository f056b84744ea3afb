/*
 Tests the promises to a C program other than numbers: the layout of the structs, the prelude's names, the answers to NULL
 of the compact polynomials and to an infinite acceleration. A broken layout fails to compile; any other broken promise is printed with its line.
*/
#include "atraj.h"
#include "promise.h"

#define REALS(type, count) A_BUILD_ASSERT(sizeof(type) == (count) * sizeof(a_float))
#define AT(type, field, index) A_BUILD_ASSERT(offsetof(type, field) == (index) * sizeof(a_float))

A_INTERN void layout(void) {
    REALS(a_trajbell, 14);
    AT(a_trajbell, t, 0); AT(a_trajbell, tv, 1); AT(a_trajbell, ta, 2); AT(a_trajbell, td, 3);
    AT(a_trajbell, taj, 4); AT(a_trajbell, tdj, 5);
    AT(a_trajbell, p0, 6); AT(a_trajbell, p1, 7); AT(a_trajbell, v0, 8); AT(a_trajbell, v1, 9);
    AT(a_trajbell, vm, 10); AT(a_trajbell, jm, 11); AT(a_trajbell, am, 12); AT(a_trajbell, dm, 13);

    REALS(a_trajtrap, 12);
    AT(a_trajtrap, t, 0); AT(a_trajtrap, p0, 1); AT(a_trajtrap, p1, 2); AT(a_trajtrap, v0, 3); AT(a_trajtrap, v1, 4);
    AT(a_trajtrap, vc, 5); AT(a_trajtrap, ta, 6); AT(a_trajtrap, td, 7);
    AT(a_trajtrap, pa, 8); AT(a_trajtrap, pd, 9); AT(a_trajtrap, ac, 10); AT(a_trajtrap, de, 11);

#if defined(A_TRAJPOLY_COMPACT)
    REALS(a_trajpoly3, 4);
    REALS(a_trajpoly5, 6);
    REALS(a_trajpoly7, 8);
    AT(a_trajpoly7, c, 0);
#else
    REALS(a_trajpoly3, A_TRAJPOLY3 == 1 ? 4 : A_TRAJPOLY3 == 2 ? 7 : 9);
    REALS(a_trajpoly5, A_TRAJPOLY5 == 1 ? 6 : A_TRAJPOLY5 == 2 ? 11 : 15);
    REALS(a_trajpoly7, A_TRAJPOLY7 == 1 ? 8 : A_TRAJPOLY7 == 2 ? 15 : A_TRAJPOLY7 == 3 ? 21 : 26);
    AT(a_trajpoly7, p, 0);
#if A_TRAJPOLY7 > 1
    AT(a_trajpoly7, v, 8);
#endif
#if A_TRAJPOLY7 > 2
    AT(a_trajpoly7, a, 15);
#endif
#if A_TRAJPOLY7 > 3
    AT(a_trajpoly7, j, 21);
#endif
#endif

    A_BUILD_ASSERT(sizeof(a_real) == sizeof(a_float) && sizeof(a_float) == A_SIZE_FLOAT);
    A_BUILD_ASSERT(sizeof(a_i8) == 1 && sizeof(a_u16) == 2 && sizeof(a_i32) == 4 && sizeof(a_u64) == 8);
}

A_INTERN int prelude(void) {
    static const int numbers[] = {1, 2, 3};
    char text[64];
    PROMISE(A_LEN(numbers) == 3);
    PROMISE(A_MIN(1, 2) == 1 && A_MAX(1, 2) == 2 && A_ABS(-3) == 3);
    PROMISE(A_SAT(5, 0, 3) == 3 && A_SAT(-5, 0, 3) == 0 && A_SAT(2, 0, 3) == 2);
    PROMISE(A_FLOAT_C(1.0) + A_FLOAT_EPSILON > 1 && A_FLOAT_C(1.0) + A_FLOAT_EPSILON / 2 == 1);
    PROMISE(A_REAL_F(sqrt)(A_REAL_C(4.0)) == 2);
    PROMISE(sprintf(text, A_FLOAT_PRI(".2", "f"), A_FLOAT_C(1.25)) == 4 && strcmp(text, "1.25") == 0);
    return 0;
}

/* `tests/miri` asks all other functions for NULL. */
#if defined(A_TRAJPOLY_COMPACT)
static int null_of_compact(void) {
    a_trajpoly7 poly;
    a_float c[8];
    a_trajpoly7_gen(&poly, 2, 0, 1, 0, 0, 0, 0, 0, 0);
    memcpy(c, poly.c, sizeof(c));
    a_trajpoly3_c0(A_NULL, c);
    a_trajpoly5_c1(A_NULL, c);
    a_trajpoly7_c2(A_NULL, c);
    PROMISE(memcmp(c, poly.c, sizeof(c)) == 0);
    a_trajpoly7_c3(&poly, A_NULL);
    /* The array may lie inside the context. */
    a_trajpoly7_c1(&poly, c);
    a_trajpoly7_c1(&poly, poly.c);
    PROMISE(memcmp(c, poly.c, 7 * sizeof(a_float)) == 0);
    a_trajpoly3_gen(A_NULL, 1, 0, 1, 0, 0);
    a_trajpoly5_gen(A_NULL, 1, 0, 1, 0, 0, 0, 0);
    a_trajpoly7_gen(A_NULL, 1, 0, 1, 0, 0, 0, 0, 0, 0);
    PROMISE(isnan(a_trajpoly3_pos(A_NULL, 0)) && isnan(a_trajpoly3_vel(A_NULL, 0)) && isnan(a_trajpoly3_acc(A_NULL, 0)));
    PROMISE(isnan(a_trajpoly5_pos(A_NULL, 0)) && isnan(a_trajpoly5_vel(A_NULL, 0)) && isnan(a_trajpoly5_acc(A_NULL, 0)));
    PROMISE(isnan(a_trajpoly7_pos(A_NULL, 0)) && isnan(a_trajpoly7_vel(A_NULL, 0)) && isnan(a_trajpoly7_acc(A_NULL, 0)));
    PROMISE(isnan(a_trajpoly7_jer(A_NULL, 0)));
    return 0;
}
#else
static int null_of_compact(void) { return 0; }
#endif

/* The original never returns from the failing plans; a controller must not hang. */
static int infinite_acceleration(void) {
    a_trajbell bell;
    PROMISE(a_trajbell_gen(&bell, 1, INFINITY, 5, 0, 100, 0, 0) > 0);
    PROMISE(a_trajbell_gen(&bell, 1, INFINITY, 5, 0, 1, 0, 0) == 0 && bell.t == 0);
    PROMISE(a_trajbell_gen(&bell, INFINITY, -INFINITY, 5, 1, 0, 5, -5) == 0);
    PROMISE(bell.t == 0 && bell.tv == 0 && isinf(bell.am) && isinf(bell.dm));
    return 0;
}

int main(void) {
    layout();
    return prelude() || null_of_compact() || infinite_acceleration();
}
