/* eigenshade: pictures of any isotropic material under any distant light, from coefficients to
pixels, in float (f32) and in integers (q15). The shipped lights and materials are in
`eigenshade_presets.h`. The table is of degree EIGENSHADE_DEGREE and order EIGENSHADE_ORDER: the
shipped one is 9 and 7.

The steps are: begin the picture of a light, a material and small bright sources of light, then draw
it into a target; or keep the transfer of a material, and relight it with each new light. For many
frames a second, fill a palette from each picture and draw from the palette. A textured object is
drawn from linear palettes, each filled from the pictures of both materials of a region. An object
with shadows has its material in its file: find its coefficients under a light, then the colors of
its codes, and draw from these. A number in integers is a mantissa times 2 to the power of an
exponent. All functions in q15 do without a float unit, except `eigenshade_picture_bake_q15` and
those that read sources. Integers give the same bits on every machine.

The caller owns every array and structure, and need not initialize those that the library
writes. No function allocates, keeps a pointer, or has state, so all may be called from
interrupts and threads at once on separate arguments. Each pointer points to a value of its type, or
to as many as the function says. Pointers must not be NULL and must be aligned; both are checked.
Arguments that a function writes to must not overlap its other arguments; this is checked too.
Lengths are counts of numbers, not bytes; that of a target is in bytes.

`crates/capi/run header` writes this file. */

#ifndef EIGENSHADE_H
#define EIGENSHADE_H

#include "eigenshade_table.h"

#include <stddef.h>
#include <stdint.h>

/** The version of this header: compare it with `eigenshade_version()`. */
#define EIGENSHADE_VERSION "0.1.0"


/**
 * The result of every function that can fail: 0, or the reason why it did nothing.
 */
enum eigenshade_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /**
   * Success.
   */
  EIGENSHADE_STATUS_OK = 0,
  /**
   * A pointer is NULL.
   */
  EIGENSHADE_STATUS_NULL_POINTER = 1,
  /**
   * A pointer is not aligned for its type.
   */
  EIGENSHADE_STATUS_UNALIGNED = 2,
  /**
   * An array that is written to overlaps another.
   */
  EIGENSHADE_STATUS_OVERLAP = 3,
  /**
   * The degree of a light is above EIGENSHADE_DEGREE, or above that of an object with shadows.
   */
  EIGENSHADE_STATUS_LIGHT_BEYOND = 4,
  /**
   * A light does not have (degree + 1)^2 coefficients.
   */
  EIGENSHADE_STATUS_LIGHT_LENGTH = 5,
  /**
   * The order of a material is above EIGENSHADE_ORDER.
   */
  EIGENSHADE_STATUS_MATERIAL_BEYOND = 6,
  /**
   * A material does not have the number of coefficients of its order, or an exponent for each o.
   */
  EIGENSHADE_STATUS_MATERIAL_LENGTH = 7,
  /**
   * An exponent is out of its range.
   */
  EIGENSHADE_STATUS_EXPONENT = 8,
  /**
   * A normal has a component that is not finite, length zero, or, in integers, a length other
   * than 1.
   */
  EIGENSHADE_STATUS_NORMAL = 9,
  /**
   * A normal points away from the camera.
   */
  EIGENSHADE_STATUS_HIDDEN = 10,
  /**
   * An array is larger than memory.
   */
  EIGENSHADE_STATUS_COUNT = 11,
  /**
   * A fault of the library.
   */
  EIGENSHADE_STATUS_INTERNAL = 12,
  /**
   * A row of a transfer is so large that its sum with a light could overflow: no function of
   * this library computed it.
   */
  EIGENSHADE_STATUS_TRANSFER = 13,
  /**
   * A coefficient of a light or a material is infinite or NaN.
   */
  EIGENSHADE_STATUS_NOT_FINITE = 14,
  /**
   * A color, metallic or roughness is not from 0 to 1.
   */
  EIGENSHADE_STATUS_OUTSIDE = 15,
  /**
   * A quaternion, or cosine and sine, are zero or not finite; or, in f32, cosine² + sine²
   * differs from 1 by more than 2 %.
   */
  EIGENSHADE_STATUS_ROTATION = 16,
  /**
   * The object has no such row.
   */
  EIGENSHADE_STATUS_ROW = 17,
  /**
   * A disc has no pixel, or more than 4096 across.
   */
  EIGENSHADE_STATUS_DIAMETER = 18,
  /**
   * A normal map has no pixel, or not two bytes for each.
   */
  EIGENSHADE_STATUS_NORMAL_MAP = 19,
  /**
   * An exposure is not a number above 0.
   */
  EIGENSHADE_STATUS_EXPOSURE = 20,
  /**
   * A baked map does not have 2 to 4096 texels a side, or its length is not three times the
   * square of a side.
   */
  EIGENSHADE_STATUS_BAKED = 21,
  /**
   * A source has wrong numbers, or there are more than EIGENSHADE_SOURCES.
   */
  EIGENSHADE_STATUS_SOURCE = 22,
  /**
   * A light above degree 12, beyond which none is turned.
   */
  EIGENSHADE_STATUS_TURN = 23,
  /**
   * A picture that was never begun, such as one of zeros.
   */
  EIGENSHADE_STATUS_PICTURE = 24,
  /**
   * A meter has counted no pixel, or only black ones.
   */
  EIGENSHADE_STATUS_DARK = 25,
  /**
   * A picture with highlights, which are too sharp for a baked map.
   */
  EIGENSHADE_STATUS_HIGHLIGHTS = 26,
  /**
   * A number that is none of `eigenshade_effect`.
   */
  EIGENSHADE_STATUS_EFFECT = 27,
  /**
   * A target has no pixel, its rows do not fit its stride and length, or the rows of
   * `EIGENSHADE_ENCODING_RGB565` have an odd stride.
   */
  EIGENSHADE_STATUS_TARGET = 28,
  /**
   * A number that is none of `eigenshade_encoding`.
   */
  EIGENSHADE_STATUS_ENCODING = 29,
  /**
   * A palette that was never filled, such as one of zeros.
   */
  EIGENSHADE_STATUS_PALETTE = 30,
  /**
   * Nodes that were never found, such as those of zeros.
   */
  EIGENSHADE_STATUS_NODES = 31,
  /**
   * The bytes of an object, textured or with shadows, are something else, or were cut or changed.
   */
  EIGENSHADE_STATUS_OBJECT = 32,
  /**
   * A textured object has no region of this number, or more regions than there are palettes.
   */
  EIGENSHADE_STATUS_REGION = 33,
  /**
   * The colors of an object with shadows have the wrong number of bytes: one pixel of the encoding for
   * each of its codes.
   */
  EIGENSHADE_STATUS_COLORS = 34,
  /**
   * Coefficients of an object that were never found, such as those of zeros.
   */
  EIGENSHADE_STATUS_COEFFICIENTS = 35,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum eigenshade_status eigenshade_status;
