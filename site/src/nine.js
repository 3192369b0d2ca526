// The nine-term formula of Ramamoorthi and Hanrahan (2001): Lambertian shading by degree 2.

import { harmonics } from "./harmonics.js";
import { inverse, rotate } from "./turn.js";

/** The cosine's gains by degree over π: what a white matte reflects. */
const GAINS = [1, 2 / 3, 1 / 4];

/**
 * The nine coefficients of the reflected light in each channel: 27 numbers, by channel.
 *
 * @param {{ r: ArrayLike<number>, g: ArrayLike<number>, b: ArrayLike<number> }} light
 * @param {number[]} albedo
 */
export function nineTerms({ r, g, b }, albedo) {
  const terms = new Float32Array(27);
  [r, g, b].forEach((channel, which) => {
    for (let k = 0; k < 9; k++) {
      terms[9 * which + k] = albedo[which] * GAINS[Math.floor(Math.sqrt(k))] * (channel[k] ?? 0);
    }
  });
  return terms;
}

/**
 * The formula at normals, under the light turned by a quaternion.
 *
 * @param {Float32Array} terms
 * @param {number[]} turn
 * @param {ArrayLike<number>[]} normals
 */
export function shadeNine(terms, turn, [x, y, z]) {
  const [back, values] = [inverse(turn), new Float64Array(9)];
  const [r, g, b] = [0, 1, 2].map(() => new Float32Array(x.length));
  for (let n = 0; n < x.length; n++) {
    const [u, v, w] = rotate(back, [x[n], y[n], z[n]]);
    harmonics(u, v, w, values);
    [r, g, b].forEach((channel, which) => {
      for (let k = 0; k < 9; k++) channel[n] += terms[9 * which + k] * values[k];
    });
  }
  return { r, g, b };
}

/** The same in GLSL: `nine[9]` holds the terms, `nineBack` turns normals back into the light's frame. */
export const GLSL = `
uniform vec3 nine[9];
uniform mat3 nineBack;
vec3 nineTerms(vec3 normal) {
  vec3 n = nineBack * normal;
  return 0.28209479 * nine[0]
    - 0.48860251 * n.y * nine[1] + 0.48860251 * n.z * nine[2] - 0.48860251 * n.x * nine[3]
    - 1.09254843 * n.x * n.y * nine[4] - 1.09254843 * n.y * n.z * nine[5]
    + 0.31539157 * (3.0 * n.z * n.z - 1.0) * nine[6]
    - 1.09254843 * n.x * n.z * nine[7] + 0.54627422 * (n.x * n.x - n.y * n.y) * nine[8];
}`;
