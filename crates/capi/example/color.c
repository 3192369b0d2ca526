/* Pictures in color. In integers each is the same on every machine: its checksum is printed. In
 * float they are those in integers to one level of a channel. Freestanding C99. */
#include "checks.h"
#include "eigenshade_presets.h"
#include "parts.h"

enum { SIDE = 48, MAP = 16, BAKED = 32, BAND = 5, MOST = 16 };

/* What was drawn, in f32 and in q15. */
static uint16_t drawn_f32[MOST][SIDE * SIDE], drawn_q15[MOST][SIDE * SIDE];
static const char *names[MOST];
static size_t count;

/* A map of arbitrary codes: objects in parts of pixels, and all directions. */
static uint8_t codes[2 * MAP * MAP];
static const eigenshade_normal_map_t map = {MAP, MAP, sizeof codes, codes};

static void fill_codes(void) {
  uint32_t state = 1;
  for (size_t k = 0; k < sizeof codes; k++) {
    state = state * 1664525u + 1013904223u;
    codes[k] = (uint8_t)(state >> 24);
  }
}

/* A sphere. */
static uint8_t codes_of_sphere[2 * SIDE * SIDE];
static const eigenshade_normal_map_t sphere = {SIDE, SIDE, sizeof codes_of_sphere, codes_of_sphere};

/* The next picture, or some of its rows. */
static eigenshade_target_t next(uint16_t picture[], size_t row, size_t rows) {
  const size_t left = SIDE - row, height = rows < left ? rows : left;
  const eigenshade_target_t target = {picture + SIDE * row, 2 * SIDE * height, 2 * SIDE, SIDE,
                                      height, 0, -(int32_t)row, EIGENSHADE_ENCODING_RGB565};
  return target;
}

