// The display that the sketch draws on. Change this file for yours.
#ifndef DISPLAY_H
#define DISPLAY_H

#ifdef USE_TFT_ESPI  // The pins are in User_Setup.h of TFT_eSPI.

#include <TFT_eSPI.h>
static TFT_eSPI tft;

static void begin_display() {
  tft.begin();
  tft.setSwapBytes(true);
  tft.fillScreen(0);
}

static void show(uint16_t *frame, int size) { tft.pushImage(0, 0, size, size, frame); }

#else

#include <Adafruit_ILI9341.h>
static Adafruit_ILI9341 tft(10, 9);  // the pins CS and DC

static void begin_display() {
  tft.begin();
  tft.fillScreen(0);
}

static void show(uint16_t *frame, int size) { tft.drawRGBBitmap(0, 0, frame, size, size); }

#endif

// Prints why a call failed, and stops.
static void check(eigenshade_status status) {
  while (status) {
    Serial.println(eigenshade_message(status));
    delay(1000);
  }
}

// Turns a light about the vertical by an angle in radians.
static void turn(const eigenshade_color_light_q15_t &from, float angle,
                 eigenshade_light_buffer_q15_t &buffer, eigenshade_color_light_q15_t &to) {
  const int32_t y = 16384 * sinf(angle / 2), w = 16384 * cosf(angle / 2);
  const int32_t quaternion[4] = {0, y, 0, w};
  check(eigenshade_turn_q15(&from, quaternion, &buffer, &to));
}

#endif
