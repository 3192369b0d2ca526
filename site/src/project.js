// Panoramas to light coefficients: degree 9, the frame of docs/conventions.md.

import { COUNT, DEGREE, harmonics } from "./harmonics.js";

/** Directions a row is reduced to: the product of two series of degree 9 needs more than 18. */
const AROUND = 24;

/**
 * The coefficients of an equirectangular map of linear radiance, row 0 at the top. Texels have
 * their exact solid angle; what a row holds beyond degree 9 about the vertical integrates to zero,
 * so each row is first reduced to a few directions.
 *
 * @param {{ width: number, height: number, stride: number, data: ArrayLike<number>, table?: ArrayLike<number> }} map
 *   red, green and blue at each stride; with a table, the data are places in it
 * @param {(share: number) => void} [progress]
 */
export function project({ width, height, stride, data, table }, progress = () => {}) {
  const total = [0, 1, 2].map(() => new Float64Array(COUNT));
  const angle = (/** @type {number} */ k, /** @type {number} */ of) => 2 * Math.PI * ((k + 0.5) / of - 0.5);
  const tables = Array.from({ length: DEGREE + 1 }, (_, k) => ({
    cosine: Float64Array.from({ length: width }, (_, x) => Math.cos(k * angle(x, width))),
    sine: Float64Array.from({ length: width }, (_, x) => Math.sin(k * angle(x, width))),
  }));
  const values = new Float64Array(COUNT);
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
    for (let j = 0; j < AROUND; j++) {
      const t = angle(j, AROUND);
      harmonics(slantSine * Math.sin(t), slantCosine, -slantSine * Math.cos(t), values);
      moments.forEach((series, channel) => {
        let level = series[0][0];
        for (let k = 1; k <= DEGREE; k++) {
          level += 2 * (series[k][0] * Math.cos(k * t) + series[k][1] * Math.sin(k * t));
        }
        level *= weight / AROUND;
        for (let k = 0; k < COUNT; k++) total[channel][k] += level * values[k];
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