/* A picture that is drawn in bands of this height. */
#define DRAWN(format, picture, band, call)                                                        \
  do {                                                                                            \
    for (size_t row = 0; row < SIDE; row += (band)) {                                             \
      const eigenshade_target_t target = next(drawn_##format[count], row, band);                  \
      check_status(call, EIGENSHADE_STATUS_OK, #format, picture);                                 \
    }                                                                                             \
    names[count++] = picture;                                                                     \
  } while (0)

#define DISC(format, picture, from)                                                               \
  DRAWN(format, picture, SIDE,                                                                    \
        eigenshade_picture_draw_disc_##format(from, SIDE, 1.5f, &eigenshade_display_filmic,       \
                                              &target))

#define PICTURES(format, number, texel, angle, one)                                               \
  static void pictures_##format(void) {                                                           \
    static eigenshade_transfer_##format##_t transfer;                                             \
    static eigenshade_picture_f32_t to_bake;                                                      \
    static eigenshade_picture_##format##_t picture, moved;                                        \
    static eigenshade_light_buffer_##format##_t light_buffer, turned_buffer;                      \
    static eigenshade_material_buffer_##format##_t material_buffer;                               \
    static texel texels[3 * BAKED * BAKED];                                                       \
    static const angle quaternion[4] = {1, -2, 3, 4}, angles[2] = {FIFTHS_##format};              \
    static const number copper[3] = {(number)(0.93f * (one)), (number)(0.5f * (one)),             \
                                     (number)(0.25f * (one))};                                    \
    const eigenshade_color_light_##format##_t *lobby = &eigenshade_light_lobby_##format;          \
    const eigenshade_color_material_##format##_t *gold =                                          \
        &eigenshade_material_gold_metallic_paint_##format;                                        \
    const eigenshade_gloss_f32_t *gloss = &eigenshade_gloss_gold_metallic_paint_f32;              \
    eigenshade_color_light_##format##_t light, turned;                                            \
    eigenshade_color_material_##format##_t material;                                              \
    eigenshade_baked_##format##_t baked;                                                          \
    eigenshade_source_f32_t sources[4];                                                           \
    static eigenshade_palette_t palette;                                                          \
    static eigenshade_nodes_t nodes;                                                              \
    const char *const name = #format;                                                             \
                                                                                                  \
    CHECKED(eigenshade_picture_begin_##format(lobby, gold, &picture));                            \
    DISC(format, "scene", &picture);                                                              \
    CHECKED(eigenshade_transfer_##format(gold, &transfer));                                       \
    CHECKED(eigenshade_picture_relight_##format(&transfer, &eigenshade_light_park_##format,       \
                                                &picture));                                       \
    DISC(format, "relit", &picture);                                                              \
    CHECKED(eigenshade_mask_light_##format(lobby, EIGENSHADE_EFFECT_DIFFUSE, &light_buffer,       \
                                           &light));                                              \
    CHECKED(eigenshade_mask_material_##format(gold, EIGENSHADE_EFFECT_DIFFUSE, &material_buffer,  \
                                              &material));                                        \
    CHECKED(eigenshade_picture_begin_##format(&light, &material, &picture));                      \
    DISC(format, "diffuse", &picture);                                                            \
    CHECKED(eigenshade_turn_##format(lobby, quaternion, &light_buffer, &light));                  \
    CHECKED(eigenshade_picture_relight_##format(&transfer, &light, &picture));                    \
    DISC(format, "turned", &picture);                                                             \
    CHECKED(eigenshade_turn_about_view_##format(lobby, angles, &light_buffer, &light));           \
    CHECKED(eigenshade_picture_relight_##format(&transfer, &light, &picture));                    \
    DISC(format, "turned about the view", &picture);                                              \
    DRAWN(format, "normal map", SIDE,                                                             \
          eigenshade_picture_draw_normal_map_##format(&picture, &map, 0.7f,                       \
                                                      &eigenshade_display_reinhard, &target));    \
    CHECKED(eigenshade_palette_fill_##format(&picture, 1.5f, &eigenshade_display_filmic, NULL,    \
                                             &palette));                                          \
    DRAWN(format, "palette", BAND, eigenshade_palette_draw(&palette, &sphere, &target));          \
    CHECKED(eigenshade_picture_begin_glossy_##format(lobby, gold, gloss,                          \
        eigenshade_sources_lobby_f32, 4, &picture));                                            \
    moved = picture;                                                                              \
    DRAWN(format, "highlights", BAND,                                                             \
          eigenshade_picture_draw_disc_##format(&moved, SIDE, 1.0f, &eigenshade_display_linear,   \
                                                &target));                                        \
    CHECKED(eigenshade_nodes_of_normal_map(&sphere, &nodes));                                     \
    CHECKED(eigenshade_palette_fill_##format(&moved, 1.0f, &eigenshade_display_linear, &nodes,    \
                                             &palette));                                          \
    DRAWN(format, "palette of highlights", SIDE,                                                  \
          eigenshade_palette_draw_dithered(&palette, &sphere, &target));                          \
    CHECKED(eigenshade_residual_##format(lobby, eigenshade_sources_lobby_f32, 4,                \
                                         &light_buffer, &light));                                 \
    CHECKED(eigenshade_turn_##format(&light, quaternion, &turned_buffer, &turned));               \
    CHECKED(eigenshade_picture_relight_##format(&transfer, &turned, &picture));                   \
    for (size_t k = 0; k < 4; k++) {                                                              \
      CHECKED(eigenshade_source_turn_f32(&eigenshade_sources_lobby_f32[k], quaternion_f32,      \
                                         &sources[k]));                                           \
    }                                                                                             \
    CHECKED(eigenshade_picture_highlights_##format(gloss, sources, 4, &picture));                 \
    DRAWN(format, "turned highlights", SIDE,                                                      \
          eigenshade_picture_draw_normal_map_##format(&picture, &map, 1.0f,                       \
                                                      &eigenshade_display_linear, &target));      \
    CHECKED(eigenshade_metallic_roughness_##format(copper, (number)(0.75f * (one)),               \
                                                   (number)(0.5f * (one)), &material_buffer,      \
                                                   &material));                                   \
    CHECKED(eigenshade_picture_begin_##format(lobby, &material, &picture));                       \
    DISC(format, "glTF", &picture);                                                               \
    CHECKED(eigenshade_picture_begin_##format(lobby, &eigenshade_material_ptfe_633nm_##format,    \
        &picture));                                                                               \
    DISC(format, "gray", &picture);                                                               \
    DRAWN(format, "gray normal map", BAND,                                                        \
          eigenshade_picture_draw_normal_map_##format(&picture, &map, 1.5f,                       \
                                                      &eigenshade_display_filmic, &target));      \
    CHECKED(eigenshade_picture_begin_f32(&eigenshade_light_lobby_f32,                             \
        &eigenshade_material_dark_red_paint_f32, &to_bake));                                      \
    CHECKED(eigenshade_picture_bake_##format(&to_bake, BAKED, texels, 3 * BAKED * BAKED,          \
                                             &baked));                                            \
    DRAWN(format, "baked", BAND,                                                                  \
          eigenshade_baked_draw_disc_##format(&baked, SIDE, 1.5f, &eigenshade_display_linear,     \
                                              &target));                                          \
    DRAWN(format, "baked normal map", SIDE,                                                       \
          eigenshade_baked_draw_normal_map_##format(&baked, &map, 1.5f,                           \
                                                    &eigenshade_display_filmic, &target));        \
  }

