/* What the library answers to arguments at fault, and that it then leaves alone what it was
 * to write. */
#include "checks.h"
#include "parts.h"

static const float bright[1] = {1.0f};
static const float white[1] = {2.0f};

static void faults_f32(void) {
  static eigenshade_workspace_f32_t workspace;
  static eigenshade_transfer_f32_t transfer;
  static eigenshade_coefficients_f32_t d;
  static eigenshade_scene_f32_t scene;
  static float numbers[4];
  const char *const name = "f32";
  const eigenshade_light_f32_t ambient = {.degree = 0, .length = 1, .coefficients = bright};
  const eigenshade_material_f32_t matte = {.order = 0, .length = 1, .coefficients = white};
  eigenshade_light_f32_t light = ambient;
  eigenshade_material_f32_t material = matte;
  float irradiance = 0.0f;

  /* A matte sphere in light from everywhere: pi times its radiance Y_0^0 over pi. */
  check_status(eigenshade_project_f32(&light, &material, &workspace, &d),
               EIGENSHADE_STATUS_OK, name, "ambient");
  check_status(eigenshade_collapse_f32(&d, EIGENSHADE_COMPONENTS, &scene),
               EIGENSHADE_STATUS_OK, name, "ambient");
  check_status(eigenshade_shade_f32(&scene, 0.0f, 0.0f, 2.0f, &irradiance),
               EIGENSHADE_STATUS_OK, name, "ambient");
  check(irradiance > 0.2820f && irradiance < 0.2822f, name, "ambient", 0);

  d.numbers[0] = 7.0f;
  check_status(eigenshade_project_f32(NULL, &material, &workspace, &d),
               EIGENSHADE_STATUS_NULL_POINTER, name, "no light");
  check_status(eigenshade_project_f32(&light, NULL, &workspace, &d),
               EIGENSHADE_STATUS_NULL_POINTER, name, "no material");
  check_status(eigenshade_project_f32(&light, &material, NULL, &d),
               EIGENSHADE_STATUS_NULL_POINTER, name, "no workspace");
  check_status(eigenshade_project_f32(&light, &material, &workspace, NULL),
               EIGENSHADE_STATUS_NULL_POINTER, name, "no d");
  light.coefficients = NULL;
  check_status(eigenshade_relight_f32(&transfer, &light, &d), EIGENSHADE_STATUS_NULL_POINTER,
               name, "no coefficients");
  light.coefficients = (const float *)(const void *)((const char *)numbers + 1);
  check_status(eigenshade_relight_f32(&transfer, &light, &d), EIGENSHADE_STATUS_UNALIGNED,
               name, "odd address");
  light = ambient;
  light.degree = EIGENSHADE_DEGREE + 1;
  check_status(eigenshade_relight_f32(&transfer, &light, &d), EIGENSHADE_STATUS_LIGHT_BEYOND,
               name, "degree");
  light.degree = 1;
  check_status(eigenshade_relight_f32(&transfer, &light, &d), EIGENSHADE_STATUS_LIGHT_LENGTH,
               name, "length of light");
  material.order = (size_t)-1;
  check_status(eigenshade_transfer_f32(&material, &workspace, &transfer),
               EIGENSHADE_STATUS_MATERIAL_BEYOND, name, "order");
  material.order = 1;
  check_status(eigenshade_transfer_f32(&material, &workspace, &transfer),
               EIGENSHADE_STATUS_MATERIAL_LENGTH, name, "length of material");
  check(d.numbers[0] == 7.0f, name, "d is as it was", 0);

  check_status(eigenshade_collapse_f32(&d, EIGENSHADE_COMPONENTS + 1, &scene),
               EIGENSHADE_STATUS_COMPONENTS, name, "components");
  irradiance = 7.0f;
  check_status(eigenshade_shade_f32(&scene, 0.0f, 0.0f, 0.0f, &irradiance),
               EIGENSHADE_STATUS_NORMAL, name, "no direction");
  check_status(eigenshade_shade_f32(&scene, 0.0f, 0.0f, -1.0f, &irradiance),
               EIGENSHADE_STATUS_HIDDEN, name, "away");
  check(irradiance == 7.0f, name, "irradiance is as it was", 0);
  check_status(eigenshade_shade_many_f32(&scene, 2, numbers, numbers, numbers, numbers + 1),
               EIGENSHADE_STATUS_OVERLAP, name, "overlap");
  check_status(eigenshade_shade_many_f32(&scene, (size_t)-1, numbers, numbers, numbers, numbers),
               EIGENSHADE_STATUS_COUNT, name, "count");
  check_status(eigenshade_shade_many_f32(&scene, 2, numbers, NULL, numbers, numbers + 2),
               EIGENSHADE_STATUS_NULL_POINTER, name, "no y");
  check_status(eigenshade_shade_many_f32(&scene, 0, NULL, NULL, NULL, NULL),
               EIGENSHADE_STATUS_OK, name, "no normals");
}

