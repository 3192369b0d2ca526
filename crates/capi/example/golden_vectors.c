/* The golden vectors through every function of one channel, in every format. Integers have to
 * be the same bits; floats are allowed the golden file's tolerance. Freestanding C99. */
#include "checks.h"
#include "golden.h"
#include "parts.h"

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
static void checks_f32(void) {
  static eigenshade_workspace_f32_t workspace;
  static eigenshade_transfer_f32_t transfer;
  static eigenshade_coefficients_f32_t d;
  static eigenshade_scene_f32_t scene;
  float irradiance[GOLDEN_NORMALS_F32];
  for (uint32_t pair = 0; pair < GOLDEN_PAIRS; pair++) {
    const eigenshade_light_f32_t light = {
        .degree = EIGENSHADE_DEGREE,
        .length = EIGENSHADE_LIGHT,
        .coefficients = golden_light_f32[pair],
    };
    const eigenshade_material_f32_t material = {
        .order = EIGENSHADE_ORDER,
        .length = EIGENSHADE_MATERIAL,
        .coefficients = golden_material_f32[pair],
    };
    const float *golden = golden_irradiance_f32[pair];
    check_status(eigenshade_project_f32(&light, &material, &workspace, &d),
                 EIGENSHADE_STATUS_OK, "f32", "project");
    check(near(d.numbers, golden_d_f32[pair], EIGENSHADE_COMPONENTS), "f32", "project", pair);

    check_status(eigenshade_transfer_f32(&material, &workspace, &transfer), EIGENSHADE_STATUS_OK,
                 "f32", "transfer");
    check_status(eigenshade_relight_f32(&transfer, &light, &d), EIGENSHADE_STATUS_OK, "f32",
                 "relight");
    check(near(d.numbers, golden_d_f32[pair], EIGENSHADE_COMPONENTS), "f32", "relight", pair);

    check_status(eigenshade_collapse_f32(&d, EIGENSHADE_COMPONENTS, &scene),
                 EIGENSHADE_STATUS_OK, "f32", "collapse");
    check_status(eigenshade_shade_many_f32(&scene, GOLDEN_NORMALS_F32, golden_x_f32,
                                           golden_y_f32, golden_z_f32, irradiance),
                 EIGENSHADE_STATUS_OK, "f32", "shade_many");
    check(near(irradiance, golden, GOLDEN_NORMALS_F32), "f32", "shade_many", pair);

    for (size_t k = 0; k < GOLDEN_NORMALS_F32; k++) {
      irradiance[k] = 0.0f;
      check_status(eigenshade_shade_f32(&scene, golden_x_f32[k], golden_y_f32[k],
                                        golden_z_f32[k], &irradiance[k]),
                   EIGENSHADE_STATUS_OK, "f32", "shade");
    }
    check(near(irradiance, golden, GOLDEN_NORMALS_F32), "f32", "shade", pair);
  }
}

