/* Draws a screen of 240 x 240 pixels with LVGL in both byte orders of RGB565, checks that they have
 * the same colors, and prints the screen as a picture (PPM). */
#include "eigenshade_presets.h"
#include "lit_object.h"
#include "objects.h"

#include <stdio.h>
#include <string.h>

enum { SIDE = 240, ROWS = 20, DIAMETER = 150, STRIPED = 48, REGIONS = 3 };

/* The driver of the display: it sends the bytes of an area as they are. */
static void flush(lv_display_t *display, const lv_area_t *area, uint8_t *bytes) {
  uint8_t *screen = lv_display_get_user_data(display);
  const size_t length = 2 * (size_t)lv_area_get_width(area);
  for (int32_t y = area->y1; y <= area->y2; y++) {
    memcpy(screen + 2 * (y * SIDE + area->x1), bytes, length);
    bytes += length;
  }
  lv_display_flush_ready(display);
}

/* A sphere of gold, from a palette. */
static eigenshade_status draw_gold(lv_obj_t *object) {
  static eigenshade_picture_q15_t picture;
  static eigenshade_palette_t palette;
  static uint8_t codes[2 * DIAMETER * DIAMETER];
  static const eigenshade_normal_map_t map = {DIAMETER, DIAMETER, sizeof codes, codes};
  eigenshade_status status = eigenshade_normal_map_sphere(DIAMETER, codes, sizeof codes);
  if (!status)
    status = eigenshade_picture_begin_q15(&eigenshade_light_lobby_q15,
                                          &eigenshade_material_gold_metallic_paint_q15, &picture);
  if (!status)
    status = eigenshade_palette_fill_q15(&picture, 1.5f, &eigenshade_display_filmic, NULL,
                                         &palette);
  if (status) return status;
  const eigenshade_target_t target = lit_object_begin(object);
  status = eigenshade_palette_draw(&palette, &map, &target);
  lit_object_end(object);
  return status;
}

/* A textured object. */
static eigenshade_status draw_striped(lv_obj_t *object) {
  static eigenshade_material_buffer_q15_t materials;
  static eigenshade_picture_q15_t tinted, plain;
  static eigenshade_linear_palette_t palettes[REGIONS];
  eigenshade_color_material_q15_t of_tinted, of_plain;
  eigenshade_status status = 0;
  for (size_t region = 0; !status && region < REGIONS; region++) {
    status = eigenshade_region_materials_q15(&striped, region, &materials, &of_tinted, &of_plain);
    if (!status)
      status = eigenshade_picture_begin_q15(&eigenshade_light_lobby_q15, &of_tinted, &tinted);
    if (!status)
      status = eigenshade_picture_begin_q15(&eigenshade_light_lobby_q15, &of_plain, &plain);
    if (!status)
      status = eigenshade_linear_palette_fill_q15(&tinted, &plain, 1.5f, NULL, &palettes[region]);
  }
  if (status) return status;
  const eigenshade_target_t target = lit_object_begin(object);
  status =
      eigenshade_object_draw(&striped, palettes, REGIONS, &eigenshade_display_filmic, &target);
  lit_object_end(object);
  return status;
}

static eigenshade_status show(lv_obj_t *screen) {
  LV_DRAW_BUF_DEFINE_STATIC(of_gold, DIAMETER, DIAMETER, LV_COLOR_FORMAT_ARGB8888);
  LV_DRAW_BUF_DEFINE_STATIC(of_striped, STRIPED, STRIPED, LV_COLOR_FORMAT_ARGB8888);
  LV_DRAW_BUF_INIT_STATIC(of_gold);
  LV_DRAW_BUF_INIT_STATIC(of_striped);

  lv_obj_t *arc = lv_arc_create(screen);
  lv_obj_set_size(arc, SIDE - 16, SIDE - 16);
  lv_obj_remove_style(arc, NULL, LV_PART_KNOB);
  lv_arc_set_value(arc, 70);
  lv_obj_center(arc);
  lv_obj_t *label = lv_label_create(screen);
  lv_label_set_text(label, "lobby, gold");
  lv_obj_align(label, LV_ALIGN_BOTTOM_MID, 0, -2);

  lv_obj_t *gold = lit_object_create(screen, &of_gold);
  lv_obj_center(gold);
  lv_obj_t *textured = lit_object_create(screen, &of_striped);
  lv_arc_align_obj_to_angle(arc, textured, 0);
  const eigenshade_status status = draw_gold(gold);
  return status ? status : draw_striped(textured);
}

/* Draws the screen in a color format: both bytes of each pixel. */
static eigenshade_status draw_screen(lv_color_format_t format, uint8_t *pixels) {
  static LV_ATTRIBUTE_MEM_ALIGN uint8_t rows[2 * SIDE * ROWS];
  lv_display_t *display = lv_display_create(SIDE, SIDE);
  lv_display_set_color_format(display, format);
  lv_display_set_buffers(display, rows, NULL, sizeof rows, LV_DISPLAY_RENDER_MODE_PARTIAL);
  lv_display_set_user_data(display, pixels);
  lv_display_set_flush_cb(display, flush);
  const eigenshade_status status = show(lv_display_get_screen_active(display));
  if (!status) lv_refr_now(display);
  lv_display_delete(display);
  return status;
}

static void write_picture(const uint8_t *pixels) {
  printf("P6\n%d %d\n255\n", SIDE, SIDE);
  for (size_t k = 0; k < 2 * SIDE * SIDE; k += 2) {
    const int color = pixels[k] | pixels[k + 1] << 8;
    const int red = color >> 11, green = color >> 5 & 63, blue = color & 31;
    putchar(red << 3 | red >> 2);
    putchar(green << 2 | green >> 4);
    putchar(blue << 3 | blue >> 2);
  }
}

int main(void) {
  static uint8_t pixels[2 * SIDE * SIDE], swapped[2 * SIDE * SIDE];
  lv_init();
  eigenshade_status status = draw_screen(LV_COLOR_FORMAT_RGB565, pixels);
  if (!status) status = draw_screen(LV_COLOR_FORMAT_RGB565_SWAPPED, swapped);
  if (status) {
    fprintf(stderr, "%s\n", eigenshade_message(status));
    return 1;
  }
  for (size_t k = 0; k < sizeof pixels; k++) {
    if (pixels[k] != swapped[k ^ 1]) {
      fprintf(stderr, "pixel %zu: the byte orders have different colors\n", k / 2);
      return 1;
    }
  }
  write_picture(pixels);
  return 0;
}
