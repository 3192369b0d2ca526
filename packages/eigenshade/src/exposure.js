// The exposure of a sphere's picture.

import { isExposure, isNumber, shown } from "./input.js";

/** What bright pixels have after {@link exposureOf}. */
const BRIGHT = 0.8;

/** Normals at points spread evenly over a sphere's picture, in a spiral. */
const DISC = (() => {
  const axes = [0, 1, 2].map(() => new Float32Array(512));
  for (let k = 0; k < 512; k++) {
    const [radius, angle] = [Math.sqrt((k + 0.5) / 512), k * Math.PI * (3 - Math.sqrt(5))];
    axes[0][k] = radius * Math.cos(angle);
    axes[1][k] = radius * Math.sin(angle);
    axes[2][k] = Math.sqrt(1 - radius * radius);
  }
  return axes;
})();

/**
 * As `Scene.exposure`.
 *
 * @param {import("./scene.js").Scene} scene
 * @param {number} share
 */
export function exposureOf(scene, share) {
  if (!(isNumber(share) && share >= 0 && share <= 1)) {
    throw new RangeError(`exposure: the share is ${shown(share)}, expected a number from 0 to 1`);
  }
  const [x, y, z] = DISC;
  const { r, g, b } = scene.shade(x, y, z);
  const largest = r.map((red, k) => Math.max(red, g[k], b[k])).sort();
  const white = largest[Math.round(share * (largest.length - 1))];
  const exposure = BRIGHT / white;
  return isExposure(exposure) ? exposure : 1;
}