/* The rotation of sources, which are in float. */
static const float quaternion_f32[4] = {1, -2, 3, 4};

/* Cosine and sine: in integers of any scale. */
#define FIFTHS_f32 0.6f, 0.8f
#define FIFTHS_q15 3, 4

PICTURES(f32, float, float, float, 1.0f)
PICTURES(q15, int16_t, int16_t, int32_t, 32767.0f)

/* The irradiance of one normal, from a picture, from a baked one, and with a highlight: in integers
 * printed, in float those in integers to a thousandth. */
static void check_shade(void) {
  static eigenshade_picture_f32_t of_f32;
  static eigenshade_picture_q15_t of_q15;
  static float texels_f32[3 * BAKED * BAKED];
  static int16_t texels_q15[3 * BAKED * BAKED];
  const eigenshade_color_material_f32_t *red = &eigenshade_material_dark_red_paint_f32;
  const char *const name = "shade";
  eigenshade_baked_f32_t baked_f32;
  eigenshade_baked_q15_t baked_q15;
  eigenshade_irradiance_f32_t found_f32[3];
  eigenshade_irradiance_q15_t found_q15[3];

  CHECKED(eigenshade_picture_begin_f32(&eigenshade_light_lobby_f32, red, &of_f32));
  CHECKED(eigenshade_picture_begin_q15(&eigenshade_light_lobby_q15,
      &eigenshade_material_dark_red_paint_q15, &of_q15));
  CHECKED(eigenshade_picture_bake_f32(&of_f32, BAKED, texels_f32, 3 * BAKED * BAKED, &baked_f32));
  CHECKED(eigenshade_picture_bake_q15(&of_f32, BAKED, texels_q15, 3 * BAKED * BAKED, &baked_q15));
  CHECKED(eigenshade_picture_shade_f32(&of_f32, 0, 0.6f, 0.8f, &found_f32[0]));
  CHECKED(eigenshade_picture_shade_q15(&of_q15, 0, 19661, 26214, &found_q15[0]));
  CHECKED(eigenshade_baked_shade_f32(&baked_f32, 0, 0.6f, 0.8f, &found_f32[1]));
  CHECKED(eigenshade_baked_shade_q15(&baked_q15, 0, 19661, 26214, &found_q15[1]));
  /* Half-way between a lamp and the camera, on copper. */
  static const eigenshade_source_f32_t lamp = {
      {0, 0.6f, 0.8f}, {0.5f, 0.4f, 0.3f}, 0.03f};
  static const float copper[3] = {0.93f, 0.5f, 0.25f};
  eigenshade_gloss_f32_t gloss;
  CHECKED(eigenshade_gloss_metallic_roughness_f32(copper, 1, 0.3f, &gloss));
  CHECKED(eigenshade_picture_highlights_f32(&gloss, &lamp, 1, &of_f32));
  CHECKED(eigenshade_picture_highlights_q15(&gloss, &lamp, 1, &of_q15));
  CHECKED(eigenshade_picture_shade_f32(&of_f32, 0, 0.3162f, 0.9487f, &found_f32[2]));
  CHECKED(eigenshade_picture_shade_q15(&of_q15, 0, 10362, 31086, &found_q15[2]));
  /* By the textbook E F D / (4 n.v): 0.5 x 0.93 x 35 / 3.8 for a lobe that the lamp widens; and the
   * scene. */
  check(found_f32[2].r > 4.3f && found_f32[2].r < 5, "f32", "the peak of a highlight", 0);
  for (uint32_t k = 0; k < 9; k++) {
    const eigenshade_irradiance_f32_t of_floats = found_f32[k / 3];
    const eigenshade_irradiance_q15_t of_integers = found_q15[k / 3];
    const float floats[3] = {of_floats.r, of_floats.g, of_floats.b};
    const int32_t integers[3] = {of_integers.r, of_integers.g, of_integers.b};
    float found = floats[k % 3];
    for (int32_t exponent = of_integers.exponents[k % 3]; exponent < 0; exponent++) {
      found *= 2;
    }
    for (int32_t exponent = of_integers.exponents[k % 3]; exponent > 0; exponent--) {
      found /= 2;
    }
    const float expected = (float)integers[k % 3];
    check(found > 0.999f * expected && found < 1.001f * expected, "f32", name, k);
    print("shade,");
    print_u32((uint32_t)integers[k % 3]);
    print("\n");
  }
  /* The highlights are those of one call only. */
  CHECKED(eigenshade_picture_highlights_f32(&gloss, NULL, 0, &of_f32));
  CHECKED(eigenshade_picture_shade_f32(&of_f32, 0, 0.6f, 0.8f, &found_f32[1]));
  check(found_f32[0].r == found_f32[1].r, "f32", "no highlights", 0);
}

