// A sketch without the library, whose size is subtracted from those of the others.
#include "Adafruit_ILI9341.h"

static uint16_t pixel;

void setup() { pixel = 16384 * sinf(millis()); }

void loop() {
  if (millis() == 1) Serial.println("");
  memset(&pixel, 0, sizeof pixel);
  Adafruit_ILI9341(10, 9).drawRGBBitmap(0, 0, &pixel, cosf(millis()) < 2, 1);
}
