/* The cost of each function on the board in instructions: CSV `operation,format,instructions`; of
 * `stack of color_scene` in bytes.
 * Under QEMU's -icount shift=0 each instruction takes the same time; a loop of known length
 * calibrates the ticks of SysTick. */
#include "eigenshade_presets.h"
#include "golden.h"
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

#define MEASURED(operation, name, each, call)                                                 \
  do {                                                                                        \
    const uint32_t before = start();                                                          \
    for (uint32_t pass = 0; pass < PASSES; pass++) {                                          \
      faults += (uint32_t)(call);                                                             \
    }                                                                                         \
    report(operation, name, since(before), each);                                             \
  } while (0)

/* Bytes below the caller's stack, which calls use, from the lowest. */
enum { PAINTED = 16384 };
static volatile uint8_t *below(void) {
  uint8_t *top;
  __asm__ volatile("mov %0, sp" : "=r"(top));
  return top - PAINTED;
}

#define STACK(operation, name, call)                                                          \
  do {                                                                                        \
    volatile uint8_t *const painted = below();                                                \
    uint32_t unused = 0;                                                                      \
    for (uint32_t k = 0; k < PAINTED - 64; k++) {                                             \
      painted[k] = 0x5a;                                                                      \
    }                                                                                         \
    faults += (uint32_t)(call);                                                               \
    while (unused < PAINTED - 64 && painted[unused] == 0x5a) {                                \
      unused++;                                                                               \
    }                                                                                         \
    print("stack of " operation "," name ",");                                                \
    print_u32(PAINTED - unused);                                                              \
    print("\n");                                                                              \
  } while (0)

#define COSTS(FORMAT, format, name, answer)                                                   \
  static uint32_t costs_##format(void) {                                                      \
    static eigenshade_workspace_##format##_t workspace;                                       \
    static eigenshade_transfer_##format##_t transfer;                                         \
    static eigenshade_coefficients_##format##_t d;                                            \
    static eigenshade_scene_##format##_t scene;                                               \
    static answer irradiance[GOLDEN_NORMALS_##FORMAT];                                        \
    const eigenshade_light_##format##_t light = LIGHT_##FORMAT;                               \
    const eigenshade_material_##format##_t material = MATERIAL_##FORMAT;                      \
    uint32_t faults = 0;                                                                      \
    MEASURED("transfer", name, 1, eigenshade_transfer_##format(&material, &workspace, &transfer)); \
    MEASURED("relight", name, 1, eigenshade_relight_##format(&transfer, &light, &d));         \
    MEASURED("collapse", name, 1,                                                             \
             eigenshade_collapse_##format(&d, EIGENSHADE_COMPONENTS, &scene));                \
    MEASURED("shade", name, 1,                                                                \
             eigenshade_shade_##format(&scene, golden_x_##format[3], golden_y_##format[3],    \
                                       golden_z_##format[3], irradiance));                    \
    MEASURED("shade_many", name, 16,                                                          \
             eigenshade_shade_many_##format(&scene, 16, golden_x_##format, golden_y_##format, \
                                            golden_z_##format, irradiance));                  \
    return faults;                                                                            \
  }

#define LIGHT_F32 {EIGENSHADE_DEGREE, EIGENSHADE_LIGHT, golden_light_f32[0]}
#define LIGHT_OF_INTEGERS(format)                                                             \
  {EIGENSHADE_DEGREE, EIGENSHADE_LIGHT, golden_light_##format[0],                             \
   golden_light_exponents_##format[0][0]}
#define LIGHT_Q15 LIGHT_OF_INTEGERS(q15)
#define MATERIAL_F32 {EIGENSHADE_ORDER, EIGENSHADE_MATERIAL, golden_material_f32[0]}
#define MATERIAL_OF_INTEGERS(format)                                                          \
  {EIGENSHADE_ORDER, EIGENSHADE_MATERIAL, golden_material_##format[0], EIGENSHADE_ORDER + 1,  \
   golden_material_exponents_##format[0]}
#define MATERIAL_Q15 MATERIAL_OF_INTEGERS(q15)

COSTS(F32, f32, "f32", float)
COSTS(Q15, q15, "q15", int32_t)

/* In color. */
enum { SIDE = 64, PIXELS_OF_ROW = SIDE };

#define COSTS_IN_COLOR(format, name, angle, ...)                                              \
  static uint32_t costs_in_color_##format(void) {                                             \
    static eigenshade_color_transfer_##format##_t transfer;                                   \
    static eigenshade_color_scene_##format##_t scene;                                         \
    static eigenshade_color_light_buffer_##format##_t buffer;                                 \
    static eigenshade_color_light_##format##_t turned;                                        \
    static uint16_t pixels[SIDE];                                                             \
    static const angle quaternion[4] = {1, -2, 3, 4}, cosine_and_sine[2] = {__VA_ARGS__};     \
    const eigenshade_color_light_##format##_t *light = &eigenshade_light_lobby_##format;      \
    const eigenshade_color_material_##format##_t *material =                                  \
        &eigenshade_material_gold_metallic_paint_##format;                                    \
    uint32_t faults = 0;                                                                      \
    MEASURED("color_transfer", name, 1,                                                       \
             eigenshade_color_transfer_##format(material, &transfer));                        \
    MEASURED("color_relight", name, 1,                                                        \
             eigenshade_color_relight_##format(&transfer, light, &scene));                    \
    MEASURED("color_scene", name, 1, eigenshade_color_scene_##format(light, material, &scene)); \
    STACK("color_scene", name, eigenshade_color_scene_##format(light, material, &scene));     \
    MEASURED("color_turn", name, 1,                                                           \
             eigenshade_color_turn_##format(light, quaternion, &buffer, &turned));            \
    MEASURED("color_turn_about_view", name, 1,                                                \
             eigenshade_color_turn_about_view_##format(light, cosine_and_sine, &buffer,       \
                                                       &turned));                             \
    MEASURED("color_disc_row", name, PIXELS_OF_ROW,                                           \
             eigenshade_color_disc_row_##format(&scene, SIDE, SIDE / 2, 1.5f,                 \
                                                &eigenshade_display_filmic, pixels, SIDE));   \
    return faults;                                                                            \
  }

COSTS_IN_COLOR(f32, "f32", float, 0.6f, 0.8f)
COSTS_IN_COLOR(q15, "q15", int32_t, 3, 4)

uint32_t program(void) {
  calibrate();
  print("operation,format,instructions\n");
  return costs_f32() + costs_q15() + costs_in_color_f32() +
         costs_in_color_q15();
}
