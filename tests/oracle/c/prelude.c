/* What the names of the prelude mean: prints the same with the original's headers and with ours. */
#include "a/trajbell.h"
#include <stdio.h>

#define TEXT_OF(...) #__VA_ARGS__
#define TEXT(...) TEXT_OF(__VA_ARGS__)
#define SIZE(type) printf(#type " %d\n", (int)sizeof(type))

A_EXTERN int exported;
A_PUBLIC int exported = 2;
A_INTERN int internal(void) { return 1; }

A_EXTERN int print(char const *format, ...) A_FORMAT(printf, 1, 2);

static void sizes(void) {
    SIZE(a_size), SIZE(a_diff), SIZE(a_byte);
    SIZE(a_i8), SIZE(a_u8), SIZE(a_i16), SIZE(a_u16), SIZE(a_i32), SIZE(a_u32), SIZE(a_i64), SIZE(a_u64);
    SIZE(a_iptr), SIZE(a_uptr), SIZE(a_imax), SIZE(a_umax);
    SIZE(a_f32), SIZE(a_f64), SIZE(a_float);
}

static void real(void) {
    printf("%d %d %d %d %d\n", A_SIZE_FLOAT, A_FLOAT_TYPE, A_FLOAT_SINGLE, A_FLOAT_DOUBLE, A_FLOAT_EXTEND);
    printf("%s %s %s\n", TEXT(A_FLOAT), TEXT(A_FLOAT_C(1.5)), TEXT(A_FLOAT_F(sin)));
    printf("%s %s\n", A_FLOAT_PRI("+.3", "f"), A_FLOAT_SCN("*", "f"));
    printf("%d %d %d %d\n", A_FLOAT_MIN_EXP, A_FLOAT_MAX_EXP, A_FLOAT_MIN_10_EXP, A_FLOAT_MAX_10_EXP);
    printf("%d %d\n", A_FLOAT_DIG, A_FLOAT_MANT_DIG);
    printf("%a %a %a\n", (double)A_FLOAT_EPSILON, (double)A_FLOAT_MIN, (double)A_FLOAT_MAX);
}

static void functions(void) {
    const int three[3] = {1, 2, 3};
    const int value = (A_BUILD_ASSERT(sizeof(three) == 3 * sizeof(int)), exported);
    printf("%d %d\n", value, (int)A_LEN(three));
    printf("%d %d %d %d\n", A_MIN(1, 2), A_MAX(1, 2), A_ABS(-3), A_ABS(3));
    printf("%d %d %d\n", A_SAT(5, 1, 3), A_SAT(-5, 1, 3), A_SAT(2, 1, 3));
    printf("%d %d %d\n", A_PREREQ_GNUC(4, 0) != 0, A_PREREQ_GNUC(999, 0) != 0, A_PREREQ_MSVC(1, 0) != 0);
}

int main(void) {
    A_BUILD_ASSERT(sizeof(a_float) == A_SIZE_FLOAT);
    sizes();
    real();
    functions();
    return A_NULL == 0 ? internal() - 1 : 2;
}
