/* Counts the checks that fail. Freestanding C99. */
#include "checks.h"

static uint32_t faults;

uint32_t found_faults(void) { return faults; }

void check(int holds, const char *format, const char *what, uint32_t number) {
  if (holds) {
    return;
  }
  faults++;
  print("fault: ");
  print(format);
  print(" ");
  print(what);
  print(" ");
  print_u32(number);
  print("\n");
}

void check_status(eigenshade_status found, eigenshade_status expected, const char *format,
                  const char *what) {
  if (found == expected) {
    return;
  }
  check(0, format, what, (uint32_t)found);
  print(eigenshade_message(found));
  print("\n");
}

void fill(void *memory, size_t size, unsigned char byte) {
  for (size_t k = 0; k < size; k++) {
    ((unsigned char *)memory)[k] = byte;
  }
}
