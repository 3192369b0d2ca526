/* Draws the middle row of a sphere, in C and in C++. */
#include "eigenshade_presets.h"

#include <stdio.h>

int main(void) {
  static eigenshade_picture_q15_t picture;
  uint16_t row[64] = {0};
  eigenshade_status status = eigenshade_picture_begin_q15(
      &eigenshade_light_lobby_q15, &eigenshade_material_gold_metallic_paint_q15, &picture);
  if (!status) {
    status = eigenshade_picture_disc_row_q15(&picture, 64, 32, 1.5f, &eigenshade_display_filmic,
                                             row, 64);
  }
  printf("%s: %u\n", eigenshade_message(status), (unsigned)row[32]);
  return status != EIGENSHADE_STATUS_OK || row[32] == 0;
}