/* What is written to overlaps what is read, or something else that is written to: the numbers
 * were wrong, and the answer was that all is well. */
static void overlaps_f32(void) {
  static eigenshade_workspace_f32_t workspace;
  static eigenshade_transfer_f32_t transfer;
  static eigenshade_coefficients_f32_t d;
  static eigenshade_scene_f32_t scene;
  static union {
    eigenshade_workspace_f32_t workspace;
    eigenshade_transfer_f32_t transfer;
    eigenshade_coefficients_f32_t d;
    eigenshade_scene_f32_t scene;
    eigenshade_light_f32_t light;
    eigenshade_material_f32_t material;
    float numbers[4];
  } one;
  const eigenshade_status overlap = EIGENSHADE_STATUS_OVERLAP;
  const char *const name = "f32";
  const eigenshade_light_f32_t light = {.degree = 0, .length = 1, .coefficients = bright};
  const eigenshade_light_f32_t light_in_d = {.degree = 0, .length = 1, .coefficients = d.numbers + 7};
  const eigenshade_material_f32_t material = {.order = 0, .length = 1, .coefficients = white};
  const eigenshade_material_f32_t in_workspace = {
      .order = 0, .length = 1, .coefficients = workspace.numbers};
  check_status(eigenshade_transfer_f32(&material, &one.workspace, &one.transfer), overlap, name,
               "workspace and transfer");
  check_status(eigenshade_transfer_f32(&in_workspace, &workspace, &transfer), overlap, name,
               "material in workspace");
  one.material = material;
  check_status(eigenshade_transfer_f32(&one.material, &workspace, &one.transfer), overlap, name,
               "material and transfer");
  check(one.material.length == 1, name, "the material is as it was", 0);
  check_status(eigenshade_relight_f32(&transfer, &light_in_d, &d), overlap, name, "light in d");
  check_status(eigenshade_relight_f32(&one.transfer, &light, &one.d), overlap, name,
               "transfer and d");
  one.light = light;
  check_status(eigenshade_relight_f32(&transfer, &one.light, &one.d), overlap, name,
               "light and d");
  check_status(eigenshade_project_f32(&light, &material, &one.workspace, &one.d), overlap, name,
               "workspace and d");
  check_status(eigenshade_project_f32(&light_in_d, &material, &workspace, &d), overlap, name,
               "project: light in d");
  check_status(eigenshade_project_f32(&light, &in_workspace, &workspace, &d), overlap, name,
               "project: material in workspace");
  check_status(eigenshade_collapse_f32(&one.d, 1, &one.scene), overlap, name, "d and scene");
  check_status(eigenshade_shade_f32(&scene, 0.0f, 0.0f, 1.0f, scene.terms + 3), overlap, name,
               "irradiance in scene");
  check_status(eigenshade_shade_many_f32(&scene, 1, white, white, white, scene.terms), overlap,
               name, "irradiances in scene");
  size_t normalized = 7;
  check_status(eigenshade_normalize_f32(one.numbers, one.numbers + 1, one.numbers + 3, 2, &normalized),
               overlap, name, "x and y");
  check(normalized == 7, name, "nothing is normalized", 0);
}

