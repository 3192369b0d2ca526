// The page's curve and sRGB, in JavaScript and in GLSL.

const [A, B, C, D, E] = [2.51, 0.03, 2.43, 0.59, 0.14];

/** The page's curve: an exposed value, which is not negative, to one that is white from 1 on. */
export const filmic = (/** @type {number} */ x) => (x * (A * x + B)) / (x * (C * x + D) + E);

/** The code, from 0 to 255 and not rounded, of a linear value from 0 to 1. */
export const srgb = (/** @type {number} */ x) => 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);

/** The linear value of an sRGB value from 0 to 1. */
export const linear = (/** @type {number} */ x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);

/** The code of an exposed value, by the page's curve or as it is. */
export const encoded = (/** @type {number} */ x, tone = true) => {
  const positive = Math.max(0, x);
  return srgb(Math.min(1, tone ? filmic(positive) : positive));
};

/** The page's curve of x. */
export const CURVE = `x * (${A} * x + ${B}) / (x * (${C} * x + ${D}) + ${E})`;

/** The page's curve. An f32 has to hold the square. */
export const FILMIC = `vec3 filmic(vec3 x) {
  x = clamp(x, 0.0, 1e15);
  return ${CURVE};
}`;

/** sRGB of what is clipped to 1. */
export const ENCODED = `vec3 encoded(vec3 x) {
  x = clamp(x, 0.0, 1.0);
  return mix(1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, 12.92 * x, vec3(lessThanEqual(x, vec3(0.0031308))));
}`;
