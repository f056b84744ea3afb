/* Reset of a Cortex-M: prepares the memory for C, turns the floating-point unit on, then calls main. */
#include <stdint.h>
#include "semihost.h"

extern uint32_t data_start[], data_end[], data_load[], bss_start[], bss_end[], stack_top[];
int main(void);

void reset(void)
{
    uint32_t *from = data_load;
    for (uint32_t *to = data_start; to != data_end; ++to) { *to = *from++; }
    for (uint32_t *to = bss_start; to != bss_end; ++to) { *to = 0; }
#if defined(__ARM_FP)
    volatile uint32_t *const CPACR = (volatile uint32_t *)0xE000ED88;
    *CPACR |= 0xFu << 20;
    __asm__ volatile("dsb\n\tisb");
#endif
    semihost_exit(main());
}

static void fault(void)
{
    semihost_print("fault\n");
    semihost_exit(1);
}

__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    stack_top, (const void *)reset, (const void *)fault, (const void *)fault,
    (const void *)fault, (const void *)fault, (const void *)fault,
};
