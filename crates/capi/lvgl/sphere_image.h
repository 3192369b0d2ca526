/* A sphere as an image of LVGL 8.3 with 16-bit colors. LVGL asks for it row by row, so that it
 * needs memory for one row, and redraws only the rows that it has to. */
#ifndef SPHERE_IMAGE_H
#define SPHERE_IMAGE_H

#include "eigenshade.h"
#include "lvgl.h"

/* An image source for `lv_img_set_src`. To change it, change the picture or the exposure and
 * call `lv_obj_invalidate` on the image. */
typedef struct {
  lv_img_dsc_t source; /* LVGL looks at this; `sphere_image_init` fills it in. */
  const eigenshade_picture_q15_t *picture;
  const eigenshade_display_t *display;
  float exposure;
  uint16_t *row; /* Memory for as many pixels as the diameter. */
} sphere_image_t;

/* Registers how LVGL draws them: once, after `lv_init`. */
void sphere_image_register(void);

/* Makes an image of this diameter, at most 2047, as LVGL keeps sizes in 11 bits. The other fields
 * are the caller's. */
void sphere_image_init(sphere_image_t *image, uint16_t diameter);

#endif
