/* What the library answers to arguments at fault, and that it then leaves alone what it was
 * to write. Freestanding C99. */
#include "checks.h"
#include "eigenshade_presets.h"
#include "parts.h"

/* The header gives the size of a picture. */
typedef char size_of_f32[sizeof(eigenshade_picture_f32_t) == 8 * EIGENSHADE_PICTURE_F32 ? 1 : -1];
typedef char size_of_q15[sizeof(eigenshade_picture_q15_t) == 8 * EIGENSHADE_PICTURE_Q15 ? 1 : -1];

static const float zeros[4] = {0, 0, 0, 0};
static const eigenshade_source_f32_t lamp = {{0, 0, 1}, {1, 1, 1}, 0};
static const eigenshade_gloss_f32_t white = {0.3f, {0, 0, 0}, {1, 1, 1}, {1, 1, 1}};

/* Pictures that were never begun, and inputs of those that are begun. */
#define BEGUN(format, number, one)                                                                \
  static void begun_##format(void) {                                                              \
    static eigenshade_transfer_##format##_t transfer;                                             \
    static eigenshade_picture_##format##_t picture;                                               \
    static union {                                                                                \
      eigenshade_picture_##format##_t picture;                                                    \
      eigenshade_transfer_##format##_t transfer;                                                  \
      eigenshade_color_light_##format##_t light;                                                  \
      eigenshade_color_material_##format##_t material;                                            \
      eigenshade_source_f32_t sources[1];                                                         \
      eigenshade_gloss_f32_t gloss;                                                               \
    } same;                                                                                       \
    const eigenshade_color_light_##format##_t *const lobby = &eigenshade_light_lobby_##format;    \
    const eigenshade_color_material_##format##_t *const gold =                                    \
        &eigenshade_material_gold_metallic_paint_##format;                                        \
    eigenshade_color_light_##format##_t light = *lobby;                                           \
    eigenshade_color_material_##format##_t material = *gold;                                      \
    eigenshade_irradiance_##format##_t irradiance, before;                                        \
    const char *const name = #format;                                                             \
                                                                                                  \
    /* Zeros, or whatever was in memory. */                                                       \
    for (int byte = 0; byte < 256; byte += 85) {                                                  \
      fill(&picture, sizeof picture, (unsigned char)byte);                                        \
      EXPECTED(PICTURE, eigenshade_picture_shade_##format(&picture, 0, 0, one, &irradiance));     \
      EXPECTED(PICTURE, eigenshade_picture_highlights_##format(&white, &lamp, 1, &picture));      \
    }                                                                                             \
    EXPECTED(OK, eigenshade_picture_begin_##format(lobby, gold, &picture));                       \
    EXPECTED(OK, eigenshade_picture_shade_##format(&picture, 0, 0, one, &before));                \
    EXPECTED(OK, eigenshade_transfer_##format(gold, &transfer));                                  \
                                                                                                  \
    light.b.degree = EIGENSHADE_DEGREE + 1;                                                       \
    EXPECTED(LIGHT_BEYOND,                                                                        \
             eigenshade_picture_begin_##format(&light, gold, &picture));                          \
    EXPECTED(LIGHT_BEYOND, eigenshade_picture_relight_##format(&transfer, &light, &picture));     \
    light.b.degree = 1;                                                                           \
    EXPECTED(LIGHT_LENGTH, eigenshade_picture_relight_##format(&transfer, &light, &picture));     \
    light = *lobby;                                                                               \
    material.g.length = 39;                                                                       \
    EXPECTED(MATERIAL_LENGTH,                                                                     \
             eigenshade_picture_begin_##format(lobby, &material, &picture));                      \
    transfer.numbers[2][0] = 77;                                                                  \
    EXPECTED(MATERIAL_LENGTH, eigenshade_transfer_##format(&material, &transfer));                \
    material.g.order = (size_t)-1;                                                                \
    EXPECTED(MATERIAL_BEYOND, eigenshade_transfer_##format(&material, &transfer));                \
    check(transfer.numbers[2][0] == (number)77, name, "the transfer is as it was", 0);            \
    EXPECTED(NULL_POINTER,                                                                        \
             eigenshade_picture_begin_##format(NULL, gold, &picture));                            \
    EXPECTED(NULL_POINTER,                                                                        \
             eigenshade_picture_begin_##format(lobby, NULL, &picture));                           \
    EXPECTED(NULL_POINTER, eigenshade_picture_begin_##format(lobby, gold, NULL));                 \
    EXPECTED(NULL_POINTER,                                                                        \
             eigenshade_picture_begin_glossy_##format(lobby, gold, NULL, &lamp, 1, &picture));    \
    EXPECTED(NULL_POINTER,                                                                        \
             eigenshade_picture_begin_glossy_##format(lobby, gold, &white, NULL, 1, &picture));   \
    EXPECTED(UNALIGNED, eigenshade_picture_begin_##format(lobby, gold, BESIDE(&picture)));        \
                                                                                                  \
    /* What is written to overlaps what is read. */                                               \
    same.light = *lobby;                                                                          \
    EXPECTED(OVERLAP, eigenshade_picture_begin_##format(&same.light, gold, &same.picture));       \
    same.material = *gold;                                                                        \
    EXPECTED(OVERLAP, eigenshade_picture_begin_##format(lobby, &same.material, &same.picture));   \
    EXPECTED(OVERLAP, eigenshade_transfer_##format(&same.material, &same.transfer));              \
    same.gloss = white;                                                                           \
    EXPECTED(OVERLAP, eigenshade_picture_begin_glossy_##format(lobby, gold, &same.gloss, &lamp,   \
        1, &same.picture));                                                                       \
    same.sources[0] = lamp;                                                                       \
    EXPECTED(OVERLAP, eigenshade_picture_begin_glossy_##format(lobby, gold, &white,               \
        same.sources, 1, &same.picture));                                                         \
    EXPECTED(OVERLAP,                                                                             \
             eigenshade_picture_relight_##format(&same.transfer, lobby, &same.picture));          \
    EXPECTED(OVERLAP, eigenshade_picture_shade_##format(                                          \
                          &picture, 0, 0, one,                                                    \
                          (eigenshade_irradiance_##format##_t *)(void *)&picture));               \
                                                                                                  \
    irradiance.r = 7;                                                                             \
    EXPECTED(HIDDEN, eigenshade_picture_shade_##format(&picture, 0, 0, -(one), &irradiance));     \
    EXPECTED(NORMAL, eigenshade_picture_shade_##format(&picture, 0, 0, 0, &irradiance));          \
    check(irradiance.r == 7, name, "the irradiance is as it was", 0);                             \
    EXPECTED(OK, eigenshade_picture_shade_##format(&picture, 0, 0, one, &irradiance));            \
    check(irradiance.r == before.r, name, "the picture is as it was", 0);                         \
  }

/* Sources that are at fault, and where they are taken out. */
#define SOURCES(format)                                                                           \
  static void sources_##format(void) {                                                            \
    static eigenshade_picture_##format##_t picture;                                               \
    static eigenshade_light_buffer_##format##_t buffer;                                           \
    static eigenshade_source_f32_t sources[EIGENSHADE_SOURCES + 1];                               \
    const eigenshade_color_light_##format##_t *const lobby = &eigenshade_light_lobby_##format;    \
    const eigenshade_color_material_##format##_t *const gold =                                    \
        &eigenshade_material_gold_metallic_paint_##format;                                        \
    const size_t most = EIGENSHADE_SOURCES;                                                       \
    eigenshade_color_light_##format##_t light;                                                    \
    eigenshade_gloss_f32_t gloss = white;                                                         \
    const char *const name = #format;                                                             \
    for (size_t k = 0; k <= most; k++) {                                                          \
      sources[k] = lamp;                                                                          \
    }                                                                                             \
    EXPECTED(OK, eigenshade_picture_begin_glossy_##format(lobby, gold, &gloss, sources, most,     \
        &picture));                                                                               \
    EXPECTED(SOURCE,                                                                              \
             eigenshade_picture_begin_glossy_##format(lobby, gold, &gloss, sources, most + 1,     \
                 &picture));                                                                      \
    EXPECTED(SOURCE,                                                                              \
             eigenshade_picture_highlights_##format(&gloss, sources, most + 1, &picture));        \
    EXPECTED(SOURCE, eigenshade_residual_##format(lobby, sources, most + 1, &buffer, &light));    \
    sources[most - 1].spread = 0.6f;                                                              \
    EXPECTED(SOURCE,                                                                              \
             eigenshade_picture_begin_glossy_##format(lobby, gold, &gloss, sources, most,         \
                 &picture));                                                                      \
    EXPECTED(SOURCE, eigenshade_residual_##format(lobby, sources, most, &buffer, &light));        \
    gloss.albedo[1] = 2;                                                                          \
    EXPECTED(OUTSIDE,                                                                             \
             eigenshade_picture_begin_glossy_##format(lobby, gold, &gloss, sources, 1,            \
                 &picture));                                                                      \
    EXPECTED(OVERLAP,                                                                             \
             eigenshade_picture_highlights_##format(                                              \
                 &white, (const eigenshade_source_f32_t *)(const void *)&picture, 1, &picture));  \
  }

/* Lights and materials that are turned or computed. */
#define INPUTS(format, number, angle)                                                             \
  static void inputs_##format(void) {                                                             \
    static eigenshade_light_buffer_##format##_t light_buffer;                                     \
    static eigenshade_material_buffer_##format##_t material_buffer;                               \
    static eigenshade_workspace_##format##_t workspace;                                           \
    static union {                                                                                \
      eigenshade_workspace_##format##_t workspace;                                                \
      eigenshade_coefficients_##format##_t d;                                                     \
      eigenshade_light_##format##_t light;                                                        \
    } same;                                                                                       \
    static eigenshade_coefficients_##format##_t d;                                                \
    static const angle none[4] = {0, 0, 0, 0};                                                    \
    static const number black[3] = {0, 0, 0}, outside[3] = {0, (number)-1, 0};                    \
    const eigenshade_color_light_##format##_t *const lobby = &eigenshade_light_lobby_##format;    \
    const eigenshade_material_##format##_t *const gold =                                          \
        &eigenshade_material_gold_metallic_paint_##format.r;                                      \
    eigenshade_color_light_##format##_t light, masked_light;                                      \
    eigenshade_color_material_##format##_t material, masked;                                      \
    const char *const name = #format;                                                             \
    EXPECTED(ROTATION, eigenshade_turn_##format(lobby, none, &light_buffer, &light));             \
    EXPECTED(ROTATION, eigenshade_turn_about_view_##format(lobby, none, &light_buffer, &light));  \
    light = *lobby;                                                                               \
    EXPECTED(OVERLAP, eigenshade_turn_##format(&light, none, &light_buffer, &light));             \
    EXPECTED(OUTSIDE, eigenshade_metallic_roughness_##format(outside, 0, 0, &material_buffer,     \
                                                             &material));                         \
    EXPECTED(OUTSIDE, eigenshade_metallic_roughness_##format(black, (number)-1, 0,                \
                                                             &material_buffer, &material));       \
    EXPECTED(OUTSIDE, eigenshade_metallic_roughness_##format(black, 0, (number)-1,                \
                                                             &material_buffer, &material));       \
    EXPECTED(EFFECT, eigenshade_mask_light_##format(lobby, -1, &light_buffer, &light));           \
    EXPECTED(EFFECT, eigenshade_mask_light_##format(lobby, 4, &light_buffer, &light));            \
    EXPECTED(NULL_POINTER, eigenshade_mask_light_##format(NULL, 1, &light_buffer, &light));       \
    EXPECTED(NULL_POINTER, eigenshade_mask_light_##format(lobby, 1, NULL, &light));               \
    EXPECTED(NULL_POINTER, eigenshade_mask_light_##format(lobby, 1, &light_buffer, NULL));        \
    light = *lobby;                                                                               \
    EXPECTED(OVERLAP, eigenshade_mask_light_##format(&light, 1, &light_buffer, &light));          \
    light.g.length = 9;                                                                           \
    EXPECTED(LIGHT_LENGTH,                                                                        \
             eigenshade_mask_light_##format(&light, 1, &light_buffer, &masked_light));            \
    material = eigenshade_material_gold_metallic_paint_##format;                                  \
    EXPECTED(EFFECT, eigenshade_mask_material_##format(&material, 4, &material_buffer, &masked)); \
    EXPECTED(NULL_POINTER, eigenshade_mask_material_##format(NULL, 1, &material_buffer, &masked));\
    EXPECTED(NULL_POINTER, eigenshade_mask_material_##format(&material, 1, NULL, &masked));       \
    EXPECTED(NULL_POINTER,                                                                        \
             eigenshade_mask_material_##format(&material, 1, &material_buffer, NULL));            \
    EXPECTED(OVERLAP,                                                                             \
             eigenshade_mask_material_##format(&material, 1, &material_buffer, &material));       \
    material.b.length = 5;                                                                        \
    EXPECTED(MATERIAL_LENGTH,                                                                     \
             eigenshade_mask_material_##format(&material, 1, &material_buffer, &masked));         \
    EXPECTED(NULL_POINTER, eigenshade_project_##format(NULL, gold, &workspace, &d));              \
    EXPECTED(NULL_POINTER, eigenshade_project_##format(&lobby->r, NULL, &workspace, &d));         \
    EXPECTED(NULL_POINTER, eigenshade_project_##format(&lobby->r, gold, NULL, &d));               \
    EXPECTED(NULL_POINTER, eigenshade_project_##format(&lobby->r, gold, &workspace, NULL));       \
    EXPECTED(OVERLAP, eigenshade_project_##format(&lobby->r, gold, &same.workspace, &same.d));    \
    same.light = lobby->r;                                                                        \
    EXPECTED(OVERLAP, eigenshade_project_##format(&same.light, gold, &workspace, &same.d));       \
  }

/* What each format has for itself. */
static void others_f32(void) {
  const char *const name = "f32";
  static eigenshade_picture_f32_t picture;
  static eigenshade_transfer_f32_t transfer;
  static const float endless[1] = {__builtin_inff()};
  const eigenshade_light_f32_t bright = {0, 1, endless};
  const eigenshade_material_f32_t white_matte = {0, 1, endless};
  const eigenshade_color_light_f32_t light = {bright, bright, bright};
  const eigenshade_color_material_f32_t material = {white_matte, white_matte, white_matte};
  EXPECTED(NOT_FINITE, eigenshade_transfer_f32(&material, &transfer));
  EXPECTED(NOT_FINITE, eigenshade_picture_relight_f32(&transfer, &light, &picture));
  eigenshade_source_f32_t turned = lamp;
  eigenshade_gloss_f32_t gloss = white;
  EXPECTED(ROTATION, eigenshade_source_turn_f32(&lamp, zeros, &turned));
  EXPECTED(OVERLAP, eigenshade_source_turn_f32(&turned, zeros, &turned));
  EXPECTED(OUTSIDE, eigenshade_gloss_metallic_roughness_f32(zeros, 2, 0, &gloss));
  check(gloss.grazing[2] > 0.5f, name, "the gloss is as it was", 0);
}

static void others_q15(void) {
  const char *const name = "q15";
  static eigenshade_picture_q15_t picture;
  static eigenshade_transfer_q15_t transfer;
  static eigenshade_light_buffer_q15_t buffer;
  static const float endless[1] = {__builtin_inff()};
  const eigenshade_light_f32_t bright = {0, 1, endless};
  const eigenshade_color_light_f32_t endless_light = {bright, bright, bright};
  eigenshade_color_light_q15_t light = eigenshade_light_lobby_q15;
  eigenshade_color_material_q15_t material = eigenshade_material_gold_metallic_paint_q15;
  eigenshade_irradiance_q15_t irradiance;
  EXPECTED(NOT_FINITE, eigenshade_quantize_light_q15(&endless_light, &buffer, &light));
  light = eigenshade_light_lobby_q15;
  EXPECTED(NULL_POINTER, eigenshade_quantize_light_q15(&eigenshade_light_lobby_f32, NULL, &light));
  material.r.exponents = NULL;
  EXPECTED(NULL_POINTER, eigenshade_transfer_q15(&material, &transfer));
  material.r.exponents_length = 2;
  EXPECTED(MATERIAL_LENGTH, eigenshade_transfer_q15(&material, &transfer));
  light.g.exponent = 129;
  EXPECTED(EXPONENT, eigenshade_picture_relight_q15(&transfer, &light, &picture));
  /* A transfer that could overflow leaves no picture. */
  EXPECTED(OK, eigenshade_transfer_q15(&eigenshade_material_gold_metallic_paint_q15, &transfer));
  for (size_t k = 0; k < EIGENSHADE_TRANSFER_Q15; k++) {
    transfer.numbers[2][k] = INT16_MAX;
  }
  light = eigenshade_light_lobby_q15;
  EXPECTED(TRANSFER, eigenshade_picture_relight_q15(&transfer, &light, &picture));
  EXPECTED(PICTURE, eigenshade_picture_shade_q15(&picture, 0, 0, INT16_MAX, &irradiance));
  /* Of a map of 8 bits. */
  const int32_t behind[3] = {255, 1, -1}, away[3] = {1, 1, -255};
  int16_t normal[3] = {7, 7, 7};
  EXPECTED(HIDDEN, eigenshade_normalize_q15(away, normal));
  check(normal[0] == 7 && normal[2] == 7, name, "normal is as it was", 0);
  EXPECTED(OK, eigenshade_normalize_q15(behind, normal));
  check(normal[0] > 32734 && normal[1] > 0 && normal[2] == 0, name, "rim", 0);
  EXPECTED(OK, eigenshade_picture_begin_q15(&light,
      &eigenshade_material_gold_metallic_paint_q15, &picture));
  EXPECTED(OK, eigenshade_picture_shade_q15(&picture, normal[0], normal[1], normal[2],
                                            &irradiance));
}

BEGUN(f32, float, 1.0f)
BEGUN(q15, int16_t, INT16_MAX)
SOURCES(f32)
SOURCES(q15)
INPUTS(f32, float, float)
INPUTS(q15, int16_t, int32_t)

void check_faults(void) {
  begun_f32();
  begun_q15();
  sources_f32();
  sources_q15();
  inputs_f32();
  inputs_q15();
  others_f32();
  others_q15();
  check(eigenshade_message(EIGENSHADE_STATUS_OK) != eigenshade_message(-1), "any", "message", 0);
}