#else
typedef int32_t eigenshade_status;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * A part of a picture: the picture of a masked light on a material masked for the same effect. The
 * pictures of all four sum to the whole.
 */
enum eigenshade_effect
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /**
   * l = 0: light that is the same from everywhere.
   */
  EIGENSHADE_EFFECT_AMBIENT = 0,
  /**
   * l >= 1, o = 0: the light's directions on a Lambertian material.
   */
  EIGENSHADE_EFFECT_DIFFUSE = 1,
  /**
   * l >= 1, 1 <= o <= 3: rough, backscattering and rim lobes.
   */
  EIGENSHADE_EFFECT_BROAD = 2,
  /**
   * l >= 1, o >= 4: highlights.
   */
  EIGENSHADE_EFFECT_GLOSS = 3,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum eigenshade_effect eigenshade_effect;
#else
typedef int32_t eigenshade_effect;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * How the pixels of a target are stored.
 */
enum eigenshade_encoding
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /**
   * RGB565 in the processor's byte order, red in the highest bits: frame buffers, and LVGL.
   */
  EIGENSHADE_ENCODING_RGB565 = 0,
  /**
   * RGB565 with the high byte first, as most displays on SPI take it.
   */
  EIGENSHADE_ENCODING_RGB565_HIGH_FIRST = 1,
  /**
   * RGB888: the bytes red, green and blue.
   */
  EIGENSHADE_ENCODING_RGB888 = 2,
  /**
   * RGBA8888: the bytes red, green, blue and opacity. Over zeros, an object has the opacity of
   * its coverage, and is transparent around it.
   */
  EIGENSHADE_ENCODING_RGBA8888 = 3,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum eigenshade_encoding eigenshade_encoding;
#else
typedef int32_t eigenshade_encoding;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * A tone curve and the sRGB encoding, as a table of 774 bytes: `eigenshade_display_linear` clips
 * colors brighter than white, `eigenshade_display_reinhard` and `eigenshade_display_filmic`
 * compress them.
 */
typedef struct eigenshade_display_t eigenshade_display_t;

/**
 * A small bright source of light, as `eigenshade light --sources` writes it. May be kept in flash.
 */
typedef struct eigenshade_source_f32_t {
  /**
   * A unit vector from the object to the light, in the camera's frame.
   */
  float direction[3];
  /**
   * The integral of radiance over solid angle: red, green and blue, at least 0.
   */
  float energy[3];
  /**
   * The standard deviation of the round blob in radians, from 0 to 0.5.
   */
  float spread;
} eigenshade_source_f32_t;

/**
 * A GGX lobe over a matte base; all numbers are from 0 to 1. May be kept in flash.
 */
typedef struct eigenshade_gloss_f32_t {
  /**
   * The roughness; below 0.065 it counts as 0.065.
   */
  float roughness;
  /**
   * The reflectance at normal incidence: the base color of a metal, 0.04 of other materials.
   */
  float reflectance[3];
  /**
   * The reflectance at grazing incidence, usually 1.
   */
  float grazing[3];
  /**
   * The color of the matte base: 0 of a metal.
   */
  float albedo[3];
} eigenshade_gloss_f32_t;

/**
 * The brightness of a picture's pixels, to meter its exposure. A meter of zeros has counted
 * nothing.
 */
typedef struct eigenshade_meter_t {
  /**
   * Private to the library.
   */
  uint32_t counts[257];
} eigenshade_meter_t;

/**
 * The visible normals of an object, as `eigenshade pack-object` makes them from a mesh or a
 * normal map. May be kept in flash.
 */
typedef struct eigenshade_normal_map_t {
  /**
   * Pixels across.
   */
  size_t width;
  /**
   * Pixels down.
   */
  size_t height;
  /**
   * Number of bytes: 2 * width * height.
   */
  size_t length;
  /**
   * Two bytes for each pixel, row by row from the top; the caller's.
   */
  const uint8_t *codes;
} eigenshade_normal_map_t;

/**
 * The nodes of a palette that an object needs, once they were found.
 */
typedef struct eigenshade_nodes_t {
  /**
   * Private to the library.
   */
  uint64_t words[EIGENSHADE_NODES];
} eigenshade_nodes_t;

/**
 * The colors of one material under one light, by normal, once it was filled: 8.7 KB. It has no
 * pointers, so it may be moved.
 */
typedef struct eigenshade_palette_t {
  /**
   * Private to the library.
   */
  uint32_t words[EIGENSHADE_PALETTE];
} eigenshade_palette_t;

/**
 * A window of pixels that objects are drawn into, such as a screen, a part of it or a band of its
 * rows, and the place of the object.
 *
 * What is outside of the window is not drawn. Pixels that an object covers in part are mixed with
 * what is there, so clear a buffer before each frame.
 */
typedef struct eigenshade_target_t {
  /**
   * The pixel at the window's top left; the caller's.
   */
  void *pixels;
  /**
   * Number of bytes from there on, at least to the window's last pixel.
   */
  size_t length;
  /**
   * Bytes from a row to the next, an even number in `EIGENSHADE_ENCODING_RGB565`. Not used if
   * there is one row.
   */
  size_t stride;
  /**
   * Pixels across the window.
   */
  size_t width;
  /**
   * Pixels down the window.
   */
  size_t height;
  /**
   * The column of the window where the object's left border is. May be below 0.
   */
  int32_t x;
  /**
   * The row of the window where the object's upper border is, counted from the top. May be
   * below 0.
   */
  int32_t y;
  /**
   * One of `eigenshade_encoding`.
   */
  int32_t encoding;
} eigenshade_target_t;

/**
 * A textured object, as `eigenshade pack-object` writes it. May be kept in flash.
 */
typedef struct eigenshade_object_t {
  /**
   * Number of bytes.
   */
  size_t length;
  /**
   * The file; the caller's.
   */
  const uint8_t *bytes;
} eigenshade_object_t;

/**
 * The size of a textured object and the number of its regions.
 */
typedef struct eigenshade_object_header_t {
  /**
   * Pixels across.
   */
  size_t width;
  /**
   * Pixels down.
   */
  size_t height;
  /**
   * Number of regions.
   */
  size_t regions;
} eigenshade_object_header_t;

/**
 * The irradiances of a region of a textured object under one light, by normal, once it was filled:
 * 13 KB. It has no pointers, so it may be moved.
 */
typedef struct eigenshade_linear_palette_t {
  /**
   * Private to the library.
   */
  uint32_t words[EIGENSHADE_LINEAR_PALETTE];
} eigenshade_linear_palette_t;

/**
 * An object with shadows, as `eigenshade pack-object --shadows` writes it. May be kept in flash.
 */
