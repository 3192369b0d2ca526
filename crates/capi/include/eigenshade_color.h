/* eigenshade in color: pictures in three channels, from light and material to rows of RGB565
pixels, in float (f32) and in integers (q15). The shipped lights and materials are in
`eigenshade_presets.h`.

The steps are: compute the scene of a light and a material, and draw its rows; or keep the
transfer of a material, and relight it with each new light. The three channels of a gray material
point to the same numbers; its transfer is then computed once. The rules of `eigenshade.h` about
memory hold here too. All functions in q15 do without a float unit, except
`eigenshade_color_bake_q15` and those with sources.

For sharp highlights, take small bright sources out of a light (`eigenshade_color_residual_f32`),
and draw the scene of the rest together with the sources and the gloss of the material
(`eigenshade_color_glossy_disc_row_f32`). Where a light turns, turn the rest and the sources.

In structures, r, g and b are the red, green and blue channel. */

#ifndef EIGENSHADE_COLOR_H
#define EIGENSHADE_COLOR_H

#include "eigenshade.h"

/** The order of glTF materials. */
#define EIGENSHADE_METALLIC_ROUGHNESS_ORDER 7

/** Coefficients of a glTF material. */
#define EIGENSHADE_METALLIC_ROUGHNESS 40

/** The most sources of a light. */
#define EIGENSHADE_SOURCES 16

/**
 * A tone curve and the sRGB encoding, as a table of 774 bytes: `eigenshade_display_linear` clips
 * colors brighter than white, `eigenshade_display_reinhard` and `eigenshade_display_filmic`
 * compress them.
 */
typedef struct eigenshade_display_t eigenshade_display_t;

/**
 * The visible normals of an object, as `eigenshade pack-normals` makes them from a mesh or a normal
 * map. May be kept in flash.
 */
typedef struct eigenshade_normal_map_t {
  /** Pixels across. */
  size_t width;
  /** Pixels down. */
  size_t height;
  /** Number of bytes: 2 * width * height. */
  size_t length;
  /** Two bytes for each pixel, row by row from the top; the caller's. */
  const uint8_t *codes;
} eigenshade_normal_map_t;

/**
 * A small bright source of light, as `eigenshade light --sources` writes it. May be kept in flash.
 */
typedef struct eigenshade_source_f32_t {
  /** A unit vector from the object to the light, in the camera's frame. */
  float direction[3];
  /** The integral of its radiance over solid angle: red, green and blue, at least 0. */
  float energy[3];
  /** The standard deviation in radians along every direction, 0 to 0.5. */
  float spread;
} eigenshade_source_f32_t;

/** A GGX lobe over a matte base; all numbers are from 0 to 1. May be kept in flash. */
typedef struct eigenshade_gloss_f32_t {
  /** The roughness; below 0.065 it counts as 0.065. */
  float roughness;
  /** The reflectance at normal incidence: the base color of a metal, 0.04 of other materials. */
  float reflectance[3];
  /** The reflectance at grazing incidence, usually 1. */
  float grazing[3];
  /** The color of the matte base: 0 of a metal. */
  float albedo[3];
} eigenshade_gloss_f32_t;

/** Distant light in three channels. */
typedef struct eigenshade_color_light_f32_t {
  struct eigenshade_light_f32_t r;
  struct eigenshade_light_f32_t g;
  struct eigenshade_light_f32_t b;
} eigenshade_color_light_f32_t;

/** An isotropic material in three channels. */
typedef struct eigenshade_color_material_f32_t {
  struct eigenshade_material_f32_t r;
  struct eigenshade_material_f32_t g;
  struct eigenshade_material_f32_t b;
} eigenshade_color_material_f32_t;

/** The transfer of a material in three channels. May be kept in flash. */
typedef struct eigenshade_color_transfer_f32_t {
  struct eigenshade_transfer_f32_t r;
  struct eigenshade_transfer_f32_t g;
  struct eigenshade_transfer_f32_t b;
} eigenshade_color_transfer_f32_t;

/** A picture in three channels. May be kept in flash. */
typedef struct eigenshade_color_scene_f32_t {
  struct eigenshade_scene_f32_t r;
  struct eigenshade_scene_f32_t g;
  struct eigenshade_scene_f32_t b;
} eigenshade_color_scene_f32_t;

