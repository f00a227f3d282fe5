/* What runs before main on a Cortex-M: the table of vectors, and the floating point unit where there is one. */
#include <stdint.h>
#include <stdlib.h>

extern uint32_t stack_top;
extern void initialise_monitor_handles(void);
int main(void);
void reset(void);
void _init(void);
void _fini(void);

void reset(void) {
#if defined(__ARM_FP)
    *(volatile uint32_t *)0xE000ED88u |= 0xFu << 20; /* CPACR: coprocessors 10 and 11 */
    __asm volatile("dsb\n\tisb");
#endif
    initialise_monitor_handles();
    exit(main());
}

static void stop(void) {
    for (;;) {
    }
}

/* The top of the stack, then addresses of functions. */
__attribute__((section(".vectors"), used)) static const uintptr_t vectors[16] = {
    (uintptr_t)&stack_top, (uintptr_t)reset, (uintptr_t)stop, (uintptr_t)stop,
};

/* What the C library asks of a system. */
void _init(void) {}
void _fini(void) {}
