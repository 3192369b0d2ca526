/* What the library answers to textured objects at fault, and that it then leaves alone what it was to
 * write. Freestanding C99. */
#include "checks.h"
#include "eigenshade_presets.h"
#include "objects.h"
#include "parts.h"

/* Pixels that stay as they are, and a target of all of them, in the middle of the sphere. */
enum { WIDTH = 8, HEIGHT = 4 };
static uint16_t pixels[WIDTH * HEIGHT];
static const eigenshade_target_t whole = {pixels, sizeof pixels, 2 * WIDTH, WIDTH,
                                          HEIGHT, -60,           -60,       0};
static const eigenshade_display_t *const display = &eigenshade_display_linear;

static void check_unchanged(const char *name) {
  for (size_t k = 0; k < WIDTH * HEIGHT; k++) {
    check(pixels[k] == 0x0707, name, "the pixels are as they were", (uint32_t)k);
  }
}

/* Pictures of regions, and linear palettes. */
#define FAULTS(format)                                                                            \
  static void faults_##format(void) {                                                             \
    static eigenshade_material_buffer_##format##_t buffer;                                        \
    static eigenshade_picture_##format##_t picture, none, other;                                  \
    static eigenshade_linear_palette_t palette;                                                   \
    static eigenshade_nodes_t nodes;                                                              \
    static union {                                                                                \
      eigenshade_picture_##format##_t picture;                                                    \
      eigenshade_linear_palette_t palette;                                                        \
      eigenshade_material_buffer_##format##_t buffer;                                             \
      eigenshade_color_material_##format##_t material;                                            \
      eigenshade_object_t object;                                                                 \
    } same;                                                                                       \
    const eigenshade_source_f32_t *const sources = eigenshade_sources_lobby_f32;                  \
    eigenshade_color_material_##format##_t tinted, plain;                                         \
    const char *const name = #format;                                                             \
    EXPECTED(OK, eigenshade_region_materials_##format(&striped, 1, &buffer, &tinted, &plain));    \
    EXPECTED(OK, eigenshade_picture_begin_##format(&eigenshade_light_lobby_##format, &tinted,     \
                                                   &picture));                                    \
    other = picture;                                                                              \
    EXPECTED(REGION, eigenshade_region_materials_##format(&striped, 3, &buffer, &tinted,    \
                                                          &plain));                               \
    EXPECTED(NULL_POINTER, eigenshade_region_materials_##format(NULL, 0, &buffer, &tinted,        \
                                                                &plain));                         \
    EXPECTED(NULL_POINTER, eigenshade_region_materials_##format(&striped, 0, NULL, &tinted,       \
                                                                &plain));                         \
    EXPECTED(NULL_POINTER, eigenshade_region_materials_##format(&striped, 0, &buffer, NULL,       \
                                                                &plain));                         \
    EXPECTED(NULL_POINTER, eigenshade_region_materials_##format(&striped, 0, &buffer, &tinted,    \
                                                                NULL));                           \
    EXPECTED(OVERLAP, eigenshade_region_materials_##format(&striped, 0, &buffer, &tinted,         \
                                                           &tinted));                             \
    EXPECTED(OVERLAP, eigenshade_region_materials_##format(&striped, 0, &same.buffer,             \
                                                           &same.material, &plain));              \
    same.object = striped;                                                                        \
    EXPECTED(OVERLAP, eigenshade_region_materials_##format(&same.object, 0, &same.buffer,         \
                                                           &tinted, &plain));                     \
                                                                                                  \
    EXPECTED(PICTURE, eigenshade_region_highlights_##format(&striped, 0, sources, 1, &picture,    \
                                                            &none));                              \
    EXPECTED(REGION, eigenshade_region_highlights_##format(&striped, 3, sources, 1,         \
                                                           &picture, &other));                    \
    EXPECTED(NULL_POINTER, eigenshade_region_highlights_##format(NULL, 0, sources, 1, &picture,   \
                                                                 &other));                        \
    EXPECTED(NULL_POINTER, eigenshade_region_highlights_##format(&striped, 0, NULL, 1, &picture,  \
                                                                 &other));                        \
    EXPECTED(NULL_POINTER, eigenshade_region_highlights_##format(&striped, 0, sources, 1, NULL,   \
                                                                 &other));                        \
    EXPECTED(OVERLAP, eigenshade_region_highlights_##format(&striped, 0, sources, 1, &picture,    \
                                                            &picture));                           \
    EXPECTED(OVERLAP,                                                                             \
             eigenshade_region_highlights_##format(                                               \
                 &striped, 0, (const eigenshade_source_f32_t *)(const void *)&other, 1,           \
                 &picture, &other));                                                              \
                                                                                                  \
    /* Palettes that nobody filled, and inputs at fault. */                                       \
    for (int byte = 0; byte < 256; byte += 85) {                                                  \
      fill(&palette, sizeof palette, (unsigned char)byte);                                        \
      EXPECTED(PALETTE, eigenshade_object_draw(&plastic, &palette, 1, display, &whole));          \
      EXPECTED(PALETTE, eigenshade_object_draw_dithered(&plastic, &palette, 1, display, &whole)); \
    }                                                                                             \
    EXPECTED(PICTURE, eigenshade_linear_palette_fill_##format(&none, &picture, 1, NULL,           \
                                                              &palette));                         \
    EXPECTED(PICTURE, eigenshade_linear_palette_fill_##format(&picture, &none, 1, NULL,           \
                                                              &palette));                         \
    EXPECTED(EXPOSURE, eigenshade_linear_palette_fill_##format(&picture, &picture, 0, NULL,       \
                                                               &palette));                        \
    EXPECTED(NODES, eigenshade_linear_palette_fill_##format(&picture, &picture, 1, &nodes,        \
                                                            &palette));                           \
    EXPECTED(NULL_POINTER, eigenshade_linear_palette_fill_##format(NULL, &picture, 1, NULL,       \
                                                                   &palette));                    \
    EXPECTED(NULL_POINTER, eigenshade_linear_palette_fill_##format(&picture, &picture, 1, NULL,   \
                                                                   NULL));                        \
    EXPECTED(UNALIGNED, eigenshade_linear_palette_fill_##format(&picture, &picture, 1, NULL,      \
                                                                BESIDE(&palette)));               \
    same.picture = picture;                                                                       \
    EXPECTED(OVERLAP, eigenshade_linear_palette_fill_##format(&picture, &same.picture, 1, NULL,   \
                                                              &same.palette));                    \
    EXPECTED(PALETTE, eigenshade_object_draw(&plastic, &palette, 1, display, &whole));            \
    EXPECTED(OK, eigenshade_linear_palette_fill_##format(&picture, &other, 1, NULL, &palette));   \
    check_unchanged(name);                                                                        \
    EXPECTED(OK, eigenshade_object_draw(&plastic, &palette, 1, display, &whole));                 \
    check(pixels[WIDTH * HEIGHT - 1] != 0x0707, name, "it is drawn", 0);                          \
    fill(pixels, sizeof pixels, 7);                                                               \
  }

