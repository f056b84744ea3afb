/* Semihosting lets firmware under QEMU print and exit. */
#ifndef SEMIHOST_H
#define SEMIHOST_H

#include <stdint.h>

static inline void semihost(uintptr_t operation, const void *argument) {
#if defined(__arm__)
    register uintptr_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
#else
    register uintptr_t a0 __asm__("a0") = operation;
    register const void *a1 __asm__("a1") = argument;
    __asm__ volatile(".option push\n\t.option norvc\n\t.balign 16\n\t"
                     "slli zero, zero, 0x1f\n\tebreak\n\tsrai zero, zero, 7\n\t"
                     ".option pop"
                     : "+r"(a0) : "r"(a1) : "memory");
#endif
}

static inline void semihost_print(const char *text) { semihost(0x04, text); }

static inline void semihost_exit(int code) {
    const uintptr_t application_exit[2] = {0x20026, (uintptr_t)code};
    semihost(0x20, application_exit);
    for (;;) {}
}

static inline void semihost_print_unsigned(uint64_t number, unsigned base) {
    char text[24];
    char *digit = text + sizeof(text);
    *--digit = 0;
    do {
        *--digit = "0123456789abcdef"[number % base];
        number /= base;
    } while (number);
    semihost_print(digit);
}

static inline void semihost_count(uint64_t number, const char *what) {
    semihost_print_unsigned(number, 10);
    semihost_print(what);
}

#endif