/** Memory for a turned light. */
typedef struct eigenshade_color_light_buffer_f32_t {
  /** Coefficients of the three channels. */
  float numbers[3][EIGENSHADE_LIGHT];
} eigenshade_color_light_buffer_f32_t;

/** Memory for a computed material. */
typedef struct eigenshade_color_material_buffer_f32_t {
  /** Coefficients of the three channels. */
  float numbers[3][EIGENSHADE_METALLIC_ROUGHNESS];
} eigenshade_color_material_buffer_f32_t;

/** A picture baked into three square maps, one for each channel. May be kept in flash. */
typedef struct eigenshade_color_baked_f32_t {
  /** Texels a side, 2 to 4096. */
  size_t size;
  /** Number of texels: 3 * size * size. */
  size_t length;
  /** The texels of red, then of green, then of blue; the caller's. */
  const float *texels;
} eigenshade_color_baked_f32_t;

/** A picture with sharp highlights. May be kept in flash. */
typedef struct eigenshade_color_glossy_f32_t {
  /** The scene of the light without its sources; the caller's. */
  const struct eigenshade_color_scene_f32_t *scene;
  /** The gloss of the material; the caller's. */
  const struct eigenshade_gloss_f32_t *gloss;
  /** The sources; the caller's. */
  const struct eigenshade_source_f32_t *sources;
  /** Number of sources, at most `EIGENSHADE_SOURCES`. */
  size_t count;
} eigenshade_color_glossy_f32_t;

/** The brightness of a picture's pixels, to meter its exposure. Zeros have counted nothing. */
typedef struct eigenshade_meter_t {
  /** The library's. */
  uint32_t counts[257];
} eigenshade_meter_t;

/** `eigenshade_color_light_f32_t` in Q15. */
typedef struct eigenshade_color_light_q15_t {
  struct eigenshade_light_q15_t r;
  struct eigenshade_light_q15_t g;
  struct eigenshade_light_q15_t b;
} eigenshade_color_light_q15_t;

/** `eigenshade_color_material_f32_t` in Q15. */
typedef struct eigenshade_color_material_q15_t {
  struct eigenshade_material_q15_t r;
  struct eigenshade_material_q15_t g;
  struct eigenshade_material_q15_t b;
} eigenshade_color_material_q15_t;

/** `eigenshade_color_transfer_f32_t` in Q15. */
typedef struct eigenshade_color_transfer_q15_t {
  struct eigenshade_transfer_q15_t r;
  struct eigenshade_transfer_q15_t g;
  struct eigenshade_transfer_q15_t b;
} eigenshade_color_transfer_q15_t;

/** `eigenshade_color_scene_f32_t` in Q15. */
typedef struct eigenshade_color_scene_q15_t {
  struct eigenshade_scene_q15_t r;
  struct eigenshade_scene_q15_t g;
  struct eigenshade_scene_q15_t b;
} eigenshade_color_scene_q15_t;

/** Memory for a turned light. */
typedef struct eigenshade_color_light_buffer_q15_t {
  /** Mantissas of the three channels. */
  int16_t mantissas[3][EIGENSHADE_LIGHT];
} eigenshade_color_light_buffer_q15_t;

/** Memory for a computed material. */
typedef struct eigenshade_color_material_buffer_q15_t {
  /** Mantissas of the three channels. */
  int16_t mantissas[3][EIGENSHADE_METALLIC_ROUGHNESS];
  /** Their exponents. */
  int8_t exponents[3][EIGENSHADE_METALLIC_ROUGHNESS_ORDER + 1];
} eigenshade_color_material_buffer_q15_t;

/** `eigenshade_color_baked_f32_t` in Q15. */
typedef struct eigenshade_color_baked_q15_t {
  size_t size;
  size_t length;
  const int16_t *texels;
  /** For each channel the exponent of its texels. */
  int32_t exponents[3];
} eigenshade_color_baked_q15_t;

/** `eigenshade_color_glossy_f32_t` in Q15. */
typedef struct eigenshade_color_glossy_q15_t {
  const struct eigenshade_color_scene_q15_t *scene;
  const struct eigenshade_gloss_f32_t *gloss;
  const struct eigenshade_source_f32_t *sources;
  size_t count;
} eigenshade_color_glossy_q15_t;

