/* Numbers as text. */
#include "say.h"

void say_number(uint32_t number) {
  char digits[11];
  char *digit = digits + sizeof digits;
  *--digit = '\0';
  do {
    *--digit = (char)('0' + number % 10);
    number /= 10;
  } while (number != 0);
  say(digit);
}
