// Small bright sources of a map, for highlights that degree 9 blurs.
//
// Matching pursuit over the sphere: the source is taken that reduces most what a glossy reflection
// of the map has beyond degree 9, then the next one from what is left. Sources are round: the
// harmonics of one are those of its direction times exp(-l (l + 1) spread² / 2).

import { DEGREE, harmonics } from "./harmonics.js";

/** The degree to which the map is known: the highlight of a roughness of 0.2 has little beyond. */
export const FINE = 40;

/** Most sources of a map. */
export const MOST = 8;

/** Directions and spreads (radians) that are tried first. A wider source is in degree 9. */
const TRIED = 3000;
const SPREADS = [0.01, 0.04, 0.08, 0.12, 0.16];
const [NARROWEST, WIDEST] = [0.004, 0.2];

/** A source is worth it if it reduces more than this share of the square of the mean light. */
const WORTH = 3e-4;

/** First move in radians and first factor of a spread, and how often both are halved. */
const [MOVE, WIDEN, HALVINGS] = [0.04, 1.5, 7];

/** What metals of these roughnesses keep of each degree, squared. */
const WEIGHTS = Float64Array.from({ length: FINE + 1 }, (_, l) =>
  l <= DEGREE ? 0 : [0.2, 0.3].reduce((sum, roughness) => {
    // The lobe of Trowbridge and Reitz, 1 / (1 + (t / 2α)²)², has the transform x K_1(x), here by
    // its first terms for large x.
    const x = 2 * roughness ** 2 * l;
    return sum + ((Math.PI * x) / 2) * Math.exp(-2 * x) * (1 + 3 / (8 * x)) ** 2;
  }, 0));

/** The power of a source of energy 1, by degree. */
const blurs = (/** @type {number} */ spread) =>
  Float64Array.from({ length: FINE + 1 }, (_, l) => Math.exp((-l * (l + 1) * spread * spread) / 2));

const values = new Float64Array((FINE + 1) ** 2);

/**
 * The energies that fit best at a direction, none negative, and how much they reduce what is left.
 *
 * @param {Float64Array[]} sums of each channel the part of each degree there, weighted
 * @param {number} spread
 */
function fit(sums, spread) {
  const blur = blurs(spread);
  const square = blur.reduce((sum, b, l) => sum + (WEIGHTS[l] * (2 * l + 1) * b * b) / (4 * Math.PI), 0);
  const energy = sums.map((parts) => Math.max(0, blur.reduce((sum, b, l) => sum + b * parts[l], 0) / square));
  return { energy, spread, score: square * energy.reduce((sum, e) => sum + e * e, 0) };
}

/**
 * @param {Float64Array[]} left the coefficients of what is left, by channel
 * @param {number[]} direction
 */
function sumsAt(left, [x, y, z]) {
  harmonics(x, y, z, values);
  return left.map((channel) => {
    const parts = new Float64Array(FINE + 1);
    for (let l = DEGREE + 1; l <= FINE; l++) {
      let sum = 0;
      for (let k = l * l; k < (l + 1) ** 2; k++) sum += channel[k] * values[k];
      parts[l] = WEIGHTS[l] * sum;
    }
    return parts;
  });
}

const unit = (/** @type {number[]} */ vector) => {
  const length = Math.hypot(...vector);
  return vector.map((value) => value / length);
};

/** Two unit vectors across a direction. */
function across([x, y, z]) {
  const one = unit(Math.abs(z) < 0.9 ? [y, -x, 0] : [0, z, -y]);
  return [one, [y * one[2] - z * one[1], z * one[0] - x * one[2], x * one[1] - y * one[0]]];
}

/**
 * The sources of a map, in the order of their worth, seven numbers each as `Channels` has them: the
 * first n are the set of n.
 *
 * @param {{ r: Float32Array, g: Float32Array, b: Float32Array }} map coefficients to degree {@link FINE}
 * @param {(share: number) => void} [progress]
 */
export function pursue({ r, g, b }, progress = () => {}) {
  const left = [r, g, b].map((channel) => Float64Array.from(channel));
  const mean = left.reduce((sum, channel) => sum + channel[0] ** 2, 0);
  const golden = Math.PI * (3 - Math.sqrt(5));
  /** @type {number[]} */
  const sources = [];
  for (let count = 0; count < MOST; count++) {
    let best = { direction: [0, 0, 1], energy: [0, 0, 0], spread: 0, score: 0 };
    const attempt = (/** @type {number[]} */ direction, /** @type {number[]} */ spreads) => {
      const sums = sumsAt(left, direction);
      for (const spread of spreads) {
        const found = fit(sums, spread);
        if (found.score > best.score) best = { direction, ...found };
      }
    };
    for (let k = 0; k < TRIED; k++) {
      const [z, turn] = [1 - (2 * k + 1) / TRIED, golden * k];
      const radius = Math.sqrt(1 - z * z);
      attempt([radius * Math.cos(turn), radius * Math.sin(turn), z], SPREADS);
    }
    if (!(best.score > WORTH * mean)) break;
    for (let step = 1; step > 2 ** -HALVINGS; ) {
      const { direction, spread, score } = best;
      const wider = [WIDEN ** step, WIDEN ** -step].map((factor) => Math.min(WIDEST, Math.max(NARROWEST, spread * factor)));
      attempt(direction, wider);
      for (const axis of across(direction)) {
        for (const sign of [-1, 1]) attempt(unit(direction.map((value, k) => value + sign * MOVE * step * axis[k])), [spread]);
      }
      if (best.score <= score * (1 + 1e-5)) step /= 2;
    }
    const { direction, energy, spread } = best;
    harmonics(direction[0], direction[1], direction[2], values);
    const blur = blurs(spread);
    for (let l = 0; l <= FINE; l++) {
      for (let k = l * l; k < (l + 1) ** 2; k++) {
        left.forEach((channel, c) => (channel[k] -= energy[c] * blur[l] * values[k]));
      }
    }
    sources.push(...direction, ...energy, spread);
    progress((count + 1) / MOST);
  }
  return Float32Array.from(sources);
}
