// What terms cost on small machines: straight lines through the counted pixels of
// firmware/counts.csv.

/**
 * Instructions of a pixel of one channel are base + each * terms, for the counted tables of 8 to
 * 166 terms (least squares, relative to the root of the count). No count is further from its line
 * than `within`. A test fits the lines again. Each source that the normal faces adds `source` in
 * color.
 */
export const BOARDS = Object.freeze([
  { name: "Cortex-M0", board: "microbit", format: "q15", base: 44.8, each: 5.3, within: 0.2, source: 306, frame: { turned: 6197480, still: 4258920, turn: 90571 } },
  { name: "Cortex-M4F", board: "mps2-an386", format: "f32", base: 12.4, each: 2.11, within: 0.09, source: 75, frame: { turned: 3759640, still: 2960720, turn: 35763 } },
]);

/** Instructions of a pixel in color that faces all sources. */
export const instructions = (/** @type {typeof BOARDS[number]} */ { base, each, source }, /** @type {number} */ terms, sources = 0) =>
  3 * (base + each * terms) + source * sources;

/** Chips with the counted instruction sets: a Cortex-M33 and an M7 run the M4F's. In Hz. */
export const CHIPS = Object.freeze([
  { name: "RP2040", core: "Cortex-M0+", clock: 133e6, board: BOARDS[0] },
  { name: "nRF52840", core: "Cortex-M4F", clock: 64e6, board: BOARDS[1] },
  { name: "SAMD51", core: "Cortex-M4F", clock: 120e6, board: BOARDS[1] },
  { name: "STM32F405", core: "Cortex-M4F", clock: 168e6, board: BOARDS[1] },
  { name: "RP2350", core: "Cortex-M33", clock: 150e6, board: BOARDS[1], counted: "counted on a Cortex-M4F" },
  { name: "STM32H743", core: "Cortex-M7", clock: 480e6, board: BOARDS[1], counted: "counted on a Cortex-M4F" },
]);

/**
 * The counted frame of a textured object, `frame_textured`: the terms of its table, the pixels of a disc
 * of 120, and the nodes of its palette, at most.
 */
const COUNTED = { terms: 167, pixels: Math.PI * 60 ** 2, nodes: 803 };

/**
 * Instructions of a frame of a textured object under a turning light: the light is turned, each part
 * relit and its palette filled, which is proportional to the instructions of a pixel, and every pixel drawn.
 *
 * @param {typeof BOARDS[number]} board
 * @param {{ terms: number, sources: number }[]} parts two of each region
 * @param {number} pixels those of the object
 */
export function frameOf({ base, each, source, frame: { turned, still, turn } }, parts, pixels) {
  const part = (turned - still - turn) / 2 / (base + each * COUNTED.terms);
  const filled = parts.map(({ terms, sources }) => part * (base + each * terms) + COUNTED.nodes * source * sources);
  return turn + filled.reduce((sum, one) => sum + one, 0) + (still * pixels) / COUNTED.pixels;
}
