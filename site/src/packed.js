// The page's object: for each pixel a normal, a base color, a region of one metallic and roughness, and
// a coverage, as `eigenshade pack-object` packs it; and the irradiances of its first light.

import { linear } from "./color.js";

/** Nodes of a palette along each axis, every eighth code from -128 to 128, and in all. */
export const SIDE = 33;
export const NODES = SIDE * SIDE;

/** Exposed irradiances are at most this; those of the first light are cube roots of 8 bits. */
export const MOST = 4;
export const toByte = (/** @type {number} */ value) => Math.round(255 * Math.cbrt(Math.min(1, Math.max(0, value / MOST))));
const fromByte = (/** @type {number} */ byte) => MOST * (byte / 255) ** 3;

/**
 * @typedef {object} Packed
 * @property {number} width
 * @property {number} height
 * @property {Uint8Array} texels four for each pixel: u and v of its normal, plus 128, the number of its
 *   color, and 4 times its coverage of 63 plus the number of its region
 * @property {Float32Array} colors linear red, green, blue and 1 of each color
 * @property {Float32Array} palettes of the first light, as `Parts.palettes` has them
 * @property {any} about what else the file says
 */

/** The file's first line is JSON. The planes after it have one byte a number. */
const LINE_FEED = 10;

/**
 * Reads the file, which is compressed (zlib). Its rows have the right half of the object, which is
 * symmetric; normals are differences from the row above.
 *
 * @param {ReadableStream<Uint8Array>} stream
 * @returns {Promise<Packed>}
 */
export async function unpacked(stream) {
  const bytes = new Uint8Array(await new Response(stream.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer());
  const end = bytes.indexOf(LINE_FEED);
  const about = JSON.parse(new TextDecoder().decode(bytes.subarray(0, end)));
  const { half, height, regions } = about;
  const [width, count] = [2 * half, half * height];
  let at = end + 1;
  const plane = (/** @type {number} */ length) => bytes.subarray(at, (at += length));
  const [u, v, color, covered] = [count, count, count, count].map(plane);
  for (const along of [u, v]) for (let k = half; k < count; k++) along[k] += along[k - half];
  const texels = new Uint8Array(4 * width * height);
  for (let k = 0; k < count; k++) {
    const [row, column] = [Math.floor(k / half), k % half];
    const first = row * width + half;
    texels.set([u[k], v[k], color[k], covered[k]], 4 * (first + column));
    texels.set([256 - u[k], v[k], color[k], covered[k]], 4 * (first - 1 - column));
  }
  const colors = new Float32Array(1024).fill(1);
  plane(768).forEach((code, k) => (colors[4 * Math.floor(k / 3) + (k % 3)] = linear(code / 255)));
  const palettes = new Float32Array(8 * NODES * regions.length).fill(1);
  const first = plane(6 * NODES * regions.length);
  let before = 0;
  first.forEach((byte, k) => {
    before = (before + byte) & 255;
    palettes[4 * (k % (2 * NODES * regions.length)) + Math.floor(k / (2 * NODES * regions.length))] = fromByte(before);
  });
  return { width, height, texels, colors, palettes, about };
}

/**
 * The exposed irradiance of a pixel, as a chip finds it from palettes: the black part, and what the base
 * color adds, between four nodes.
 *
 * @param {Packed} object
 * @param {Float32Array} palettes
 * @param {number} pixel
 * @param {number[]} to red, green and blue
 */
export function lookUp({ texels, colors }, palettes, pixel, to) {
  const [u, v, color, covered] = texels.subarray(4 * pixel, 4 * pixel + 4);
  const [column, row, right, down] = [u >> 3, v >> 3, (u & 7) / 8, (v & 7) / 8];
  const node = 8 * NODES * (covered & 3) + 4 * (SIDE * row + column);
  const weights = [(1 - right) * (1 - down), right * (1 - down), (1 - right) * down, right * down];
  for (let c = 0; c < 3; c++) {
    let [black, white] = [0, 0];
    for (let k = 0; k < 4; k++) {
      const at = node + 4 * ((k & 1) + SIDE * (k >> 1)) + c;
      black += weights[k] * palettes[at];
      white += weights[k] * palettes[at + 4 * NODES];
    }
    to[c] = black + colors[4 * color + c] * (white - black);
  }
}
