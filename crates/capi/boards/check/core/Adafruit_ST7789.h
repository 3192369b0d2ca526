/* A display that prints the checksum of what it is given. */
#pragma once
#include "Arduino.h"

class Adafruit_ST7789 {
 public:
  Adafruit_ST7789(int8_t, int8_t, int8_t) {}
  void init(uint16_t, uint16_t, uint8_t mode = 0) { (void)mode; }
  void fillScreen(uint16_t) {}
  void drawRGBBitmap(int16_t, int16_t, uint16_t *pixels, int16_t width, int16_t height) {
    print_picture(pixels, width, height);
  }

 protected:
  void begin(uint32_t) {}
};
