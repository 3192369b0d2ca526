// Pictures of spheres, computed on the CPU: row by row from a palette, where that is faster.

import { shown } from "./input.js";
import { prepared } from "./scene.js";

/** @typedef {import("./engine.js").Engine} Engine */
/** @typedef {import("./scene.js").Scene} Scene */
/** @typedef {import("./input.js").Tone} Tone */

/** Nodes of the palette along each axis, as `crates/wasm/src/palette.rs` has them. */
const SIDE = 65;

/** The smallest picture that a palette makes faster, in pixels across. */
const SMALLEST = 128;

/** With fewer smooth nodes, a quarter of all, the palette is not faster. */
const FEWEST = SIDE ** 2 / 4;

/** The largest picture whose rows are kept: they have 12 bytes a pixel. */
const KEPT = 1024;

/**
 * The pixels of a row that a sphere covers, as points of the palette's map of normals.
 *
 * @typedef {object} Row
 * @property {number} first their first column
 * @property {Int32Array} u in units of 2^-31, as v
 * @property {Int32Array} v
 * @property {Float32Array} s
 * @property {number[][]} edge columns that are covered in part, and their opacity
 */

/**
 * The rows of the last picture.
 *
 * @type {{ size: number, rows: Row[] }}
 */
let last = { size: 0, rows: [] };

/**
 * The picture of a sphere, computed on the CPU.
 *
 * Colors are those of `Scene.pixels`, to 1 of 255. From 128 pixels on, they are taken from a
 * palette of 3,200 normals and interpolated where these are nearly even, unless that is slower: for
 * each shipped light and material, 99 % of the pixels are then within 1 of 255, and all within 6.
 *
 * @param {Scene} scene
 * @param {number} size pixels across
 * @param {{ exposure?: number, tone?: Tone }} [look] as `Scene.pixels`
 * @returns {Uint8ClampedArray<ArrayBuffer>} red, green, blue and opacity, row by row from the top
 * @throws {TypeError | RangeError} unless the size is a whole number from 1 to 4096, or as
 *   `Scene.pixels`
 */
export function sphere(scene, size, look = {}) {
  if (!(Number.isInteger(size) && size >= 1 && size <= 4096)) {
    throw new RangeError(
      `sphere: the size is ${shown(size)}, expected a whole number from 1 to 4096`,
    );
  }
  const { engine, exposure, curve } = prepared(scene, "sphere", look);
  const interpolates = Number(size >= SMALLEST && fill(engine, exposure, curve));
  const { points, scales, pixels, normals: most } = engine;
  const picture = new Uint8ClampedArray(4 * size * size);
  if (last.size !== size) last = { size, rows: [] };
  for (let row = 0; row < size; row++) {
    const { first, u, v, s, edge } = last.rows[row] ?? rowOf(size, row);
    if (size <= KEPT) last.rows[row] ??= { first, u, v, s, edge };
    const at = 4 * row * size;
    for (let start = 0; start < s.length; start += most) {
      const end = Math.min(start + most, s.length);
      points.set(u.subarray(start, end));
      points.set(v.subarray(start, end), most);
      scales.set(s.subarray(start, end));
      const count = end - start;
      if (engine.wasm.draw(count, exposure, curve, interpolates) !== count) {
        throw new Error("sphere: the module rejected its input");
      }
      picture.set(pixels.subarray(0, 4 * count), at + 4 * (first + start));
    }
    for (const [column, opacity] of edge) picture[at + 4 * column + 3] = opacity;
  }
  return picture;
}

/**
 * A row of a sphere. As in the shader, the outline is half a pixel from the border, and pixels that
 * the outline crosses show the rim.
 *
 * @param {number} size
 * @param {number} row
 * @returns {Row}
 */
function rowOf(size, row) {
  const radius = Math.max(size - 1, 1) / 2;
  const up = (size / 2 - row - 0.5) / radius;
  const [u, v, s] = [new Int32Array(size), new Int32Array(size), new Float32Array(size)];
  const edge = [];
  let [first, count] = [0, 0];
  for (let column = 0; column < size; column++) {
    const across = (column + 0.5 - size / 2) / radius;
    const distance = Math.sqrt(across * across + up * up);
    const coverage = Math.min(1, radius * (1 - distance) + 0.5);
    if (coverage <= 0) continue;
    if (count === 0) first = column;
    if (coverage < 1) edge.push([column, 255 * coverage]);
    const scale = Math.sqrt(1 + Math.sqrt(Math.max(0, 1 - distance * distance)));
    const unit = 2 ** 31 / (scale * Math.max(1, distance));
    u[count] = Math.min(across * unit, 2 ** 31 - 1);
    v[count] = Math.min(up * unit, 2 ** 31 - 1);
    s[count] = scale;
    count++;
  }
  return { first, u: u.slice(0, count), v: v.slice(0, count), s: s.slice(0, count), edge };
}

/** @type {Float32Array[] | undefined} The normals of nodes; those beyond the map point away. */
let nodes;

/**
 * Fills the palette of a module with its scene.
 *
 * @param {Engine} engine
 * @param {number} exposure
 * @param {number} curve
 * @returns {boolean} whether it makes a picture faster
 */
function fill(engine, exposure, curve) {
  nodes ??= nodesOf();
  engine.shadeAll("sphere", nodes, (start, count) => {
    if (engine.wasm.nodes(start, count, exposure, curve) !== count) {
      throw new Error("sphere: the module rejected the exposure");
    }
  });
  return engine.wasm.smooth() >= FEWEST;
}

function nodesOf() {
  const [x, y, z] = [0, 1, 2].map(() => new Float32Array(SIDE ** 2));
  for (let at = 0; at < SIDE ** 2; at++) {
    const half = (SIDE - 1) / 2;
    const [u, v] = [(at % SIDE) / half - 1, Math.floor(at / SIDE) / half - 1];
    const square = u * u + v * v;
    const scale = Math.sqrt(2 - square);
    [x[at], y[at], z[at]] = [u * scale, v * scale, 1 - square];
  }
  return [x, y, z];
}
