// Spherical harmonics in the convention of docs/method.md, and lights that a formula
// describes.

import { factor } from "../eigenshade/src/window.js";

export const DEGREE = 9;
export const COUNT = (DEGREE + 1) ** 2;

/**
 * All Y_l^m of a unit vector up to a degree, at l² + l + m.
 *
 * @param {number} x
 * @param {number} y
 * @param {number} z
 * @param {Float64Array} out (degree + 1)² numbers
 */
export function harmonics(x, y, z, out, degree = Math.sqrt(out.length) - 1) {
  // Normalized P_l^m / (-sin)^m by the three-term recurrence; Re and Im of (x + iy)^m.
  let [cosine, sine, start] = [1, 0, Math.sqrt(1 / (4 * Math.PI))];
  for (let m = 0; m <= degree; m++) {
    if (m > 0) start *= Math.sqrt((2 * m + 1) / (2 * m));
    let [before, now] = [0, start];
    const sign = m % 2 ? -1 : 1;
    for (let l = m; l <= degree; l++) {
      if (m === 0) out[l * l + l] = now;
      else {
        out[l * l + l + m] = Math.SQRT2 * sign * cosine * now;
        out[l * l + l - m] = -Math.SQRT2 * sine * now;
      }
      const next = l + 1;
      const a = Math.sqrt((4 * next * next - 1) / (next * next - m * m));
      const b = Math.sqrt(((next - 1) ** 2 - m * m) / (4 * (next - 1) ** 2 - 1) || 0);
      [before, now] = [now, a * (z * now - b * before)];
    }
    [cosine, sine] = [cosine * x - sine * y, cosine * y + sine * x];
  }
  return out;
}

const three = (/** @type {(channel: number) => number[]} */ of) => {
  const [r, g, b] = [0, 1, 2].map((channel) => Float32Array.from(of(channel)));
  return { r, g, b };
};

/** Light of this color from everywhere. */
export const ambient = (color = [1, 1, 1]) =>
  three((channel) =>
    Array.from({ length: COUNT }, (_, k) => (k === 0 ? 2 * Math.sqrt(Math.PI) * color[channel] : 0)),
  );

/**
 * A disc of light around a direction, of an angular radius in radians.
 *
 * @param {number[]} direction a unit vector
 * @param {number} radius
 * @param {number[]} color radiance
 */
export function disc(direction, radius, color) {
  // 2π times the integral of P_l from the cosine to 1: (P_{l-1} - P_{l+1}) / (2l + 1).
  const cosine = Math.cos(radius);
  const legendre = [1, cosine];
  for (let l = 1; l <= DEGREE; l++) {
    legendre.push(((2 * l + 1) * cosine * legendre[l] - l * legendre[l - 1]) / (l + 1));
  }
  return along(direction, color, (l) =>
    2 * Math.PI * (l === 0 ? 1 - cosine : (legendre[l - 1] - legendre[l + 1]) / (2 * l + 1)),
  );
}

/** Light from one direction, of this irradiance on a surface that faces it. */
export const directional = (/** @type {number[]} */ direction, /** @type {number[]} */ color) =>
  along(direction, color, () => 1);

/** Sky above a ground. */
export const hemisphere = (/** @type {number[]} */ sky, /** @type {number[]} */ ground) =>
  sum(ambient(ground), disc([0, 1, 0], Math.PI / 2, sky.map((value, k) => value - ground[k])));

/**
 * The light after a window of this width, which blurs it instead of letting it ring.
 *
 * @param {{ r: Float32Array, g: Float32Array, b: Float32Array }} light
 * @param {number} width
 */
export function windowed(light, width = 20) {
  const each = (/** @type {Float32Array} */ channel) =>
    channel.map((value, k) => value * factor(width, Math.floor(Math.sqrt(k))));
  return { r: each(light.r), g: each(light.g), b: each(light.b) };
}

/** @param {{ r: Float32Array, g: Float32Array, b: Float32Array }[]} lights */
export function sum(...lights) {
  const of = (/** @type {"r" | "g" | "b"} */ channel) =>
    lights[0][channel].map((_, k) => lights.reduce((total, light) => total + light[channel][k], 0));
  return { r: of("r"), g: of("g"), b: of("b") };
}

/**
 * @param {number[]} direction
 * @param {number[]} color
 * @param {(degree: number) => number} factor
 */
function along([x, y, z], color, factor) {
  const values = harmonics(x, y, z, new Float64Array(COUNT));
  return three((channel) =>
    Array.from(values, (value, k) => value * color[channel] * factor(Math.floor(Math.sqrt(k)))),
  );
}

const LAMP = [-0.5, 0.62, 0.6].map((value) => value / Math.hypot(0.5, 0.62, 0.6));

/** The lights of formulas that the page offers. */
export const ANALYTIC = {
  ambient: () => ambient(),
  hemisphere: () => hemisphere([0.8, 0.92, 1.1], [0.24, 0.2, 0.16]),
  directional: () => windowed(sum(directional(LAMP, [3, 2.85, 2.6]), ambient([0.06, 0.07, 0.09]))),
};
