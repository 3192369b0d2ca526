/* A program that draws a sphere in bands of a row, in one format, FORMAT (f32, q15), to measure its
 * size. WAY 0 has any material, WAY 1 one whose transfer is in flash, WAY 2 any with small sources,
 * WAY 3 draws as WAY 1 from a palette, with the codes in flash; WAY 4 a textured object of one pixel,
 * WAY 5 one with shadows.
 * Without FORMAT the program is empty, for comparison. */
#include "eigenshade_presets.h"
#include "print.h"

#ifdef FORMAT

#define JOINED(a, b) a##b
#define NAME(a, b) JOINED(a, b)
#define MY(name) NAME(NAME(eigenshade_, name), FORMAT)
#define TYPE(name) NAME(MY(name), _t)
#define PRESET(kind, name) NAME(eigenshade_##kind##_##name##_, FORMAT)

enum { SIDE = 240 };

#if WAY != 5
static TYPE(picture_) picture;
#endif
static uint16_t row_of_pixels[SIDE];
volatile uint16_t drawn;
#if WAY == 1 || WAY == 3
static const TYPE(transfer_) transfer = {.numbers = {{1}}};
#endif
#if WAY == 3
static const uint8_t codes[2] = {0, 0};
static const eigenshade_normal_map_t map = {1, 1, sizeof codes, codes};
static eigenshade_palette_t palette;
#endif
#if WAY == 4
static const uint8_t bytes[38] = {'e', 'i', 'g', 'o', 'b', 1, 1, 0, 1, 0, 1, 0, 0, 0, 0, 64, 0, 123,
                                  0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 200, 90, 10, 255};
static const eigenshade_object_t object = {sizeof bytes, bytes};
static TYPE(material_buffer_) materials;
static TYPE(picture_) plain;
static eigenshade_nodes_t nodes;
static eigenshade_linear_palette_t linear;
#endif

#if WAY == 5
static const uint8_t bytes[46] = {'e', 'i', 'g', 's', 'h', 1,   1,   0,   1, 0, 1, 0, 1, 0, 0, 1,
                                  1,   0,   255, 127, 255, 127, 255, 127, 240, 0, 64, 1, 0, 242, 0, 64,
                                  0,   0,   0,   0,   3,   0,   0,   0,   0, 0, 1, 0, 0, 0};
static const eigenshade_shadowed_object_t object = {sizeof bytes, bytes};
static eigenshade_object_coefficients_t coefficients;
static uint16_t colors[1];
#endif

uint32_t program(void) {
#if WAY == 0
  eigenshade_status status = MY(picture_begin_)(&PRESET(light, lobby), &PRESET(material,
      gold_metallic_paint), &picture);
#elif WAY == 1 || WAY == 3
  eigenshade_status status = MY(picture_relight_)(&transfer, &PRESET(light, lobby), &picture);
#elif WAY == 4
  TYPE(color_material_) of_tinted, of_plain;
  eigenshade_status status = eigenshade_nodes_of_region(&object, 0, &nodes);
  status |= MY(region_materials_)(&object, 0, &materials, &of_tinted, &of_plain);
  status |= MY(picture_begin_)(&PRESET(light, lobby), &of_tinted, &picture);
  status |= MY(picture_begin_)(&PRESET(light, lobby), &of_plain, &plain);
  status |= MY(linear_palette_fill_)(&picture, &plain, 1.5f, &nodes, &linear);
#elif WAY == 5
  eigenshade_status status = MY(shadowed_object_coefficients_)(&object, &PRESET(light, lobby),
      &coefficients);
  status |= eigenshade_shadowed_object_colors(&object, &coefficients, 1.5f,
      &eigenshade_display_filmic, EIGENSHADE_ENCODING_RGB565, colors, sizeof colors);
#else
  eigenshade_status status = MY(picture_begin_glossy_)(&PRESET(light, lobby), &PRESET(material,
      gold_metallic_paint), &eigenshade_gloss_gold_metallic_paint_f32,
      eigenshade_sources_lobby_f32, 4, &picture);
#endif
#if WAY == 3
  status |= MY(palette_fill_)(&picture, 1.5f, &eigenshade_display_filmic, NULL, &palette);
#endif
  for (int32_t row = 0; !status && row < SIDE; row++) {
    const eigenshade_target_t target = {row_of_pixels, sizeof row_of_pixels, 0, SIDE, 1, 0, -row,
                                        EIGENSHADE_ENCODING_RGB565};
#if WAY == 3
    status = eigenshade_palette_draw(&palette, &map, &target);
#elif WAY == 4
    status = eigenshade_object_draw(&object, &linear, 1, &eigenshade_display_filmic, &target);
#elif WAY == 5
    status = eigenshade_shadowed_object_draw(&object, colors, sizeof colors, &target);
#else
    status = MY(picture_draw_disc_)(&picture, SIDE, 1.5f, &eigenshade_display_filmic, &target);
#endif
    drawn = row_of_pixels[SIDE / 2];
  }
  return (uint32_t)status;
}

#else

uint32_t program(void) { return 0; }

#endif
