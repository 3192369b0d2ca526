/* Pictures in color, drawn row by row. In integers each is the same on every machine: its checksum
 * is printed. In float they are those in integers to one level of a channel. Freestanding C99. */
#include "checks.h"
#include "eigenshade_presets.h"
#include "parts.h"

enum { SIDE = 48, MAP = 16, BAKED = 32, MOST = 16 };

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

#define DRAWN(format, picture, rows, call)                                                    \
  do {                                                                                        \
    uint16_t *pixels = drawn_##format[count];                                                 \
    names[count++] = picture;                                                                 \
    for (size_t row = 0; row < (rows); row++, pixels += SIDE) {                               \
      check_status(call, EIGENSHADE_STATUS_OK, #format, picture);                             \
    }                                                                                         \
  } while (0)

#define DISC(format, picture, scene)                                                          \
  DRAWN(format, picture, SIDE,                                                                \
        eigenshade_color_disc_row_##format(scene, SIDE, row, 1.5f,                            \
                                           &eigenshade_display_filmic, pixels, SIDE))

#define PICTURES(format, number, texel, angle, one)                                           \
  static void pictures_##format(void) {                                                       \
    static eigenshade_color_transfer_##format##_t transfer;                                   \
    static eigenshade_color_scene_f32_t to_bake;                                              \
    static eigenshade_color_scene_##format##_t scene;                                         \
    static eigenshade_color_light_buffer_##format##_t light_buffer, turned_buffer;            \
    static eigenshade_color_material_buffer_##format##_t material_buffer;                     \
    static texel texels[3 * BAKED * BAKED];                                                   \
    static const angle quaternion[4] = {1, -2, 3, 4}, angles[2] = {FIFTHS_##format};          \
    static const number copper[3] = {(number)(0.93f * (one)), (number)(0.5f * (one)),         \
                                     (number)(0.25f * (one))};                                \
    const eigenshade_color_light_##format##_t *lobby = &eigenshade_light_lobby_##format;      \
    eigenshade_color_light_##format##_t light, turned;                                        \
    eigenshade_color_material_##format##_t material;                                          \
    eigenshade_color_baked_##format##_t baked;                                                \
    eigenshade_source_f32_t sources[4];                                                       \
    eigenshade_color_glossy_##format##_t glossy = {                                           \
        &scene, &eigenshade_gloss_gold_metallic_paint_f32, eigenshade_sources_lobby_f32, 4};   \
    const char *const name = #format;                                                         \
                                                                                              \
    CHECKED(eigenshade_color_scene_##format(                                                  \
        lobby, &eigenshade_material_gold_metallic_paint_##format, &scene));                   \
    DISC(format, "scene", &scene);                                                            \
    CHECKED(eigenshade_color_transfer_##format(                                               \
        &eigenshade_material_gold_metallic_paint_##format, &transfer));                       \
    CHECKED(eigenshade_color_relight_##format(&transfer, &eigenshade_light_park_##format,     \
                                              &scene));                                       \
    DISC(format, "relit", &scene);                                                            \
    CHECKED(eigenshade_color_turn_##format(lobby, quaternion, &light_buffer, &light));        \
    CHECKED(eigenshade_color_relight_##format(&transfer, &light, &scene));                    \
    DISC(format, "turned", &scene);                                                           \
    CHECKED(eigenshade_color_turn_about_view_##format(lobby, angles, &light_buffer, &light)); \
    CHECKED(eigenshade_color_relight_##format(&transfer, &light, &scene));                    \
    DISC(format, "turned about the view", &scene);                                            \
    DRAWN(format, "normal map", MAP,                                                          \
          eigenshade_color_normal_map_row_##format(&scene, &map, row, 0.7f,                   \
                                                   &eigenshade_display_reinhard, pixels,      \
                                                   SIDE));                                    \
    CHECKED(eigenshade_color_residual_##format(&eigenshade_light_lobby_f32, glossy.sources, 4, \
                                               &light_buffer, &light));                       \
    CHECKED(eigenshade_color_relight_##format(&transfer, &light, &scene));                    \
    DRAWN(format, "highlights", SIDE,                                                         \
          eigenshade_color_glossy_disc_row_##format(&glossy, SIDE, row, 1.0f,                 \
                                                    &eigenshade_display_linear, pixels, SIDE)); \
    CHECKED(eigenshade_color_turn_##format(&light, quaternion, &turned_buffer, &turned));     \
    CHECKED(eigenshade_color_relight_##format(&transfer, &turned, &scene));                   \
    for (size_t k = 0; k < 4; k++) {                                                          \
      CHECKED(eigenshade_source_turn_f32(&eigenshade_sources_lobby_f32[k],                    \
                                         quaternion_f32, &sources[k]));                       \
    }                                                                                         \
    glossy.sources = sources;                                                                 \
    DRAWN(format, "turned highlights", MAP,                                                   \
          eigenshade_color_glossy_normal_map_row_##format(                                    \
              &glossy, &map, row, 1.0f, &eigenshade_display_linear, pixels, SIDE));           \
    CHECKED(eigenshade_color_metallic_roughness_##format(                                     \
        copper, (number)(0.75f * (one)), (number)(0.5f * (one)), &material_buffer,            \
        &material));                                                                          \
    CHECKED(eigenshade_color_scene_##format(lobby, &material, &scene));                       \
    DISC(format, "glTF", &scene);                                                             \
    CHECKED(eigenshade_color_scene_##format(                                                  \
        lobby, &eigenshade_material_ptfe_633nm_##format, &scene));                            \
    DISC(format, "gray", &scene);                                                             \
    CHECKED(eigenshade_color_scene_f32(&eigenshade_light_lobby_f32,                           \
                                       &eigenshade_material_dark_red_paint_f32, &to_bake));   \
    CHECKED(eigenshade_color_bake_##format(&to_bake, BAKED, texels, 3 * BAKED * BAKED,        \
                                           &baked));                                          \
    DRAWN(format, "baked", SIDE,                                                              \
          eigenshade_color_baked_disc_row_##format(&baked, SIDE, row, 1.5f,                   \
                                                   &eigenshade_display_linear, pixels, SIDE)); \
    DRAWN(format, "baked normal map", MAP,                                                    \
          eigenshade_color_baked_normal_map_row_##format(                                     \
              &baked, &map, row, 1.5f, &eigenshade_display_filmic, pixels, SIDE));            \
  }

#define CHECKED(call) check_status(call, EIGENSHADE_STATUS_OK, name, #call)

/* The rotation of sources, which are in float. */
static const float quaternion_f32[4] = {1, -2, 3, 4};

/* Cosine and sine: in integers of any scale. */
#define FIFTHS_f32 0.6f, 0.8f
#define FIFTHS_q15 3, 4

PICTURES(f32, float, float, float, 1.0f)
PICTURES(q15, int16_t, int16_t, int32_t, 32767.0f)

/* FNV-1a of a picture, the low byte of each pixel first. */
static uint32_t checksum(const uint16_t *picture) {
  uint32_t sum = 2166136261u;
  for (size_t k = 0; k < SIDE * SIDE; k++) {
    sum = (sum ^ (picture[k] & 0xffu)) * 16777619u;
    sum = (sum ^ (uint32_t)(picture[k] >> 8)) * 16777619u;
  }
  return sum;
}

/* Whether the channels of bits `low` to `low` + `bits` differ by one at most. */
static int are_near(uint16_t a, uint16_t b, int low, int bits) {
  const int mask = (1 << bits) - 1;
  const int difference = ((a >> low) & mask) - ((b >> low) & mask);
  return difference >= -1 && difference <= 1;
}

/* The irradiance of one normal, from a scene and from a baked one: in integers printed, in float
 * those in integers to a thousandth. */
static void check_shade(void) {
  static eigenshade_color_scene_f32_t scene_f32;
  static eigenshade_color_scene_q15_t scene_q15;
  static float texels_f32[3 * BAKED * BAKED];
  static int16_t texels_q15[3 * BAKED * BAKED];
  const char *const name = "shade";
  eigenshade_color_baked_f32_t baked_f32;
  eigenshade_color_baked_q15_t baked_q15;
  float found_f32[9];
  int32_t found_q15[9];

  CHECKED(eigenshade_color_scene_f32(&eigenshade_light_lobby_f32,
                                     &eigenshade_material_dark_red_paint_f32, &scene_f32));
  CHECKED(eigenshade_color_scene_q15(&eigenshade_light_lobby_q15,
                                     &eigenshade_material_dark_red_paint_q15, &scene_q15));
  CHECKED(eigenshade_color_bake_f32(&scene_f32, BAKED, texels_f32, 3 * BAKED * BAKED, &baked_f32));
  CHECKED(eigenshade_color_bake_q15(&scene_f32, BAKED, texels_q15, 3 * BAKED * BAKED, &baked_q15));
  CHECKED(eigenshade_color_shade_f32(&scene_f32, 0, 0.6f, 0.8f, found_f32));
  CHECKED(eigenshade_color_shade_q15(&scene_q15, 0, 19661, 26214, found_q15));
  CHECKED(eigenshade_color_baked_shade_f32(&baked_f32, 0, 0.6f, 0.8f, found_f32 + 3));
  CHECKED(eigenshade_color_baked_shade_q15(&baked_q15, 0, 19661, 26214, found_q15 + 3));
  /* Half-way between a lamp and the camera, on copper. */
  static const eigenshade_source_f32_t lamp = {
      {0, 0.6f, 0.8f}, {0.5f, 0.4f, 0.3f}, 0.03f};
  static const float copper[3] = {0.93f, 0.5f, 0.25f};
  eigenshade_gloss_f32_t gloss;
  CHECKED(eigenshade_gloss_metallic_roughness_f32(copper, 1, 0.3f, &gloss));
  const eigenshade_color_glossy_f32_t glossy_f32 = {&scene_f32, &gloss, &lamp, 1};
  const eigenshade_color_glossy_q15_t glossy_q15 = {&scene_q15, &gloss, &lamp, 1};
  CHECKED(eigenshade_color_glossy_shade_f32(&glossy_f32, 0, 0.3162f, 0.9487f, found_f32 + 6));
  CHECKED(eigenshade_color_glossy_shade_q15(&glossy_q15, 0, 10362, 31086, found_q15 + 6));
  const int32_t exponents[9] = {scene_q15.r.exponent,   scene_q15.g.exponent,
                                scene_q15.b.exponent,   baked_q15.exponents[0],
                                baked_q15.exponents[1], baked_q15.exponents[2],
                                scene_q15.r.exponent,   scene_q15.g.exponent,
                                scene_q15.b.exponent};
  /* By the textbook E F D / (4 n.v): 0.5 x 0.93 x 35 / 3.8 for a lobe that the lamp widens; and the
   * scene. */
  check(found_f32[6] > 4.3f && found_f32[6] < 5, "f32", "the peak of a highlight", 0);
  for (uint32_t k = 0; k < 9; k++) {
    float found = found_f32[k];
    for (int32_t exponent = exponents[k]; exponent < 0; exponent++) {
      found *= 2;
    }
    for (int32_t exponent = exponents[k]; exponent > 0; exponent--) {
      found /= 2;
    }
    const float expected = (float)found_q15[k];
    check(found > 0.999f * expected && found < 1.001f * expected, "f32", name, k);
    print("shade,");
    print_u32((uint32_t)found_q15[k]);
    print("\n");
  }
}

void check_color(void) {
  fill_codes();
  pictures_f32();
  count = 0;
  pictures_q15();
  for (size_t picture = 0; picture < count; picture++) {
    for (size_t k = 0; k < SIDE * SIDE; k++) {
      const uint16_t a = drawn_f32[picture][k], b = drawn_q15[picture][k];
      check(are_near(a, b, 0, 5) && are_near(a, b, 5, 6) && are_near(a, b, 11, 5), "f32",
            names[picture], (uint32_t)k);
    }
    print(names[picture]);
    print(",");
    print_u32(checksum(drawn_q15[picture]));
    print("\n");
  }
  check_shade();
}
