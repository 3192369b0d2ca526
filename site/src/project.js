// Panoramas to light coefficients, in the frame of docs/method.md.

import { DEGREE, harmonics } from "./harmonics.js";

/**
 * Red, green and blue at each stride; with a table, the data are places in it.
 *
 * @typedef {{ width: number, height: number, stride: number, data: ArrayLike<number>, table?: ArrayLike<number> }} Map
 */

/**
 * The coefficients of an equirectangular map of linear radiance, row 0 at the top. Texels have
 * their exact solid angle; what a row holds beyond the degree about the vertical integrates to
 * zero, so each row is first reduced to a few directions.
 *
 * @param {Map} map
 * @param {(share: number) => void} [progress]
 */
export function project({ width, height, stride, data, table }, progress = () => {}, degree = DEGREE) {
  const count = (degree + 1) ** 2;
  // The product of two series of a degree needs more than twice as many directions.
  const around = 2 * degree + 6;
  const total = [0, 1, 2].map(() => new Float64Array(count));
  const angle = (/** @type {number} */ k, /** @type {number} */ of) => 2 * Math.PI * ((k + 0.5) / of - 0.5);
  const tables = Array.from({ length: degree + 1 }, (_, k) => ({
    cosine: Float64Array.from({ length: width }, (_, x) => Math.cos(k * angle(x, width))),
    sine: Float64Array.from({ length: width }, (_, x) => Math.sin(k * angle(x, width))),
  }));
  const values = new Float64Array(count);
  const row = [0, 1, 2].map(() => new Float64Array(width));
  for (let y = 0; y < height; y++) {
    const [top, bottom] = [(Math.PI * y) / height, (Math.PI * (y + 1)) / height];
    const weight = ((2 * Math.PI) / width) * (Math.cos(top) - Math.cos(bottom));
    for (let x = 0, at = y * width * stride; x < width; x++, at += stride) {
      for (let c = 0; c < 3; c++) row[c][x] = table ? table[data[at + c]] : data[at + c];
    }
    const moments = row.map((line) =>
      tables.map(({ cosine, sine }) => {
        let [even, odd] = [0, 0];
        for (let x = 0; x < width; x++) {
          even += line[x] * cosine[x];
          odd += line[x] * sine[x];
        }
        return [even, odd];
      }),
    );
    const [slantSine, slantCosine] = [Math.sin((top + bottom) / 2), Math.cos((top + bottom) / 2)];
    for (let j = 0; j < around; j++) {
      const t = angle(j, around);
      harmonics(slantSine * Math.sin(t), slantCosine, -slantSine * Math.cos(t), values);
      moments.forEach((series, channel) => {
        let level = series[0][0];
        for (let k = 1; k <= degree; k++) {
          level += 2 * (series[k][0] * Math.cos(k * t) + series[k][1] * Math.sin(k * t));
        }
        level *= weight / around;
        for (let k = 0; k < count; k++) total[channel][k] += level * values[k];
      });
    }
    if (y % 16 === 15) progress((y + 1) / height);
  }
  const [r, g, b] = total.map((channel) => Float32Array.from(channel));
  if (![r, g, b].every((channel) => channel.every(Number.isFinite))) {
    throw new RangeError("the map holds infinite values or NaN");
  }
  return { r, g, b };
}

/**
 * The map with 256 to 512 texels on its longer side, or `side`: means of blocks of texels, or texels
 * repeated, so that each is a patch and not a point for {@link project}.
 *
 * @param {Map} map
 * @returns {Map}
 */
export function resized({ width, height, stride, data, table }, side = Math.min(512, Math.max(256, width, height))) {
  const [columns, rows] = [width, height].map((length) => Math.max(1, Math.round((length * side) / Math.max(width, height))));
  const means = new Float32Array(3 * columns * rows);
  const span = (/** @type {number} */ k, /** @type {number} */ from, /** @type {number} */ to) => {
    const start = Math.floor((k * from) / to);
    return [start, Math.max(start + 1, Math.floor(((k + 1) * from) / to))];
  };
  for (let row = 0; row < rows; row++) {
    const [top, bottom] = span(row, height, rows);
    for (let column = 0; column < columns; column++) {
      const [left, right] = span(column, width, columns);
      for (let c = 0; c < 3; c++) {
        let sum = 0;
        for (let y = top; y < bottom; y++) {
          for (let x = left; x < right; x++) {
            const value = data[(y * width + x) * stride + c];
            sum += table ? table[value] : value;
          }
        }
        means[3 * (row * columns + column) + c] = sum / ((bottom - top) * (right - left));
      }
    }
  }
  return { width: columns, height: rows, stride: 3, data: means };
}
