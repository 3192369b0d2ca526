// A window over the degrees of a light, where its picture would have dark rings.

import { isNumber, shown } from "./input.js";

/**
 * A window: its width, the degree from which on nothing is left, `"none"`, or `"auto"`: the weakest
 * with which a picture has no dark rings.
 *
 * @typedef {number | "auto" | "none"} Window
 */

/** The darkest channel of a picture without dark rings, as a share of white. */
const DARKEST = -0.02;

/** The windows that are tried, from weak to strong: their widths, in degrees of the light plus one. */
const WIDTHS = [4.5, 3.6, 3, 2.6, 2.3, 2, 1.8, 1.6, 1.4, 1.2, 1];

/**
 * The weakest window without dark rings, as `Window::weakest` in Rust: if none suffices, that with
 * the brightest darkest channel.
 *
 * @param {number} degree of the light
 * @param {(width: number) => number} darkest the smallest channel of the picture with a window of
 *   this width, infinite for none, as a share of white
 * @returns {number} its width
 */
export function weakest(degree, darkest) {
  let best = { width: Infinity, least: darkest(Infinity) };
  for (const width of WIDTHS.map((width) => width * (degree + 1))) {
    if (best.least >= DARKEST) break;
    const least = darkest(width);
    if (least > best.least) best = { width, least };
  }
  return best.width;
}

/**
 * The window (sin x / x)⁴, x = π l / width.
 *
 * @param {number} width
 * @param {number} degree
 */
export function factor(width, degree) {
  const x = (Math.PI * degree) / width;
  return x === 0 ? 1 : degree < width ? (Math.sin(x) / x) ** 4 : 0;
}

/**
 * The three channels of a light, one after the other, with a window.
 *
 * @param {Float32Array} light
 * @param {number} width
 */
export function windowed(light, width) {
  const factors = Float64Array.from({ length: light.length / 3 }, (_, k) =>
    factor(width, Math.floor(Math.sqrt(k))),
  );
  return light.map((number, k) => number * factors[k % factors.length]);
}

/** @param {unknown} window */
export function checkWindow(window) {
  if (window === "auto" || window === "none" || (isNumber(window) && window > 0)) return;
  const expected = 'expected a number above 0, "auto" or "none"';
  throw new RangeError(`window: it is ${shown(window)}, ${expected}`);
}
