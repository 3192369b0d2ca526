#include "sphere_image.h"

#include <string.h>

#if LV_COLOR_DEPTH != 16 || LV_COLOR_16_SWAP
#error "rows are written as 16 bits a pixel in the processor's byte order"
#endif

/* The format by which the functions below know their images. */
#define FORMAT LV_IMG_CF_USER_ENCODED_0

static lv_res_t info(lv_img_decoder_t *decoder, const void *source, lv_img_header_t *header) {
  const sphere_image_t *image = source;
  (void)decoder;
  if (lv_img_src_get_type(source) != LV_IMG_SRC_VARIABLE || image->source.header.cf != FORMAT) {
    return LV_RES_INV;
  }
  *header = image->source.header;
  /* Pixels of the key's color are transparent: those beside the sphere. */
  header->cf = LV_IMG_CF_TRUE_COLOR_CHROMA_KEYED;
  return LV_RES_OK;
}

static lv_res_t open_image(lv_img_decoder_t *decoder, lv_img_decoder_dsc_t *opened) {
  (void)decoder;
  opened->img_data = NULL; /* LVGL then reads row by row. */
  return LV_RES_OK;
}

static lv_res_t read_row(lv_img_decoder_t *decoder, lv_img_decoder_dsc_t *opened, lv_coord_t x,
                         lv_coord_t y, lv_coord_t length, uint8_t *pixels) {
  const sphere_image_t *image = opened->src;
  const lv_color_t key = LV_COLOR_CHROMA_KEY;
  const size_t diameter = image->source.header.w;
  (void)decoder;
  for (size_t column = 0; column < diameter; column++) {
    image->row[column] = key.full;
  }
  if (eigenshade_picture_disc_row_q15(image->picture, diameter, (size_t)y, image->exposure,
                                      image->display, image->row, diameter)) {
    return LV_RES_INV;
  }
  memcpy(pixels, image->row + x, (size_t)length * sizeof *image->row);
  return LV_RES_OK;
}

void sphere_image_register(void) {
  lv_img_decoder_t *decoder = lv_img_decoder_create();
  lv_img_decoder_set_info_cb(decoder, info);
  lv_img_decoder_set_open_cb(decoder, open_image);
  lv_img_decoder_set_read_line_cb(decoder, read_row);
}

void sphere_image_init(sphere_image_t *image, uint16_t diameter) {
  image->source = (lv_img_dsc_t){
      .header = {.cf = FORMAT, .w = diameter & 0x7ffu, .h = diameter & 0x7ffu},
      .data = (const uint8_t *)image, /* LVGL wants some. */
  };
}