typedef struct eigenshade_shadowed_object_t {
  /**
   * Number of bytes.
   */
  size_t length;
  /**
   * The file; the caller's.
   */
  const uint8_t *bytes;
} eigenshade_shadowed_object_t;

/**
 * The size of an object with shadows, the number of its codes, and the degree of its light.
 */
typedef struct eigenshade_shadowed_object_header_t {
  /**
   * Pixels across.
   */
  size_t width;
  /**
   * Pixels down.
   */
  size_t height;
  /**
   * Number of codes: as many colors a frame has.
   */
  size_t codes;
  /**
   * The largest degree of a light.
   */
  size_t degree;
} eigenshade_shadowed_object_header_t;

/**
 * The coefficients of an object with shadows under one light, once they were found. It has no
 * pointers, so it may be moved.
 */
typedef struct eigenshade_object_coefficients_t {
  /**
   * Private to the library.
   */
  uint32_t words[EIGENSHADE_OBJECT_COEFFICIENTS];
} eigenshade_object_coefficients_t;

/**
 * One channel of distant light: spherical harmonic coefficients L_l^m in radiance, l from 0, m
 * from -l to l, each at l*l + l + m.
 *
 * The harmonics carry the Condon-Shortley phase, x points to the right, y up, z to the
 * camera.
 */
typedef struct eigenshade_light_f32_t {
  /**
   * Largest l, at most EIGENSHADE_DEGREE; above it the light is zero.
   */
  size_t degree;
  /**
   * Number of coefficients: (degree + 1)^2.
   */
  size_t length;
  /**
   * The coefficients; the caller's.
   */
  const float *coefficients;
} eigenshade_light_f32_t;

/**
 * One channel of an isotropic material: Koenderink-van Doorn coefficients b_op^q of its
 * BRDF in 1/sr, by o, then p, then q: 000, 111, 200, 220, 222, 311, ... White matte is
 * the one coefficient 2.
 */
typedef struct eigenshade_material_f32_t {
  /**
   * Largest o, at most EIGENSHADE_ORDER; above it the material is zero.
   */
  size_t order;
  /**
   * Number of coefficients: 1, 2, 5, 8, 14, 20, 30, 40 for orders 0 to 7.
   */
  size_t length;
  /**
   * The coefficients; the caller's.
   */
  const float *coefficients;
} eigenshade_material_f32_t;

/**
 * Scratch memory; holds nothing between two calls.
 */
typedef struct eigenshade_workspace_f32_t {
  /**
   * Scratch.
   */
  float numbers[EIGENSHADE_WORKSPACE_F32];
} eigenshade_workspace_f32_t;

/**
 * The coefficients d of one image, component by component.
 */
typedef struct eigenshade_coefficients_f32_t {
  /**
   * d.
   */
  float numbers[EIGENSHADE_COMPONENTS];
} eigenshade_coefficients_f32_t;

/**
 * An isotropic material in three channels. The channels of a gray material point to the same
 * numbers.
 */
typedef struct eigenshade_color_material_f32_t {
  /**
   * Red.
   */
  struct eigenshade_material_f32_t r;
  /**
   * Green.
   */
  struct eigenshade_material_f32_t g;
  /**
   * Blue.
   */
  struct eigenshade_material_f32_t b;
} eigenshade_color_material_f32_t;

/**
 * The transfer of a material in three channels. May be kept in flash.
 */
typedef struct eigenshade_transfer_f32_t {
  /**
   * The numbers of red, green and blue.
   */
  float numbers[3][EIGENSHADE_TRANSFER_F32];
} eigenshade_transfer_f32_t;

/**
 * Distant light in three channels.
 */
typedef struct eigenshade_color_light_f32_t {
  /**
   * Red.
   */
  struct eigenshade_light_f32_t r;
  /**
   * Green.
   */
  struct eigenshade_light_f32_t g;
  /**
   * Blue.
   */
  struct eigenshade_light_f32_t b;
} eigenshade_color_light_f32_t;

/**
 * A picture, once it was begun. A picture has no pointers, so it may be moved.
 */
typedef struct eigenshade_picture_f32_t {
  /**
   * Private to the library.
   */
  uint64_t words[EIGENSHADE_PICTURE_F32];
} eigenshade_picture_f32_t;

/**
 * The irradiance of a normal, in the light's radiance times sr times the material's 1/sr.
 */
typedef struct eigenshade_irradiance_f32_t {
  /**
   * Red.
   */
  float r;
  /**
   * Green.
   */
  float g;
  /**
   * Blue.
   */
  float b;
} eigenshade_irradiance_f32_t;

/**
 * A picture baked into three square maps, one for each channel. May be kept in flash.
 */
typedef struct eigenshade_baked_f32_t {
  /**
   * Texels a side, 2 to 4096.
   */
  size_t size;
  /**
   * Number of texels: 3 * size * size.
   */
  size_t length;
  /**
   * The texels of red, then of green, then of blue; the caller's.
   */
  const float *texels;
} eigenshade_baked_f32_t;

/**
 * Memory for a turned or masked light, or for one without its sources.
 */
typedef struct eigenshade_light_buffer_f32_t {
  /**
   * Coefficients of the three channels.
   */
  float numbers[3][EIGENSHADE_LIGHT];
} eigenshade_light_buffer_f32_t;

/**
 * Memory for a computed or masked material.
 */
typedef struct eigenshade_material_buffer_f32_t {
  /**
   * Coefficients of the three channels.
   */
  float numbers[3][EIGENSHADE_MATERIAL_BUFFER];
} eigenshade_material_buffer_f32_t;

/**
 * One channel of distant light: as `eigenshade_light_f32_t`, in mantissas times 2^exponent.
 */
typedef struct eigenshade_light_q15_t {
  /**
   * Largest l, at most EIGENSHADE_DEGREE; above it the light is zero.
   */
  size_t degree;
  /**
   * Number of mantissas: (degree + 1)^2.
   */
  size_t length;
  /**
   * The mantissas; the caller's. The more bits the largest has, the better.
   */
  const int16_t *mantissas;
  /**
   * The exponent of all mantissas, from -128 to 128.
   */
  int32_t exponent;
} eigenshade_light_q15_t;

/**
 * One channel of an isotropic material: as `eigenshade_material_f32_t`, in mantissas times
 * 2^exponent, an exponent for each o.
 */
typedef struct eigenshade_material_q15_t {
  /**
   * Largest o, at most EIGENSHADE_ORDER; above it the material is zero.
   */
  size_t order;
  /**
   * Number of mantissas: 1, 2, 5, 8, 14, 20, 30, 40 for orders 0 to 7.
   */
  size_t length;
  /**
   * The mantissas; the caller's. The more bits the largest of each o has, the better.
   */
  const int16_t *mantissas;
  /**
   * Number of exponents: order + 1.
   */
  size_t exponents_length;
  /**
   * For each o the exponent of its mantissas; the caller's.
   */
  const int8_t *exponents;
} eigenshade_material_q15_t;

