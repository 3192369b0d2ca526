/* The golden vectors, which are gray, through all steps in every format. Integers have to be the
 * same bits; floats are allowed the golden file's tolerance. Freestanding C99. */
#include "checks.h"
#include "eigenshade.h"
#include "golden.h"
#include "parts.h"

#define CHECKED(call) check_status(call, EIGENSHADE_STATUS_OK, name, #call)

static int same(const int32_t *a, const int32_t *b, size_t count) {
  for (size_t k = 0; k < count; k++) {
    if (a[k] != b[k]) {
      return 0;
    }
  }
  return 1;
}

static float size_of(float number) { return number < 0.0f ? -number : number; }

/* Whether both are the same to the tolerance times the largest. */
static int near(const float *found, const float *golden, size_t count) {
  float largest = 0.0f;
  for (size_t k = 0; k < count; k++) {
    if (size_of(golden[k]) > largest) {
      largest = size_of(golden[k]);
    }
  }
  for (size_t k = 0; k < count; k++) {
    /* Written so that NaN fails. */
    if (!(size_of(found[k] - golden[k]) <= golden_tolerance[0] * largest)) {
      return 0;
    }
  }
  return 1;
}

/* The largest arrays are static: a board's stack is small. */
static void shades_f32(const eigenshade_picture_f32_t *picture, const float *golden,
                       const char *step, uint32_t pair) {
  static float found[3][GOLDEN_NORMALS_F32];
  const char *const name = "f32";
  for (size_t k = 0; k < GOLDEN_NORMALS_F32; k++) {
    eigenshade_irradiance_f32_t one = {0, 0, 0};
    CHECKED(eigenshade_picture_shade_f32(picture, golden_x_f32[k], golden_y_f32[k],
                                         golden_z_f32[k], &one));
    found[0][k] = one.r;
    found[1][k] = one.g;
    found[2][k] = one.b;
  }
  for (size_t channel = 0; channel < 3; channel++) {
    check(near(found[channel], golden, GOLDEN_NORMALS_F32), name, step, pair);
  }
}

static void checks_f32(void) {
  static eigenshade_workspace_f32_t workspace;
  static eigenshade_coefficients_f32_t d;
  static eigenshade_transfer_f32_t transfer;
  static eigenshade_picture_f32_t picture;
  const char *const name = "f32";
  for (uint32_t pair = 0; pair < GOLDEN_PAIRS; pair++) {
    const eigenshade_light_f32_t light = {EIGENSHADE_DEGREE, EIGENSHADE_LIGHT,
                                          golden_light_f32[pair]};
    const eigenshade_material_f32_t material = {EIGENSHADE_ORDER, EIGENSHADE_MATERIAL,
                                                golden_material_f32[pair]};
    const eigenshade_color_light_f32_t white = {light, light, light};
    const eigenshade_color_material_f32_t gray = {material, material, material};
    const float *golden = golden_irradiance_f32[pair];
    CHECKED(eigenshade_project_f32(&light, &material, &workspace, &d));
    check(near(d.numbers, golden_d_f32[pair], EIGENSHADE_COMPONENTS), name, "project", pair);
    CHECKED(eigenshade_picture_begin_f32(&white, &gray, &picture));
    shades_f32(&picture, golden, "begin", pair);
    CHECKED(eigenshade_transfer_f32(&gray, &transfer));
    CHECKED(eigenshade_picture_relight_f32(&transfer, &white, &picture));
    shades_f32(&picture, golden, "relight", pair);
  }
}

static void shades_q15(const eigenshade_picture_q15_t *picture, uint32_t pair, const char *step) {
  static int32_t found[3][GOLDEN_NORMALS_Q15];
  const char *const name = "q15";
  for (size_t k = 0; k < GOLDEN_NORMALS_Q15; k++) {
    eigenshade_irradiance_q15_t one = {0, 0, 0, {0, 0, 0}};
    CHECKED(eigenshade_picture_shade_q15(picture, golden_x_q15[k], golden_y_q15[k],
                                         golden_z_q15[k], &one));
    found[0][k] = one.r;
    found[1][k] = one.g;
    found[2][k] = one.b;
    for (size_t channel = 0; channel < 3; channel++) {
      check(one.exponents[channel] == golden_irradiance_exponents_q15[pair][0], name, "exponent",
            pair);
    }
  }
  for (size_t channel = 0; channel < 3; channel++) {
    check(same(found[channel], golden_irradiance_q15[pair], GOLDEN_NORMALS_Q15), name, step,
          pair);
  }
}

