/* The part of ESP-IDF's interface that docs/boards.md uses. */
#pragma once

typedef int esp_err_t;
typedef struct esp_lcd_panel_t *esp_lcd_panel_handle_t;
esp_err_t esp_lcd_panel_draw_bitmap(esp_lcd_panel_handle_t panel, int x_start, int y_start, int x_end,
                                    int y_end, const void *color_data);
