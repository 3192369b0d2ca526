/* LVGL as the example needs it: 16-bit colors, the rest as it comes. */
#ifndef LV_CONF_H
#define LV_CONF_H

#define LV_COLOR_DEPTH 16
#define LV_MEM_SIZE (64U * 1024U)
#define LV_FONT_MONTSERRAT_14 1

#endif
