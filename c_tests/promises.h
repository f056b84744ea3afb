/* For tests in C and C++ that go on after a broken promise: `broken` tells at the end whether there was one. */
#include <stdio.h>

static int broken;

#define PROMISE(condition) \
    do { \
        if (!(condition)) { \
            printf("%s:%d: broken: %s\n", __FILE__, __LINE__, #condition); \
            broken = 1; \
        } \
    } while (0)
