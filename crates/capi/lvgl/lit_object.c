#include "lit_object.h"

lv_obj_t *lit_object_create(lv_obj_t *parent, lv_draw_buf_t *pixels) {
  if (pixels->header.cf != LV_COLOR_FORMAT_ARGB8888) {
    LV_LOG_ERROR("the buffer is not in LV_COLOR_FORMAT_ARGB8888");
    return NULL;
  }
  lv_obj_t *object = lv_canvas_create(parent);
  lv_canvas_set_draw_buf(object, pixels);
  return object;
}

eigenshade_target_t lit_object_begin(lv_obj_t *object) {
  lv_draw_buf_t *buffer = lv_canvas_get_draw_buf(object);
  lv_draw_buf_clear(buffer, NULL);
  const eigenshade_target_t target = {
      .pixels = buffer->data,
      .length = buffer->data_size,
      .stride = buffer->header.stride,
      .width = buffer->header.w,
      .height = buffer->header.h,
      .encoding = EIGENSHADE_ENCODING_RGBA8888,
  };
  return target;
}

void lit_object_end(lv_obj_t *object) {
  lv_draw_buf_t *buffer = lv_canvas_get_draw_buf(object);
  /* The first byte of a pixel is red here, and blue in LVGL. */
  for (uint32_t y = 0; y < buffer->header.h; y++) {
    uint8_t *pixel = lv_draw_buf_goto_xy(buffer, 0, y);
    for (uint32_t x = 0; x < buffer->header.w; x++, pixel += 4) {
      const uint8_t red = pixel[0];
      pixel[0] = pixel[2];
      pixel[2] = red;
    }
  }
  lv_draw_buf_flush_cache(buffer, NULL);
  lv_obj_invalidate(object);
}
