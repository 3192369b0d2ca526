#include "lit_object.h"

#if LV_COLOR_DEPTH != 16
#error "pixels are written as 16 bits"
#endif

static void draw(lv_event_t *event) {
  const lit_object_t *from = lv_event_get_user_data(event);
  const lv_area_t *object = &lv_event_get_target(event)->coords;
  lv_draw_ctx_t *context = lv_event_get_draw_ctx(event);
  const lv_area_t *buffer = context->buf_area;
  lv_area_t visible;
  if (!_lv_area_intersect(&visible, object, context->clip_area)) {
    return;
  }
  lv_draw_wait_for_finish(context);
  const size_t across = (size_t)lv_area_get_width(buffer);
  const size_t pixels = across * (size_t)lv_area_get_height(buffer);
  const size_t above = across * (size_t)(visible.y1 - buffer->y1);
  const size_t first = above + (size_t)(visible.x1 - buffer->x1);
  const eigenshade_target_t target = {
      .pixels = (lv_color_t *)context->buf + first,
      .length = (pixels - first) * sizeof(lv_color_t),
      .stride = across * sizeof(lv_color_t),
      .width = (size_t)lv_area_get_width(&visible),
      .height = (size_t)lv_area_get_height(&visible),
      .x = object->x1 - visible.x1,
      .y = object->y1 - visible.y1,
      .encoding = LV_COLOR_16_SWAP ? EIGENSHADE_ENCODING_RGB565_HIGH_FIRST
                                   : EIGENSHADE_ENCODING_RGB565,
  };
  const eigenshade_status status =
      eigenshade_palette_draw_dithered(from->palette, from->map, &target);
  if (status) {
    LV_LOG_ERROR("%s", eigenshade_message(status));
  }
}

lv_obj_t *lit_object_create(lv_obj_t *parent, lit_object_t *from) {
  lv_obj_t *object = lv_obj_create(parent);
  lv_obj_remove_style_all(object);
  lv_obj_clear_flag(object, LV_OBJ_FLAG_SCROLLABLE);
  lv_obj_set_size(object, (lv_coord_t)from->map->width, (lv_coord_t)from->map->height);
  lv_obj_add_event_cb(object, draw, LV_EVENT_DRAW_MAIN, from);
  return object;
}
