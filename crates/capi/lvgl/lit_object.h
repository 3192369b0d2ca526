/* An object of eigenshade as a widget of LVGL 9: a canvas with opacity, so LVGL mixes the object's
 * rim with what is behind it, on displays of every color format. */
#ifndef LIT_OBJECT_H
#define LIT_OBJECT_H

#include "eigenshade.h"
#include "lvgl.h"

/* A new widget of the size of a buffer in LV_COLOR_FORMAT_ARGB8888, which takes 4 bytes a pixel.
 * The buffer is the caller's, in use until the widget is deleted. NULL for another format. */
lv_obj_t *lit_object_create(lv_obj_t *parent, lv_draw_buf_t *pixels);

/* Clears the pixels for a new picture and returns them as a target, in which the top left of an
 * object is at (0, 0). */
eigenshade_target_t lit_object_begin(lv_obj_t *object);

/* Shows what was drawn since `lit_object_begin`. */
void lit_object_end(lv_obj_t *object);

#endif