static void runtime_inputs_f32(void) {
  const char *const name = "f32";
  const float numbers[4] = {1.0f, 0.0f, __builtin_inff(), 0.0f};
  const eigenshade_light_f32_t light = {.degree = 1, .length = 4, .coefficients = numbers};
  const eigenshade_material_f32_t material = {.order = 1, .length = 2, .coefficients = numbers + 1};
  check_status(eigenshade_check_light_f32(&light), EIGENSHADE_STATUS_NOT_FINITE, name, "light");
  check_status(eigenshade_check_material_f32(&material), EIGENSHADE_STATUS_NOT_FINITE, name,
               "material");
  const eigenshade_light_f32_t ambient = {.degree = 0, .length = 1, .coefficients = numbers};
  check_status(eigenshade_check_light_f32(&ambient), EIGENSHADE_STATUS_OK, name, "finite light");
  check_status(eigenshade_check_material_f32(NULL), EIGENSHADE_STATUS_NULL_POINTER, name, "none");
  /* Of a map of 8 bits: toward the camera, just behind the rim, far behind it. */
  float x[3] = {1.0f, 255.0f, 255.0f}, y[3] = {1.0f, 1.0f, 1.0f}, z[3] = {255.0f, -1.0f, -255.0f};
  size_t normalized = 7;
  check_status(eigenshade_normalize_f32(x, y, z, 3, &normalized), EIGENSHADE_STATUS_HIDDEN, name,
               "one behind");
  check(normalized == 2 && z[0] > 0.9999f && z[0] < 1.0f && z[1] == 0.0f && x[1] > 0.9999f, name,
        "those before it", 0);
  check(x[2] == 255.0f && z[2] == -255.0f, name, "the one behind is as it was", 0);
}

