/* Draws the middle rows of a sphere, in C and in C++. */
#include "eigenshade_presets.h"

#include <stdio.h>

int main(void) {
  static eigenshade_picture_q15_t picture;
  static uint16_t rows[2 * 64];
  const eigenshade_target_t target = {rows, sizeof rows, 128,  64,
                                      2,    0,           -31, EIGENSHADE_ENCODING_RGB565};
  eigenshade_status status = eigenshade_picture_begin_q15(
      &eigenshade_light_lobby_q15, &eigenshade_material_gold_metallic_paint_q15, &picture);
  if (!status) {
    status = eigenshade_picture_draw_disc_q15(&picture, 64, 1.5f, &eigenshade_display_filmic,
                                              &target);
  }
  printf("%s: %u\n", eigenshade_message(status), (unsigned)rows[32]);
  return status != EIGENSHADE_STATUS_OK || rows[32] == 0;
}
