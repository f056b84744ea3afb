/* The golden tables, as bit patterns of this build's real type. */
#ifndef GOLDEN_H
#define GOLDEN_H

#include <stdint.h>
#include "a/a.h"

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

#endif
