/* Runs a sketch for three frames. */
#include "Arduino.h"

#include <stdio.h>
#include <stdlib.h>

Printer Serial;

void Printer::println(const char *text) { puts(text); }

static unsigned long frame;

unsigned long millis() { return 700 * frame; }

void delay(unsigned long) { exit(1); }

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

void setup();
void loop();

int main() {
  for (setup(); frame < 3; frame++) loop();
  return 0;
}