/* The same in integers. */
#define CHECKS_OF_INTEGERS(FORMAT, format, name, mantissa)                                    \
  static int same_light_##format(const eigenshade_light_##format##_t *a,                      \
                                 const eigenshade_light_##format##_t *b) {                    \
    for (size_t k = 0; k < EIGENSHADE_LIGHT; k++) {                                           \
      if (a->mantissas[k] != b->mantissas[k]) {                                               \
        return 0;                                                                             \
      }                                                                                       \
    }                                                                                         \
    return a->degree == b->degree && a->length == b->length && a->exponent == b->exponent;    \
  }                                                                                           \
  static int same_material_##format(const eigenshade_material_##format##_t *a,                \
                                    const eigenshade_material_##format##_t *b) {              \
    for (size_t k = 0; k < EIGENSHADE_MATERIAL; k++) {                                        \
      if (a->mantissas[k] != b->mantissas[k]) {                                               \
        return 0;                                                                             \
      }                                                                                       \
    }                                                                                         \
    for (size_t o = 0; o <= EIGENSHADE_ORDER; o++) {                                          \
      if (a->exponents[o] != b->exponents[o]) {                                               \
        return 0;                                                                             \
      }                                                                                       \
    }                                                                                         \
    return a->order == b->order && a->length == b->length &&                                  \
           a->exponents_length == b->exponents_length;                                        \
  }                                                                                           \
  static void checks_##format(void) {                                                         \
    static eigenshade_workspace_##format##_t workspace;                                       \
    static eigenshade_transfer_##format##_t transfer;                                         \
    static eigenshade_coefficients_##format##_t d;                                            \
    static eigenshade_scene_##format##_t scene;                                               \
    int32_t irradiance[GOLDEN_NORMALS_##FORMAT];                                              \
    for (uint32_t pair = 0; pair < GOLDEN_PAIRS; pair++) {                                    \
      const eigenshade_light_##format##_t light = {                                           \
          .degree = EIGENSHADE_DEGREE,                                                        \
          .length = EIGENSHADE_LIGHT,                                                         \
          .mantissas = golden_light_##format[pair],                                           \
          .exponent = golden_light_exponents_##format[pair][0],                               \
      };                                                                                      \
      const eigenshade_material_##format##_t material = {                                     \
          .order = EIGENSHADE_ORDER,                                                          \
          .length = EIGENSHADE_MATERIAL,                                                      \
          .mantissas = golden_material_##format[pair],                                        \
          .exponents_length = EIGENSHADE_ORDER + 1,                                           \
          .exponents = golden_material_exponents_##format[pair],                              \
      };                                                                                      \
      const eigenshade_light_f32_t light_in_floats = {                                        \
          EIGENSHADE_DEGREE, EIGENSHADE_LIGHT, golden_light_f32[pair]};                       \
      const eigenshade_material_f32_t material_in_floats = {                                  \
          EIGENSHADE_ORDER, EIGENSHADE_MATERIAL, golden_material_f32[pair]};                  \
      static mantissa numbers[EIGENSHADE_LIGHT];                                              \
      int8_t exponents[EIGENSHADE_ORDER + 1];                                                 \
      eigenshade_light_##format##_t own_light;                                                \
      eigenshade_material_##format##_t own_material;                                          \
      check_status(eigenshade_quantize_light_##format(&light_in_floats, numbers,              \
                                                      EIGENSHADE_LIGHT, &own_light),          \
                   EIGENSHADE_STATUS_OK, name, "quantize_light");                             \
      check(same_light_##format(&own_light, &light), name, "quantize_light", pair);           \
      check_status(eigenshade_quantize_material_##format(                                     \
                       &material_in_floats, numbers, EIGENSHADE_MATERIAL, exponents,          \
                       EIGENSHADE_ORDER + 1, &own_material),                                  \
                   EIGENSHADE_STATUS_OK, name, "quantize_material");                          \
      check(same_material_##format(&own_material, &material), name, "quantize_material",      \
            pair);                                                                            \
      const int32_t *golden_d = golden_d_##format[pair];                                      \
      const int32_t of_d = golden_d_exponents_##format[pair][0];                              \
      const int32_t *golden = golden_irradiance_##format[pair];                               \
      check_status(eigenshade_transfer_##format(&material, &workspace, &transfer),            \
                   EIGENSHADE_STATUS_OK, name, "transfer");                                   \
      check_status(eigenshade_relight_##format(&transfer, &light, &d), EIGENSHADE_STATUS_OK,  \
                   name, "relight");                                                          \
      check(same(d.mantissas, golden_d, EIGENSHADE_COMPONENTS) && d.exponent == of_d, name,   \
            "relight", pair);                                                                 \
      d.exponent = 0;                                                                         \
      check_status(                                                                           \
          eigenshade_project_##format(&light, &material, &workspace, &transfer, &d),          \
          EIGENSHADE_STATUS_OK, name, "project");                                             \
      check(same(d.mantissas, golden_d, EIGENSHADE_COMPONENTS) && d.exponent == of_d, name,   \
            "project", pair);                                                                 \
      check_status(eigenshade_collapse_##format(&d, EIGENSHADE_COMPONENTS, &scene),           \
                   EIGENSHADE_STATUS_OK, name, "collapse");                                   \
      check(scene.exponent == golden_irradiance_exponents_##format[pair][0], name,            \
            "collapse", pair);                                                                \
      check_status(eigenshade_shade_many_##format(&scene, GOLDEN_NORMALS_##FORMAT,            \
                                                  golden_x_##format, golden_y_##format,       \
                                                  golden_z_##format, irradiance),             \
                   EIGENSHADE_STATUS_OK, name, "shade_many");                                 \
      check(same(irradiance, golden, GOLDEN_NORMALS_##FORMAT), name, "shade_many", pair);     \
      for (size_t k = 0; k < GOLDEN_NORMALS_##FORMAT; k++) {                                  \
        irradiance[k] = 0;                                                                    \
        check_status(eigenshade_shade_##format(&scene, golden_x_##format[k],                  \
                                               golden_y_##format[k], golden_z_##format[k],    \
                                               &irradiance[k]),                               \
                     EIGENSHADE_STATUS_OK, name, "shade");                                    \
      }                                                                                       \
      check(same(irradiance, golden, GOLDEN_NORMALS_##FORMAT), name, "shade", pair);          \
    }                                                                                         \
  }

CHECKS_OF_INTEGERS(Q15, q15, "q15", int16_t)

void check_golden_vectors(void) {
  checks_f32();
  checks_q15();
}