/**
 * Scratch memory; holds nothing between two calls.
 */
typedef struct eigenshade_workspace_q15_t {
  /**
   * Scratch.
   */
  int32_t numbers[EIGENSHADE_WORKSPACE_Q15];
  /**
   * A channel of a transfer.
   */
  int16_t transfer[EIGENSHADE_TRANSFER_Q15];
  /**
   * The exponents of the transfer.
   */
  int16_t exponents[EIGENSHADE_PROFILES];
} eigenshade_workspace_q15_t;

/**
 * The coefficients d of one image, component by component: mantissas times 2^exponent.
 */
typedef struct eigenshade_coefficients_q15_t {
  /**
   * Mantissas of at most 2^30.
   */
  int32_t mantissas[EIGENSHADE_COMPONENTS];
  /**
   * The exponent of all mantissas.
   */
  int32_t exponent;
} eigenshade_coefficients_q15_t;

/**
 * An isotropic material in three channels. The channels of a gray material point to the same
 * numbers.
 */
typedef struct eigenshade_color_material_q15_t {
  /**
   * Red.
   */
  struct eigenshade_material_q15_t r;
  /**
   * Green.
   */
  struct eigenshade_material_q15_t g;
  /**
   * Blue.
   */
  struct eigenshade_material_q15_t b;
} eigenshade_color_material_q15_t;

/**
 * The transfer of a material in three channels. May be kept in flash.
 */
typedef struct eigenshade_transfer_q15_t {
  /**
   * The mantissas of red, green and blue.
   */
  int16_t numbers[3][EIGENSHADE_TRANSFER_Q15];
  /**
   * The exponents of red, green and blue.
   */
  int16_t exponents[3][EIGENSHADE_PROFILES];
} eigenshade_transfer_q15_t;

/**
 * Distant light in three channels.
 */
typedef struct eigenshade_color_light_q15_t {
  /**
   * Red.
   */
  struct eigenshade_light_q15_t r;
  /**
   * Green.
   */
  struct eigenshade_light_q15_t g;
  /**
   * Blue.
   */
  struct eigenshade_light_q15_t b;
} eigenshade_color_light_q15_t;

/**
 * A picture, once it was begun. A picture has no pointers, so it may be moved.
 */
typedef struct eigenshade_picture_q15_t {
  /**
   * Private to the library.
   */
  uint64_t words[EIGENSHADE_PICTURE_Q15];
} eigenshade_picture_q15_t;

/**
 * The irradiance of a normal: mantissas times 2^exponent, in the light's radiance times sr times
 * the material's 1/sr.
 */
typedef struct eigenshade_irradiance_q15_t {
  /**
   * Red.
   */
  int32_t r;
  /**
   * Green.
   */
  int32_t g;
  /**
   * Blue.
   */
  int32_t b;
  /**
   * The exponents of red, green and blue: the same for all normals of a picture.
   */
  int32_t exponents[3];
} eigenshade_irradiance_q15_t;

/**
 * A picture baked into three square maps, one for each channel. May be kept in flash.
 */
typedef struct eigenshade_baked_q15_t {
  /**
   * Texels a side, 2 to 4096.
   */
  size_t size;
  /**
   * Number of texels: 3 * size * size.
   */
  size_t length;
  /**
   * The texels of red, then of green, then of blue; the caller's.
   */
  const int16_t *texels;
  /**
   * For each channel the exponent of its texels.
   */
  int32_t exponents[3];
} eigenshade_baked_q15_t;

/**
 * Memory for a turned, masked or quantized light, or for one without its sources.
 */
typedef struct eigenshade_light_buffer_q15_t {
  /**
   * Mantissas of the three channels.
   */
  int16_t mantissas[3][EIGENSHADE_LIGHT];
} eigenshade_light_buffer_q15_t;

/**
 * Memory for a computed, masked or quantized material.
 */
typedef struct eigenshade_material_buffer_q15_t {
  /**
   * Mantissas of the three channels.
   */
  int16_t mantissas[3][EIGENSHADE_MATERIAL_BUFFER];
  /**
   * The exponents of red, green and blue.
   */
  int8_t exponents[3][EIGENSHADE_MATERIAL_EXPONENTS];
} eigenshade_material_buffer_q15_t;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * Clips at white.
 */
extern const struct eigenshade_display_t eigenshade_display_linear;

/**
 * Reinhard's curve: reaches white at 16.
 */
extern const struct eigenshade_display_t eigenshade_display_reinhard;

/**
 * A fit to the curve of ACES.
 */
extern const struct eigenshade_display_t eigenshade_display_filmic;

/**
 * The library's version, a static string: compare it with EIGENSHADE_VERSION of the header.
 * Never fails.
 */
const char *eigenshade_version(void);

/**
 * A checksum of the sizes of the library's table. If the checksum is not `EIGENSHADE_TABLE`, the
 * headers belong to another library: do not call this one. Tables of the same sizes have the same
 * checksum.
 */
uint32_t eigenshade_table(void);

/**
 * The message of a status, with the remedy: a static string in English without a line end.
 *
 * Never fails: an unknown status has a message too.
 */
const char *eigenshade_message(int32_t status);

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
 * The gloss of a glTF material from its linear base color, metallic and roughness, all from 0 to
 * 1.
 *
 * On an error `gloss` is unchanged.
 */
eigenshade_status eigenshade_gloss_metallic_roughness_f32(const float *base_color,
                                                          float metallic,
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
                                                      const float *errors,
                                                      size_t length,
                                                      float tolerance,
                                                      size_t *count);

/**
 * The exposure of the pixels that a meter has counted, in either format, to within 7 %.
 *
 * One pixel in a hundred is brighter than white. If the median pixel is then darker than 0.12 of
 * white, the exposure rises until the median has 0.12 or one pixel in ten is brighter than white.
 * On an error `exposure` is unchanged.
 */
eigenshade_status eigenshade_meter_exposure_f32(const struct eigenshade_meter_t *meter,
                                                float *exposure);

/**
 * Writes the codes of the normal map of a sphere of `diameter` x `diameter` pixels, 1 to 4096.
 * `length` is 2 * diameter * diameter bytes. Cost: a root and divisions of 64 bits for a quarter
 * of the pixels, once.
 *
 * On an error `codes` is unchanged.
 */
eigenshade_status eigenshade_normal_map_sphere(size_t diameter, uint8_t *codes, size_t length);

/**
 * Finds the nodes of a palette that the object of a normal map needs, once for a map: fewer than
 * all of them.
 *
 * On an error `nodes` is unchanged.
 */
eigenshade_status eigenshade_nodes_of_normal_map(const struct eigenshade_normal_map_t *map,
                                                 struct eigenshade_nodes_t *nodes);