/* The same in an integer format of type `mantissa`, its largest `one`. */
#define FAULTS_OF_INTEGERS(FORMAT, format, name, mantissa, one)                               \
  static void faults_##format(void) {                                                         \
    static const mantissa largest[1] = {one};                                                 \
    static const int8_t exponents[1] = {0};                                                   \
    static eigenshade_workspace_##format##_t workspace;                                       \
    static eigenshade_transfer_##format##_t transfer;                                         \
    static eigenshade_coefficients_##format##_t d;                                            \
    static eigenshade_scene_##format##_t scene;                                               \
    static mantissa zeros[3], z[3] = {one, -one, one};                                        \
    static int32_t irradiances[3] = {7, 7, 7};                                                \
    const eigenshade_light_##format##_t ambient = {.degree = 0, .length = 1, .mantissas = largest}; \
    const eigenshade_material_##format##_t matte = {.order = 0,                               \
                                                .length = 1,                                  \
                                                .mantissas = largest,                         \
                                                .exponents_length = 1,                        \
                                                .exponents = exponents};                      \
    eigenshade_light_##format##_t light = ambient;                                            \
    eigenshade_material_##format##_t material = matte;                                        \
    int32_t irradiance = 7;                                                                   \
    check_status(eigenshade_project_##format(&light, &material, &workspace, &transfer, &d),   \
                 EIGENSHADE_STATUS_OK, name, "ambient");                                      \
    check_status(eigenshade_collapse_##format(&d, EIGENSHADE_COMPONENTS, &scene),             \
                 EIGENSHADE_STATUS_OK, name, "ambient");                                      \
    const eigenshade_light_f32_t of_floats = {.degree = 0, .length = 1, .coefficients = bright}; \
    mantissa quantized[1] = {7};                                                              \
    check_status(eigenshade_quantize_light_##format(&of_floats, NULL, 1, &light),             \
                 EIGENSHADE_STATUS_NULL_POINTER, name, "no mantissas");                       \
    check_status(eigenshade_quantize_light_##format(&of_floats, quantized, 4, &light),        \
                 EIGENSHADE_STATUS_LIGHT_LENGTH, name, "room for another light");             \
    check(quantized[0] == 7, name, "mantissas are as they were", 0);                          \
    check_status(eigenshade_quantize_light_##format(&of_floats, quantized, 1, &light),        \
                 EIGENSHADE_STATUS_OK, name, "light of floats");                              \
    check(light.mantissas == quantized, name, "the light's mantissas", 0);                    \
    light = ambient;                                                                          \
    d.mantissas[0] = 7;                                                                       \
    check_status(eigenshade_transfer_##format(NULL, &workspace, &transfer),                   \
                 EIGENSHADE_STATUS_NULL_POINTER, name, "no material");                        \
    check_status(eigenshade_transfer_##format(&material, NULL, &transfer),                    \
                 EIGENSHADE_STATUS_NULL_POINTER, name, "no workspace");                       \
    check_status(eigenshade_transfer_##format(&material, &workspace, NULL),                   \
                 EIGENSHADE_STATUS_NULL_POINTER, name, "no transfer");                        \
    material.exponents = NULL;                                                                \
    check_status(eigenshade_transfer_##format(&material, &workspace, &transfer),              \
                 EIGENSHADE_STATUS_NULL_POINTER, name, "no exponents");                       \
    material = matte;                                                                         \
    material.exponents_length = 2;                                                            \
    check_status(eigenshade_transfer_##format(&material, &workspace, &transfer),              \
                 EIGENSHADE_STATUS_MATERIAL_LENGTH, name, "exponents");                       \
    material.order = EIGENSHADE_ORDER + 1;                                                    \
    check_status(eigenshade_transfer_##format(&material, &workspace, &transfer),              \
                 EIGENSHADE_STATUS_MATERIAL_BEYOND, name, "order");                           \
    light.exponent = 129;                                                                     \
    check_status(eigenshade_relight_##format(&transfer, &light, &d),                          \
                 EIGENSHADE_STATUS_EXPONENT, name, "exponent of light");                      \
    light.degree = EIGENSHADE_DEGREE + 1;                                                     \
    check_status(eigenshade_relight_##format(&transfer, &light, &d),                          \
                 EIGENSHADE_STATUS_LIGHT_BEYOND, name, "degree");                             \
    light.degree = 1;                                                                         \
    check_status(eigenshade_relight_##format(&transfer, &light, &d),                          \
                 EIGENSHADE_STATUS_LIGHT_LENGTH, name, "length of light");                    \
    check(d.mantissas[0] == 7, name, "d is as it was", 0);                                    \
    light = ambient;                                                                          \
    transfer.numbers[0] = transfer.numbers[1] = transfer.numbers[2] = one;                    \
    check_status(eigenshade_relight_##format(&transfer, &light, &d),                          \
                 EIGENSHADE_STATUS_TRANSFER, name, "transfer");                               \
    check(d.mantissas[0] == 0, name, "d is zero", 0);                                         \
    check_status(eigenshade_collapse_##format(&d, EIGENSHADE_COMPONENTS + 1, &scene),         \
                 EIGENSHADE_STATUS_COMPONENTS, name, "components");                           \
    d.exponent = INT32_MIN;                                                                   \
    check_status(eigenshade_collapse_##format(&d, EIGENSHADE_COMPONENTS, &scene),             \
                 EIGENSHADE_STATUS_EXPONENT, name, "exponent of d");                          \
    check_status(eigenshade_shade_##format(&scene, 0, 0, one / 2, &irradiance),               \
                 EIGENSHADE_STATUS_NORMAL, name, "no unit vector");                           \
    check_status(eigenshade_shade_##format(&scene, 0, 0, -one, &irradiance),                  \
                 EIGENSHADE_STATUS_HIDDEN, name, "away");                                     \
    check(irradiance == 7, name, "irradiance is as it was", 0);                               \
    check_status(eigenshade_shade_##format(&scene, 0, 0, one, &irradiance),                   \
                 EIGENSHADE_STATUS_OK, name, "toward");                                       \
    check_status(eigenshade_shade_many_##format(&scene, 3, zeros, NULL, z, irradiances),      \
                 EIGENSHADE_STATUS_NULL_POINTER, name, "no y");                               \
    check(irradiances[0] == 7, name, "irradiances are as they were", 0);                      \
    /* The second normal points away. */                                                      \
    check_status(eigenshade_shade_many_##format(&scene, 3, zeros, zeros, z, irradiances),     \
                 EIGENSHADE_STATUS_HIDDEN, name, "one away");                                 \
    check(irradiances[0] == irradiance && irradiances[1] == 0 && irradiances[2] == 0, name,   \
          "what stands before it", 0);                                                        \
    check_status(                                                                             \
        eigenshade_shade_many_##format(&scene, 1, zeros, zeros, z, (int32_t *)(void *)z),     \
        EIGENSHADE_STATUS_OVERLAP, name, "overlap");                                          \
    static eigenshade_light_##format##_t light_in_d;                                          \
    static union {                                                                            \
      eigenshade_workspace_##format##_t workspace;                                            \
      eigenshade_transfer_##format##_t transfer;                                              \
      eigenshade_coefficients_##format##_t d;                                                 \
      eigenshade_scene_##format##_t scene;                                                    \
      eigenshade_light_##format##_t light;                                                    \
      mantissa mantissas[4];                                                                  \
    } same;                                                                                   \
    const eigenshade_status overlap = EIGENSHADE_STATUS_OVERLAP;                              \
    check_status(eigenshade_transfer_##format(&matte, &same.workspace, &same.transfer), overlap, \
                 name, "workspace and transfer");                                             \
    light_in_d = ambient;                                                                     \
    light_in_d.mantissas = (const mantissa *)(const void *)d.mantissas;                       \
    check_status(eigenshade_relight_##format(&transfer, &light_in_d, &d), overlap, name,      \
                 "light in d");                                                               \
    check_status(eigenshade_relight_##format(&same.transfer, &ambient, &same.d), overlap,     \
                 name, "transfer and d");                                                     \
    check_status(eigenshade_project_##format(&ambient, &matte, &workspace, &same.transfer,    \
                                             &same.d),                                        \
                 overlap, name, "project: transfer and d");                                   \
    check_status(eigenshade_project_##format(&ambient, &matte, &same.workspace, &transfer,    \
                                             &same.d),                                        \
                 overlap, name, "project: workspace and d");                                  \
    check_status(eigenshade_collapse_##format(&same.d, 1, &same.scene), overlap, name,        \
                 "d and scene");                                                              \
    check_status(eigenshade_shade_##format(&scene, 0, 0, one, scene.terms + 3), overlap, name, \
                 "irradiance in scene");                                                      \
    check_status(eigenshade_shade_many_##format(&scene, 1, zeros, zeros, z, &scene.exponent), \
                 overlap, name, "irradiances in scene");                                      \
    check_status(eigenshade_quantize_light_##format(&of_floats, same.mantissas, 1,            \
                                                    &same.light),                             \
                 overlap, name, "mantissas in their light");                                  \
    const float endless[1] = {__builtin_inff()};                                              \
    const eigenshade_light_f32_t of_infinity = {                                              \
        .degree = 0, .length = 1, .coefficients = endless};                                   \
    check_status(eigenshade_quantize_light_##format(&of_infinity, quantized, 1, &light),      \
                 EIGENSHADE_STATUS_NOT_FINITE, name, "light of infinity");                    \
    /* Of a map of 8 bits. */                                                                 \
    const int32_t behind[3] = {255, 1, -1}, away[3] = {1, 1, -255};                           \
    mantissa normal[3] = {7, 7, 7};                                                           \
    check_status(eigenshade_normalize_##format(away, normal), EIGENSHADE_STATUS_HIDDEN, name, \
                 "far behind");                                                               \
    check(normal[0] == 7 && normal[2] == 7, name, "normal is as it was", 0);                  \
    check_status(eigenshade_normalize_##format(behind, normal), EIGENSHADE_STATUS_OK, name,   \
                 "behind");                                                                   \
    check(normal[0] > one - one / 1000 && normal[1] > 0 && normal[2] == 0, name, "rim", 0);   \
    check_status(eigenshade_shade_##format(&scene, normal[0], normal[1], normal[2],           \
                                           &irradiance),                                      \
                 EIGENSHADE_STATUS_OK, name, "at the rim");                                   \
  }

FAULTS_OF_INTEGERS(Q15, q15, "q15", int16_t, 32767)
FAULTS_OF_INTEGERS(Q31, q31, "q31", int32_t, 2147483647)

void check_faults(void) {
  faults_f32();
  overlaps_f32();
  runtime_inputs_f32();
  faults_q15();
  faults_q31();
  check(eigenshade_message(EIGENSHADE_STATUS_OK) != eigenshade_message(-1), "any", "message", 0);
}
