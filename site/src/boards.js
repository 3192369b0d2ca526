// What terms cost on small machines: straight lines through the counted pixels of
// firmware/counts.csv.

/**
 * Instructions of a pixel of one channel are base + each * terms, for the counted tables of 8 to
 * 166 terms (least squares, relative to the root of the count). No count is further from its line
 * than `within`. A test fits the lines again. Each source that the normal faces adds `source` in
 * color.
 */
export const BOARDS = Object.freeze([
  { name: "Cortex-M0", board: "microbit", format: "q15", base: 44.8, each: 5.3, within: 0.2, source: 306 },
  { name: "Cortex-M4F", board: "mps2-an386", format: "f32", base: 12.4, each: 2.11, within: 0.09, source: 75 },
]);

/** Instructions of a pixel in color that faces all sources. */
export const instructions = (/** @type {typeof BOARDS[number]} */ { base, each, source }, /** @type {number} */ terms, sources = 0) =>
  3 * (base + each * terms) + source * sources;
