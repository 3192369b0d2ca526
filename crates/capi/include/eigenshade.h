/* eigenshade: image irradiance of any isotropic material under any distant light. Its
table is of degree EIGENSHADE_DEGREE and order EIGENSHADE_ORDER: the shipped one is 9 and 7.

The steps are: compute the transfer of a material, relight it with a light, collapse the
coefficients to a scene, and shade normals with the scene; in float (f32) and in integers
(q15). A number in integers is a mantissa times 2 to the power of an exponent. The
quantize functions convert lights and materials from float to integers, without a float
unit. These are the steps of one channel; `eigenshade_color.h` has three, and rows of pixels.

The caller owns every array and structure, and need not initialize those that the library
writes. No function allocates, keeps a pointer, or has state, so all may be called from
interrupts and threads at once on separate arguments. Pointers must not be NULL and must be
aligned; both are checked. Arguments that a function writes to must not overlap its other
arguments; this is checked too. Lengths are counts of numbers, not bytes.

Integers give the same bits on every machine. */

#ifndef EIGENSHADE_H
#define EIGENSHADE_H

#include "eigenshade_table.h"

#include <stddef.h>
#include <stdint.h>

/** The version of this header: compare it with `eigenshade_version()`. */
#define EIGENSHADE_VERSION "0.1.0"