/**
 * Draws the object of a normal map from a palette, which `eigenshade_palette_fill_f32` or `_q15`
 * filled for the nodes of the object.
 *
 * On an error no pixel is changed.
 */
eigenshade_status eigenshade_palette_draw(const struct eigenshade_palette_t *palette,
                                          const struct eigenshade_normal_map_t *map,
                                          const struct eigenshade_target_t *target);

/**
 * `eigenshade_palette_draw` with ordered dithering of RGB565, which hides its steps.
 */
eigenshade_status eigenshade_palette_draw_dithered(const struct eigenshade_palette_t *palette,
                                                   const struct eigenshade_normal_map_t *map,
                                                   const struct eigenshade_target_t *target);

/**
 * The size of a textured object, and its number of regions. All bytes are checked: some
 * instructions for each row and each run.
 *
 * On an error `header` is unchanged.
 */
eigenshade_status eigenshade_object_header(const struct eigenshade_object_t *object,
                                           struct eigenshade_object_header_t *header);

/**
 * Finds the nodes of a linear palette that a region of a textured object needs, once for an object.
 *
 * On an error `nodes` is unchanged.
 */
eigenshade_status eigenshade_nodes_of_region(const struct eigenshade_object_t *object,
                                             size_t region,
                                             struct eigenshade_nodes_t *nodes);

/**
 * Draws a textured object from `count` linear palettes, one for each region in their order, which
 * `eigenshade_linear_palette_fill_f32` or `_q15` filled for the nodes of the region.
 *
 * The bytes of the rows that the target has are checked. On an error no pixel is changed.
 */
eigenshade_status eigenshade_object_draw(const struct eigenshade_object_t *object,
                                         const struct eigenshade_linear_palette_t *palettes,
                                         size_t count,
                                         const struct eigenshade_display_t *display,
                                         const struct eigenshade_target_t *target);

/**
 * `eigenshade_object_draw` with ordered dithering of RGB565, which hides its steps.
 */
eigenshade_status eigenshade_object_draw_dithered(const struct eigenshade_object_t *object,
                                                  const struct eigenshade_linear_palette_t *palettes,
                                                  size_t count,
                                                  const struct eigenshade_display_t *display,
                                                  const struct eigenshade_target_t *target);

/**
 * The size of an object with shadows, its number of codes and the degree of its light. All bytes are
 * checked, here and in the functions below: some instructions for each row, each run and each cluster.
 *
 * On an error `header` is unchanged.
 */
eigenshade_status eigenshade_shadowed_object_header(const struct eigenshade_shadowed_object_t *object,
                                                    struct eigenshade_shadowed_object_header_t *header);

/**
 * Writes the colors of the codes of an object with shadows, from coefficients that
 * `eigenshade_shadowed_object_coefficients_f32` or `_q15` found for this object. `encoding` is one of
 * `eigenshade_encoding`, and `length` is the number of bytes: one pixel for each code.
 *
 * On an error `colors` is unchanged.
 */
eigenshade_status eigenshade_shadowed_object_colors(const struct eigenshade_shadowed_object_t *object,
                                                    const struct eigenshade_object_coefficients_t *coefficients,
                                                    float exposure,
                                                    const struct eigenshade_display_t *display,
                                                    int32_t encoding,
                                                    void *colors,
                                                    size_t length);

/**
 * Draws an object with shadows in the colors of its codes, in the encoding of the target. `length` is
 * the number of bytes of the colors.
 *
 * On an error no pixel is changed.
 */
eigenshade_status eigenshade_shadowed_object_draw(const struct eigenshade_shadowed_object_t *object,
                                                  const void *colors,
                                                  size_t length,
                                                  const struct eigenshade_target_t *target);

/**
 * The coefficients d of a light on a material in one channel, as numbers.
 *
 * Cost: a multiplication for each of the table's factors. On an error `coefficients` is unchanged.
 */
eigenshade_status eigenshade_project_f32(const struct eigenshade_light_f32_t *light,
                                         const struct eigenshade_material_f32_t *material,
                                         struct eigenshade_workspace_f32_t *workspace,
                                         struct eigenshade_coefficients_f32_t *coefficients);

/**
 * The transfer of a material, for any number of lights. A gray material takes the computation of
 * one channel.
 *
 * On an error `transfer` is unchanged.
 */
eigenshade_status eigenshade_transfer_f32(const struct eigenshade_color_material_f32_t *material,
                                          struct eigenshade_transfer_f32_t *transfer);

/**
 * Begins the picture of a material under a light: computes all that its pixels have in common.
 *
 * Uses 5 KB of stack. On an error `picture` is unchanged.
 */
eigenshade_status eigenshade_picture_begin_f32(const struct eigenshade_color_light_f32_t *light,
                                               const struct eigenshade_color_material_f32_t *material,
                                               struct eigenshade_picture_f32_t *picture);

/**
 * Begins the picture of a glossy material under a light with `count` small sources, at most
 * EIGENSHADE_SOURCES: they are taken out of the light, and become sharp highlights. If `count` is
 * 0, `sources` is not read.
 *
 * Uses 8 KB of stack. On an error `picture` is unchanged.
 */
eigenshade_status eigenshade_picture_begin_glossy_f32(const struct eigenshade_color_light_f32_t *light,
                                                      const struct eigenshade_color_material_f32_t *material,
                                                      const struct eigenshade_gloss_f32_t *gloss,
                                                      const struct eigenshade_source_f32_t *sources,
                                                      size_t count,
                                                      struct eigenshade_picture_f32_t *picture);

/**
 * Begins the picture of a transferred material under a new light, without highlights.
 *
 * On an error `picture` is unchanged.
 */
eigenshade_status eigenshade_picture_relight_f32(const struct eigenshade_transfer_f32_t *transfer,
                                                 const struct eigenshade_color_light_f32_t *light,
                                                 struct eigenshade_picture_f32_t *picture);

/**
 * Gives a picture the highlights of `count` sources, at most EIGENSHADE_SOURCES, in place of any
 * earlier highlights. The picture's light has to be without these sources, as
 * `eigenshade_residual_f32` makes it. Where a light turns, turn the residual and the sources.
 *
 * On an error `picture` has no highlights, or is unchanged.
 */
eigenshade_status eigenshade_picture_highlights_f32(const struct eigenshade_gloss_f32_t *gloss,
                                                    const struct eigenshade_source_f32_t *sources,
                                                    size_t count,
                                                    struct eigenshade_picture_f32_t *picture);

/**
 * Gives the pictures of both parts of a region the highlights of `count` sources, as
 * `eigenshade_picture_highlights_f32` does for a gloss.
 *
 * On an error the pictures have no highlights, or are unchanged.
 */
