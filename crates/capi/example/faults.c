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

  /* A scene of zeros, or of whatever was in memory. */
  for (int byte = 0; byte < 256; byte += 85) {
    for (size_t k = 0; k < sizeof scene; k++) {
      ((unsigned char *)&scene)[k] = (unsigned char)byte;
    }
    EXPECTED(SCENE, eigenshade_shade_f32(&scene, 0.0f, 0.0f, 1.0f, &irradiance));
    EXPECTED(SCENE, eigenshade_shade_many_f32(&scene, 1, bright, bright, bright, &irradiance));
  }
  check(irradiance == 0.0f, name, "irradiance without a scene", 0);

  /* A matte sphere in light from everywhere: pi times its radiance Y_0^0 over pi. */
  EXPECTED(OK, eigenshade_project_f32(&light, &material, &workspace, &d));
  EXPECTED(OK, eigenshade_collapse_f32(&d, EIGENSHADE_COMPONENTS, &scene));
  EXPECTED(OK, eigenshade_shade_f32(&scene, 0.0f, 0.0f, 2.0f, &irradiance));
  check(irradiance > 0.2820f && irradiance < 0.2822f, name, "ambient", 0);

  d.numbers[0] = 7.0f;
  EXPECTED(NULL_POINTER, eigenshade_project_f32(NULL, &material, &workspace, &d));
  EXPECTED(NULL_POINTER, eigenshade_project_f32(&light, NULL, &workspace, &d));
  EXPECTED(NULL_POINTER, eigenshade_project_f32(&light, &material, NULL, &d));
  EXPECTED(NULL_POINTER, eigenshade_project_f32(&light, &material, &workspace, NULL));
  light.coefficients = NULL;
  EXPECTED(NULL_POINTER, eigenshade_relight_f32(&transfer, &light, &d));
  light.coefficients = (const float *)(const void *)((const char *)numbers + 1);
  EXPECTED(UNALIGNED, eigenshade_relight_f32(&transfer, &light, &d));
  light = ambient;
  light.degree = EIGENSHADE_DEGREE + 1;
  EXPECTED(LIGHT_BEYOND, eigenshade_relight_f32(&transfer, &light, &d));
  light.degree = 1;
  EXPECTED(LIGHT_LENGTH, eigenshade_relight_f32(&transfer, &light, &d));
  material.order = (size_t)-1;
  EXPECTED(MATERIAL_BEYOND, eigenshade_transfer_f32(&material, &workspace, &transfer));
  material.order = 1;
  EXPECTED(MATERIAL_LENGTH, eigenshade_transfer_f32(&material, &workspace, &transfer));
  check(d.numbers[0] == 7.0f, name, "d is as it was", 0);

  EXPECTED(COMPONENTS, eigenshade_collapse_f32(&d, EIGENSHADE_COMPONENTS + 1, &scene));
  irradiance = 7.0f;
  EXPECTED(NORMAL, eigenshade_shade_f32(&scene, 0.0f, 0.0f, 0.0f, &irradiance));
  EXPECTED(HIDDEN, eigenshade_shade_f32(&scene, 0.0f, 0.0f, -1.0f, &irradiance));
  check(irradiance == 7.0f, name, "irradiance is as it was", 0);
  EXPECTED(OVERLAP, eigenshade_shade_many_f32(&scene, 2, numbers, numbers, numbers, numbers + 1));
  EXPECTED(COUNT,
           eigenshade_shade_many_f32(&scene, (size_t)-1, numbers, numbers, numbers, numbers));
  EXPECTED(NULL_POINTER, eigenshade_shade_many_f32(&scene, 2, numbers, NULL, numbers, numbers + 2));
  EXPECTED(OK, eigenshade_shade_many_f32(&scene, 0, NULL, NULL, NULL, NULL));
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
  const char *const name = "f32";
  const eigenshade_light_f32_t light = {.degree = 0, .length = 1, .coefficients = bright};
  const eigenshade_light_f32_t light_in_d = {.degree = 0, .length = 1, .coefficients = d.numbers + 7};
  const eigenshade_material_f32_t material = {.order = 0, .length = 1, .coefficients = white};
  const eigenshade_material_f32_t in_workspace = {
      .order = 0, .length = 1, .coefficients = workspace.numbers};
  EXPECTED(OVERLAP, eigenshade_transfer_f32(&material, &one.workspace, &one.transfer));
  EXPECTED(OVERLAP, eigenshade_transfer_f32(&in_workspace, &workspace, &transfer));
  one.material = material;
  EXPECTED(OVERLAP, eigenshade_transfer_f32(&one.material, &workspace, &one.transfer));
  check(one.material.length == 1, name, "the material is as it was", 0);
  EXPECTED(OVERLAP, eigenshade_relight_f32(&transfer, &light_in_d, &d));
  EXPECTED(OVERLAP, eigenshade_relight_f32(&one.transfer, &light, &one.d));
  one.light = light;
  EXPECTED(OVERLAP, eigenshade_relight_f32(&transfer, &one.light, &one.d));
  EXPECTED(OVERLAP, eigenshade_project_f32(&light, &material, &one.workspace, &one.d));
  EXPECTED(OVERLAP, eigenshade_project_f32(&light_in_d, &material, &workspace, &d));
  EXPECTED(OVERLAP, eigenshade_project_f32(&light, &in_workspace, &workspace, &d));
  EXPECTED(OVERLAP, eigenshade_collapse_f32(&one.d, 1, &one.scene));
  EXPECTED(OVERLAP, eigenshade_shade_f32(&scene, 0.0f, 0.0f, 1.0f, scene.terms + 3));
  EXPECTED(OK, eigenshade_project_f32(&light, &material, &workspace, &d));
  EXPECTED(OK, eigenshade_collapse_f32(&d, 1, &scene));
  EXPECTED(OVERLAP, eigenshade_shade_many_f32(&scene, 1, white, white, white, scene.terms));
  size_t normalized = 7;
  EXPECTED(OVERLAP,
           eigenshade_normalize_f32(one.numbers, one.numbers + 1, one.numbers + 3, 2, &normalized));
  check(normalized == 7, name, "nothing is normalized", 0);
}

