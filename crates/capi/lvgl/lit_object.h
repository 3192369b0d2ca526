/* The object of a normal map on a screen of LVGL 8.3 with 16-bit colors. It is drawn from a palette
 * into LVGL's own buffer, over what is there. */
#ifndef LIT_OBJECT_H
#define LIT_OBJECT_H

#include "eigenshade.h"
#include "lvgl.h"

/* What an object is drawn from; the caller's. To change it, fill the palette and call
 * `lv_obj_invalidate` on the object. */
typedef struct {
  const eigenshade_palette_t *palette;
  const eigenshade_normal_map_t *map;
} lit_object_t;

/* A new object of the size of the map. */
lv_obj_t *lit_object_create(lv_obj_t *parent, lit_object_t *from);

#endif
