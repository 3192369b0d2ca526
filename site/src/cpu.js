// Pictures of a sphere on the CPU: for machines without WebGL 2, thumbnails, eigenimages and hard
// cases.

import { sphere } from "../eigenshade/src/index.js";
import { encoded } from "./color.js";
import { shadeNine } from "./nine.js";

/** @typedef {{ r: ArrayLike<number>, g: ArrayLike<number>, b: ArrayLike<number> }} Values */

/**
 * The normals of a sphere's pixels, row by row from the top, where they are, and their coverage.
 *
 * @param {number} size
 */
export function disc(size) {
  const axes = /** @type {number[][]} */ ([[], [], []]);
  const [places, coverage] = [/** @type {number[]} */ ([]), /** @type {number[]} */ ([])];
  for (let row = 0; row < size; row++) {
    for (let column = 0; column < size; column++) {
      const [x, y] = [((2 * column + 1) / size - 1) / 0.94, (1 - (2 * row + 1) / size) / 0.94];
      const distance = Math.hypot(x, y);
      const covered = Math.min(1, 0.47 * size * (1 - distance) + 0.5);
      if (covered <= 0) continue;
      const scale = Math.max(1, distance);
      axes[0].push(x / scale);
      axes[1].push(y / scale);
      axes[2].push(Math.sqrt(Math.max(0, 1 - distance * distance)));
      places.push(row * size + column);
      coverage.push(covered);
    }
  }
  const [x, y, z] = axes.map((axis) => Float32Array.from(axis));
  return { x, y, z, places, coverage, size };
}

/**
 * The picture of values at the normals of a {@link disc}.
 *
 * @param {ReturnType<typeof disc>} disc
 * @param {Values} values
 * @param {number} exposure
 */
export function image({ places, coverage, size }, { r, g, b }, exposure, tone = true) {
  const picture = new ImageData(size, size);
  places.forEach((place, k) => {
    picture.data.set([r, g, b].map((channel) => encoded(exposure * channel[k], tone)), 4 * place);
    picture.data[4 * place + 3] = 255 * coverage[k];
  });
  return picture;
}

/** Shows a picture on a canvas of its size. */
export function show(/** @type {HTMLCanvasElement} */ canvas, /** @type {ImageData} */ picture) {
  canvas.width = picture.width;
  canvas.height = picture.height;
  canvas.getContext("2d")?.putImageData(picture, 0, 0);
}

/** Pixels of the CPU's picture: it is drawn at every change. */
const SIDE = 240;

/**
 * The sphere, or four of them, as `Drawing.draw` has them.
 *
 * @param {HTMLCanvasElement} canvas
 * @param {import("../eigenshade/src/index.js").Scene} scene
 * @param {import("../eigenshade/src/index.js").Scene | undefined} all of the split view
 * @param {import("./draw.js").Look} look
 */
export function drawCpu(canvas, scene, all, { exposure, nine, times = 10 }) {
  const context = canvas.getContext("2d");
  if (!context) return;
  if (!all) {
    show(canvas, new ImageData(sphere(scene, SIDE, { exposure }), SIDE, SIDE));
    return;
  }
  const pixels = disc(SIDE / 2);
  const { x, y, z } = pixels;
  const [ours, whole, formula] = [scene.shade(x, y, z), all.shade(x, y, z), shadeNine(nine.terms, nine.turn, [x, y, z])];
  const apart = /** @type {any} */ (
    Object.fromEntries(["r", "g", "b"].map((c) => [c, ours[c].map((value, k) => times * Math.abs(value - formula[c][k]))]))
  );
  canvas.width = canvas.height = SIDE;
  [ours, whole, formula, apart].forEach((values, k) =>
    context.putImageData(image(pixels, values, exposure, k < 3), (k % 2) * (SIDE / 2), Math.floor(k / 2) * (SIDE / 2)),
  );
}
