// A gold sphere in a lobby, whose light turns.
#include <eigenshade_presets.h>
#include "display.h"
#include "sketch.h"

const int SIZE = 120;  // 48 on a board with 32 KB of RAM

uint16_t frame[SIZE * SIZE];
uint8_t normals[2 * SIZE * SIZE];
const eigenshade_normal_map_t sphere = {SIZE, SIZE, sizeof normals, normals};
eigenshade_nodes_t nodes;
eigenshade_transfer_q15_t gold;

eigenshade_light_buffer_q15_t buffer;
eigenshade_color_light_q15_t light;
eigenshade_picture_q15_t picture;
eigenshade_palette_t palette;

void setup() {
  Serial.begin(115200);
  begin_display();
  check(eigenshade_normal_map_sphere(SIZE, normals, sizeof normals));
  check(eigenshade_nodes_of_normal_map(&sphere, &nodes));
  check(eigenshade_transfer_q15(&eigenshade_material_gold_metallic_paint_q15, &gold));
}

void loop() {
  turn(eigenshade_light_lobby_q15, buffer, light);
  check(eigenshade_picture_relight_q15(&gold, &light, &picture));
  check(eigenshade_palette_fill_q15(&picture, 1.5f, &eigenshade_display_filmic, &nodes, &palette));

  memset(frame, 0, sizeof frame);
  const eigenshade_target_t target = {frame, sizeof frame, 2 * SIZE, SIZE, SIZE, 0, 0,
                                      EIGENSHADE_ENCODING_RGB565};
  check(eigenshade_palette_draw(&palette, &sphere, &target));
  show(frame, SIZE);
}
