/* A display that prints the checksum of what it is given. */
#pragma once
#include "Arduino.h"

struct Adafruit_ILI9341 {
  Adafruit_ILI9341(int8_t, int8_t) {}
  void begin() {}
  void fillScreen(uint16_t) {}
  void drawRGBBitmap(int16_t, int16_t, uint16_t *pixels, int16_t width, int16_t height) {
    print_picture(pixels, width, height);
  }
};