#ifdef __cplusplus
extern "C" {
#endif

/** Clips at white. */
extern const struct eigenshade_display_t eigenshade_display_linear;

/** Reinhard's curve: reaches white at 16. */
extern const struct eigenshade_display_t eigenshade_display_reinhard;

/** A fit to the curve of ACES. */
extern const struct eigenshade_display_t eigenshade_display_filmic;

/**
 * The picture of a material under a light.
 *
 * Uses 5 KB of stack. On an error `scene` is unchanged.
 */
eigenshade_status eigenshade_color_scene_f32(const struct eigenshade_color_light_f32_t *light,
                                             const struct eigenshade_color_material_f32_t *material,
                                             struct eigenshade_color_scene_f32_t *scene);

/**
 * The transfer of a material, for any number of lights.
 *
 * On an error `transfer` is unchanged.
 */
eigenshade_status eigenshade_color_transfer_f32(
    const struct eigenshade_color_material_f32_t *material,
    struct eigenshade_color_transfer_f32_t *transfer);

/**
 * The picture of a transferred material under a new light.
 *
 * On an error `scene` is unchanged, unless the transfer is refused: then its numbers are
 * meaningless.
 */
eigenshade_status eigenshade_color_relight_f32(
    const struct eigenshade_color_transfer_f32_t *transfer,
    const struct eigenshade_color_light_f32_t *light, struct eigenshade_color_scene_f32_t *scene);

/**
 * Writes three numbers, red, green and blue: the irradiance of the normal (x, y, z),
 * which may have any length.
 *
 * On an error `irradiance` is unchanged.
 */
eigenshade_status eigenshade_color_shade_f32(const struct eigenshade_color_scene_f32_t *scene,
                                             float x, float y, float z, float *irradiance);

/**
 * A light, of degree 12 at most, turned by the rotation of a quaternion (x, y, z, w):
 * L'(R v) = L(v) for every direction v.
 *
 * The turned light is in `buffer`, and `to` points there. On an error neither may be used.
 */
eigenshade_status eigenshade_color_turn_f32(const struct eigenshade_color_light_f32_t *from,
                                            const float *quaternion,
                                            struct eigenshade_color_light_buffer_f32_t *buffer,
                                            struct eigenshade_color_light_f32_t *to);

/**
 * A light turned about the view axis, from x toward y, by an angle, given by its cosine and sine:
 * much cheaper than any other axis. Their squares sum to 1 to within 2 %; they are scaled.
 *
 * The turned light is in `buffer`, and `to` points there. On an error neither may be used.
 */
eigenshade_status eigenshade_color_turn_about_view_f32(
    const struct eigenshade_color_light_f32_t *from, const float *cosine_and_sine,
    struct eigenshade_color_light_buffer_f32_t *buffer, struct eigenshade_color_light_f32_t *to);

/**
 * A glTF material from its linear base color, metallic and roughness, all from 0 to 1.
 *
 * A roughness below 0.2 is drawn as 0.2. The table's order
 * has to be 7 or more. The material is in `buffer`, and `to` points there. On an
 * error neither may be used.
 */
eigenshade_status eigenshade_color_metallic_roughness_f32(
    const float *base_color, float metallic, float roughness,
    struct eigenshade_color_material_buffer_f32_t *buffer,
    struct eigenshade_color_material_f32_t *to);

/**
 * One row of a sphere that fills a square of `diameter` x `diameter` pixels, 1 to 4096, into
 * `length` RGB565 pixels, at least `diameter`. Row 0 is the top.
 *
 * Pixels beside the sphere are unchanged, and on an error all of them. `exposure` is a number above
 * 0 that multiplies the irradiance.
 */
eigenshade_status eigenshade_color_disc_row_f32(const struct eigenshade_color_scene_f32_t *scene,
                                                size_t diameter, size_t row, float exposure,
                                                const struct eigenshade_display_t *display,
                                                uint16_t *pixels, size_t length);

/**
 * One row of the object of a normal map, into `length` RGB565 pixels, at least its width. Pixels
 * that the object covers in part are mixed with what they were.
 *
 * Other pixels are unchanged, and on an error all of them. The rest is as in
 * `eigenshade_color_disc_row_f32`.
 */
eigenshade_status eigenshade_color_normal_map_row_f32(
    const struct eigenshade_color_scene_f32_t *scene, const struct eigenshade_normal_map_t *map,
    size_t row, float exposure, const struct eigenshade_display_t *display, uint16_t *pixels,
    size_t length);

/**
 * Counts the pixels of one row of a sphere, to meter the exposure of its picture. The arguments are
 * those of `eigenshade_color_disc_row_f32`. Every fourth row of a small sphere will do.
 *
 * On an error `meter` is unchanged.
 */
eigenshade_status eigenshade_color_meter_disc_row_f32(
    const struct eigenshade_color_scene_f32_t *scene, size_t diameter, size_t row,
    struct eigenshade_meter_t *meter);

/** `eigenshade_color_meter_disc_row_f32` of the object of a normal map. */
eigenshade_status eigenshade_color_meter_normal_map_row_f32(
    const struct eigenshade_color_scene_f32_t *scene, const struct eigenshade_normal_map_t *map,
    size_t row, struct eigenshade_meter_t *meter);

/**
 * The exposure of the pixels that a meter has counted, in either format, to within 7 %.
 *
 * One pixel in a hundred is brighter than white. If that leaves the median pixel darker than 0.12 of
 * white, the exposure rises until the median has 0.12 or one pixel in ten is brighter than white. On
 * an error `exposure` is unchanged.
 */
eigenshade_status eigenshade_meter_exposure_f32(const struct eigenshade_meter_t *meter,
                                                float *exposure);

/**
 * Bakes a picture into maps of `size` x `size` texels, 2 to 4096. `length` is
 * 3 * size * size.
 *
 * A look-up costs less than a pixel of the scene and is less exact, as docs/method.md lists by size.
 * The texels are in `texels`, and `baked` points there. On an error
 * neither may be used.
 */
eigenshade_status eigenshade_color_bake_f32(const struct eigenshade_color_scene_f32_t *scene,
                                            size_t size, float *texels, size_t length,
                                            struct eigenshade_color_baked_f32_t *baked);

/** `eigenshade_color_shade_f32` from a baked picture. */
eigenshade_status eigenshade_color_baked_shade_f32(
    const struct eigenshade_color_baked_f32_t *baked, float x, float y, float z,
    float *irradiance);

/** `eigenshade_color_disc_row_f32` from a baked picture. */
eigenshade_status eigenshade_color_baked_disc_row_f32(
    const struct eigenshade_color_baked_f32_t *baked, size_t diameter, size_t row, float exposure,
    const struct eigenshade_display_t *display, uint16_t *pixels, size_t length);

/** `eigenshade_color_normal_map_row_f32` from a baked picture. */
eigenshade_status eigenshade_color_baked_normal_map_row_f32(
    const struct eigenshade_color_baked_f32_t *baked, const struct eigenshade_normal_map_t *map,
    size_t row, float exposure, const struct eigenshade_display_t *display, uint16_t *pixels,
    size_t length);

/**
 * A source turned by the rotation of a quaternion (x, y, z, w), as the light is that it was taken
 * out of.
 *
 * On an error `to` is unchanged.
 */
eigenshade_status eigenshade_source_turn_f32(const struct eigenshade_source_f32_t *from,
                                             const float *quaternion,
                                             struct eigenshade_source_f32_t *to);

/**
 * The gloss of a glTF material from its linear base color, metallic and roughness, all from 0 to 1.
 *
 * On an error `gloss` is unchanged.
 */
eigenshade_status eigenshade_gloss_metallic_roughness_f32(const float *base_color, float metallic,
                                                          float roughness,
                                                          struct eigenshade_gloss_f32_t *gloss);

/**
 * The fewest of a light's first sources with which pictures of a gloss are within `tolerance`, a
 * share of white: 0 from a roughness of 0.6 on, and `length` if all exceed it. `errors` is such as
 * `eigenshade_source_errors_lobby_f32[0]`, and `length` its number of rows, of six numbers each.
 *
 * On an error `count` is unchanged.
 */
eigenshade_status eigenshade_gloss_fewest_sources_f32(const struct eigenshade_gloss_f32_t *gloss,
                                                      const float *errors, size_t length,
                                                      float tolerance, size_t *count);

/**
 * A light without `count` sources, at most `EIGENSHADE_SOURCES`.
 *
 * The light is in `buffer`, and `to` points there. On an error neither may be used.
 */
eigenshade_status eigenshade_color_residual_f32(const struct eigenshade_color_light_f32_t *from,
                                                const struct eigenshade_source_f32_t *sources,
                                                size_t count,
                                                struct eigenshade_color_light_buffer_f32_t *buffer,
                                                struct eigenshade_color_light_f32_t *to);

/**
 * `eigenshade_color_shade_f32` with highlights.
 *
 * A call prepares all sources, which costs as much as two pixels for four of them.
 */
eigenshade_status eigenshade_color_glossy_shade_f32(
    const struct eigenshade_color_glossy_f32_t *glossy, float x, float y, float z,
    float *irradiance);

/** `eigenshade_color_disc_row_f32` with highlights. A call prepares all sources. */
eigenshade_status eigenshade_color_glossy_disc_row_f32(
    const struct eigenshade_color_glossy_f32_t *glossy, size_t diameter, size_t row, float exposure,
    const struct eigenshade_display_t *display, uint16_t *pixels, size_t length);

/** `eigenshade_color_normal_map_row_f32` with highlights. A call prepares all sources. */
eigenshade_status eigenshade_color_glossy_normal_map_row_f32(
    const struct eigenshade_color_glossy_f32_t *glossy, const struct eigenshade_normal_map_t *map,
    size_t row, float exposure, const struct eigenshade_display_t *display, uint16_t *pixels,
    size_t length);

/** `eigenshade_color_meter_disc_row_f32` with highlights. A call prepares all sources. */
eigenshade_status eigenshade_color_glossy_meter_disc_row_f32(
    const struct eigenshade_color_glossy_f32_t *glossy, size_t diameter, size_t row,
    struct eigenshade_meter_t *meter);

/** `eigenshade_color_meter_normal_map_row_f32` with highlights. A call prepares all sources. */
eigenshade_status eigenshade_color_glossy_meter_normal_map_row_f32(
    const struct eigenshade_color_glossy_f32_t *glossy, const struct eigenshade_normal_map_t *map,
    size_t row, struct eigenshade_meter_t *meter);

/** `eigenshade_color_scene_f32` in Q15. Uses 2 KB of stack. */
eigenshade_status eigenshade_color_scene_q15(const struct eigenshade_color_light_q15_t *light,
                                             const struct eigenshade_color_material_q15_t *material,
                                             struct eigenshade_color_scene_q15_t *scene);

/** `eigenshade_color_transfer_f32` in Q15. */
eigenshade_status eigenshade_color_transfer_q15(
    const struct eigenshade_color_material_q15_t *material,
    struct eigenshade_color_transfer_q15_t *transfer);

/** `eigenshade_color_relight_f32` in Q15. */
eigenshade_status eigenshade_color_relight_q15(
    const struct eigenshade_color_transfer_q15_t *transfer,
    const struct eigenshade_color_light_q15_t *light, struct eigenshade_color_scene_q15_t *scene);

/**
 * `eigenshade_color_shade_f32` in Q15: (x, y, z) has length 1, in fractions of 2^15, and the
 * numbers are times 2 to the exponent of their channel.
 */
eigenshade_status eigenshade_color_shade_q15(const struct eigenshade_color_scene_q15_t *scene,
                                             int16_t x, int16_t y, int16_t z, int32_t *irradiance);

/** `eigenshade_color_turn_f32` in Q15. The quaternion may have any scale. */
eigenshade_status eigenshade_color_turn_q15(const struct eigenshade_color_light_q15_t *from,
                                            const int32_t *quaternion,
                                            struct eigenshade_color_light_buffer_q15_t *buffer,
                                            struct eigenshade_color_light_q15_t *to);

/** `eigenshade_color_turn_about_view_f32` in Q15. Cosine and sine may have any scale. */
eigenshade_status eigenshade_color_turn_about_view_q15(
    const struct eigenshade_color_light_q15_t *from, const int32_t *cosine_and_sine,
    struct eigenshade_color_light_buffer_q15_t *buffer, struct eigenshade_color_light_q15_t *to);

/** `eigenshade_color_metallic_roughness_f32` in Q15, in which 1 is 32767. */
eigenshade_status eigenshade_color_metallic_roughness_q15(
    const int16_t *base_color, int16_t metallic, int16_t roughness,
    struct eigenshade_color_material_buffer_q15_t *buffer,
    struct eigenshade_color_material_q15_t *to);

/** `eigenshade_color_disc_row_f32` in Q15. The bits of `exposure` are read in integers. */
eigenshade_status eigenshade_color_disc_row_q15(const struct eigenshade_color_scene_q15_t *scene,
                                                size_t diameter, size_t row, float exposure,
                                                const struct eigenshade_display_t *display,
                                                uint16_t *pixels, size_t length);

/** `eigenshade_color_normal_map_row_f32` in Q15. */
eigenshade_status eigenshade_color_normal_map_row_q15(
    const struct eigenshade_color_scene_q15_t *scene, const struct eigenshade_normal_map_t *map,
    size_t row, float exposure, const struct eigenshade_display_t *display, uint16_t *pixels,
    size_t length);

/** `eigenshade_color_meter_disc_row_f32` in Q15. */
eigenshade_status eigenshade_color_meter_disc_row_q15(
    const struct eigenshade_color_scene_q15_t *scene, size_t diameter, size_t row,
    struct eigenshade_meter_t *meter);

/** `eigenshade_color_meter_normal_map_row_f32` in Q15. */
eigenshade_status eigenshade_color_meter_normal_map_row_q15(
    const struct eigenshade_color_scene_q15_t *scene, const struct eigenshade_normal_map_t *map,
    size_t row, struct eigenshade_meter_t *meter);

/** `eigenshade_color_bake_f32` in Q15, from a picture in float. */
eigenshade_status eigenshade_color_bake_q15(const struct eigenshade_color_scene_f32_t *scene,
                                            size_t size, int16_t *texels, size_t length,
                                            struct eigenshade_color_baked_q15_t *baked);

/** `eigenshade_color_baked_shade_f32` in Q15, with the exponents of the picture. */
eigenshade_status eigenshade_color_baked_shade_q15(
    const struct eigenshade_color_baked_q15_t *baked, int16_t x, int16_t y, int16_t z,
    int32_t *irradiance);

/** `eigenshade_color_baked_disc_row_f32` in Q15. */
eigenshade_status eigenshade_color_baked_disc_row_q15(
    const struct eigenshade_color_baked_q15_t *baked, size_t diameter, size_t row, float exposure,
    const struct eigenshade_display_t *display, uint16_t *pixels, size_t length);

/** `eigenshade_color_baked_normal_map_row_f32` in Q15. */
eigenshade_status eigenshade_color_baked_normal_map_row_q15(
    const struct eigenshade_color_baked_q15_t *baked, const struct eigenshade_normal_map_t *map,
    size_t row, float exposure, const struct eigenshade_display_t *display, uint16_t *pixels,
    size_t length);

/** `eigenshade_color_residual_f32` in Q15, from light and sources in float. */
eigenshade_status eigenshade_color_residual_q15(const struct eigenshade_color_light_f32_t *from,
                                                const struct eigenshade_source_f32_t *sources,
                                                size_t count,
                                                struct eigenshade_color_light_buffer_q15_t *buffer,
                                                struct eigenshade_color_light_q15_t *to);

/**
 * `eigenshade_color_glossy_shade_f32` in Q15. Without a float unit, a call prepares each source
 * in some 20,000 instructions.
 */
eigenshade_status eigenshade_color_glossy_shade_q15(
    const struct eigenshade_color_glossy_q15_t *glossy, int16_t x, int16_t y, int16_t z,
    int32_t *irradiance);

/** `eigenshade_color_glossy_disc_row_f32` in Q15. */
eigenshade_status eigenshade_color_glossy_disc_row_q15(
    const struct eigenshade_color_glossy_q15_t *glossy, size_t diameter, size_t row, float exposure,
    const struct eigenshade_display_t *display, uint16_t *pixels, size_t length);

/** `eigenshade_color_glossy_normal_map_row_f32` in Q15. */
eigenshade_status eigenshade_color_glossy_normal_map_row_q15(
    const struct eigenshade_color_glossy_q15_t *glossy, const struct eigenshade_normal_map_t *map,
    size_t row, float exposure, const struct eigenshade_display_t *display, uint16_t *pixels,
    size_t length);

/** `eigenshade_color_glossy_meter_disc_row_f32` in Q15. */
eigenshade_status eigenshade_color_glossy_meter_disc_row_q15(
    const struct eigenshade_color_glossy_q15_t *glossy, size_t diameter, size_t row,
    struct eigenshade_meter_t *meter);

/** `eigenshade_color_glossy_meter_normal_map_row_f32` in Q15. */
eigenshade_status eigenshade_color_glossy_meter_normal_map_row_q15(
    const struct eigenshade_color_glossy_q15_t *glossy, const struct eigenshade_normal_map_t *map,
    size_t row, struct eigenshade_meter_t *meter);

#ifdef __cplusplus
}
#endif

#endif