/** The result of every function that can fail: 0, or the reason why it did nothing. */
enum eigenshade_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif
{
  /** Success. */
  EIGENSHADE_STATUS_OK = 0,
  /** A pointer is NULL. */
  EIGENSHADE_STATUS_NULL_POINTER = 1,
  /** A pointer is not aligned for its type. */
  EIGENSHADE_STATUS_UNALIGNED = 2,
  /** An array that is written to overlaps another. */
  EIGENSHADE_STATUS_OVERLAP = 3,
  /** The degree of a light is above EIGENSHADE_DEGREE. */
  EIGENSHADE_STATUS_LIGHT_BEYOND = 4,
  /** A light does not have (degree + 1)^2 coefficients. */
  EIGENSHADE_STATUS_LIGHT_LENGTH = 5,
  /** The order of a material is above EIGENSHADE_ORDER. */
  EIGENSHADE_STATUS_MATERIAL_BEYOND = 6,
  /**
   * A material does not have the number of coefficients of its order, or an exponent for each o.
   */
  EIGENSHADE_STATUS_MATERIAL_LENGTH = 7,
  /** More than EIGENSHADE_COMPONENTS components. */
  EIGENSHADE_STATUS_COMPONENTS = 8,
  /** An exponent is out of its range. */
  EIGENSHADE_STATUS_EXPONENT = 9,
  /**
   * A normal has a component that is not finite, length zero, or, in integers, a length other
   * than 1.
   */
  EIGENSHADE_STATUS_NORMAL = 10,
  /** A normal points away from the camera. */
  EIGENSHADE_STATUS_HIDDEN = 11,
  /** More normals than memory can hold. */
  EIGENSHADE_STATUS_COUNT = 12,
  /** A fault of the library. */
  EIGENSHADE_STATUS_INTERNAL = 13,
  /**
   * A row of a transfer is so large that its sum with a light could overflow: no function of
   * this library computed it.
   */
  EIGENSHADE_STATUS_TRANSFER = 14,
  /** A coefficient of a light or a material is infinite or NaN. */
  EIGENSHADE_STATUS_NOT_FINITE = 15,
  /** A color, metallic or roughness is not from 0 to 1. */
  EIGENSHADE_STATUS_OUTSIDE = 16,
  /**
   * A quaternion, or cosine and sine, are zero or not finite; or, in f32, cosine² + sine² differs
   * from 1 by more than 2 %.
   */
  EIGENSHADE_STATUS_ROTATION = 17,
  /** The object has no such row, or the buffer is shorter than a row. */
  EIGENSHADE_STATUS_ROW = 18,
  /** A disc has no pixel, or more than 4096 across. */
  EIGENSHADE_STATUS_DIAMETER = 19,
  /** A normal map has no pixel, or not two bytes for each. */
  EIGENSHADE_STATUS_NORMAL_MAP = 20,
  /** An exposure is not a number above 0. */
  EIGENSHADE_STATUS_EXPOSURE = 21,
  /** A baked map is not of 2 to 4096 texels a side, or has not three times its square. */
  EIGENSHADE_STATUS_BAKED = 22,
  /** A source has wrong numbers, or there are more than `EIGENSHADE_SOURCES`. */
  EIGENSHADE_STATUS_SOURCE = 23,
  /** A light above degree 12, beyond which none is turned. */
  EIGENSHADE_STATUS_TURN = 24,
  /** A scene that no function of this library computed, such as one of zeros. */
  EIGENSHADE_STATUS_SCENE = 25,
  /** A meter has counted no pixel, or only black ones. */
  EIGENSHADE_STATUS_DARK = 26,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum eigenshade_status eigenshade_status;
#else
typedef int32_t eigenshade_status;
#endif
#endif

/**
 * One channel of distant light: spherical harmonic coefficients L_l^m in radiance, l from
 * 0, m from -l to l, that of l and m at l*l + l + m.
 *
 * The harmonics carry the Condon-Shortley phase, x points to the right, y up, z to the
 * camera. Take them finite: one that is not spoils the image, and
 * `eigenshade_check_light_f32` finds it.
 */
typedef struct eigenshade_light_f32_t {
  /** Largest l, at most EIGENSHADE_DEGREE; above it the light is zero. */
  size_t degree;
  /** Number of coefficients: (degree + 1)^2. */
  size_t length;
  /** The coefficients; the caller's. */
  const float *coefficients;
} eigenshade_light_f32_t;

/**
 * One channel of an isotropic material: Koenderink-van Doorn coefficients b_op^q of its
 * BRDF in 1/sr, by o, then p, then q: 000, 111, 200, 220, 222, 311, ... White matte is
 * the one coefficient 2.
 *
 * Take them finite: one that is not spoils the image, and `eigenshade_check_material_f32`
 * finds it.
 */
typedef struct eigenshade_material_f32_t {
  /** Largest o, at most EIGENSHADE_ORDER; above it the material is zero. */
  size_t order;
  /** Number of coefficients: 1, 2, 5, 8, 14, 20, 30, 40 for orders 0 to 7. */
  size_t length;
  /** The coefficients; the caller's. */
  const float *coefficients;
} eigenshade_material_f32_t;

/** Scratch memory; holds nothing between two calls. */
typedef struct eigenshade_workspace_f32_t {
  /** Scratch. */
  float numbers[EIGENSHADE_WORKSPACE_F32];
} eigenshade_workspace_f32_t;

/** The transfer of a material, as `eigenshade_transfer_f32` writes it. May be kept in flash. */
typedef struct eigenshade_transfer_f32_t {
  /** Its numbers. */
  float numbers[EIGENSHADE_TRANSFER_F32];
} eigenshade_transfer_f32_t;

/** The coefficients d of one image, component by component. */
typedef struct eigenshade_coefficients_f32_t {
  /** d. */
  float numbers[EIGENSHADE_COMPONENTS];
} eigenshade_coefficients_f32_t;

/** One image, as `eigenshade_collapse_f32` writes it. May be kept in flash. */
typedef struct eigenshade_scene_f32_t {
  /** Its polynomials. */
  float terms[EIGENSHADE_SCENE_F32];
  /** What marks a computed scene: the library's. */
  uint32_t state;
} eigenshade_scene_f32_t;

/** One channel of distant light: as `eigenshade_light_f32_t`, in mantissas times 2^exponent. */
typedef struct eigenshade_light_q15_t {
  /** Largest l, at most EIGENSHADE_DEGREE; above it the light is zero. */
  size_t degree;
  /** Number of mantissas: (degree + 1)^2. */
  size_t length;
  /** The mantissas; the caller's. The more bits the largest has, the better. */
  const int16_t *mantissas;
  /** The exponent of all of them, from -128 to 128. */
  int32_t exponent;
} eigenshade_light_q15_t;

/**
 * One channel of an isotropic material: as `eigenshade_material_f32_t`, in mantissas times
 * 2^exponent, an exponent for each o.
 */
typedef struct eigenshade_material_q15_t {
  /** Largest o, at most EIGENSHADE_ORDER; above it the material is zero. */
  size_t order;
  /** Number of mantissas: 1, 2, 5, 8, 14, 20, 30, 40 for orders 0 to 7. */
  size_t length;
  /** The mantissas; the caller's. The more bits the largest of each o has, the better. */
  const int16_t *mantissas;
  /** Number of exponents: order + 1. */
  size_t exponents_length;
  /** For each o the exponent of its mantissas; the caller's. */
  const int8_t *exponents;
} eigenshade_material_q15_t;

/** Scratch memory; holds nothing between two calls. */
typedef struct eigenshade_workspace_q15_t {
  /** Scratch. */
  int32_t numbers[EIGENSHADE_WORKSPACE];
} eigenshade_workspace_q15_t;

/** The transfer of a material, as `eigenshade_transfer_q15` writes it. May be kept in flash. */
typedef struct eigenshade_transfer_q15_t {
  /** Its mantissas. */
  int16_t numbers[EIGENSHADE_TRANSFER];
  /** Its exponents. */
  int16_t exponents[EIGENSHADE_PROFILES];
} eigenshade_transfer_q15_t;

/** The coefficients d of one image, component by component: mantissas times 2^exponent. */
typedef struct eigenshade_coefficients_q15_t {
  /** Mantissas of at most 2^30. */
  int32_t mantissas[EIGENSHADE_COMPONENTS];
  /** The exponent of all of them. */
  int32_t exponent;
} eigenshade_coefficients_q15_t;

/** One image, as `eigenshade_collapse_q15` writes it. May be kept in flash. */
typedef struct eigenshade_scene_q15_t {
  /** Its polynomials. */
  int32_t terms[EIGENSHADE_SCENE_Q15];
  /** The exponent of every irradiance. */
  int32_t exponent;
  /** What marks a computed scene: the library's. */
  uint32_t state;
} eigenshade_scene_q15_t;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The library's version, a static string: compare it with EIGENSHADE_VERSION of the header.
 * Never fails.
 */
const char *eigenshade_version(void);

/**
 * A checksum of the sizes of the library's table. If it is not `EIGENSHADE_TABLE`, the headers are
 * those of another library: do not call it. Tables of the same sizes have the same checksum.
 */
uint32_t eigenshade_table(void);

/**
 * The message of a status, with the remedy: a static string in English without a line end.
 *
 * Never fails: an unknown status has a message too.
 */
const char *eigenshade_message(int32_t status);

/**
 * Computes the transfer of a material, for any number of lights.
 *
 * Cost: a multiplication for each of the table's factors. On an error `transfer` is
 * unchanged.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type, and
 * `workspace` and `transfer` to nothing else's memory.
 */
eigenshade_status eigenshade_transfer_f32(const struct eigenshade_material_f32_t *material,
                                          struct eigenshade_workspace_f32_t *workspace,
                                          struct eigenshade_transfer_f32_t *transfer);

/**
 * Computes d of a new light on a material from its transfer.
 *
 * Cost: a multiplication for each number of the transfer. On an error `coefficients` is
 * unchanged.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type, and
 * `coefficients` to nothing else's memory.
 */
eigenshade_status eigenshade_relight_f32(const struct eigenshade_transfer_f32_t *transfer,
                                         const struct eigenshade_light_f32_t *light,
                                         struct eigenshade_coefficients_f32_t *coefficients);

/**
 * Computes d of a light on a material without a transfer, for when both change each time.
 *
 * Cost: as `eigenshade_transfer_f32`. On an error `coefficients` is unchanged.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type, and
 * `workspace` and `coefficients` to nothing else's memory.
 */
eigenshade_status eigenshade_project_f32(const struct eigenshade_light_f32_t *light,
                                         const struct eigenshade_material_f32_t *material,
                                         struct eigenshade_workspace_f32_t *workspace,
                                         struct eigenshade_coefficients_f32_t *coefficients);

/**
 * Sums the components of each azimuth to a scene, from which pixels are shaded.
 *
 * Of d only the first `components` are used, at most EIGENSHADE_COMPONENTS; the others count
 * as zero. On an error `scene` is unchanged.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type, and
 * `scene` to nothing else's memory.
 */
eigenshade_status eigenshade_collapse_f32(const struct eigenshade_coefficients_f32_t *coefficients,
                                          size_t components, struct eigenshade_scene_f32_t *scene);

/**
 * The irradiance of the normal along (x, y, z), in the light's radiance times sr times the
 * material's 1/sr.
 *
 * The normal may have any length from 1e-9 to 1e9; it is scaled, which costs a root. One
 * that points away by no more than 1/8 is laid on the rim. On an error `irradiance` is as
 * it was.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type, and
 * `irradiance` to nothing else's memory.
 */
eigenshade_status eigenshade_shade_f32(const struct eigenshade_scene_f32_t *scene, float x, float y,
                                       float z, float *irradiance);

/**
 * Whether a light's degree, length and coefficients are in order, all of these finite: for what
 * arrives at run time. The functions that take a light check all but the last.
 *
 * Cost: a comparison for each coefficient.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type.
 */
eigenshade_status eigenshade_check_light_f32(const struct eigenshade_light_f32_t *light);

/**
 * Whether a material's order, length and coefficients are in order: as
 * `eigenshade_check_light_f32`.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type.
 */
eigenshade_status eigenshade_check_material_f32(const struct eigenshade_material_f32_t *material);

/**
 * Scales `count` normals to length 1, each where it is, and lays those on the rim that point
 * away by no more than 1/8: those of a mesh, or of a normal map, whose channel c of 8 bits says
 * 2c - 255.
 *
 * `normalized` becomes their number. If one has no direction or points away by more, it becomes
 * its place, and it and those after it stay as they were; on any other error nothing is written.
 * Cost: a root for each.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type, the first three
 * to `count` numbers each.
 */
eigenshade_status eigenshade_normalize_f32(float *x, float *y, float *z, size_t count,
                                           size_t *normalized);

/**
 * The irradiances of `count` unit normals with z from 0 to 1, into `irradiance`.
 *
 * Normals are neither normalized nor checked: a wrong normal has a meaningless irradiance and
 * affects no other; `eigenshade_normalize_f32` normalizes any vectors. If `count` is 0, the
 * pointers are not read. On an error `irradiance` is unchanged.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type, the last
 * four to `count` numbers each.
 */
eigenshade_status eigenshade_shade_many_f32(const struct eigenshade_scene_f32_t *scene,
                                            size_t count, const float *x, const float *y,
                                            const float *z, float *irradiance);

/**
 * A light in these mantissas from one in float, in integer arithmetic throughout.
 *
 * Writes `length` mantissas, as many as `from` has coefficients, and the light that they
 * make; they stay the caller's, and the light points to them. On an error
 * nothing is written, unless a number is not finite or `to` is at fault.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type, `mantissas`
 * to room for `length` numbers, and it and `to` to nothing else's memory.
 */
eigenshade_status eigenshade_quantize_light_q15(const struct eigenshade_light_f32_t *from,
                                                int16_t *mantissas, size_t length,
                                                struct eigenshade_light_q15_t *to);

/**
 * A material in these mantissas from one in float, in integer arithmetic throughout.
 *
 * Writes `length` mantissas, as many as `from` has coefficients, `exponents_length`
 * exponents, one for each o, and the material that they make; they stay the caller's, and
 * the material points to them. On an error nothing is written, unless a number is not finite,
 * or `exponents` or `to` is at fault.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type, `mantissas`
 * and `exponents` to room for as many numbers, and they and `to` to nothing else's memory.
 */
eigenshade_status eigenshade_quantize_material_q15(const struct eigenshade_material_f32_t *from,
                                                   int16_t *mantissas, size_t length,
                                                   int8_t *exponents, size_t exponents_length,
                                                   struct eigenshade_material_q15_t *to);

/**
 * Computes the transfer of a material, for any number of lights.
 *
 * Cost: a multiplication for each of the table's factors. On an error `transfer` is
 * unchanged.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type, and
 * `workspace` and `transfer` to nothing else's memory.
 */
eigenshade_status eigenshade_transfer_q15(const struct eigenshade_material_q15_t *material,
                                          struct eigenshade_workspace_q15_t *workspace,
                                          struct eigenshade_transfer_q15_t *transfer);

/**
 * Computes d of a new light on a material from its transfer.
 *
 * A transfer that `eigenshade_transfer_q15` did not write is refused if its rows could overflow
 * their sums, and gives meaningless numbers otherwise. Cost: two multiplications for each
 * number of the transfer. On an error `coefficients` is unchanged, except that it is zero if
 * the transfer is refused.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type, and
 * `coefficients` to nothing else's memory.
 */
eigenshade_status eigenshade_relight_q15(const struct eigenshade_transfer_q15_t *transfer,
                                         const struct eigenshade_light_q15_t *light,
                                         struct eigenshade_coefficients_q15_t *coefficients);

/**
 * Computes d of a light on a material: first the `transfer`, then d.
 *
 * Cost: as `eigenshade_transfer_q15` and `eigenshade_relight_q15`. On an error `coefficients`
 * is unchanged; `transfer` may have changed.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type, and
 * `workspace`, `transfer` and `coefficients` to nothing else's memory.
 */
eigenshade_status eigenshade_project_q15(const struct eigenshade_light_q15_t *light,
                                         const struct eigenshade_material_q15_t *material,
                                         struct eigenshade_workspace_q15_t *workspace,
                                         struct eigenshade_transfer_q15_t *transfer,
                                         struct eigenshade_coefficients_q15_t *coefficients);

/**
 * Sums the components of each azimuth to a scene, from which pixels are shaded.
 *
 * Of d only the first `components` are used, at most EIGENSHADE_COMPONENTS; the others count
 * as zero. Of coefficients that `eigenshade_relight_q15` did not write the exponent has to be
 * 2048 at most, either way. On an error `scene` is unchanged.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type, and
 * `scene` to nothing else's memory.
 */
eigenshade_status eigenshade_collapse_q15(const struct eigenshade_coefficients_q15_t *coefficients,
                                          size_t components, struct eigenshade_scene_q15_t *scene);

/**
 * The unit normal along a vector of three integers of any scale, as three mantissas, x, y and z:
 * of a normal map of 8 bits, whose channel c says 2c - 255.
 *
 * One that points away by no more than 1/8 is laid on the rim. Cost: a root and three divisions
 * in 64 bits. On an error `normal` is unchanged.
 *
 * Pointers that are neither NULL nor unaligned point to three numbers each.
 */
eigenshade_status eigenshade_normalize_q15(const int32_t *vector, int16_t *normal);

/**
 * The irradiance of the unit normal (x, y, z), in fractions of 2^15 (1 as 2^15 - 1):
 * `irradiance` times 2 to the scene's exponent, in the light's radiance times sr times the
 * material's 1/sr.
 *
 * On an error `irradiance` is unchanged.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type, and
 * `irradiance` to nothing else's memory.
 */
eigenshade_status eigenshade_shade_q15(const struct eigenshade_scene_q15_t *scene, int16_t x,
                                       int16_t y, int16_t z, int32_t *irradiance);

/**
 * The irradiances of `count` such normals, into `irradiance`.
 *
 * If `count` is 0, the pointers to numbers are not read. On an error `irradiance` is unchanged,
 * unless a normal is at fault: then the irradiances before it are written, and zeros from it on.
 *
 * Every pointer that is neither NULL nor unaligned points to a value of its type, the last
 * four to `count` numbers each.
 */
eigenshade_status eigenshade_shade_many_q15(const struct eigenshade_scene_q15_t *scene,
                                            size_t count, const int16_t *x, const int16_t *y,
                                            const int16_t *z, int32_t *irradiance);

#ifdef __cplusplus
}
#endif

#endif
