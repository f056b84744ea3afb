/*
 The double of an Arm core without a unit for it, computed by the unit of this machine: the functions that `src/real/soft.rs` calls.
 `make mutants` links it, so that tests on a host see a fault in `soft.rs`.
*/
#include <stdint.h>
#include <string.h>

static double as_number(uint64_t bits) {
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static uint64_t as_bits(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

#define OPERATION(name, result) \
    uint64_t __aeabi_d##name(uint64_t a, uint64_t b); \
    uint64_t __aeabi_d##name(uint64_t a, uint64_t b) { return as_bits(result); }
#define COMPARISON(name, sign) \
    int __aeabi_dcmp##name(uint64_t a, uint64_t b); \
    int __aeabi_dcmp##name(uint64_t a, uint64_t b) { return as_number(a) sign as_number(b); }

OPERATION(add, as_number(a) + as_number(b))
OPERATION(rsub, as_number(b) - as_number(a))
OPERATION(mul, as_number(a) * as_number(b))
OPERATION(div, as_number(a) / as_number(b))
COMPARISON(eq, ==)
COMPARISON(lt, <)
COMPARISON(le, <=)
COMPARISON(gt, >)
COMPARISON(ge, >=)
