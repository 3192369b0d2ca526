// Errors, costs and effects of a scene, measured here by the CPU module.

import { EFFECTS } from "../eigenshade/src/index.js";

/** @typedef {import("../eigenshade/src/index.js").Scene} Scene */
/** @typedef {{ r: Float32Array, g: Float32Array, b: Float32Array }} Picture */

/** The slider's steps: shares of white from 10^-0.5 to 10^-6, and all terms. */
export const STEPS = 41;
/** The last step: all terms. */
export const ALL_TERMS = STEPS - 1;

/** The tolerance of a step, or `undefined` for all terms. */
export const toleranceOf = (/** @type {number} */ step) =>
  step >= ALL_TERMS ? undefined : 10 ** (-0.5 - (5.5 * step) / (ALL_TERMS - 1));

/** Normals spread evenly over a sphere's picture, of equal weight. */
export const NORMALS = (() => {
  const count = 1024;
  const axes = [0, 1, 2].map(() => new Float32Array(count));
  for (let k = 0; k < count; k++) {
    const [radius, angle] = [Math.sqrt((k + 0.5) / count), k * Math.PI * (3 - Math.sqrt(5))];
    axes[0][k] = radius * Math.cos(angle);
    axes[1][k] = radius * Math.sin(angle);
    axes[2][k] = Math.sqrt(1 - radius * radius);
  }
  return axes;
})();

/** A scene's picture at {@link NORMALS}. */
export const pictureOf = (/** @type {Scene} */ scene) => scene.shade(NORMALS[0], NORMALS[1], NORMALS[2]);

const channels = /** @type {const} */ (["r", "g", "b"]);

/** The largest value in any channel. */
export const peakOf = (/** @type {Picture} */ picture) =>
  Math.max(1e-30, ...channels.map((c) => picture[c].reduce((most, value) => Math.max(most, Math.abs(value)), 0)));

/** The root mean square in the strongest channel. */
export const rmsOf = (/** @type {Picture} */ picture) =>
  Math.max(...channels.map((c) => Math.sqrt(picture[c].reduce((sum, value) => sum + value * value, 0) / picture[c].length)));

/** The mean in each channel. */
export const meanOf = (/** @type {Picture} */ picture) =>
  channels.map((c) => picture[c].reduce((sum, value) => sum + value, 0) / picture[c].length);

/**
 * The error of a picture against another as shares of white: both are exposed and clipped at white
 * and black.
 *
 * @param {Picture} found
 * @param {Picture} expected
 * @param {number} exposure
 */
export function errorOf(found, expected, exposure) {
  const shown = (/** @type {number} */ value) => Math.min(1, Math.max(0, exposure * value));
  const difference = /** @type {Picture} */ (
    Object.fromEntries(channels.map((c) => [c, found[c].map((value, k) => shown(value) - shown(expected[c][k]))]))
  );
  return { rms: rmsOf(difference), worst: Math.min(1, peakOf(difference)) };
}

/** How many times something runs in about this many milliseconds, and the mean time in seconds. */
function time(/** @type {() => void} */ run, milliseconds = 12) {
  run();
  let [count, spent] = [0, 0];
  const start = performance.now();
  for (let batch = 4; spent < milliseconds; batch *= 2) {
    for (let k = 0; k < batch; k++) run();
    count += batch;
    spent = performance.now() - start;
  }
  return spent / 1000 / count;
}

/**
 * Seconds of a new light, up to the polynomials, and of a pixel in color, on the CPU.
 *
 * @param {Scene} scene
 * @param {import("./state.js").Light} light the light it has
 */
export function timesOf(scene, light) {
  const [x, y, z] = NORMALS;
  // With the window that it has: only the first picture of a light chooses one.
  scene.window(scene.windowWidth);
  const times = {
    light: time(() => void scene.light(light).truncation),
    pixel: time(() => void scene.shade(x, y, z)) / x.length,
  };
  scene.window("auto");
  return times;
}

/**
 * Terms and errors at every step.
 *
 * @param {Scene} scene
 * @param {Picture} reference
 * @param {number} exposure
 */
export function curveOf(scene, reference, exposure) {
  return Array.from({ length: STEPS }, (_, step) => {
    scene.within(toleranceOf(step), exposure);
    return { terms: scene.terms, ...errorOf(pictureOf(scene), reference, exposure) };
  });
}

/**
 * Terms without an effect, at the same share of white.
 *
 * @param {Scene} scene of all effects
 * @param {number} exposure
 * @param {number | undefined} tolerance
 * @returns {Record<string, { share: number, saved: number }>}
 */
export function effectsOf(scene, exposure, tolerance = 1e-6) {
  const rms = rmsOf(pictureOf(scene.effects().within()));
  const all = scene.within(tolerance, exposure).terms;
  const entries = EFFECTS.map((effect) => {
    const share = rmsOf(pictureOf(scene.within().effects([effect]))) / (rms || 1);
    scene.effects(EFFECTS.filter((other) => other !== effect));
    return [effect, { share, saved: all - scene.within(tolerance, exposure).terms }];
  });
  scene.effects().within();
  return Object.fromEntries(entries);
}

/**
 * The effects and the step that take the fewest terms within a share of white (rms); of equals, those
 * of fewer effects.
 *
 * @param {Scene} scene
 * @param {number} exposure
 * @param {number} tolerance
 */
export function automatic(scene, exposure, tolerance) {
  const reference = pictureOf(scene.effects().within());
  const at = (/** @type {number} */ step) => {
    scene.within(toleranceOf(step), exposure);
    return { step, terms: scene.terms, ...errorOf(pictureOf(scene), reference, exposure) };
  };
  let best;
  for (let bits = 15; bits >= 0; bits--) {
    const effects = EFFECTS.filter((_, k) => bits & (1 << k));
    scene.effects(effects);
    if (at(ALL_TERMS).rms > tolerance) continue;
    let [low, high] = [0, ALL_TERMS];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (at(middle).rms <= tolerance) high = middle;
      else low = middle + 1;
    }
    const found = at(low);
    if (!best || found.terms < best.terms || (found.terms === best.terms && effects.length < best.effects.length)) {
      best = { effects, ...found };
    }
  }
  scene.effects().within();
  return best;
}
