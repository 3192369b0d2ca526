/* The cost of each function on the board in instructions: CSV `operation,format,instructions`; of
 * those that start with `stack of`, in bytes.
 * Under QEMU's -icount shift=0 each instruction takes the same time; a loop of known length
 * calibrates the ticks of SysTick. */
#include "eigenshade_presets.h"
#include "objects.h"
#include "print.h"

#define PASSES 100u
#define SYST_CSR (*(volatile uint32_t *)0xe000e010u)
#define SYST_RVR (*(volatile uint32_t *)0xe000e014u)
#define SYST_CVR (*(volatile uint32_t *)0xe000e018u)
#define TOP 0xffffffu

/* Instructions in 1024 ticks. */
static uint32_t calibrated;

static uint32_t start(void) {
  SYST_RVR = TOP;
  SYST_CVR = 0;
  SYST_CSR = 5;
  return SYST_CVR;
}

static uint32_t since(uint32_t before) { return (before - SYST_CVR) & TOP; }

static void calibrate(void) {
  uint32_t left = 2000000u;
  const uint32_t before = start();
  __asm__ volatile("1: subs %0, #1\n\tbne 1b" : "+r"(left) : : "cc");
  calibrated = (uint32_t)(4000000ull * 1024u / since(before));
}

static void report(const char *operation, const char *format, uint32_t ticks, uint32_t each) {
  print(operation);
  print(",");
  print(format);
  print(",");
  print_u32((uint32_t)((uint64_t)ticks * calibrated / 1024u / PASSES / each));
  print("\n");
}

#define MEASURED(operation, name, each, call)                                                     \
  do {                                                                                            \
    const uint32_t before = start();                                                              \
    for (uint32_t pass = 0; pass < PASSES; pass++) {                                              \
      faults += (uint32_t)(call);                                                                 \
    }                                                                                             \
    report(operation, name, since(before), each);                                                 \
  } while (0)

/* Bytes below the caller's stack, which calls use, from the lowest. */
enum { PAINTED = 16384 };
static volatile uint8_t *below(void) {
  uint8_t *top;
  __asm__ volatile("mov %0, sp" : "=r"(top));
  return top - PAINTED;
}

#define STACK(operation, name, call)                                                              \
  do {                                                                                            \
    volatile uint8_t *const painted = below();                                                    \
    uint32_t unused = 0;                                                                          \
    for (uint32_t k = 0; k < PAINTED - 64; k++) {                                                 \
      painted[k] = 0x5a;                                                                          \
    }                                                                                             \
    faults += (uint32_t)(call);                                                                   \
    while (unused < PAINTED - 64 && painted[unused] == 0x5a) {                                    \
      unused++;                                                                                   \
    }                                                                                             \
    print("stack of " operation "," name ",");                                                    \
    print_u32(PAINTED - unused);                                                                  \
    print("\n");                                                                                  \
  } while (0)

enum { SIDE = 64, PIXELS_OF_ROW = SIDE };

enum { SIDE_OF_OBJECT = 120 };

