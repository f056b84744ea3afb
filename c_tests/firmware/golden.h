/* The golden tables, as bit patterns of this build's real type. */
#ifndef GOLDEN_H
#define GOLDEN_H

#include <stdint.h>
#include "a/a.h"
#include "problem.h"

#if A_SIZE_FLOAT == 4
typedef uint32_t bits;
#define NAN_BITS 0x7FC00000
#else
typedef uint64_t bits;
#define NAN_BITS 0x7FF8000000000000
#endif
typedef union { bits bits; a_float value; } real;
_Static_assert(sizeof(real) == sizeof(a_float), "a bit pattern is as wide as the number");

/* A row of CLARAty's listing: the operation, what it must give besides binary64 numbers, and the line in the golden file. */
enum { OP_init, OP_set, OP_start, OP_stop, OP_reset, OP_advance, OP_get, OP_get_at };
#define ROW(operation, started, type, warnings, line) \
    ((uint64_t)(line) << 32 | (uint64_t)(warnings) << 24 | (type) << 16 | (started) << 8 | OP_##operation)

#include "golden_rows.h"
#define ROWS(table) (sizeof(table) / sizeof *(table))

static inline atraj_state state_of(const real *r) {
    return (atraj_state){r[0].value, r[1].value, r[2].value};
}

/* The problem in a row of fastest_move. */
static inline problem problem_of(const real *r) {
    return (problem){
        .function = (unsigned)r[1].value,
        .limits = {r[2].value, r[3].value, r[4].value, r[5].value, r[6].value, r[7].value},
        .from = state_of(r + 8),
        .to = state_of(r + 11),
    };
}

/* The axes in a row of fastest_axes. */
static inline axes_problem axes_of(const real *r) {
    axes_problem q = {.function = (unsigned)r[1].value, .duration = r[2].value, .cycle = r[3].value};
    for (int i = 0; i != AXES; ++i) {
        const real *axis = r + 4 + 12 * i;
        q.limits[i] = (atraj_limits){axis[0].value, axis[1].value, axis[2].value, axis[3].value, axis[4].value, axis[5].value};
        q.from[i] = state_of(axis + 6);
        q.to[i] = state_of(axis + 9);
    }
    return q;
}

#endif
