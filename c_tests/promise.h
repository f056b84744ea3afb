/* What the C tests share. */
#include "a/a.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Ends a function with 1, and prints its line, if a condition does not hold. */
#define PROMISE(condition) \
    do { \
        if (!(condition)) \
        { \
            printf("%s:%d: broken: %s\n", __FILE__, __LINE__, #condition); \
            return 1; \
        } \
    } while (0)

static const a_float none = (a_float)NAN, endless = (a_float)INFINITY;
