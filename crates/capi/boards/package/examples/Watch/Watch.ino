// A blue dial around a golden relief, whose hands cast shadows, in a hall whose light turns.
#include <eigenshade_presets.h>
#include "dial.h"
#include "display.h"
#include "relief.h"
#include "sketch.h"

const int SIZE = 128, CODES = 2048;
const eigenshade_normal_map_t &dial = normal_map_dial;
const eigenshade_shadowed_object_t &relief = shadowed_object_relief;

uint16_t frame[SIZE * SIZE];
eigenshade_nodes_t nodes;
eigenshade_transfer_q15_t blue;

eigenshade_light_buffer_q15_t buffer;
eigenshade_color_light_q15_t light;
eigenshade_picture_q15_t picture;
eigenshade_palette_t palette;
eigenshade_object_coefficients_t coefficients;
uint16_t colors[CODES];

void setup() {
  Serial.begin(115200);
  begin_display();
  check(eigenshade_nodes_of_normal_map(&dial, &nodes));
  check(eigenshade_transfer_q15(&eigenshade_material_blue_metallic_paint2_q15, &blue));
}

void loop() {
  turn(eigenshade_light_hall_q15, buffer, light);
  check(eigenshade_picture_relight_q15(&blue, &light, &picture));
  check(eigenshade_palette_fill_q15(&picture, 2, &eigenshade_display_filmic, &nodes, &palette));
  check(eigenshade_shadowed_object_coefficients_q15(&relief, &light, &coefficients));
  check(eigenshade_shadowed_object_colors(&relief, &coefficients, 2, &eigenshade_display_filmic,
                                          EIGENSHADE_ENCODING_RGB565, colors, sizeof colors));

  memset(frame, 0, sizeof frame);
  eigenshade_target_t target = {frame, sizeof frame, 2 * SIZE, SIZE, SIZE, 0, 0,
                                EIGENSHADE_ENCODING_RGB565};
  check(eigenshade_palette_draw(&palette, &dial, &target));
  target.x = target.y = 27;
  check(eigenshade_shadowed_object_draw(&relief, colors, sizeof colors, &target));
  show(frame, SIZE);
}
