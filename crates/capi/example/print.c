/* Numbers as text. */
#include "print.h"

void print_u32(uint32_t number) {
  char digits[11];
  char *digit = digits + sizeof digits;
  *--digit = '\0';
  do {
    *--digit = (char)('0' + number % 10);
    number /= 10;
  } while (number != 0);
  print(digit);
}