/* Windows of 40 x 30 pixels in all encodings, with space between the rows, and a sphere beyond each
 * corner. */
static void check_targets(void) {
  enum { WIDTH = 40, HEIGHT = 30, PLACES = 4 };
  static const struct {
    int32_t encoding;
    size_t stride;
  } rows[4] = {{EIGENSHADE_ENCODING_RGB565, 88},
               {EIGENSHADE_ENCODING_RGB565_HIGH_FIRST, 91},
               {EIGENSHADE_ENCODING_RGB888, 133},
               {EIGENSHADE_ENCODING_RGBA8888, 174}};
  static const int32_t places[PLACES][2] = {{-5, -20}, {20, -7}, {-31, 3}, {2, 11}};
  static uint16_t memory[174 * HEIGHT / 2];
  static eigenshade_picture_q15_t picture;
  static eigenshade_palette_t palette;
  const eigenshade_display_t *display = &eigenshade_display_filmic;
  const char *const name = "targets";
  CHECKED(eigenshade_picture_begin_q15(&eigenshade_light_lobby_q15,
      &eigenshade_material_gold_metallic_paint_q15, &picture));
  CHECKED(eigenshade_palette_fill_q15(&picture, 1.5f, display, NULL, &palette));
  for (size_t k = 0; k < 4 * PLACES; k++) {
    const int32_t *place = places[k % PLACES];
    const size_t stride = rows[k / PLACES].stride;
    const eigenshade_target_t target = {memory, stride * HEIGHT, stride, WIDTH, HEIGHT,
                                        place[0], place[1], rows[k / PLACES].encoding};
    for (int way = 0; way < 4; way++) {
      for (size_t pixel = 0; pixel < sizeof memory / 2; pixel++) {
        memory[pixel] = 0x5a5a;
      }
      if (way == 0) {
        CHECKED(eigenshade_picture_draw_disc_q15(&picture, SIDE, 1.5f, display, &target));
      } else if (way == 1) {
        CHECKED(eigenshade_picture_draw_normal_map_q15(&picture, &sphere, 1.5f, display, &target));
      } else if (way == 2) {
        CHECKED(eigenshade_palette_draw(&palette, &sphere, &target));
      } else {
        CHECKED(eigenshade_palette_draw_dithered(&palette, &sphere, &target));
      }
      print_checksum("target", memory, stride * HEIGHT);
    }
  }
}

void check_color(void) {
  fill_codes();
  check_status(eigenshade_normal_map_sphere(SIDE, codes_of_sphere, sizeof codes_of_sphere),
               EIGENSHADE_STATUS_OK, "any", "sphere");
  pictures_f32();
  count = 0;
  pictures_q15();
  for (size_t picture = 0; picture < count; picture++) {
    check_picture(names[picture], drawn_f32[picture], drawn_q15[picture], SIDE * SIDE);
  }
  check_targets();
  check_shade();
}
