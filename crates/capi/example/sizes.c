/* A program that draws the rows of a sphere in one format, FORMAT (f32, q15), to measure its size.
 * WAY 0 has any material, WAY 1 one whose transfer is in flash, WAY 2 any with small sources.
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

static TYPE(picture_) picture;
static uint16_t row_of_pixels[SIDE];
volatile uint16_t drawn;
#if WAY == 1
static const TYPE(transfer_) transfer = {.numbers = {{1}}};
#endif

uint32_t program(void) {
#if WAY == 0
  eigenshade_status status = MY(picture_begin_)(&PRESET(light, lobby), &PRESET(material,
      gold_metallic_paint), &picture);
#elif WAY == 1
  eigenshade_status status = MY(picture_relight_)(&transfer, &PRESET(light, lobby), &picture);
#else
  eigenshade_status status = MY(picture_begin_glossy_)(&PRESET(light, lobby), &PRESET(material,
      gold_metallic_paint), &eigenshade_gloss_gold_metallic_paint_f32,
      eigenshade_sources_lobby_f32, 4, &picture);
#endif
  for (size_t row = 0; !status && row < SIDE; row++) {
    status = MY(picture_disc_row_)(&picture, SIDE, row, 1.5f, &eigenshade_display_filmic,
                                   row_of_pixels, SIDE);
    drawn = row_of_pixels[SIDE / 2];
  }
  return (uint32_t)status;
}

#else

uint32_t program(void) { return 0; }

#endif
