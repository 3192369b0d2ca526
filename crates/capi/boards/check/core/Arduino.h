/* The part of Arduino's interface that the sketches use. */
#pragma once
#include <math.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
#include "eigenshade.h"

/* Milliseconds: later in each frame. */
unsigned long millis();

/* Ends the program with an error: a call failed. */
void delay(unsigned long milliseconds);

/* Prints the checksum of a picture in RGB565. */
void print_picture(const uint16_t *pixels, int width, int height);

struct Printer {
  void begin(long) {}
  void println(const char *text);
};
extern Printer Serial;
#endif
