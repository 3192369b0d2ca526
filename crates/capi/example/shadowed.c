/* An object with shadows: pictures, printed and compared as those of color.c, and what the library
 * answers to arguments at fault. Freestanding C99. */
#include "checks.h"
#include "eigenshade_presets.h"
#include "objects.h"
#include "parts.h"

enum { SIDE = 48, CODES = 40, BAND = 5 };

static uint16_t drawn_f32[SIDE * SIDE], drawn_q15[SIDE * SIDE], colors[CODES];
static eigenshade_object_coefficients_t coefficients;
static const eigenshade_display_t *const display = &eigenshade_display_filmic;

/* Draws the object in bands. */
#define SHADOWED(format)                                                                          \
  static void shadowed_##format(void) {                                                           \
    const char *const name = #format;                                                             \
    CHECKED(eigenshade_shadowed_object_coefficients_##format(                                     \
        &shaded, &eigenshade_light_lobby_##format, &coefficients));                               \
    CHECKED(eigenshade_shadowed_object_colors(&shaded, &coefficients, 1.5f, display,              \
                                              EIGENSHADE_ENCODING_RGB565, colors,                 \
                                              sizeof colors));                                    \
    for (size_t row = 0; row < SIDE; row += BAND) {                                               \
      const size_t rows = row + BAND < SIDE ? BAND : SIDE - row;                                  \
      const eigenshade_target_t target = {drawn_##format + SIDE * row, 2 * SIDE * rows, 2 * SIDE, \
                                          SIDE, rows, 0, -(int32_t)row,                           \
                                          EIGENSHADE_ENCODING_RGB565};                            \
      CHECKED(eigenshade_shadowed_object_draw(&shaded, colors, sizeof colors, &target));          \
    }                                                                                             \
  }

SHADOWED(f32)
SHADOWED(q15)

/* A part of the object in all encodings, under the light in integers. */
static void check_encodings(void) {
  static const size_t strides[4] = {88, 91, 133, 174}, bytes_of[4] = {2, 2, 3, 4};
  static uint16_t memory[174 * 30 / 2], of_codes[2 * CODES];
  const char *const name = "encodings";
  for (int32_t encoding = 0; encoding < 4; encoding++) {
    const size_t stride = strides[encoding], length = bytes_of[encoding] * CODES;
    const eigenshade_target_t target = {memory, 30 * stride, stride, 40, 30, -5, 7, encoding};
    fill(memory, sizeof memory, 0x5a);
    CHECKED(eigenshade_shadowed_object_colors(&shaded, &coefficients, 1.5f, display, encoding,
                                              of_codes, length));
    CHECKED(eigenshade_shadowed_object_draw(&shaded, of_codes, length, &target));
    print_checksum("shadowed target", memory, 30 * stride);
  }
}

/* A gray object of 1 x 1 pixels, degree 0 and one code. */
static uint8_t bytes[46] = {'e', 'i', 'g', 's', 'h', 2, 1, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 0,
                            255, 127, 255, 127, 255, 127, 248, 0, 64,  /* the share and the row */
                            1, 0, 242, 0, 64,                          /* the cluster */
                            0, 0, 0, 0, 3, 0, 0, 0,                    /* the rows of pixels */
                            0, 0, 1, 0, 0, 0};
static const eigenshade_shadowed_object_t small = {sizeof bytes, bytes};