eigenshade_status eigenshade_region_highlights_f32(const struct eigenshade_object_t *object,
                                                   size_t region,
                                                   const struct eigenshade_source_f32_t *sources,
                                                   size_t count,
                                                   struct eigenshade_picture_f32_t *tinted,
                                                   struct eigenshade_picture_f32_t *plain);

/**
 * The irradiance of the normal along (x, y, z).
 *
 * The normal may have any length from 1e-9 to 1e9; it is scaled, which costs a root. A normal that
 * points away by no more than 1/8 is laid on the rim. On an error `irradiance` is unchanged.
 */
eigenshade_status eigenshade_picture_shade_f32(const struct eigenshade_picture_f32_t *picture,
                                               float x,
                                               float y,
                                               float z,
                                               struct eigenshade_irradiance_f32_t *irradiance);

/**
 * Draws a sphere that fills a square of `diameter` x `diameter` pixels, 1 to 4096, every pixel
 * shaded. `exposure` is a number above 0 that multiplies the irradiance.
 *
 * On an error no pixel is changed. To draw the same picture many times a second, fill a palette.
 */
eigenshade_status eigenshade_picture_draw_disc_f32(const struct eigenshade_picture_f32_t *picture,
                                                   size_t diameter,
                                                   float exposure,
                                                   const struct eigenshade_display_t *display,
                                                   const struct eigenshade_target_t *target);

/**
 * `eigenshade_picture_draw_disc_f32` of the object of a normal map.
 */
eigenshade_status eigenshade_picture_draw_normal_map_f32(const struct eigenshade_picture_f32_t *picture,
                                                         const struct eigenshade_normal_map_t *map,
                                                         float exposure,
                                                         const struct eigenshade_display_t *display,
                                                         const struct eigenshade_target_t *target);

/**
 * Shades a picture, with its highlights, at the nodes of a palette: at those of an object, or at
 * all 921 if `nodes` is NULL. Draw from it any number of objects by `eigenshade_palette_draw`.
 *
 * The nodes of others stay as they are, and on an error all of them; in the first call they
 * become black. A picture drawn from it differs by CIEDE2000 0.36 in the median from one with every
 * pixel shaded, more in highlights narrower than 5.7 degrees.
 */
eigenshade_status eigenshade_palette_fill_f32(const struct eigenshade_picture_f32_t *picture,
                                              float exposure,
                                              const struct eigenshade_display_t *display,
                                              const struct eigenshade_nodes_t *nodes,
                                              struct eigenshade_palette_t *palette);

/**
 * Shades the pictures of both parts of a region, with their highlights, at the nodes of a linear
 * palette: at those of the region, or at all 921 if `nodes` is NULL. Begin the pictures of the
 * materials that `eigenshade_region_materials_f32` writes.
 *
 * The nodes of others stay as they are, and on an error all of them; in the first call they
 * become black.
 */
eigenshade_status eigenshade_linear_palette_fill_f32(const struct eigenshade_picture_f32_t *tinted,
                                                     const struct eigenshade_picture_f32_t *plain,
                                                     float exposure,
                                                     const struct eigenshade_nodes_t *nodes,
                                                     struct eigenshade_linear_palette_t *palette);

/**
 * The coefficients of an object with shadows under a light, whose degree is at most that of the object.
 *
 * On an error `coefficients` is unchanged.
 */
eigenshade_status eigenshade_shadowed_object_coefficients_f32(const struct eigenshade_shadowed_object_t *object,
                                                              const struct eigenshade_color_light_f32_t *light,
                                                              struct eigenshade_object_coefficients_t *coefficients);

/**
 * Counts the pixels of one row of a sphere, to meter the exposure of its picture. Row 0 is the
 * top. Every fourth row of a small sphere will do.
 *
 * On an error `meter` is unchanged.
 */
eigenshade_status eigenshade_picture_meter_disc_row_f32(const struct eigenshade_picture_f32_t *picture,
                                                        size_t diameter,
                                                        size_t row,
                                                        struct eigenshade_meter_t *meter);

/**
 * `eigenshade_picture_meter_disc_row_f32` of the object of a normal map.
 */
eigenshade_status eigenshade_picture_meter_normal_map_row_f32(const struct eigenshade_picture_f32_t *picture,
                                                              const struct eigenshade_normal_map_t *map,
                                                              size_t row,
                                                              struct eigenshade_meter_t *meter);

/**
 * Bakes a picture without highlights into maps of `size` x `size` texels, 2 to 4096. `length` is
 * 3 * size * size.
 *
 * A look-up costs less than a pixel of the picture and is less exact, as docs/method.md lists by
 * size. The texels are in `texels`, and `baked` points there. On an error neither may be used.
 */
eigenshade_status eigenshade_picture_bake_f32(const struct eigenshade_picture_f32_t *picture,
                                              size_t size,
                                              float *texels,
                                              size_t length,
                                              struct eigenshade_baked_f32_t *baked);

/**
 * `eigenshade_picture_shade_f32` from a baked picture.
 */
eigenshade_status eigenshade_baked_shade_f32(const struct eigenshade_baked_f32_t *baked,
                                             float x,
                                             float y,
                                             float z,
                                             struct eigenshade_irradiance_f32_t *irradiance);

/**
 * `eigenshade_picture_draw_disc_f32` from a baked picture.
 */
eigenshade_status eigenshade_baked_draw_disc_f32(const struct eigenshade_baked_f32_t *baked,
                                                 size_t diameter,
                                                 float exposure,
                                                 const struct eigenshade_display_t *display,
                                                 const struct eigenshade_target_t *target);

/**
 * `eigenshade_picture_draw_normal_map_f32` from a baked picture.
 */
eigenshade_status eigenshade_baked_draw_normal_map_f32(const struct eigenshade_baked_f32_t *baked,
                                                       const struct eigenshade_normal_map_t *map,
                                                       float exposure,
                                                       const struct eigenshade_display_t *display,
                                                       const struct eigenshade_target_t *target);

/**
 * A light, of degree 12 at most, turned by the rotation of a quaternion (x, y, z, w):
 * L'(R v) = L(v) for every direction v.
 *
 * The turned light is in `buffer`, and `to` points there. Uses 6 KB of stack. On an error neither
 * may be used.
 */
eigenshade_status eigenshade_turn_f32(const struct eigenshade_color_light_f32_t *from,
                                      const float *quaternion,
                                      struct eigenshade_light_buffer_f32_t *buffer,
                                      struct eigenshade_color_light_f32_t *to);

/**
 * A light turned about the view axis, from x toward y, by an angle, given by its cosine and sine:
 * much cheaper than any other axis. The squares of cosine and sine sum to 1 to within 2 %; both
 * are scaled.
 *
 * The turned light is in `buffer`, and `to` points there. On an error neither may be used.
 */
eigenshade_status eigenshade_turn_about_view_f32(const struct eigenshade_color_light_f32_t *from,
                                                 const float *cosine_and_sine,
                                                 struct eigenshade_light_buffer_f32_t *buffer,
                                                 struct eigenshade_color_light_f32_t *to);