FAULTS(f32)
FAULTS(q15)

/* Of 2 x 2 pixels and one region. */
static uint8_t bytes[54] = {'e', 'i', 'g', 'o', 'b', 1, 2, 0, 2,   0,  1,  0,
                            0,   0,   0,   64,  0,   123,          /* the region */
                            0,   0,   0,   0,   2,   0, 0, 0, 4,   0,  0,  0, /* the rows */
                            1,   0,   1,   0,   0,   0, 0, 0, 200, 90, 10, 255,
                            0,   0,   1,   0,   0,   0, 1, 0, 9,   9,  9,  128};
static const eigenshade_object_t small = {sizeof bytes, bytes};

/* Bytes that were cut or changed. */
static void changed(const eigenshade_linear_palette_t *palette) {
  static const struct {
    size_t place;
    uint8_t byte;
  } changes[] = {{0, 'x'}, {5, 2},   {6, 0},  {8, 0},  {8, 3},  {10, 0}, {13, 128},
                 {15, 128}, {17, 128}, {18, 1}, {22, 1}, {22, 5}, {26, 3}, {26, 5},
                 {30, 2},  {32, 0},   {32, 2}, {34, 1}, {42, 2}, {44, 2}, {46, 1}};
  const eigenshade_target_t target = {pixels, sizeof pixels, 2 * WIDTH, WIDTH, HEIGHT, 0, 0, 0};
  const eigenshade_target_t of_row = {pixels, sizeof pixels, 2 * WIDTH, WIDTH, 1, 0, 0, 0};
  static eigenshade_nodes_t nodes;
  eigenshade_object_t cut = small;
  eigenshade_object_header_t header = {7, 7, 7};
  const char *const name = "changed";
  for (cut.length = 0; cut.length < sizeof bytes; cut.length++) {
    EXPECTED(OBJECT, eigenshade_object_header(&cut, &header));
    EXPECTED(OBJECT, eigenshade_nodes_of_region(&cut, 0, &nodes));
    EXPECTED(OBJECT, eigenshade_object_draw(&cut, palette, 1, display, &of_row));
  }
  for (size_t k = 0; k < sizeof changes / sizeof changes[0]; k++) {
    const uint8_t before = bytes[changes[k].place];
    bytes[changes[k].place] = changes[k].byte;
    EXPECTED(OBJECT, eigenshade_object_header(&small, &header));
    EXPECTED(OBJECT, eigenshade_nodes_of_region(&small, 0, &nodes));
    EXPECTED(OBJECT, eigenshade_object_draw(&small, palette, 1, display, &target));
    bytes[changes[k].place] = before;
  }
  check(header.width == 7 && header.regions == 7, name, "the header is as it was", 0);
  check_unchanged(name);
  EXPECTED(OK, eigenshade_object_header(&small, &header));
  check(header.width == 2 && header.height == 2 && header.regions == 1, name, "header", 0);
  EXPECTED(OK, eigenshade_object_draw(&small, palette, 1, display, &target));
  check(pixels[0] == 0x0707 && pixels[1] != 0x0707, name, "two pixels", 0);
  check(pixels[WIDTH] != 0x0707 && pixels[WIDTH + 1] == 0x0707, name, "two pixels", 1);
  /* Other rows are not checked. */
  bytes[46] = 1;
  EXPECTED(OK, eigenshade_object_draw(&small, palette, 1, display, &of_row));
  bytes[46] = 0;
  fill(pixels, sizeof pixels, 7);
}

