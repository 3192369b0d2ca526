/* A Cortex-M4F without an operating system: start-up code, output and exit by
 * semihosting. Freestanding C99; for QEMU's mps2-an386. */
#include "print.h"

/* From the linker script. */
extern uint32_t stack_top[], data_start[], data_end[], data_stored[], bss_start[], bss_end[];

void reset(void);
static void fault(void);

typedef void (*vector)(void);

/* The stack, then the handlers up to SysTick. */
__attribute__((section(".vectors"), used)) static const struct {
  uint32_t *stack;
  vector handlers[15];
} vectors = {stack_top,
             {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
              fault, fault, fault, fault}};

/* Semihosting: see Arm's specification of it. */
enum { SYS_WRITE0 = 0x04, SYS_EXIT_EXTENDED = 0x20 };
enum { ADP_STOPPED_APPLICATION_EXIT = 0x20026 };

static void semihost(uint32_t operation, const void *argument) {
  register uint32_t r0 __asm__("r0") = operation;
  register const void *r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void print(const char *text) { semihost(SYS_WRITE0, text); }

__attribute__((noreturn)) static void leave(uint32_t status) {
  const uint32_t how[2] = {ADP_STOPPED_APPLICATION_EXIT, status};
  semihost(SYS_EXIT_EXTENDED, how);
  for (;;) {
  }
}

static void fault(void) {
  print("fault: an exception\n");
  leave(1);
}

__attribute__((noreturn)) static void start(void) {
  for (uint32_t *to = data_start, *from = data_stored; to != data_end; to++, from++) {
    *to = *from;
  }
  for (uint32_t *to = bss_start; to != bss_end; to++) {
    *to = 0;
  }
  leave(program() == 0 ? 0 : 1);
}

void reset(void) {
  /* Full access to the float unit: CPACR, coprocessors 10 and 11. */
  *(volatile uint32_t *)0xe000ed88u |= 0xfu << 20;
  __asm__ volatile("dsb\n\tisb" ::: "memory");
  start();
}
