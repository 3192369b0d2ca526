/* Pictures of textured objects, printed and compared as those of color.c. Freestanding C99. */
#include "checks.h"
#include "eigenshade_presets.h"
#include "objects.h"
#include "parts.h"

enum { SIDE = 48, REGIONS = 3, BAND = 5, PICTURES = 3 };

static const char *const names[PICTURES] = {"textured", "dithered", "textured highlights"};
static uint16_t drawn_f32[PICTURES][SIDE * SIDE], drawn_q15[PICTURES][SIDE * SIDE];
static eigenshade_linear_palette_t palettes[REGIONS];

/* Fills the palettes under a light, with the highlights of sources, and draws the object in bands. */
#define TEXTURED(format)                                                                          \
  static void fill_##format(const eigenshade_color_light_##format##_t *light,                     \
                            const eigenshade_source_f32_t *sources, size_t count) {               \
    static eigenshade_material_buffer_##format##_t buffer;                                        \
    static eigenshade_picture_##format##_t tinted, plain;                                         \
    static eigenshade_nodes_t nodes;                                                              \
    eigenshade_color_material_##format##_t of_tinted, of_plain;                                   \
    const char *const name = #format;                                                             \
    for (size_t region = 0; region < REGIONS; region++) {                                         \
      CHECKED(eigenshade_nodes_of_region(&striped, region, &nodes));                              \
      CHECKED(eigenshade_region_materials_##format(&striped, region, &buffer, &of_tinted,         \
                                                   &of_plain));                                   \
      CHECKED(eigenshade_picture_begin_##format(light, &of_tinted, &tinted));                     \
      CHECKED(eigenshade_picture_begin_##format(light, &of_plain, &plain));                       \
      CHECKED(eigenshade_region_highlights_##format(&striped, region, sources, count, &tinted,    \
                                                    &plain));                                     \
      CHECKED(eigenshade_linear_palette_fill_##format(&tinted, &plain, 1.5f, &nodes,              \
                                                      &palettes[region]));                        \
    }                                                                                             \
  }                                                                                               \
                                                                                                  \
  static void textured_##format(void) {                                                           \
    static eigenshade_light_buffer_##format##_t buffer;                                           \
    const eigenshade_color_light_##format##_t *const lobby = &eigenshade_light_lobby_##format;    \
    const eigenshade_source_f32_t *const sources = eigenshade_sources_lobby_f32;                  \
    const eigenshade_display_t *const display = &eigenshade_display_filmic;                       \
    eigenshade_color_light_##format##_t rest;                                                     \
    const char *const name = #format;                                                             \
    CHECKED(eigenshade_residual_##format(lobby, sources, 4, &buffer, &rest));                     \
    for (size_t picture = 0; picture < PICTURES; picture++) {                                     \
      if (picture == 2) {                                                                         \
        fill_##format(&rest, sources, 4);                                                         \
      } else {                                                                                    \
        fill_##format(lobby, NULL, 0);                                                            \
      }                                                                                           \
      for (size_t row = 0; row < SIDE; row += BAND) {                                             \
        const size_t rows = row + BAND < SIDE ? BAND : SIDE - row;                                \
        const eigenshade_target_t target = {drawn_##format[picture] + SIDE * row,                 \
                                            2 * SIDE * rows, 2 * SIDE, SIDE, rows, 0,             \
                                            -(int32_t)row, EIGENSHADE_ENCODING_RGB565};           \
        if (picture == 1) {                                                                       \
          CHECKED(eigenshade_object_draw_dithered(&striped, palettes, REGIONS, display,           \
                                                  &target));                                      \
        } else {                                                                                  \
          CHECKED(eigenshade_object_draw(&striped, palettes, REGIONS, display, &target));         \
        }                                                                                         \
      }                                                                                           \
    }                                                                                             \
  }

TEXTURED(f32)
TEXTURED(q15)

/* A part of the object in all encodings, from the palettes in integers. */
static void check_encodings(void) {
  static const size_t strides[4] = {88, 91, 133, 174};
  static uint16_t memory[174 * 30 / 2];
  const char *const name = "encodings";
  for (int32_t encoding = 0; encoding < 4; encoding++) {
    const size_t stride = strides[encoding];
    const eigenshade_target_t target = {memory, 30 * stride, stride, 40, 30, -5, 7, encoding};
    for (int way = 0; way < 2; way++) {
      fill(memory, sizeof memory, 0x5a);
      CHECKED((way ? eigenshade_object_draw_dithered : eigenshade_object_draw)(
          &striped, palettes, REGIONS, &eigenshade_display_filmic, &target));
      print_checksum("textured target", memory, 30 * stride);
    }
  }
}

void check_textured(void) {
  textured_f32();
  textured_q15();
  for (size_t picture = 0; picture < PICTURES; picture++) {
    check_picture(names[picture], drawn_f32[picture], drawn_q15[picture], SIDE * SIDE);
  }
  check_encodings();
}
