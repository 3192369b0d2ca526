// Which of a light's sets of sources a material needs.

/**
 * Sets of sources, smallest first, and which of them is taken: for a metal or a dielectric, up to a
 * roughness, the set of this place.
 *
 * @typedef {object} Sets
 * @property {import("./input.js").Numbers[]} all
 * @property {{ isMetal: boolean, roughness: number, place: number }[]} steps
 */

/**
 * The place of the set that is close on a screen with the fewest sources, by the table of errors
 * that the preset was made with.
 *
 * @param {Sets["steps"]} steps
 * @param {Float32Array} gloss as `Channels` has it
 */
export function placeOf(steps, gloss) {
  const sum = (/** @type {number} */ from) => gloss[from] + gloss[from + 1] + gloss[from + 2];
  const isMetal = sum(1) > sum(7);
  return steps.find((step) => step.isMetal === isMetal && gloss[0] <= step.roughness)?.place ?? 0;
}