/**
 * A light without `count` sources, at most EIGENSHADE_SOURCES.
 *
 * The light is in `buffer`, and `to` points there. On an error neither may be used.
 */
eigenshade_status eigenshade_residual_f32(const struct eigenshade_color_light_f32_t *from,
                                          const struct eigenshade_source_f32_t *sources,
                                          size_t count,
                                          struct eigenshade_light_buffer_f32_t *buffer,
                                          struct eigenshade_color_light_f32_t *to);

/**
 * A light with only its coefficients of an effect, which is one of `eigenshade_effect`; the others
 * are zero. Mask the material for the same effect.
 *
 * The light is in `buffer`, and `to` points there. On an error neither may be used.
 */
eigenshade_status eigenshade_mask_light_f32(const struct eigenshade_color_light_f32_t *from,
                                            int32_t effect,
                                            struct eigenshade_light_buffer_f32_t *buffer,
                                            struct eigenshade_color_light_f32_t *to);

/**
 * A material with only its coefficients of an effect, which is one of `eigenshade_effect`; the
 * others are zero. Mask the light for the same effect.
 *
 * The material is in `buffer`, and `to` points there. On an error neither may be used.
 */
eigenshade_status eigenshade_mask_material_f32(const struct eigenshade_color_material_f32_t *from,
                                               int32_t effect,
                                               struct eigenshade_material_buffer_f32_t *buffer,
                                               struct eigenshade_color_material_f32_t *to);

/**
 * A glTF material from its linear base color, metallic and roughness, all from 0 to 1.
 *
 * A roughness below 0.2 is drawn as 0.2. The table's order has to be 7 or more. The material is in
 * `buffer`, and `to` points there. On an error neither may be used.
 */
eigenshade_status eigenshade_metallic_roughness_f32(const float *base_color,
                                                    float metallic,
                                                    float roughness,
                                                    struct eigenshade_material_buffer_f32_t *buffer,
                                                    struct eigenshade_color_material_f32_t *to);

/**
 * The two materials of a region of a textured object: the irradiance of a pixel is its base color
 * times the irradiance of the tinted part, plus that of the plain part. Both are gray.
 *
 * The table's order has to be 7 or more. Both are in `buffer`, and `tinted` and `plain` point there.
 * On an error none of them may be used.
 */
eigenshade_status eigenshade_region_materials_f32(const struct eigenshade_object_t *object,
                                                  size_t region,
                                                  struct eigenshade_material_buffer_f32_t *buffer,
                                                  struct eigenshade_color_material_f32_t *tinted,
                                                  struct eigenshade_color_material_f32_t *plain);

/**
 * `eigenshade_project_f32` in Q15.
 */
eigenshade_status eigenshade_project_q15(const struct eigenshade_light_q15_t *light,
                                         const struct eigenshade_material_q15_t *material,
                                         struct eigenshade_workspace_q15_t *workspace,
                                         struct eigenshade_coefficients_q15_t *coefficients);

/**
 * `eigenshade_transfer_f32` in Q15.
 */
eigenshade_status eigenshade_transfer_q15(const struct eigenshade_color_material_q15_t *material,
                                          struct eigenshade_transfer_q15_t *transfer);

/**
 * `eigenshade_picture_begin_f32` in Q15. Uses 3 KB of stack.
 */
eigenshade_status eigenshade_picture_begin_q15(const struct eigenshade_color_light_q15_t *light,
                                               const struct eigenshade_color_material_q15_t *material,
                                               struct eigenshade_picture_q15_t *picture);

/**
 * `eigenshade_picture_begin_glossy_f32` in Q15, partly computed in floats. Uses 9 KB of stack.
 */
eigenshade_status eigenshade_picture_begin_glossy_q15(const struct eigenshade_color_light_q15_t *light,
                                                      const struct eigenshade_color_material_q15_t *material,
                                                      const struct eigenshade_gloss_f32_t *gloss,
                                                      const struct eigenshade_source_f32_t *sources,
                                                      size_t count,
                                                      struct eigenshade_picture_q15_t *picture);

/**
 * `eigenshade_picture_relight_f32` in Q15. If the transfer is refused, the picture is as if never
 * begun.
 */
eigenshade_status eigenshade_picture_relight_q15(const struct eigenshade_transfer_q15_t *transfer,
                                                 const struct eigenshade_color_light_q15_t *light,
                                                 struct eigenshade_picture_q15_t *picture);

/**
 * `eigenshade_picture_highlights_f32` in Q15, computed in floats.
 */
eigenshade_status eigenshade_picture_highlights_q15(const struct eigenshade_gloss_f32_t *gloss,
                                                    const struct eigenshade_source_f32_t *sources,
                                                    size_t count,
                                                    struct eigenshade_picture_q15_t *picture);

/**
 * `eigenshade_region_highlights_f32` in Q15, computed in floats.
 */
eigenshade_status eigenshade_region_highlights_q15(const struct eigenshade_object_t *object,
                                                   size_t region,
                                                   const struct eigenshade_source_f32_t *sources,
                                                   size_t count,
                                                   struct eigenshade_picture_q15_t *tinted,
                                                   struct eigenshade_picture_q15_t *plain);

/**
 * `eigenshade_picture_shade_f32` in Q15: (x, y, z) has length 1, in fractions of 2^15 (1 as 2^15 -
 * 1).
 */
eigenshade_status eigenshade_picture_shade_q15(const struct eigenshade_picture_q15_t *picture,
                                               int16_t x,
                                               int16_t y,
                                               int16_t z,
                                               struct eigenshade_irradiance_q15_t *irradiance);

/**
 * `eigenshade_picture_draw_disc_f32` in Q15. The bits of `exposure` are read in integers.
 */
eigenshade_status eigenshade_picture_draw_disc_q15(const struct eigenshade_picture_q15_t *picture,
                                                   size_t diameter,
                                                   float exposure,
                                                   const struct eigenshade_display_t *display,
                                                   const struct eigenshade_target_t *target);

/**
 * `eigenshade_picture_draw_normal_map_f32` in Q15.
 */
eigenshade_status eigenshade_picture_draw_normal_map_q15(const struct eigenshade_picture_q15_t *picture,
                                                         const struct eigenshade_normal_map_t *map,
                                                         float exposure,
                                                         const struct eigenshade_display_t *display,
                                                         const struct eigenshade_target_t *target);

/**
 * `eigenshade_palette_fill_f32` in Q15. The bits of `exposure` are read in integers.
 */
eigenshade_status eigenshade_palette_fill_q15(const struct eigenshade_picture_q15_t *picture,
                                              float exposure,
                                              const struct eigenshade_display_t *display,
                                              const struct eigenshade_nodes_t *nodes,
                                              struct eigenshade_palette_t *palette);

