/* A program that shades one image in one format, FORMAT (f32, q15), to measure its size.
 * WAY 0 computes the transfer on the board; WAY 1 has it in flash; 2 and 3 do the same in color,
 * to a row of RGB565. Without FORMAT the program is empty, for comparison. */
#include "eigenshade_presets.h"
#include "print.h"

#ifdef FORMAT

#define JOINED(a, b) a##b
#define NAME(a, b) JOINED(a, b)
#define MY(name) NAME(NAME(eigenshade_, name), FORMAT)
#define TYPE(name) NAME(MY(name), _t)

#if WAY >= 2

enum { SIDE = 240 };

static TYPE(color_scene_) scene;
static uint16_t row_of_pixels[SIDE];
volatile uint16_t drawn;
#define PRESET(kind, name) NAME(eigenshade_##kind##_##name##_, FORMAT)
#if WAY == 3
static const TYPE(color_transfer_) transfer = {.r = {.numbers = {1}}};
#endif

uint32_t program(void) {
#if WAY == 2
  eigenshade_status status =
      MY(color_scene_)(&PRESET(light, lobby), &PRESET(material, gold_metallic_paint), &scene);
#else
  eigenshade_status status = MY(color_relight_)(&transfer, &PRESET(light, lobby), &scene);
#endif
  for (size_t row = 0; !status && row < SIDE; row++) {
    status = MY(color_disc_row_)(&scene, SIDE, row, 1.5f, &eigenshade_display_filmic,
                                 row_of_pixels, SIDE);
    drawn = row_of_pixels[SIDE / 2];
  }
  return (uint32_t)status;
}

#else

#if IS_FLOAT
typedef float number, irradiance;
#define NUMBERS coefficients
#else
typedef MANTISSA number;
typedef int32_t irradiance;
#define NUMBERS mantissas
#endif

/* Not constants: a compiler may not see through them. */
static number light_numbers[EIGENSHADE_LIGHT];
static TYPE(coefficients_) d;
static TYPE(scene_) scene;
volatile irradiance shaded;

#if WAY == 0
static number material_numbers[EIGENSHADE_MATERIAL];
static TYPE(workspace_) workspace;
static TYPE(transfer_) transfer;
#if !IS_FLOAT
static int8_t exponents[EIGENSHADE_ORDER + 1];
#endif
#else
static const TYPE(transfer_) transfer = {.numbers = {1}};
#endif

uint32_t program(void) {
  TYPE(light_) light = {.degree = EIGENSHADE_DEGREE, .length = EIGENSHADE_LIGHT,
                      .NUMBERS = light_numbers};
  irradiance found = 0;
  eigenshade_status status = EIGENSHADE_STATUS_OK;
#if WAY == 0
  TYPE(material_) material = {.order = EIGENSHADE_ORDER, .length = EIGENSHADE_MATERIAL,
                            .NUMBERS = material_numbers};
#if !IS_FLOAT
  material.exponents = exponents;
  material.exponents_length = EIGENSHADE_ORDER + 1;
#endif
  status |= MY(transfer_)(&material, &workspace, &transfer);
#endif
  status |= MY(relight_)(&transfer, &light, &d);
  status |= MY(collapse_)(&d, EIGENSHADE_COMPONENTS, &scene);
#if IS_FLOAT
  status |= MY(shade_)(&scene, 0.0f, 0.0f, 1.0f, &found);
#else
  status |= MY(shade_)(&scene, 0, 0, (number)((1u << (8 * sizeof(number) - 1)) - 1), &found);
#endif
  shaded = found;
  return (uint32_t)status;
}

#endif

#else

uint32_t program(void) { return 0; }

#endif
