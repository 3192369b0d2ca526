// The exposure of a picture, by the rule of `Meter` in Rust.

import { isExposure } from "./input.js";

/** @typedef {{ r: Float32Array, g: Float32Array, b: Float32Array }} Picture */

/** The share of white that the median pixel has at least, if highlights leave room. */
const MIDDLE = 0.12;

/** A pixel darker than this share of the brightest one is black. */
const DARKEST = 2 ** -16;

/** Normals at points spread evenly over a sphere's picture, in a spiral. */
export const DISC = (() => {
  const axes = [0, 1, 2].map(() => new Float32Array(512));
  for (let k = 0; k < 512; k++) {
    const [radius, angle] = [Math.sqrt((k + 0.5) / 512), k * Math.PI * (3 - Math.sqrt(5))];
    axes[0][k] = radius * Math.cos(angle);
    axes[1][k] = radius * Math.sin(angle);
    axes[2][k] = Math.sqrt(1 - radius * radius);
  }
  return axes;
})();

/**
 * The exposure of a picture: one pixel in a hundred is brighter than white, in its brightest
 * channel. If that leaves the median darker than 0.12, the exposure rises until the median has 0.12
 * or one pixel in ten is brighter than white.
 *
 * @param {Picture} picture
 * @returns {number} 1 for a black picture
 */
export function metered({ r, g, b }) {
  const largest = r.map((red, k) => Math.max(red, g[k], b[k])).sort();
  const { length } = largest;
  const least = DARKEST * largest[length - 1];
  // The median of a picture that is mostly black is its darkest other pixel.
  const lit = Math.max(0, largest.findIndex((value) => value > least));
  const brightness = (/** @type {number} */ share) =>
    largest[Math.max(lit, Math.floor(share * length) - 1)];
  const unclipped = Math.min(MIDDLE / brightness(0.5), 1 / brightness(0.9));
  const exposure = Math.max(1 / brightness(0.99), unclipped);
  return isExposure(exposure) ? exposure : 1;
}
