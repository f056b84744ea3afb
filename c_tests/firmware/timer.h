/* Counts executed instructions. QEMU's -icount ties the clock of a board to them, so the numbers are exact and repeatable. */
#ifndef TIMER_H
#define TIMER_H

#include <stdint.h>

#if defined(__arm__)
/* CMSDK timer 0 counts down at 25 MHz; with -icount shift=7 an instruction takes 128 ns, so the count ends at 1.3 billion. A program that is run
 * with another shift defines its own time first. */
#ifndef NS_PER_INSTRUCTION
#define NS_PER_INSTRUCTION 128
#endif
static volatile uint32_t *const TIMER = (volatile uint32_t *)0x40000000;
enum { CONTROL, VALUE, RELOAD };

static inline void start_timer(void) {
    TIMER[RELOAD] = UINT32_MAX;
    TIMER[VALUE] = UINT32_MAX;
    TIMER[CONTROL] = 1;
}
static inline uint32_t now(void) { return ~TIMER[VALUE]; }
static inline uint32_t instructions(uint32_t ticks) { return (uint32_t)(((uint64_t)ticks * 40 + NS_PER_INSTRUCTION / 2) / NS_PER_INSTRUCTION); }
#else
/* With -icount shift=0 the counter of RISC-V counts instructions. */
static inline void start_timer(void) {}
static inline uint32_t now(void) {
    uint32_t count;
    __asm__ volatile(".option push\n\t.option arch, +zicsr\n\tcsrr %0, minstret\n\t.option pop" : "=r"(count));
    return count;
}
static inline uint32_t instructions(uint32_t ticks) { return ticks; }
#endif

#endif