static void runtime_inputs_f32(void) {
  const char *const name = "f32";
  const float numbers[4] = {1.0f, 0.0f, __builtin_inff(), 0.0f};
  const eigenshade_light_f32_t light = {.degree = 1, .length = 4, .coefficients = numbers};
  const eigenshade_material_f32_t material = {.order = 1, .length = 2, .coefficients = numbers + 1};
  EXPECTED(NOT_FINITE, eigenshade_check_light_f32(&light));
  EXPECTED(NOT_FINITE, eigenshade_check_material_f32(&material));
  const eigenshade_light_f32_t ambient = {.degree = 0, .length = 1, .coefficients = numbers};
  EXPECTED(OK, eigenshade_check_light_f32(&ambient));
  EXPECTED(NULL_POINTER, eigenshade_check_material_f32(NULL));
  /* Of a map of 8 bits: toward the camera, just behind the rim, far behind it. */
  float x[3] = {1.0f, 255.0f, 255.0f}, y[3] = {1.0f, 1.0f, 1.0f}, z[3] = {255.0f, -1.0f, -255.0f};
  size_t normalized = 7;
  EXPECTED(HIDDEN, eigenshade_normalize_f32(x, y, z, 3, &normalized));
  check(normalized == 2 && z[0] > 0.9999f && z[0] < 1.0f && z[1] == 0.0f && x[1] > 0.9999f, name,
        "those before it", 0);
  check(x[2] == 255.0f && z[2] == -255.0f, name, "the one behind is as it was", 0);
}

