/* What the library answers to targets, palettes, maps and meters at fault, and that it then leaves
 * alone what it was to write. Freestanding C99. */
#include "checks.h"
#include "eigenshade_presets.h"
#include "parts.h"

enum { SIDE = 8, BAKED = 4 };

static const eigenshade_source_f32_t lamp = {{0, 0, 1}, {1, 1, 1}, 0};
static const eigenshade_gloss_f32_t white = {0.3f, {0, 0, 0}, {1, 1, 1}, {1, 1, 1}};

/* Pixels that stay as they are, and a target of all of them. */
static uint16_t pixels[SIDE * SIDE];
static const eigenshade_target_t whole = {pixels, sizeof pixels, 2 * SIDE, SIDE,
                                          SIDE,   0,             0,        0};

static void check_pixels(const char *name) {
  for (size_t k = 0; k < SIDE * SIDE; k++) {
    check(pixels[k] == 0x0707, name, "the pixels are as they were", (uint32_t)k);
  }
}

/* Pictures, the meter and baked maps. */
#define DRAWN(format, texel)                                                                      \
  static void drawn_##format(void) {                                                              \
    static eigenshade_picture_##format##_t picture, none;                                         \
    static eigenshade_picture_f32_t to_bake;                                                      \
    static eigenshade_palette_t palette;                                                          \
    static eigenshade_nodes_t nodes;                                                              \
    static union {                                                                                \
      eigenshade_picture_##format##_t picture;                                                    \
      eigenshade_palette_t palette;                                                               \
      eigenshade_nodes_t nodes;                                                                   \
    } same;                                                                                       \
    static eigenshade_meter_t meter;                                                              \
    static texel texels[3 * BAKED * BAKED];                                                       \
    static const uint8_t codes[2] = {0, 0};                                                       \
    static uint8_t sphere_codes[2 * SIDE * SIDE];                                                 \
    const eigenshade_normal_map_t sphere = {SIDE, SIDE, sizeof sphere_codes, sphere_codes};       \
    const eigenshade_display_t *const display = &eigenshade_display_linear;                       \
    eigenshade_target_t target = whole;                                                           \
    eigenshade_baked_##format##_t baked;                                                          \
    eigenshade_normal_map_t map = {1, 1, 2, codes};                                               \
    float exposure = 7;                                                                           \
    const char *const name = #format;                                                             \
    fill(pixels, sizeof pixels, 7);                                                               \
    EXPECTED(OK, eigenshade_picture_begin_##format(&eigenshade_light_lobby_##format,              \
        &eigenshade_material_gold_metallic_paint_##format, &picture));                            \
                                                                                                  \
    EXPECTED(PICTURE,                                                                             \
             eigenshade_picture_draw_disc_##format(&none, 8, 1, display, &whole));                \
    EXPECTED(DIAMETER,                                                                            \
             eigenshade_picture_draw_disc_##format(&picture, 0, 1, display, &whole));             \
    EXPECTED(DIAMETER,                                                                            \
             eigenshade_picture_draw_disc_##format(&picture, 4097, 1, display, &whole));          \
    EXPECTED(EXPOSURE,                                                                            \
             eigenshade_picture_draw_disc_##format(&picture, 8, 0, display, &whole));             \
    EXPECTED(EXPOSURE,                                                                            \
             eigenshade_picture_draw_disc_##format(&picture, 8, -1, display, &whole));            \
    EXPECTED(NULL_POINTER,                                                                        \
             eigenshade_picture_draw_disc_##format(&picture, 8, 1, NULL, &whole));                \
    EXPECTED(NULL_POINTER,                                                                        \
             eigenshade_picture_draw_disc_##format(&picture, 8, 1, display, NULL));               \
    EXPECTED(NULL_POINTER,                                                                        \
             eigenshade_picture_draw_normal_map_##format(&picture, NULL, 1, display, &whole));    \
    target.pixels = &picture;                                                                     \
    EXPECTED(OVERLAP,                                                                             \
             eigenshade_picture_draw_disc_##format(&picture, 8, 1, display, &target));            \
    target.pixels = sphere_codes;                                                                 \
    EXPECTED(OVERLAP,                                                                             \
             eigenshade_picture_draw_normal_map_##format(&picture, &sphere, 1, display, &target));\
    target.encoding = 4;                                                                          \
    EXPECTED(ENCODING,                                                                            \
             eigenshade_picture_draw_normal_map_##format(&picture, &map, 1, display, &target));   \
                                                                                                  \
    /* Palettes and nodes that nobody wrote, and inputs at fault. */                              \
    EXPECTED(OK, eigenshade_normal_map_sphere(SIDE, sphere_codes, sizeof sphere_codes));          \
    for (int byte = 0; byte < 256; byte += 85) {                                                  \
      fill(&palette, sizeof palette, (unsigned char)byte);                                        \
      fill(&nodes, sizeof nodes, (unsigned char)byte);                                            \
      EXPECTED(NODES,                                                                             \
               eigenshade_palette_fill_##format(&picture, 1, display, &nodes, &palette));         \
      EXPECTED(PALETTE, eigenshade_palette_draw(&palette, &sphere, &whole));                      \
      EXPECTED(PALETTE, eigenshade_palette_draw_dithered(&palette, &sphere, &whole));             \
    }                                                                                             \
    EXPECTED(PICTURE, eigenshade_palette_fill_##format(&none, 1, display, NULL, &palette));       \
    EXPECTED(EXPOSURE, eigenshade_palette_fill_##format(&picture, 0, display, NULL, &palette));   \
    EXPECTED(NULL_POINTER, eigenshade_palette_fill_##format(NULL, 1, display, NULL, &palette));   \
    EXPECTED(NULL_POINTER, eigenshade_palette_fill_##format(&picture, 1, NULL, NULL, &palette));  \
    EXPECTED(NULL_POINTER, eigenshade_palette_fill_##format(&picture, 1, display, NULL, NULL));   \
    EXPECTED(UNALIGNED, eigenshade_palette_fill_##format(&picture, 1, display, NULL,              \
                                                         BESIDE(&palette)));                      \
    EXPECTED(UNALIGNED, eigenshade_palette_fill_##format(&picture, 1, display, BESIDE(&nodes),    \
                                                         &palette));                              \
    EXPECTED(PALETTE, eigenshade_palette_draw(&palette, &sphere, &whole));                        \
    same.picture = picture;                                                                       \
    EXPECTED(PALETTE, eigenshade_palette_draw(&same.palette, &sphere, &whole));                   \
    EXPECTED(NODES,                                                                               \
             eigenshade_palette_fill_##format(&picture, 1, display, &same.nodes, &palette));      \
    EXPECTED(OVERLAP, eigenshade_palette_fill_##format(&same.picture, 1, display, NULL,           \
                                                       &same.palette));                           \
    EXPECTED(OK, eigenshade_nodes_of_normal_map(&map, &same.nodes));                              \
    EXPECTED(OVERLAP, eigenshade_palette_fill_##format(&picture, 1, display, &same.nodes,         \
                                                       &same.palette));                           \
    check_pixels(name);                                                                           \
    /* The first call makes the nodes of other objects black, not later ones. */                  \
    for (int again = 0; again < 3; again++) {                                                     \
      const eigenshade_nodes_t *const filled = again == 1 ? NULL : &same.nodes;                   \
      EXPECTED(OK, eigenshade_palette_fill_##format(&picture, 1, display, filled, &palette));     \
      EXPECTED(OK, eigenshade_palette_draw(&palette, &sphere, &whole));                           \
      check((pixels[SIDE * 4 + 1] == 0) == (again == 0), name, "the side", (uint32_t)again);          \
      check(pixels[SIDE * 4 + 4] != 0, name, "the middle", (uint32_t)again);                      \
    }                                                                                             \
    fill(pixels, sizeof pixels, 7);                                                               \
                                                                                                  \
    EXPECTED(PICTURE, eigenshade_picture_meter_disc_row_##format(&none, 8, 4, &meter));           \
    EXPECTED(ROW, eigenshade_picture_meter_disc_row_##format(&picture, 8, 8, &meter));            \
    EXPECTED(DIAMETER, eigenshade_picture_meter_disc_row_##format(&picture, 0, 0, &meter));       \
    EXPECTED(NULL_POINTER, eigenshade_picture_meter_disc_row_##format(&picture, 8, 4, NULL));     \
    EXPECTED(OVERLAP, eigenshade_picture_meter_disc_row_##format(                                 \
                          &picture, 8, 4, (eigenshade_meter_t *)(void *)&picture));               \
    EXPECTED(ROW, eigenshade_picture_meter_normal_map_row_##format(&picture, &map, 1, &meter));   \
    EXPECTED(DARK, eigenshade_meter_exposure_f32(&meter, &exposure));                             \
    check(exposure == 7, name, "the exposure is as it was", 0);                                   \
    EXPECTED(OK, eigenshade_picture_meter_normal_map_row_##format(&picture, &map, 0, &meter));    \
    EXPECTED(OK, eigenshade_meter_exposure_f32(&meter, &exposure));                               \
    check(exposure > 0 && exposure != 7, name, "a metered exposure", 0);                          \
    map.length = 3;                                                                               \
    EXPECTED(NORMAL_MAP,                                                                          \
             eigenshade_picture_draw_normal_map_##format(&picture, &map, 1, display, &whole));    \
    map.width = map.length = 0;                                                                   \
    EXPECTED(NORMAL_MAP,                                                                          \
             eigenshade_picture_draw_normal_map_##format(&picture, &map, 1, display, &whole));    \
    check_pixels(name);                                                                           \
                                                                                                  \
    EXPECTED(PICTURE, eigenshade_picture_bake_##format(&to_bake, BAKED, texels, 48, &baked));     \
    EXPECTED(OK, eigenshade_picture_begin_f32(&eigenshade_light_lobby_f32,                        \
        &eigenshade_material_gold_metallic_paint_f32, &to_bake));                                 \
    EXPECTED(BAKED, eigenshade_picture_bake_##format(&to_bake, 1, texels, 3, &baked));            \
    EXPECTED(BAKED, eigenshade_picture_bake_##format(&to_bake, BAKED, texels, 47, &baked));       \
    EXPECTED(BAKED, eigenshade_picture_bake_##format(&to_bake, (size_t)-1, texels, 3, &baked));   \
    EXPECTED(OK, eigenshade_picture_bake_##format(&to_bake, BAKED, texels, 48, &baked));          \
    baked.size = 5;                                                                               \
    EXPECTED(BAKED,                                                                               \
             eigenshade_baked_draw_disc_##format(&baked, 8, 1, display, &whole));                 \
    EXPECTED(BAKED,                                                                               \
             eigenshade_baked_draw_normal_map_##format(&baked, &sphere, 1, display, &whole));     \
    EXPECTED(OK, eigenshade_picture_highlights_f32(&white, &lamp, 1, &to_bake));                  \
    EXPECTED(HIGHLIGHTS, eigenshade_picture_bake_##format(&to_bake, BAKED, texels, 48, &baked));  \
  }

/* Targets at fault, and objects beside their windows. */
static void targets(void) {
  static eigenshade_picture_q15_t picture;
  static eigenshade_palette_t palette;
  static eigenshade_nodes_t nodes;
  static uint8_t codes[2 * SIDE * SIDE];
  const eigenshade_normal_map_t sphere = {SIDE, SIDE, sizeof codes, codes};
  eigenshade_normal_map_t map = sphere;
  const eigenshade_display_t *const display = &eigenshade_display_linear;
  const size_t most = (size_t)-1;
  const char *const name = "targets";
  eigenshade_target_t target = whole;
  EXPECTED(OK, eigenshade_picture_begin_q15(&eigenshade_light_lobby_q15,
      &eigenshade_material_gold_metallic_paint_q15, &picture));
  EXPECTED(OK, eigenshade_normal_map_sphere(SIDE, codes, sizeof codes));
  EXPECTED(OK, eigenshade_palette_fill_q15(&picture, 1, display, NULL, &palette));
  fill(pixels, sizeof pixels, 7);

#define REFUSED(expected, field, value)                                                           \
  target = whole;                                                                                 \
  target.field = value;                                                                           \
  EXPECTED(expected, eigenshade_picture_draw_disc_q15(&picture, SIDE, 1, display, &target));      \
  EXPECTED(expected, eigenshade_palette_draw(&palette, &sphere, &target))

  REFUSED(NULL_POINTER, pixels, NULL);
  REFUSED(UNALIGNED, pixels, BESIDE(pixels));
  REFUSED(TARGET, length, sizeof pixels - 1);
  REFUSED(TARGET, length, 0);
  REFUSED(COUNT, length, most);
  REFUSED(TARGET, stride, 2 * SIDE - 2);
  REFUSED(TARGET, stride, 2 * SIDE + 2);
  REFUSED(TARGET, stride, most);
  REFUSED(TARGET, width, 0);
  REFUSED(TARGET, width, SIDE + 1);
  REFUSED(TARGET, width, most);
  REFUSED(TARGET, height, 0);
  REFUSED(TARGET, height, SIDE + 1);
  REFUSED(TARGET, height, most);
  REFUSED(TARGET, encoding, EIGENSHADE_ENCODING_RGB888);
  REFUSED(ENCODING, encoding, -1);
  REFUSED(TARGET, encoding, EIGENSHADE_ENCODING_RGBA8888);
  REFUSED(ENCODING, encoding, 4);
  REFUSED(OVERLAP, pixels, &target);
  target = whole;
  target.height = 2;
  target.stride = 2 * SIDE + 1;
  EXPECTED(TARGET, eigenshade_palette_draw(&palette, &sphere, &target));
  target = whole;
  target.pixels = codes;
  EXPECTED(OVERLAP, eigenshade_palette_draw(&palette, &sphere, &target));
  target.pixels = &palette;
  EXPECTED(OVERLAP, eigenshade_palette_draw_dithered(&palette, &sphere, &target));
  target.pixels = (void *)(uintptr_t)display;
  EXPECTED(OVERLAP, eigenshade_picture_draw_disc_q15(&picture, SIDE, 1, display, &target));
  EXPECTED(NULL_POINTER, eigenshade_palette_draw(&palette, &sphere, NULL));
  EXPECTED(NULL_POINTER, eigenshade_palette_draw(&palette, NULL, &whole));
  EXPECTED(NULL_POINTER, eigenshade_palette_draw(NULL, &sphere, &whole));

  static const int32_t far[4] = {INT32_MIN, -SIDE, SIDE, INT32_MAX};
  for (int k = 0; k < 8; k++) {
    target = whole;
    *(k < 4 ? &target.x : &target.y) = far[k % 4];
    EXPECTED(OK, eigenshade_picture_draw_disc_q15(&picture, SIDE, 1, display, &target));
    EXPECTED(OK, eigenshade_palette_draw(&palette, &sphere, &target));
    EXPECTED(OK, eigenshade_palette_draw_dithered(&palette, &sphere, &target));
  }
  check_pixels(name);
  /* Of one row, the stride is not used. */
  target = whole;
  target.height = target.stride = 1;
  target.y = -4;
  EXPECTED(OK, eigenshade_palette_draw(&palette, &sphere, &target));
  check(pixels[4] != 0x0707 && pixels[SIDE + 4] == 0x0707, name, "one row", 0);

  EXPECTED(DIAMETER, eigenshade_normal_map_sphere(0, codes, 0));
  EXPECTED(DIAMETER, eigenshade_normal_map_sphere(4097, codes, sizeof codes));
  EXPECTED(NORMAL_MAP, eigenshade_normal_map_sphere(SIDE, codes, sizeof codes - 1));
  EXPECTED(NULL_POINTER, eigenshade_normal_map_sphere(SIDE, NULL, sizeof codes));
  EXPECTED(NULL_POINTER, eigenshade_nodes_of_normal_map(NULL, &nodes));
  EXPECTED(NULL_POINTER, eigenshade_nodes_of_normal_map(&sphere, NULL));
  map.codes = (const uint8_t *)&nodes;
  EXPECTED(OVERLAP, eigenshade_nodes_of_normal_map(&map, &nodes));
  map.length--;
  EXPECTED(NORMAL_MAP, eigenshade_nodes_of_normal_map(&map, &nodes));
  EXPECTED(NODES, eigenshade_palette_fill_q15(&picture, 1, display, &nodes, &palette));
}

DRAWN(f32, float)
DRAWN(q15, int16_t)

void check_target_faults(void) {
  drawn_f32();
  drawn_q15();
  targets();
}