static void check_faults_of_shadowed(void) {
  static eigenshade_object_coefficients_t none;
  static uint16_t pixels[4] = {7, 7, 7, 7};
  static union {
    eigenshade_shadowed_object_t object;
    eigenshade_shadowed_object_header_t header;
    eigenshade_object_coefficients_t coefficients;
    uint16_t pixels[4];
  } same;
  const float of_light[4] = {1, 0, 0, 0};
  const eigenshade_light_f32_t gray = {0, 1, of_light}, high = {1, 4, of_light};
  const eigenshade_color_light_f32_t light = {gray, gray, gray}, too_high = {gray, gray, high};
  const eigenshade_target_t target = {pixels, sizeof pixels, 4, 2, 2, 0, 0, 0};
  eigenshade_target_t other = target;
  eigenshade_shadowed_object_header_t header = {9, 9, 9, 9};
  eigenshade_shadowed_object_t cut = small;
  uint16_t color = 9;
  const char *const name = "shadowed";
  for (cut.length = 0; cut.length < small.length; cut.length++) {
    EXPECTED(OBJECT, eigenshade_shadowed_object_header(&cut, &header));
    EXPECTED(OBJECT, eigenshade_shadowed_object_coefficients_f32(&cut, &light, &coefficients));
    EXPECTED(OBJECT, eigenshade_shadowed_object_colors(&cut, &coefficients, 1, display, 0, &color, 2));
    EXPECTED(OBJECT, eigenshade_shadowed_object_draw(&cut, &color, 2, &target));
  }
  check(header.width == 9 && header.degree == 9, name, "the header is as it was", 0);
  EXPECTED(OK, eigenshade_shadowed_object_header(&small, &header));
  check(header.width == 1 && header.height == 1 && header.codes == 1 && header.degree == 0, name,
        "header", 0);
  cut.bytes = NULL;
  EXPECTED(NULL_POINTER, eigenshade_shadowed_object_header(&cut, &header));
  EXPECTED(NULL_POINTER, eigenshade_shadowed_object_header(NULL, &header));
  EXPECTED(NULL_POINTER, eigenshade_shadowed_object_header(&small, NULL));
  same.object = small;
  EXPECTED(OVERLAP, eigenshade_shadowed_object_header(&same.object, &same.header));

  EXPECTED(NULL_POINTER, eigenshade_shadowed_object_coefficients_f32(&small, NULL, &coefficients));
  EXPECTED(NULL_POINTER, eigenshade_shadowed_object_coefficients_f32(&small, &light, NULL));
  EXPECTED(UNALIGNED, eigenshade_shadowed_object_coefficients_f32(&small, &light, BESIDE(&none)));
  EXPECTED(LIGHT_BEYOND, eigenshade_shadowed_object_coefficients_f32(&small, &too_high, &none));
  EXPECTED(LIGHT_BEYOND, eigenshade_shadowed_object_coefficients_q15(
                             &small, &eigenshade_light_lobby_q15, &none));
  EXPECTED(OVERLAP, eigenshade_shadowed_object_coefficients_f32(&same.object, &light,
                                                                &same.coefficients));
  EXPECTED(COEFFICIENTS, eigenshade_shadowed_object_colors(&small, &none, 1, display, 0, &color, 2));
  EXPECTED(OK, eigenshade_shadowed_object_coefficients_f32(&small, &light, &coefficients));

  EXPECTED(NULL_POINTER, eigenshade_shadowed_object_colors(NULL, &coefficients, 1, display, 0,
                                                           &color, 2));
  EXPECTED(NULL_POINTER, eigenshade_shadowed_object_colors(&small, NULL, 1, display, 0, &color, 2));
  EXPECTED(NULL_POINTER, eigenshade_shadowed_object_colors(&small, &coefficients, 1, NULL, 0,
                                                           &color, 2));
  EXPECTED(NULL_POINTER, eigenshade_shadowed_object_colors(&small, &coefficients, 1, display, 0,
                                                           NULL, 2));
  EXPECTED(UNALIGNED, eigenshade_shadowed_object_colors(&small, &coefficients, 1, display, 0,
                                                        BESIDE(pixels), 2));
  EXPECTED(EXPOSURE, eigenshade_shadowed_object_colors(&small, &coefficients, 0, display, 0, &color,
                                                       2));
  EXPECTED(ENCODING, eigenshade_shadowed_object_colors(&small, &coefficients, 1, display, 4, &color,
                                                       2));
  EXPECTED(COLORS, eigenshade_shadowed_object_colors(&small, &coefficients, 1, display, 0, &color,
                                                     1));
  EXPECTED(COLORS, eigenshade_shadowed_object_colors(&small, &coefficients, 1, display, 2, &color,
                                                     2));
  same.coefficients = coefficients;
  EXPECTED(OVERLAP, eigenshade_shadowed_object_colors(&small, &same.coefficients, 1, display, 0,
                                                      same.pixels, 2));
  EXPECTED(OVERLAP, eigenshade_shadowed_object_colors(&small, &coefficients, 1, display, 0, bytes,
                                                      2));
  check(color == 9, name, "the color is as it was", 0);
  EXPECTED(OK, eigenshade_shadowed_object_colors(&small, &coefficients, 1, display, 0, &color, 2));
  check(color != 9 && color != 0, name, "a color", 0);

  EXPECTED(NULL_POINTER, eigenshade_shadowed_object_draw(NULL, &color, 2, &target));
  EXPECTED(NULL_POINTER, eigenshade_shadowed_object_draw(&small, NULL, 2, &target));
  EXPECTED(NULL_POINTER, eigenshade_shadowed_object_draw(&small, &color, 2, NULL));
  EXPECTED(COLORS, eigenshade_shadowed_object_draw(&small, &color, 4, &target));
  EXPECTED(UNALIGNED, eigenshade_shadowed_object_draw(&shaded, BESIDE(colors), sizeof colors,
                                                      &target));
  EXPECTED(OVERLAP, eigenshade_shadowed_object_draw(&small, pixels + 1, 2, &target));
  other.pixels = bytes;
  other.encoding = EIGENSHADE_ENCODING_RGB565_HIGH_FIRST;
  EXPECTED(OVERLAP, eigenshade_shadowed_object_draw(&small, &color, 2, &other));
  other.encoding = 4;
  EXPECTED(ENCODING, eigenshade_shadowed_object_draw(&small, &color, 2, &other));
  check(pixels[0] == 7 && pixels[3] == 7, name, "the pixels are as they were", 0);
  /* Beyond all borders, and inside. */
  static const int32_t far[4] = {INT32_MIN, -1, 2, INT32_MAX};
  for (int k = 0; k < 8; k++) {
    other = target;
    *(k < 4 ? &other.x : &other.y) = far[k % 4];
    EXPECTED(OK, eigenshade_shadowed_object_draw(&small, &color, 2, &other));
  }
  check(pixels[0] == 7 && pixels[3] == 7, name, "the pixels are as they were", 1);
  EXPECTED(OK, eigenshade_shadowed_object_draw(&small, &color, 2, &target));
  check(pixels[0] == color && pixels[1] == 7 && pixels[2] == 7, name, "one pixel", 0);
}

void check_shadowed(void) {
  shadowed_f32();
  shadowed_q15();
  check_picture("shadowed", drawn_f32, drawn_q15, SIDE * SIDE);
  check_encodings();
  check_faults_of_shadowed();
}
