/* Runs a sketch for three frames, or with PICTURE for one, as a picture (PPM). On a board, the last
 * line is `stack,` and the bytes of stack that the sketch took at most, with printing. */
#include "Arduino.h"

#include <stdio.h>
#include <stdlib.h>

Printer Serial;

void Printer::println(const char *text) { puts(text); }

static unsigned long frame;

unsigned long millis() { return 700 * (frame + 1); }

void delay(unsigned long) { exit(1); }

#ifdef PICTURE

enum { FRAMES = 1 };

void print_picture(const uint16_t *pixels, int width, int height) {
  printf("P6\n%d %d\n255\n", width, height);
  for (const uint16_t *pixel = pixels; pixel != pixels + width * height; pixel++) {
    putchar((*pixel >> 11) * 255 / 31);
    putchar((*pixel >> 5 & 63) * 255 / 63);
    putchar((*pixel & 31) * 255 / 31);
  }
}

#else

enum { FRAMES = 3 };

void print_picture(const uint16_t *pixels, int width, int height) {
  uint32_t checksum = 2166136261u;
  int drawn = 0;
  for (int k = 0; k < width * height; k++) {
    drawn += pixels[k] != 0;
    checksum = (checksum ^ (pixels[k] & 255)) * 16777619u;
    checksum = (checksum ^ (pixels[k] >> 8)) * 16777619u;
  }
  printf("%d x %d, %d drawn: %08lx\n", width, height, drawn, (unsigned long)checksum);
}

#endif

void setup();
void loop();

#if defined(__arm__) || defined(__riscv)

enum { PAINTED = 16384 };
static const uint8_t COLOR = 0x5a;

/* Paints the stack below the caller, and returns its lowest address. */
__attribute__((noinline)) static uintptr_t paint() {
  volatile uint8_t stack[PAINTED];
  for (int k = 0; k < PAINTED; k++) stack[k] = COLOR;
  return (uintptr_t)stack;
}

int main() {
  const uintptr_t lowest = paint();
  for (setup(); frame < FRAMES; frame++) loop();
  const volatile uint8_t *const stack = (const volatile uint8_t *)lowest;
  int unused = 0;
  while (unused < PAINTED && stack[unused] == COLOR) unused++;
  printf("stack,%d\n", PAINTED - unused);
  return 0;
}

#else

int main() {
  for (setup(); frame < FRAMES; frame++) loop();
  return 0;
}

#endif
