/* Draws a screen of 240 x 240 pixels with LVGL, and prints it as a picture (PPM). */
#include "eigenshade_presets.h"
#include "lit_object.h"

#include <stdio.h>

enum { SIDE = 240, ROWS = 20, DIAMETER = 150 };

static lv_color_t screen[SIDE * SIDE];

/* What a display's driver does. */
static void flush(lv_disp_drv_t *driver, const lv_area_t *area, lv_color_t *colors) {
  for (lv_coord_t y = area->y1; y <= area->y2; y++) {
    for (lv_coord_t x = area->x1; x <= area->x2; x++) {
      screen[y * SIDE + x] = *colors++;
    }
  }
  lv_disp_flush_ready(driver);
}

static void open_display(void) {
  static lv_color_t rows[SIDE * ROWS];
  static lv_disp_draw_buf_t buffer;
  static lv_disp_drv_t driver;
  lv_init();
  lv_disp_draw_buf_init(&buffer, rows, NULL, SIDE * ROWS);
  lv_disp_drv_init(&driver);
  driver.draw_buf = &buffer;
  driver.flush_cb = flush;
  driver.hor_res = SIDE;
  driver.ver_res = SIDE;
  lv_disp_drv_register(&driver);
}

static void write_picture(void) {
  printf("P6\n%d %d\n255\n", SIDE, SIDE);
  for (size_t k = 0; k < SIDE * SIDE; k++) {
    const lv_color32_t color = {.full = lv_color_to32(screen[k])};
    putchar(color.ch.red);
    putchar(color.ch.green);
    putchar(color.ch.blue);
  }
}

static eigenshade_status light(eigenshade_palette_t *palette) {
  static eigenshade_picture_q15_t picture;
  const eigenshade_status status = eigenshade_picture_begin_q15(
      &eigenshade_light_lobby_q15, &eigenshade_material_gold_metallic_paint_q15, &picture);
  if (status) return status;
  return eigenshade_palette_fill_q15(&picture, 1.5f, &eigenshade_display_filmic, NULL, palette);
}

int main(void) {
  static eigenshade_palette_t palette;
  static uint8_t codes[2 * DIAMETER * DIAMETER];
  static const eigenshade_normal_map_t map = {DIAMETER, DIAMETER, sizeof codes, codes};
  static lit_object_t sphere = {&palette, &map};
  eigenshade_status status = eigenshade_normal_map_sphere(DIAMETER, codes, sizeof codes);
  if (!status) status = light(&palette);
  if (status) {
    fprintf(stderr, "%s\n", eigenshade_message(status));
    return 1;
  }

  open_display();
  lv_obj_center(lit_object_create(lv_scr_act(), &sphere));

  lv_obj_t *arc = lv_arc_create(lv_scr_act());
  lv_obj_set_size(arc, SIDE - 16, SIDE - 16);
  lv_obj_remove_style(arc, NULL, LV_PART_KNOB);
  lv_arc_set_value(arc, 70);
  lv_obj_center(arc);
  lv_obj_t *label = lv_label_create(lv_scr_act());
  lv_label_set_text(label, "lobby, gold");
  lv_obj_align(label, LV_ALIGN_BOTTOM_MID, 0, -2);

  lv_refr_now(NULL);
  write_picture();
  return 0;
}
