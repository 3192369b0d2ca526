/* A program that draws a sphere in bands of a row, in one format, FORMAT (f32, q15), to measure its
 * size. WAY 0 has any material, WAY 1 one whose transfer is in flash, WAY 2 any with small sources,
 * WAY 3 draws as WAY 1 from a palette, with the codes in flash. Without FORMAT the program is empty,
 * for comparison. */
#include "eigenshade_presets.h"
#include "print.h"

#ifdef FORMAT

#define JOINED(a, b) a##b
#define NAME(a, b) JOINED(a, b)
#define MY(name) NAME(NAME(eigenshade_, name), FORMAT)
#define TYPE(name) NAME(MY(name), _t)
#define PRESET(kind, name) NAME(eigenshade_##kind##_##name##_, FORMAT)

enum { SIDE = 240 };

static TYPE(picture_) picture;
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

uint32_t program(void) {
#if WAY == 0
  eigenshade_status status = MY(picture_begin_)(&PRESET(light, lobby), &PRESET(material,
      gold_metallic_paint), &picture);
#elif WAY == 1 || WAY == 3
  eigenshade_status status = MY(picture_relight_)(&transfer, &PRESET(light, lobby), &picture);
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
