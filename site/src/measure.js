// Errors, costs and effects of a scene, measured here by the CPU module.

import { EFFECTS } from "../eigenshade/src/index.js";

/** @typedef {import("../eigenshade/src/index.js").Scene} Scene */
/** @typedef {{ r: Float32Array, g: Float32Array, b: Float32Array }} Picture */

/** The slider's steps: tolerances from 10^-0.5 to 10^-6, and all terms. */
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
 * The error of a picture, relative to the peak of another.
 *
 * @param {Picture} found
 * @param {Picture} expected
 */
export function errorOf(found, expected) {
  const difference = /** @type {Picture} */ (
    Object.fromEntries(channels.map((c) => [c, found[c].map((value, k) => value - expected[c][k])]))
  );
  const peak = peakOf(expected);
  return { rms: rmsOf(difference) / peak, worst: peakOf(difference) / peak };
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
  return {
    light: time(() => void scene.light(light).truncation),
    pixel: time(() => void scene.shade(x, y, z)) / x.length,
  };
}

/**
 * Terms and errors at every step.
 *
 * @param {Scene} scene
 * @param {Picture} reference
 */
export function curveOf(scene, reference) {
  const curve = Array.from({ length: STEPS }, (_, step) => {
    scene.within(toleranceOf(step));
    return { terms: scene.terms, ...errorOf(pictureOf(scene), reference) };
  });
  return curve;
}

/**
 * Terms without an effect, at the absolute error that `tolerance` is of the whole picture.
 *
 * @param {Scene} scene of all effects
 * @param {number | undefined} tolerance
 * @returns {Record<string, { share: number, saved: number }>}
 */
export function effectsOf(scene, tolerance = 1e-6) {
  const whole = pictureOf(scene.effects().within());
  const [rms, peak] = [rmsOf(whole), peakOf(whole)];
  const all = scene.within(tolerance).terms;
  const entries = EFFECTS.map((effect) => {
    const share = rmsOf(pictureOf(scene.within().effects([effect]))) / (rms || 1);
    scene.effects(EFFECTS.filter((other) => other !== effect));
    const rest = peakOf(pictureOf(scene));
    const relative = (tolerance * peak) / rest;
    // What is left may be darker than the error.
    const terms = relative < 1 ? scene.within(Math.max(1e-30, relative)).terms : 0;
    return [effect, { share, saved: all - terms }];
  });
  scene.effects().within();
  return Object.fromEntries(entries);
}

/**
 * The effects and the step that take the fewest terms within an error (rms); of equals, those of
 * fewer effects.
 *
 * @param {Scene} scene
 * @param {number} tolerance
 */
export function automatic(scene, tolerance) {
  const reference = pictureOf(scene.effects().within());
  const at = (/** @type {number} */ step) => {
    scene.within(toleranceOf(step));
    return { step, terms: scene.terms, ...errorOf(pictureOf(scene), reference) };
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
