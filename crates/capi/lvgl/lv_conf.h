/* LVGL as the example needs it: 16-bit colors in both byte orders, the rest as it comes. */
#ifndef LV_CONF_H
#define LV_CONF_H

#define LV_COLOR_DEPTH 16
#define LV_DRAW_SW_SUPPORT_RGB565_SWAPPED 1
#define LV_FONT_MONTSERRAT_14 1
#define LV_USE_CANVAS 1

#endif