static void objects(void) {
  static eigenshade_picture_q15_t picture;
  static eigenshade_linear_palette_t palette;
  static eigenshade_nodes_t nodes;
  eigenshade_object_header_t header;
  eigenshade_object_t object = {sizeof header, (const uint8_t *)&header};
  eigenshade_target_t target = whole;
  const char *const name = "objects";
  EXPECTED(OK, eigenshade_picture_begin_q15(&eigenshade_light_lobby_q15,
      &eigenshade_material_gold_metallic_paint_q15, &picture));
  EXPECTED(OK, eigenshade_linear_palette_fill_q15(&picture, &picture, 1, NULL, &palette));
  changed(&palette);
  EXPECTED(NULL_POINTER, eigenshade_object_header(NULL, &header));
  EXPECTED(NULL_POINTER, eigenshade_object_header(&small, NULL));
  EXPECTED(NULL_POINTER, eigenshade_nodes_of_region(NULL, 0, &nodes));
  EXPECTED(NULL_POINTER, eigenshade_nodes_of_region(&small, 0, NULL));
  EXPECTED(REGION, eigenshade_nodes_of_region(&small, 1, &nodes));
  EXPECTED(NULL_POINTER, eigenshade_object_draw(NULL, &palette, 1, display, &whole));
  EXPECTED(NULL_POINTER, eigenshade_object_draw(&small, NULL, 1, display, &whole));
  EXPECTED(NULL_POINTER, eigenshade_object_draw(&small, &palette, 1, NULL, &whole));
  EXPECTED(NULL_POINTER, eigenshade_object_draw(&small, &palette, 1, display, NULL));
  EXPECTED(UNALIGNED, eigenshade_object_draw(&small, BESIDE(&palette), 1, display, &whole));
  EXPECTED(COUNT, eigenshade_object_draw(&small, &palette, (size_t)-1, display, &whole));
  EXPECTED(REGION, eigenshade_object_draw(&small, NULL, 0, display, &whole));
  EXPECTED(REGION, eigenshade_object_draw(&striped, &palette, 1, display, &whole));
  object.bytes = NULL;
  EXPECTED(NULL_POINTER, eigenshade_object_header(&object, &header));
  target.encoding = 4;
  EXPECTED(ENCODING, eigenshade_object_draw(&small, &palette, 1, display, &target));

  /* What is written to overlaps what is read. */
  EXPECTED(OVERLAP, eigenshade_object_header(
                        &small, (eigenshade_object_header_t *)(void *)(uintptr_t)&small));
  target = whole;
  target.pixels = bytes;
  EXPECTED(OVERLAP, eigenshade_object_draw(&small, &palette, 1, display, &target));
  target.pixels = &palette;
  EXPECTED(OVERLAP, eigenshade_object_draw_dithered(&small, &palette, 1, display, &target));
  target.pixels = (void *)(uintptr_t)display;
  EXPECTED(OVERLAP, eigenshade_object_draw(&small, &palette, 1, display, &target));

  /* Beyond all borders. */
  static const int32_t far[4] = {INT32_MIN, -120, WIDTH, INT32_MAX};
  for (int k = 0; k < 8; k++) {
    target = whole;
    *(k < 4 ? &target.x : &target.y) = far[k % 4];
    EXPECTED(OK, eigenshade_object_draw(&plastic, &palette, 1, display, &target));
    EXPECTED(OK, eigenshade_object_draw_dithered(&plastic, &palette, 1, display, &target));
  }
  check_unchanged(name);
}

void check_object_faults(void) {
  fill(pixels, sizeof pixels, 7);
  faults_f32();
  faults_q15();
  objects();
}
