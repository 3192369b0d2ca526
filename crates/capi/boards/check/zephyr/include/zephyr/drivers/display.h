/* The part of Zephyr's interface that docs/boards.md uses. */
#pragma once
#include <stdbool.h>
#include <stdint.h>

struct device;
extern const struct device chosen_display;
#define DT_CHOSEN(name) name
#define DEVICE_DT_GET(node) (&chosen_display)

struct display_buffer_descriptor {
  uint32_t buf_size;
  uint16_t width, height, pitch;
  bool frame_incomplete;
};
int display_write(const struct device *dev, uint16_t x, uint16_t y,
                  const struct display_buffer_descriptor *desc, const void *buf);
int display_blanking_off(const struct device *dev);
