// How many of a light's sources a material needs.

/**
 * Numbers of sources, for a metal or a dielectric up to a roughness.
 *
 * @typedef {{ isMetal: boolean, roughness: number, count: number }[]} Steps
 */

/**
 * The fewest sources with which pictures are close on a screen, by the table of errors that the
 * preset was made with.
 *
 * @param {Steps} steps
 * @param {Float32Array} gloss as `Channels` has it
 */
export function countOf(steps, gloss) {
  const sum = (/** @type {number} */ from) => gloss[from] + gloss[from + 1] + gloss[from + 2];
  const isMetal = sum(1) > sum(7);
  return steps.find((step) => step.isMetal === isMetal && gloss[0] <= step.roughness)?.count ?? 0;
}