/**
 * `eigenshade_linear_palette_fill_f32` in Q15. The bits of `exposure` are read in integers.
 */
eigenshade_status eigenshade_linear_palette_fill_q15(const struct eigenshade_picture_q15_t *tinted,
                                                     const struct eigenshade_picture_q15_t *plain,
                                                     float exposure,
                                                     const struct eigenshade_nodes_t *nodes,
                                                     struct eigenshade_linear_palette_t *palette);

/**
 * `eigenshade_shadowed_object_coefficients_f32` in Q15. Uses 3 KB of stack.
 */
eigenshade_status eigenshade_shadowed_object_coefficients_q15(const struct eigenshade_shadowed_object_t *object,
                                                              const struct eigenshade_color_light_q15_t *light,
                                                              struct eigenshade_object_coefficients_t *coefficients);

/**
 * `eigenshade_picture_meter_disc_row_f32` in Q15.
 */
eigenshade_status eigenshade_picture_meter_disc_row_q15(const struct eigenshade_picture_q15_t *picture,
                                                        size_t diameter,
                                                        size_t row,
                                                        struct eigenshade_meter_t *meter);

/**
 * `eigenshade_picture_meter_normal_map_row_f32` in Q15.
 */
eigenshade_status eigenshade_picture_meter_normal_map_row_q15(const struct eigenshade_picture_q15_t *picture,
                                                              const struct eigenshade_normal_map_t *map,
                                                              size_t row,
                                                              struct eigenshade_meter_t *meter);

/**
 * `eigenshade_picture_bake_f32` in Q15, from a picture in float.
 */
eigenshade_status eigenshade_picture_bake_q15(const struct eigenshade_picture_f32_t *picture,
                                              size_t size,
                                              int16_t *texels,
                                              size_t length,
                                              struct eigenshade_baked_q15_t *baked);

/**
 * `eigenshade_picture_shade_q15` from a baked picture.
 */
eigenshade_status eigenshade_baked_shade_q15(const struct eigenshade_baked_q15_t *baked,
                                             int16_t x,
                                             int16_t y,
                                             int16_t z,
                                             struct eigenshade_irradiance_q15_t *irradiance);

/**
 * `eigenshade_picture_draw_disc_q15` from a baked picture.
 */
eigenshade_status eigenshade_baked_draw_disc_q15(const struct eigenshade_baked_q15_t *baked,
                                                 size_t diameter,
                                                 float exposure,
                                                 const struct eigenshade_display_t *display,
                                                 const struct eigenshade_target_t *target);

/**
 * `eigenshade_picture_draw_normal_map_q15` from a baked picture.
 */
eigenshade_status eigenshade_baked_draw_normal_map_q15(const struct eigenshade_baked_q15_t *baked,
                                                       const struct eigenshade_normal_map_t *map,
                                                       float exposure,
                                                       const struct eigenshade_display_t *display,
                                                       const struct eigenshade_target_t *target);

/**
 * A light in Q15 from one in float, in integer arithmetic throughout.
 *
 * The light is in `buffer`, and `to` points there. On an error neither may be used.
 */
eigenshade_status eigenshade_quantize_light_q15(const struct eigenshade_color_light_f32_t *from,
                                                struct eigenshade_light_buffer_q15_t *buffer,
                                                struct eigenshade_color_light_q15_t *to);

/**
 * A material in Q15 from one in float, in integer arithmetic throughout.
 *
 * The material is in `buffer`, and `to` points there. On an error neither may be used.
 */
eigenshade_status eigenshade_quantize_material_q15(const struct eigenshade_color_material_f32_t *from,
                                                   struct eigenshade_material_buffer_q15_t *buffer,
                                                   struct eigenshade_color_material_q15_t *to);

/**
 * The unit normal along a vector of three integers of any scale, as three mantissas, x, y and z.
 * For a normal map of 8 bits, pass 2c - 255 for each channel c.
 *
 * A vector that points away by no more than 1/8 is laid on the rim. Cost: a root and three
 * divisions in 64 bits. On an error `normal` is unchanged.
 */
eigenshade_status eigenshade_normalize_q15(const int32_t *vector, int16_t *normal);

/**
 * `eigenshade_turn_f32` in Q15. The quaternion may have any scale. Uses 3 KB of stack.
 */
eigenshade_status eigenshade_turn_q15(const struct eigenshade_color_light_q15_t *from,
                                      const int32_t *quaternion,
                                      struct eigenshade_light_buffer_q15_t *buffer,
                                      struct eigenshade_color_light_q15_t *to);

/**
 * `eigenshade_turn_about_view_f32` in Q15. Cosine and sine may have any scale.
 */
eigenshade_status eigenshade_turn_about_view_q15(const struct eigenshade_color_light_q15_t *from,
                                                 const int32_t *cosine_and_sine,
                                                 struct eigenshade_light_buffer_q15_t *buffer,
                                                 struct eigenshade_color_light_q15_t *to);

/**
 * `eigenshade_residual_f32` in Q15, computed in floats.
 */
eigenshade_status eigenshade_residual_q15(const struct eigenshade_color_light_q15_t *from,
                                          const struct eigenshade_source_f32_t *sources,
                                          size_t count,
                                          struct eigenshade_light_buffer_q15_t *buffer,
                                          struct eigenshade_color_light_q15_t *to);

/**
 * `eigenshade_mask_light_f32` in Q15.
 */
eigenshade_status eigenshade_mask_light_q15(const struct eigenshade_color_light_q15_t *from,
                                            int32_t effect,
                                            struct eigenshade_light_buffer_q15_t *buffer,
                                            struct eigenshade_color_light_q15_t *to);

/**
 * `eigenshade_mask_material_f32` in Q15.
 */
eigenshade_status eigenshade_mask_material_q15(const struct eigenshade_color_material_q15_t *from,
                                               int32_t effect,
                                               struct eigenshade_material_buffer_q15_t *buffer,
                                               struct eigenshade_color_material_q15_t *to);

/**
 * `eigenshade_metallic_roughness_f32` in Q15, in which 1 is 32767.
 */
eigenshade_status eigenshade_metallic_roughness_q15(const int16_t *base_color,
                                                    int16_t metallic,
                                                    int16_t roughness,
                                                    struct eigenshade_material_buffer_q15_t *buffer,
                                                    struct eigenshade_color_material_q15_t *to);

/**
 * `eigenshade_region_materials_f32` in Q15.
 */
eigenshade_status eigenshade_region_materials_q15(const struct eigenshade_object_t *object,
                                                  size_t region,
                                                  struct eigenshade_material_buffer_q15_t *buffer,
                                                  struct eigenshade_color_material_q15_t *tinted,
                                                  struct eigenshade_color_material_q15_t *plain);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* EIGENSHADE_H */
