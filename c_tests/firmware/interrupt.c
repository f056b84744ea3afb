/* Plans at random while a timer interrupt comes after random numbers of instructions, and asks the axis for setpoints. INTERRUPTS is
 * their number, SPAN the highest number of timer counts between two of them, LEAD the longest lead. */
#include <stddef.h>
#include "../watch.h"
#include "semihost.h"

#if defined(__arm__)
/* SysTick counts down from the value in RELOAD, again and again. What came meanwhile is forgotten. */
static volatile uint32_t *const TIMER = (volatile uint32_t *)0xE000E010, *const PENDING = (volatile uint32_t *)0xE000ED04;
enum { CONTROL, RELOAD, VALUE, FORGET = 1 << 25 };

static void interrupt_in(unsigned counts) {
    TIMER[RELOAD] = counts;
    TIMER[VALUE] = 0;
    TIMER[CONTROL] = 7;
    *PENDING = FORGET;
}

static void start_timer(void) {}
static void stop_timer(void) { TIMER[CONTROL] = 0; }
#else
/* The timer of the machine `virt`: an interrupt comes when TIME reaches COMPARE. */
static volatile uint32_t *const COMPARE = (volatile uint32_t *)0x02004000, *const TIME = (volatile uint32_t *)0x0200BFF8;

static void interrupt_in(unsigned counts) {
    uint32_t const low = TIME[0], high = TIME[1];
    uint64_t const then = ((uint64_t)high << 32 | low) + counts;
    COMPARE[1] = UINT32_MAX;
    COMPARE[0] = (uint32_t)then;
    COMPARE[1] = (uint32_t)(then >> 32);
}

#define ZICSR(text) ".option push\n\t.option arch, +zicsr\n\t" text "\n\t.option pop"
static void timer_interrupt(void);
static void start_timer(void) {
    __asm__ volatile(ZICSR("csrw mtvec, %0\n\tcsrs mie, %1\n\tcsrsi mstatus, 8") : : "r"(timer_interrupt), "r"(1 << 7));
}
static void stop_timer(void) { __asm__ volatile(ZICSR("csrci mstatus, 8")); }
#endif

#if defined(__arm__)
void arm_systick_isr(void);
void arm_systick_isr(void)
#else
__attribute__((interrupt, aligned(4))) static void timer_interrupt(void)
#endif
{
    static unsigned random = 2;
    interrupt();
    interrupt_in(50 + next_random(&random) % SPAN);
}

int main(void) {
    unsigned volatile *const ticks = &watch.ticks;
    unsigned settled;
    if (init() != 0) { semihost_exit(1); }
    interrupt_in(SPAN);
    start_timer();
    while (*ticks < INTERRUPTS) { plan(LEAD); }
    while (go(last_target, 2 * LEAD) < 0) {}
    settled = *ticks + SETTLED + 2 * LEAD;
    while (*ticks < settled) {}
    stop_timer();
    semihost_count(watch.ticks, " interrupts, ");
    semihost_count(answers.accepted, " plans in time, ");
    semihost_count(answers.late, " late, ");
    semihost_count(answers.refused, " refused, ");
    semihost_count(watch.jumps, " jumps\n");
    semihost_exit(!is_good());
}
