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

void print_checksum(const char *picture, const void *pixels, size_t length) {
  const uint8_t *bytes = pixels;
  uint32_t sum = 2166136261u;
  for (size_t k = 0; k < length; k++) {
    sum = (sum ^ bytes[k]) * 16777619u;
  }
  print(picture);
  print(",");
  print_u32(sum);
  print("\n");
}

/* Whether the channels of bits `low` to `low` + `bits` differ by one at most. */
static int are_near(uint16_t a, uint16_t b, int low, int bits) {
  const int mask = (1 << bits) - 1;
  const int difference = ((a >> low) & mask) - ((b >> low) & mask);
  return difference >= -1 && difference <= 1;
}

void check_picture(const char *picture, const uint16_t of_f32[], const uint16_t of_q15[],
                   size_t length) {
  for (size_t k = 0; k < length; k++) {
    const uint16_t a = of_f32[k], b = of_q15[k];
    check(are_near(a, b, 0, 5) && are_near(a, b, 5, 6) && are_near(a, b, 11, 5), "f32", picture,
          (uint32_t)k);
  }
  print_checksum(picture, of_q15, length * sizeof of_q15[0]);
}