/* The same in an integer format of type `mantissa`, its largest `one`. */
#define FAULTS_OF_INTEGERS(format, mantissa, one)                                             \
  static void faults_##format(void) {                                                         \
    const char *const name = #format;                                                         \
    static const mantissa largest[1] = {one};                                                 \
    static const int8_t exponents[1] = {0};                                                   \
    static eigenshade_workspace_##format##_t workspace;                                       \
    static eigenshade_transfer_##format##_t transfer;                                         \
    static eigenshade_coefficients_##format##_t d;                                            \
    static eigenshade_scene_##format##_t scene;                                               \
    static mantissa zeros[3], z[3] = {one, -one, one};                                        \
    static int32_t irradiances[3] = {7, 7, 7};                                                \
    const eigenshade_light_##format##_t ambient = {.degree = 0, .length = 1, .mantissas = largest}; \
    const eigenshade_material_##format##_t matte = {                                          \
        .order = 0, .length = 1, .mantissas = largest, .exponents_length = 1,                 \
        .exponents = exponents};                                                              \
    eigenshade_light_##format##_t light = ambient;                                            \
    eigenshade_material_##format##_t material = matte;                                        \
    int32_t irradiance = 7;                                                                   \
    EXPECTED(SCENE, eigenshade_shade_##format(&scene, 0, 0, one, &irradiance));               \
    EXPECTED(SCENE, eigenshade_shade_many_##format(&scene, 1, zeros, zeros, z, &irradiance)); \
    EXPECTED(OK, eigenshade_project_##format(&light, &material, &workspace, &transfer, &d));  \
    EXPECTED(OK, eigenshade_collapse_##format(&d, EIGENSHADE_COMPONENTS, &scene));            \
    const eigenshade_light_f32_t of_floats = {.degree = 0, .length = 1, .coefficients = bright}; \
    mantissa quantized[1] = {7};                                                              \
    EXPECTED(NULL_POINTER, eigenshade_quantize_light_##format(&of_floats, NULL, 1, &light));  \
    EXPECTED(LIGHT_LENGTH, eigenshade_quantize_light_##format(&of_floats, quantized, 4, &light)); \
    check(quantized[0] == 7, name, "mantissas are as they were", 0);                          \
    EXPECTED(OK, eigenshade_quantize_light_##format(&of_floats, quantized, 1, &light));       \
    check(light.mantissas == quantized, name, "the light's mantissas", 0);                    \
    light = ambient;                                                                          \
    d.mantissas[0] = 7;                                                                       \
    EXPECTED(NULL_POINTER, eigenshade_transfer_##format(NULL, &workspace, &transfer));        \
    EXPECTED(NULL_POINTER, eigenshade_transfer_##format(&material, NULL, &transfer));         \
    EXPECTED(NULL_POINTER, eigenshade_transfer_##format(&material, &workspace, NULL));        \
    material.exponents = NULL;                                                                \
    EXPECTED(NULL_POINTER, eigenshade_transfer_##format(&material, &workspace, &transfer));   \
    material = matte;                                                                         \
    material.exponents_length = 2;                                                            \
    EXPECTED(MATERIAL_LENGTH, eigenshade_transfer_##format(&material, &workspace, &transfer)); \
    material.order = EIGENSHADE_ORDER + 1;                                                    \
    EXPECTED(MATERIAL_BEYOND, eigenshade_transfer_##format(&material, &workspace, &transfer)); \
    light.exponent = 129;                                                                     \
    EXPECTED(EXPONENT, eigenshade_relight_##format(&transfer, &light, &d));                   \
    light.degree = EIGENSHADE_DEGREE + 1;                                                     \
    EXPECTED(LIGHT_BEYOND, eigenshade_relight_##format(&transfer, &light, &d));               \
    light.degree = 1;                                                                         \
    EXPECTED(LIGHT_LENGTH, eigenshade_relight_##format(&transfer, &light, &d));               \
    check(d.mantissas[0] == 7, name, "d is as it was", 0);                                    \
    light = ambient;                                                                          \
    transfer.numbers[0] = transfer.numbers[1] = transfer.numbers[2] = one;                    \
    EXPECTED(TRANSFER, eigenshade_relight_##format(&transfer, &light, &d));                   \
    check(d.mantissas[0] == 0, name, "d is zero", 0);                                         \
    EXPECTED(COMPONENTS, eigenshade_collapse_##format(&d, EIGENSHADE_COMPONENTS + 1, &scene)); \
    d.exponent = INT32_MIN;                                                                   \
    EXPECTED(EXPONENT, eigenshade_collapse_##format(&d, EIGENSHADE_COMPONENTS, &scene));      \
    EXPECTED(NORMAL, eigenshade_shade_##format(&scene, 0, 0, one / 2, &irradiance));          \
    EXPECTED(HIDDEN, eigenshade_shade_##format(&scene, 0, 0, -one, &irradiance));             \
    check(irradiance == 7, name, "irradiance is as it was", 0);                               \
    EXPECTED(OK, eigenshade_shade_##format(&scene, 0, 0, one, &irradiance));                  \
    EXPECTED(NULL_POINTER,                                                                    \
             eigenshade_shade_many_##format(&scene, 3, zeros, NULL, z, irradiances));         \
    check(irradiances[0] == 7, name, "irradiances are as they were", 0);                      \
    /* The second normal points away. */                                                      \
    EXPECTED(HIDDEN, eigenshade_shade_many_##format(&scene, 3, zeros, zeros, z, irradiances)); \
    check(irradiances[0] == irradiance && irradiances[1] == 0 && irradiances[2] == 0, name,   \
          "what stands before it", 0);                                                        \
    EXPECTED(OVERLAP,                                                                         \
             eigenshade_shade_many_##format(&scene, 1, zeros, zeros, z, (int32_t *)(void *)z)); \
    static eigenshade_light_##format##_t light_in_d;                                          \
    static union {                                                                            \
      eigenshade_workspace_##format##_t workspace;                                            \
      eigenshade_transfer_##format##_t transfer;                                              \
      eigenshade_coefficients_##format##_t d;                                                 \
      eigenshade_scene_##format##_t scene;                                                    \
      eigenshade_light_##format##_t light;                                                    \
      mantissa mantissas[4];                                                                  \
    } same;                                                                                   \
    EXPECTED(OVERLAP, eigenshade_transfer_##format(&matte, &same.workspace, &same.transfer)); \
    light_in_d = ambient;                                                                     \
    light_in_d.mantissas = (const mantissa *)(const void *)d.mantissas;                       \
    EXPECTED(OVERLAP, eigenshade_relight_##format(&transfer, &light_in_d, &d));               \
    EXPECTED(OVERLAP, eigenshade_relight_##format(&same.transfer, &ambient, &same.d));        \
    EXPECTED(OVERLAP,                                                                         \
             eigenshade_project_##format(&ambient, &matte, &workspace, &same.transfer, &same.d)); \
    EXPECTED(OVERLAP,                                                                         \
             eigenshade_project_##format(&ambient, &matte, &same.workspace, &transfer, &same.d)); \
    EXPECTED(OVERLAP, eigenshade_collapse_##format(&same.d, 1, &same.scene));                 \
    EXPECTED(OVERLAP, eigenshade_shade_##format(&scene, 0, 0, one, scene.terms + 3));         \
    EXPECTED(OVERLAP,                                                                         \
             eigenshade_shade_many_##format(&scene, 1, zeros, zeros, z, &scene.exponent));    \
    EXPECTED(OVERLAP,                                                                         \
             eigenshade_quantize_light_##format(&of_floats, same.mantissas, 1, &same.light)); \
    const float endless[1] = {__builtin_inff()};                                              \
    const eigenshade_light_f32_t of_infinity = {                                              \
        .degree = 0, .length = 1, .coefficients = endless};                                   \
    EXPECTED(NOT_FINITE, eigenshade_quantize_light_##format(&of_infinity, quantized, 1, &light)); \
    /* Of a map of 8 bits. */                                                                 \
    const int32_t behind[3] = {255, 1, -1}, away[3] = {1, 1, -255};                           \
    mantissa normal[3] = {7, 7, 7};                                                           \
    EXPECTED(HIDDEN, eigenshade_normalize_##format(away, normal));                            \
    check(normal[0] == 7 && normal[2] == 7, name, "normal is as it was", 0);                  \
    EXPECTED(OK, eigenshade_normalize_##format(behind, normal));                              \
    check(normal[0] > one - one / 1000 && normal[1] > 0 && normal[2] == 0, name, "rim", 0);   \
    EXPECTED(OK, eigenshade_shade_##format(&scene, normal[0], normal[1], normal[2], &irradiance)); \
  }

FAULTS_OF_INTEGERS(q15, int16_t, 32767)

void check_faults(void) {
  faults_f32();
  overlaps_f32();
  runtime_inputs_f32();
  faults_q15();
  check(eigenshade_message(EIGENSHADE_STATUS_OK) != eigenshade_message(-1), "any", "message", 0);
}
