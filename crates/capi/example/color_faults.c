/* What the functions in color answer to arguments at fault, and that they leave alone what they
 * were to write. Freestanding C99. */
#include "checks.h"
#include "eigenshade_presets.h"
#include "parts.h"

enum { SIDE = 8, BAKED = 4 };

/* A pointer that is not aligned. */
#define BESIDE(pointer) ((void *)((char *)(pointer) + 1))

/* The one row of a disc of a pixel, which is column 4 of the buffer. */
#define GLOSSY(format)                                                                        \
  eigenshade_color_glossy_disc_row_##format(&glossy, 1, 0, 1, display, pixels + 4, 1)

static const float zeros[4] = {0, 0, 0, 0};

#define FAULTS(format, number, texel, angle)                                                  \
  static void faults_##format(void) {                                                         \
    static eigenshade_color_transfer_##format##_t transfer;                                   \
    static eigenshade_color_scene_f32_t to_bake;                                              \
    static eigenshade_color_scene_##format##_t scene;                                         \
    static eigenshade_meter_t meter;                                                          \
    static eigenshade_color_light_buffer_##format##_t light_buffer;                           \
    static eigenshade_color_material_buffer_##format##_t material_buffer;                     \
    static texel texels[3 * BAKED * BAKED];                                                   \
    static const angle none[4] = {0, 0, 0, 0};                                                \
    static const uint8_t codes[2] = {0, 0};                                                   \
    static const number black[3] = {0, 0, 0}, outside[3] = {0, (number)-1, 0};                \
    const eigenshade_color_light_##format##_t *const lobby = &eigenshade_light_lobby_##format; \
    const eigenshade_color_material_##format##_t *const gold =                                \
        &eigenshade_material_gold_metallic_paint_##format;                                    \
    const eigenshade_display_t *const display = &eigenshade_display_linear;                   \
    eigenshade_color_light_##format##_t light = *lobby;                                       \
    eigenshade_color_material_##format##_t material = *gold;                                  \
    eigenshade_color_baked_##format##_t baked;                                                \
    eigenshade_normal_map_t map = {1, 1, 2, codes};                                           \
    uint16_t pixels[SIDE] = {7, 7, 7, 7, 7, 7, 7, 7};                                         \
    const char *const name = #format;                                                         \
                                                                                              \
    EXPECTED(SCENE,                                                                           \
             eigenshade_color_disc_row_##format(&scene, 8, 4, 1, display, pixels, SIDE));     \
    EXPECTED(SCENE, eigenshade_color_bake_##format(&to_bake, BAKED, texels, 48, &baked));     \
    EXPECTED(OK, eigenshade_color_scene_##format(lobby, gold, &scene));                       \
    scene.b.state ^= 1;                                                                       \
    EXPECTED(SCENE,                                                                           \
             eigenshade_color_disc_row_##format(&scene, 8, 4, 1, display, pixels, SIDE));     \
    EXPECTED(SCENE, eigenshade_color_meter_disc_row_##format(&scene, 8, 4, &meter));          \
    scene.b.state ^= 1;                                                                       \
    float exposure = 7;                                                                       \
    EXPECTED(ROW, eigenshade_color_meter_disc_row_##format(&scene, 8, 8, &meter));            \
    EXPECTED(DIAMETER, eigenshade_color_meter_disc_row_##format(&scene, 0, 0, &meter));       \
    EXPECTED(NULL_POINTER, eigenshade_color_meter_disc_row_##format(&scene, 8, 4, NULL));     \
    EXPECTED(OVERLAP, eigenshade_color_meter_disc_row_##format(                               \
                          &scene, 8, 4, (eigenshade_meter_t *)(void *)&scene));               \
    EXPECTED(ROW, eigenshade_color_meter_normal_map_row_##format(&scene, &map, 1, &meter));   \
    EXPECTED(DARK, eigenshade_meter_exposure_f32(&meter, &exposure));                         \
    check(exposure == 7, name, "the exposure is as it was", 0);                               \
    EXPECTED(OK, eigenshade_color_meter_normal_map_row_##format(&scene, &map, 0, &meter));    \
    EXPECTED(OK, eigenshade_meter_exposure_f32(&meter, &exposure));                           \
    check(exposure > 0 && exposure != 7, name, "a metered exposure", 0);                      \
    scene.b.terms[0] = 77;                                                                    \
    light.b.degree = EIGENSHADE_DEGREE + 1;                                                   \
    EXPECTED(LIGHT_BEYOND, eigenshade_color_scene_##format(&light, gold, &scene));            \
    EXPECTED(LIGHT_BEYOND, eigenshade_color_relight_##format(&transfer, &light, &scene));     \
    material.g.length = 39;                                                                   \
    EXPECTED(MATERIAL_LENGTH, eigenshade_color_scene_##format(lobby, &material, &scene));     \
    transfer.b.numbers[0] = 77;                                                               \
    EXPECTED(MATERIAL_LENGTH, eigenshade_color_transfer_##format(&material, &transfer));      \
    check(transfer.b.numbers[0] == (number)77, name, "the transfer is as it was", 0);         \
    EXPECTED(NULL_POINTER, eigenshade_color_scene_##format(NULL, gold, &scene));              \
    EXPECTED(NULL_POINTER, eigenshade_color_scene_##format(lobby, NULL, &scene));             \
    EXPECTED(NULL_POINTER, eigenshade_color_scene_##format(lobby, gold, NULL));               \
    EXPECTED(UNALIGNED, eigenshade_color_scene_##format(lobby, gold, BESIDE(&scene)));        \
    check(scene.b.terms[0] == (number)77, name, "the scene is as it was", 0);                 \
                                                                                              \
    light = *lobby;                                                                           \
    EXPECTED(ROTATION, eigenshade_color_turn_##format(lobby, none, &light_buffer, &light));   \
    EXPECTED(ROTATION, eigenshade_color_turn_about_view_##format(lobby, none, &light_buffer,  \
                                                                 &light));                    \
    light = *lobby;                                                                           \
    EXPECTED(OVERLAP, eigenshade_color_turn_##format(&light, none, &light_buffer, &light));   \
    EXPECTED(OUTSIDE,                                                                         \
             eigenshade_color_metallic_roughness_##format(outside, 0, 0, &material_buffer,    \
                                                          &material));                        \
    EXPECTED(OUTSIDE,                                                                         \
             eigenshade_color_metallic_roughness_##format(black, (number)-1, 0,               \
                                                          &material_buffer, &material));      \
    EXPECTED(OUTSIDE,                                                                         \
             eigenshade_color_metallic_roughness_##format(black, 0, (number)-1,               \
                                                          &material_buffer, &material));      \
                                                                                              \
    EXPECTED(DIAMETER,                                                                        \
             eigenshade_color_disc_row_##format(&scene, 0, 0, 1, display, pixels, SIDE));     \
    EXPECTED(DIAMETER,                                                                        \
             eigenshade_color_disc_row_##format(&scene, 4097, 0, 1, display, pixels, SIDE));  \
    EXPECTED(ROW, eigenshade_color_disc_row_##format(&scene, 8, 8, 1, display, pixels, SIDE)); \
    EXPECTED(ROW,                                                                             \
             eigenshade_color_disc_row_##format(&scene, 8, 4, 1, display, pixels, SIDE - 1)); \
    EXPECTED(EXPOSURE,                                                                        \
             eigenshade_color_disc_row_##format(&scene, 8, 4, 0, display, pixels, SIDE));     \
    EXPECTED(EXPOSURE,                                                                        \
             eigenshade_color_disc_row_##format(&scene, 8, 4, -1, display, pixels, SIDE));    \
    EXPECTED(NULL_POINTER,                                                                    \
             eigenshade_color_disc_row_##format(&scene, 8, 4, 1, NULL, pixels, SIDE));        \
    EXPECTED(NULL_POINTER,                                                                    \
             eigenshade_color_disc_row_##format(&scene, 8, 4, 1, display, NULL, SIDE));       \
    EXPECTED(OVERLAP, eigenshade_color_disc_row_##format(                                     \
                          &scene, 8, 4, 1, display, (uint16_t *)(void *)&scene, SIDE));       \
    EXPECTED(ROW, eigenshade_color_normal_map_row_##format(&scene, &map, 1, 1, display,       \
                                                           pixels, SIDE));                    \
    EXPECTED(ROW, eigenshade_color_normal_map_row_##format(&scene, &map, 0, 1, display,       \
                                                           pixels, 0));                       \
    map.length = 3;                                                                           \
    EXPECTED(NORMAL_MAP, eigenshade_color_normal_map_row_##format(&scene, &map, 0, 1,         \
                                                                  display, pixels, SIDE));    \
    map.width = map.length = 0;                                                               \
    EXPECTED(NORMAL_MAP, eigenshade_color_normal_map_row_##format(&scene, &map, 0, 1,         \
                                                                  display, pixels, SIDE));    \
    for (size_t column = 0; column < SIDE; column++) {                                        \
      check(pixels[column] == 7, name, "the pixels are as they were", (uint32_t)column);      \
    }                                                                                         \
                                                                                              \
    eigenshade_source_f32_t sources[EIGENSHADE_SOURCES + 1];                                  \
    eigenshade_source_f32_t lamp = {{0, 0, 1}, {1, 1, 1}, 0};                                 \
    eigenshade_gloss_f32_t gloss = {0.3f, {0, 0, 0}, {1, 1, 1}, {1, 1, 1}};                   \
    eigenshade_color_glossy_##format##_t glossy = {&scene, &gloss, sources, EIGENSHADE_SOURCES}; \
    for (size_t k = 0; k <= EIGENSHADE_SOURCES; k++) {                                        \
      sources[k] = lamp;                                                                      \
    }                                                                                         \
    EXPECTED(OK, GLOSSY(format));                                                             \
    EXPECTED(OK, eigenshade_color_glossy_meter_disc_row_##format(&glossy, 1, 0, &meter));     \
    EXPECTED(OVERLAP, eigenshade_color_glossy_meter_disc_row_##format(                        \
                          &glossy, 1, 0, (eigenshade_meter_t *)(void *)sources));             \
    EXPECTED(NORMAL_MAP,                                                                      \
             eigenshade_color_glossy_meter_normal_map_row_##format(&glossy, &map, 0, &meter)); \
    check(pixels[4] != 7, name, "a glossy row", 0);                                           \
    pixels[4] = 7;                                                                            \
    glossy.count = EIGENSHADE_SOURCES + 1;                                                    \
    EXPECTED(SOURCE, GLOSSY(format));                                                         \
    EXPECTED(SOURCE, eigenshade_color_residual_##format(&eigenshade_light_lobby_f32, sources, \
                                                        glossy.count, &light_buffer, &light)); \
    glossy.count = EIGENSHADE_SOURCES;                                                        \
    sources[EIGENSHADE_SOURCES - 1].spread = 0.6f;                                            \
    EXPECTED(SOURCE, GLOSSY(format));                                                         \
    EXPECTED(SOURCE, eigenshade_color_residual_##format(&eigenshade_light_lobby_f32, sources, \
                                                        glossy.count, &light_buffer, &light)); \
    glossy.count = EIGENSHADE_SOURCES - 1;                                                    \
    gloss.albedo[1] = 2;                                                                      \
    EXPECTED(OUTSIDE, GLOSSY(format));                                                        \
    gloss.albedo[1] = 1;                                                                      \
    glossy.gloss = NULL;                                                                      \
    EXPECTED(NULL_POINTER, GLOSSY(format));                                                   \
    glossy.gloss = &gloss;                                                                    \
    glossy.scene = NULL;                                                                      \
    EXPECTED(NULL_POINTER, GLOSSY(format));                                                   \
    glossy.scene = &scene;                                                                    \
    glossy.sources = NULL;                                                                    \
    EXPECTED(NULL_POINTER, GLOSSY(format));                                                   \
    glossy.sources = sources;                                                                 \
    EXPECTED(OVERLAP, eigenshade_color_glossy_disc_row_##format(                              \
                          &glossy, 8, 4, 1, display, (uint16_t *)(void *)sources, SIDE));     \
    EXPECTED(OVERLAP, eigenshade_color_glossy_disc_row_##format(                              \
                          &glossy, 8, 4, 1, display, (uint16_t *)(void *)&gloss, SIDE));      \
    EXPECTED(OVERLAP, eigenshade_color_glossy_disc_row_##format(                              \
                          &glossy, 8, 4, 1, display, (uint16_t *)(void *)&scene, SIDE));      \
    for (size_t column = 0; column < SIDE; column++) {                                        \
      check(pixels[column] == 7, name, "the pixels are as they were", (uint32_t)column);      \
    }                                                                                         \
    EXPECTED(ROTATION, eigenshade_source_turn_f32(&lamp, zeros, &sources[0]));                \
    EXPECTED(OVERLAP, eigenshade_source_turn_f32(&lamp, zeros, &lamp));                       \
    EXPECTED(OUTSIDE, eigenshade_gloss_metallic_roughness_f32(zeros, 2, 0, &gloss));          \
    size_t fewest = 7;                                                                        \
    EXPECTED(OK, eigenshade_gloss_fewest_sources_f32(                                         \
                     &gloss, eigenshade_source_errors_lobby_f32[0], 2, 1, &fewest));          \
    check(fewest == 0, name, "none for any error", (uint32_t)fewest);                         \
    EXPECTED(OK, eigenshade_gloss_fewest_sources_f32(                                         \
                     &gloss, eigenshade_source_errors_lobby_f32[0], 2, 0, &fewest));          \
    check(fewest == 2, name, "more than two for no error", (uint32_t)fewest);                 \
    check(gloss.grazing[2] > 0.5f, name, "the gloss is as it was", 0);                        \
                                                                                              \
    EXPECTED(OK, eigenshade_color_scene_f32(&eigenshade_light_lobby_f32,                      \
                                            &eigenshade_material_gold_metallic_paint_f32,     \
                                            &to_bake));                                       \
    EXPECTED(BAKED, eigenshade_color_bake_##format(&to_bake, 1, texels, 3, &baked));          \
    EXPECTED(BAKED, eigenshade_color_bake_##format(&to_bake, BAKED, texels, 47, &baked));     \
    EXPECTED(BAKED, eigenshade_color_bake_##format(&to_bake, (size_t)-1, texels, 3, &baked)); \
    EXPECTED(OK, eigenshade_color_bake_##format(&to_bake, BAKED, texels, 48, &baked));        \
    baked.size = 5;                                                                           \
    EXPECTED(BAKED, eigenshade_color_baked_disc_row_##format(&baked, 8, 4, 1, display,        \
                                                             pixels, SIDE));                  \
  }

FAULTS(f32, float, float, float)
FAULTS(q15, int16_t, int16_t, int32_t)

void check_color_faults(void) {
  faults_f32();
  faults_q15();
}