static int same_light(const eigenshade_light_q15_t *a, const eigenshade_light_q15_t *b) {
  for (size_t k = 0; k < EIGENSHADE_LIGHT; k++) {
    if (a->mantissas[k] != b->mantissas[k]) {
      return 0;
    }
  }
  return a->degree == b->degree && a->length == b->length && a->exponent == b->exponent;
}

static int same_material(const eigenshade_material_q15_t *a, const eigenshade_material_q15_t *b) {
  for (size_t k = 0; k < EIGENSHADE_MATERIAL; k++) {
    if (a->mantissas[k] != b->mantissas[k]) {
      return 0;
    }
  }
  for (size_t o = 0; o <= EIGENSHADE_ORDER; o++) {
    if (a->exponents[o] != b->exponents[o]) {
      return 0;
    }
  }
  return a->order == b->order && a->length == b->length &&
         a->exponents_length == b->exponents_length;
}

/* What is quantized in a program is what the golden file has. */
static void check_quantized(uint32_t pair, const eigenshade_light_q15_t *light,
                            const eigenshade_material_q15_t *material) {
  static eigenshade_light_buffer_q15_t light_buffer;
  static eigenshade_material_buffer_q15_t material_buffer;
  const eigenshade_light_f32_t of_light = {EIGENSHADE_DEGREE, EIGENSHADE_LIGHT,
                                           golden_light_f32[pair]};
  const eigenshade_material_f32_t of_material = {EIGENSHADE_ORDER, EIGENSHADE_MATERIAL,
                                                 golden_material_f32[pair]};
  const eigenshade_color_light_f32_t white = {of_light, of_light, of_light};
  const eigenshade_color_material_f32_t gray = {of_material, of_material, of_material};
  const char *const name = "q15";
  eigenshade_color_light_q15_t own_light;
  eigenshade_color_material_q15_t own_material;
  CHECKED(eigenshade_quantize_light_q15(&white, &light_buffer, &own_light));
  check(same_light(&own_light.r, light) && same_light(&own_light.g, light) &&
            same_light(&own_light.b, light),
        name, "quantize_light", pair);
  CHECKED(eigenshade_quantize_material_q15(&gray, &material_buffer, &own_material));
  check(same_material(&own_material.r, material) && same_material(&own_material.g, material) &&
            same_material(&own_material.b, material),
        name, "quantize_material", pair);
}

static void checks_q15(void) {
  static eigenshade_workspace_q15_t workspace;
  static eigenshade_coefficients_q15_t d;
  static eigenshade_transfer_q15_t transfer;
  static eigenshade_picture_q15_t picture;
  const char *const name = "q15";
  for (uint32_t pair = 0; pair < GOLDEN_PAIRS; pair++) {
    const eigenshade_light_q15_t light = {EIGENSHADE_DEGREE, EIGENSHADE_LIGHT,
                                          golden_light_q15[pair],
                                          golden_light_exponents_q15[pair][0]};
    const eigenshade_material_q15_t material = {EIGENSHADE_ORDER, EIGENSHADE_MATERIAL,
                                                golden_material_q15[pair], EIGENSHADE_ORDER + 1,
                                                golden_material_exponents_q15[pair]};
    const eigenshade_color_light_q15_t white = {light, light, light};
    const eigenshade_color_material_q15_t gray = {material, material, material};
    check_quantized(pair, &light, &material);
    CHECKED(eigenshade_project_q15(&light, &material, &workspace, &d));
    check(same(d.mantissas, golden_d_q15[pair], EIGENSHADE_COMPONENTS) &&
              d.exponent == golden_d_exponents_q15[pair][0],
          name, "project", pair);
    CHECKED(eigenshade_picture_begin_q15(&white, &gray, &picture));
    shades_q15(&picture, pair, "begin");
    CHECKED(eigenshade_transfer_q15(&gray, &transfer));
    CHECKED(eigenshade_picture_relight_q15(&transfer, &white, &picture));
    shades_q15(&picture, pair, "relight");
  }
}

void check_golden_vectors(void) {
  checks_f32();
  checks_q15();
}