/* A frame of the textured sphere whose frames the runtime's counts are of, row by row. */
#define TEXTURED(format, angle)                                                                   \
  static eigenshade_color_material_##format##_t parts_##format[2];                                \
  static eigenshade_transfer_##format##_t transfers_##format[2];                                  \
                                                                                                  \
  static uint32_t frame_##format(int has_transfers, const eigenshade_nodes_t *nodes,              \
                                 eigenshade_linear_palette_t *palette) {                          \
    static eigenshade_light_buffer_##format##_t buffer;                                           \
    static eigenshade_picture_##format##_t pictures[2];                                           \
    static uint16_t row[240];                                                                     \
    static const angle quaternion[4] = {1, 2, 3, 10};                                             \
    const eigenshade_display_t *const display = &eigenshade_display_filmic;                       \
    eigenshade_color_light_##format##_t light;                                                    \
    uint32_t faults = (uint32_t)eigenshade_turn_##format(&eigenshade_light_lobby_##format,        \
                                                         quaternion, &buffer, &light);            \
    for (int part = 0; part < 2; part++) {                                                        \
      faults += (uint32_t)(has_transfers                                                          \
          ? eigenshade_picture_relight_##format(&transfers_##format[part], &light,                \
                                                &pictures[part])                                  \
          : eigenshade_picture_begin_##format(&light, &parts_##format[part],                      \
                                              &pictures[part]));                                  \
    }                                                                                             \
    faults += (uint32_t)eigenshade_linear_palette_fill_##format(&pictures[0], &pictures[1],       \
                                                                1.5f, nodes, palette);            \
    for (int32_t place = 0; place < SIDE_OF_OBJECT; place++) {                                    \
      const eigenshade_target_t target = {row, sizeof row, 0, 240, 1, 0, -place,                  \
                                          EIGENSHADE_ENCODING_RGB565_HIGH_FIRST};                 \
      for (size_t k = 0; k < 240; k++) {                                                          \
        row[k] = 0;                                                                               \
      }                                                                                           \
      faults += (uint32_t)eigenshade_object_draw(&plastic, palette, 1, display, &target);         \
    }                                                                                             \
    return faults;                                                                                \
  }                                                                                               \
                                                                                                  \
  static uint32_t textured_##format(void) {                                                       \
    static eigenshade_material_buffer_##format##_t buffer;                                        \
    static eigenshade_picture_##format##_t picture;                                               \
    static eigenshade_nodes_t nodes;                                                              \
    static eigenshade_linear_palette_t palette;                                                   \
    static uint16_t row[SIDE_OF_OBJECT];                                                          \
    eigenshade_color_material_##format##_t *const parts = parts_##format;                         \
    const eigenshade_display_t *const display = &eigenshade_display_filmic;                       \
    const eigenshade_target_t target = {row, sizeof row, 0, SIDE_OF_OBJECT, 1, 0, -60, 0};        \
    const char *const name = #format;                                                             \
    uint32_t faults = 0;                                                                          \
    MEASURED("region_materials", name, 1,                                                         \
             eigenshade_region_materials_##format(&plastic, 0, &buffer, &parts[0], &parts[1]));   \
    MEASURED("nodes of object", name, 1, eigenshade_nodes_of_region(&plastic, 0, &nodes));        \
    for (int part = 0; part < 2; part++) {                                                        \
      faults += (uint32_t)eigenshade_transfer_##format(&parts[part],                              \
                                                       &transfers_##format[part]);                \
    }                                                                                             \
    faults += (uint32_t)eigenshade_picture_begin_##format(&eigenshade_light_lobby_##format,       \
                                                          &parts[0], &picture);                   \
    MEASURED("fill of linear palette", name, 1,                                                   \
             eigenshade_linear_palette_fill_##format(&picture, &picture, 1.5f, NULL,              \
                                                     &palette));                                  \
    MEASURED("row of object", name, SIDE_OF_OBJECT,                                               \
             eigenshade_object_draw(&plastic, &palette, 1, display, &target));                    \
    MEASURED("dithered row of object", name, SIDE_OF_OBJECT,                                      \
             eigenshade_object_draw_dithered(&plastic, &palette, 1, display, &target));           \
    MEASURED("frame of object", name, 1, frame_##format(0, &nodes, &palette));                    \
    MEASURED("frame with transfers", name, 1, frame_##format(1, &nodes, &palette));               \
    return faults;                                                                                \
  }

TEXTURED(f32, float)
TEXTURED(q15, int32_t)

/* An object with shadows of 96 pixels across, 4,096 codes, rank 64 and 8 images. */
#define SHADOWED(format)                                                                          \
  static uint32_t shadowed_##format(void) {                                                       \
    static eigenshade_object_coefficients_t coefficients;                                         \
    static uint16_t colors[4096], row[96];                                                        \
    const eigenshade_display_t *const display = &eigenshade_display_filmic;                       \
    const eigenshade_target_t target = {row, sizeof row, 0, 96, 1, 0, -48, 0};                    \
    const char *const name = #format;                                                             \
    uint32_t faults = 0;                                                                          \
    MEASURED("coefficients of shadows", name, 1,                                                  \
             eigenshade_shadowed_object_coefficients_##format(                                    \
                 &relief, &eigenshade_light_lobby_##format, &coefficients));                      \
    STACK("coefficients of shadows", #format,                                                     \
          eigenshade_shadowed_object_coefficients_##format(                                       \
              &relief, &eigenshade_light_lobby_##format, &coefficients));                         \
    MEASURED("colors of shadows", name, 1,                                                        \
             eigenshade_shadowed_object_colors(&relief, &coefficients, 1.5f, display, 0, colors,  \
                                               sizeof colors));                                   \
    MEASURED("row of shadows", name, 1,                                                           \
             eigenshade_shadowed_object_draw(&relief, colors, sizeof colors, &target));           \
    return faults;                                                                                \
  }

SHADOWED(f32)
SHADOWED(q15)

#define COSTS(format, angle, x, y, z, ...)                                                        \
  static uint32_t costs_##format(void) {                                                          \
    static eigenshade_workspace_##format##_t workspace;                                           \
    static eigenshade_coefficients_##format##_t d;                                                \
    static eigenshade_transfer_##format##_t transfer;                                             \
    static eigenshade_picture_##format##_t picture;                                               \
    static eigenshade_light_buffer_##format##_t buffer;                                           \
    static eigenshade_material_buffer_##format##_t material_buffer;                               \
    static eigenshade_color_light_##format##_t turned;                                            \
    static eigenshade_color_material_##format##_t masked;                                         \
    static uint16_t pixels[SIDE];                                                                 \
    static eigenshade_palette_t palette;                                                          \
    static uint8_t codes[2 * SIDE * SIDE];                                                        \
    const eigenshade_normal_map_t sphere = {SIDE, SIDE, sizeof codes, codes};                     \
    const eigenshade_target_t target = {pixels, sizeof pixels, 2 * SIDE, SIDE, 1, 0, -SIDE / 2,   \
                                        EIGENSHADE_ENCODING_RGB565};                              \
    const eigenshade_display_t *const display = &eigenshade_display_filmic;                       \
    static const angle quaternion[4] = {1, -2, 3, 4}, cosine_and_sine[2] = {__VA_ARGS__};         \
    const eigenshade_color_light_##format##_t *light = &eigenshade_light_lobby_##format;          \
    const eigenshade_color_material_##format##_t *material =                                      \
        &eigenshade_material_gold_metallic_paint_##format;                                        \
    const eigenshade_gloss_f32_t *gloss = &eigenshade_gloss_gold_metallic_paint_f32;              \
    const eigenshade_source_f32_t *sources = eigenshade_sources_lobby_f32;                      \
    eigenshade_irradiance_##format##_t irradiance;                                                \
    const char *const name = #format;                                                             \
    uint32_t faults = 0;                                                                          \
    MEASURED("project", name, 1,                                                                  \
             eigenshade_project_##format(&light->r, &material->r, &workspace, &d));               \
    MEASURED("transfer", name, 1, eigenshade_transfer_##format(material, &transfer));             \
    MEASURED("turn", name, 1, eigenshade_turn_##format(light, quaternion, &buffer, &turned));     \
    STACK("transfer", #format, eigenshade_transfer_##format(material, &transfer));                \
    STACK("turn", #format, eigenshade_turn_##format(light, quaternion, &buffer, &turned));        \
    MEASURED("turn_about_view", name, 1,                                                          \
             eigenshade_turn_about_view_##format(light, cosine_and_sine, &buffer, &turned));      \
    MEASURED("residual", name, 1,                                                                 \
             eigenshade_residual_##format(light, sources, 4, &buffer, &turned));                  \
    MEASURED("mask_light", name, 1,                                                               \
             eigenshade_mask_light_##format(light, EIGENSHADE_EFFECT_GLOSS, &buffer, &turned));   \
    MEASURED("mask_material", name, 1,                                                            \
             eigenshade_mask_material_##format(material, EIGENSHADE_EFFECT_GLOSS,                 \
                                               &material_buffer, &masked));                       \
    MEASURED("relight", name, 1,                                                                  \
             eigenshade_picture_relight_##format(&transfer, light, &picture));                    \
    MEASURED("begin", name, 1,                                                                    \
             eigenshade_picture_begin_##format(light, material, &picture));                       \
    STACK("begin", #format,                                                                       \
          eigenshade_picture_begin_##format(light, material, &picture));                          \
    MEASURED("shade", name, 1, eigenshade_picture_shade_##format(&picture, x, y, z,               \
        &irradiance));                                                                            \
    MEASURED("row", name, PIXELS_OF_ROW,                                                          \
             eigenshade_picture_draw_disc_##format(&picture, SIDE, 1.5f, display, &target));      \
    MEASURED("fill", name, 1,                                                                     \
             eigenshade_palette_fill_##format(&picture, 1.5f, display, NULL, &palette));          \
    STACK("fill", #format,                                                                        \
          eigenshade_palette_fill_##format(&picture, 1.5f, display, NULL, &palette));             \
    faults += (uint32_t)eigenshade_normal_map_sphere(SIDE, codes, sizeof codes);                  \
    MEASURED("row of palette", name, PIXELS_OF_ROW,                                               \
             eigenshade_palette_draw(&palette, &sphere, &target));                                \
    MEASURED("dithered row of palette", name, PIXELS_OF_ROW,                                      \
             eigenshade_palette_draw_dithered(&palette, &sphere, &target));                       \
    MEASURED("highlights", name, 1,                                                               \
             eigenshade_picture_highlights_##format(gloss, sources, 4, &picture));                \
    STACK("begin_glossy", #format,                                                                \
          eigenshade_picture_begin_glossy_##format(light, material, gloss, sources, 4,            \
              &picture));                                                                         \
    MEASURED("shade with sources", name, 1,                                                       \
             eigenshade_picture_shade_##format(&picture, x, y, z, &irradiance));                  \
    MEASURED("row with sources", name, PIXELS_OF_ROW,                                             \
             eigenshade_picture_draw_disc_##format(&picture, SIDE, 1.5f, display, &target));      \
    MEASURED("fill with sources", name, 1,                                                        \
             eigenshade_palette_fill_##format(&picture, 1.5f, display, NULL, &palette));          \
    return faults;                                                                                \
  }

COSTS(f32, float, 0, 0.6f, 0.8f, 0.6f, 0.8f)
COSTS(q15, int32_t, 0, 19661, 26214, 3, 4)

uint32_t program(void) {
  calibrate();
  print("operation,format,instructions\n");
  return costs_f32() + costs_q15() + textured_f32() + textured_q15() + shadowed_f32() +
         shadowed_q15();
}
