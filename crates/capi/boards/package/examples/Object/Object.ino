// A textured object, packed by `eigenshade pack-object coin.glb --size 120 --regions 1 -o coin.h`.
#include <eigenshade_presets.h>
#include "coin.h"
#include "display.h"
#include "sketch.h"

const int SIZE = 120;
const eigenshade_object_t &coin = object_coin;

uint16_t frame[SIZE * SIZE];
eigenshade_nodes_t nodes;
eigenshade_transfer_q15_t tinted, plain;  // colored by the texture, and not

eigenshade_light_buffer_q15_t buffer;
eigenshade_color_light_q15_t light;
eigenshade_picture_q15_t of_tinted, of_plain;
eigenshade_linear_palette_t palette;

void setup() {
  Serial.begin(115200);
  begin_display();
  static eigenshade_material_buffer_q15_t materials;
  eigenshade_color_material_q15_t first, second;
  check(eigenshade_nodes_of_region(&coin, 0, &nodes));
  check(eigenshade_region_materials_q15(&coin, 0, &materials, &first, &second));
  check(eigenshade_transfer_q15(&first, &tinted));
  check(eigenshade_transfer_q15(&second, &plain));
}

void loop() {
  turn(eigenshade_light_lobby_q15, buffer, light);
  check(eigenshade_picture_relight_q15(&tinted, &light, &of_tinted));
  check(eigenshade_picture_relight_q15(&plain, &light, &of_plain));
  check(eigenshade_linear_palette_fill_q15(&of_tinted, &of_plain, 0.7f, &nodes, &palette));

  memset(frame, 0, sizeof frame);
  const eigenshade_target_t target = {frame, sizeof frame, 2 * SIZE, SIZE, SIZE, 0, 0,
                                      EIGENSHADE_ENCODING_RGB565};
  check(eigenshade_object_draw(&coin, &palette, 1, &eigenshade_display_filmic, &target));
  show(frame, SIZE);
}
