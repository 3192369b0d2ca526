// The display that the sketch draws on. Change this file for yours. An ILI9341 unless one of these:
// #define USE_ST7789
// #define USE_TFT_ESPI
//
// The display's pins SCK and MOSI go to those of the board's SPI, CS and DC to the pins below, RST
// and LED to 3.3 V.
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

#ifdef USE_ST7789

#include <Adafruit_ST7789.h>
static Adafruit_ST7789 tft(10, 9, -1);  // the pins CS and DC, and no RST

static void begin_display() {
  tft.init(240, 240);  // the size; on a display without CS, (240, 240, SPI_MODE3)
  tft.fillScreen(0);
}

#else

#include <Adafruit_ILI9341.h>
static Adafruit_ILI9341 tft(10, 9);  // the pins CS and DC

static void begin_display() {
  tft.begin();
  tft.fillScreen(0);
}

#endif

static void show(uint16_t *frame, int size) { tft.drawRGBBitmap(0, 0, frame, size, size); }

#endif

#endif
