// The error of a picture on a screen: CIEDE2000 between pixels that are exposed, clipped to white
// and encoded in sRGB.

import { differenceCiede2000, modeLab65, modeRgb, modeXyz65, useMode } from "../vendor/culori.js";
import { encoded } from "./color.js";
import { counted } from "./plot.js";
import { COMPONENTS } from "./state.js";

useMode(modeRgb);
useMode(modeXyz65);
const lab = useMode(modeLab65);
const difference = differenceCiede2000();

/** @typedef {{ mean: number, most: number }} ScreenError the mean and the 95th percentile of pixels */

/**
 * The colors of a picture on a screen.
 *
 * @param {import("./measure.js").Picture} picture
 * @param {number} exposure
 */
export const colorsOf = ({ r, g, b }, exposure) =>
  Array.from(r, (red, k) => {
    const [x, y, z] = [red, g[k], b[k]].map((value) => encoded(exposure * value, false) / 255);
    return lab({ mode: "rgb", r: x, g: y, b: z });
  });

/**
 * The differences of two pictures.
 *
 * @param {ReturnType<typeof colorsOf>} found
 * @param {ReturnType<typeof colorsOf>} expected
 * @returns {ScreenError}
 */
export function screenError(found, expected) {
  const apart = Float64Array.from(found, (color, k) => difference(expected[k], color)).sort();
  const mean = apart.reduce((sum, value) => sum + value, 0) / apart.length;
  return { mean, most: apart[Math.ceil(0.95 * apart.length) - 1] };
}

/** An error in words: the mean, and what 95 % of pixels do not exceed. */
export const screenText = (/** @type {ScreenError} */ { mean, most }) => `mean ${digits(mean)}, 95\u00a0% within ${digits(most)}`;
const digits = (/** @type {number} */ value) => (value > 0 && value < 0.05 ? "< 0.1" : value.toFixed(value < 9.95 ? 1 : 0));

/** What people see of an error. */
export const seen = (/** @type {ScreenError} */ { mean, most }) =>
  mean <= 1 && most <= 2 ? "not visible" : mean <= 2 && most <= 5 ? "close" : "visible";

/** @typedef {{ light: string, roughness: number, sources: number, error: ScreenError }} Direct */

/**
 * The error of a picture in words, and what it is compared with.
 *
 * @param {ScreenError} error against the best that the page computes, which has degree 9, too, so
 *   that the whole error is larger
 * @param {number} sources those of the best
 */
export function verdict(error, sources) {
  const word = seen(error);
  const also = sources ? ` and ${counted(sources, "source")}` : "";
  return {
    error: `${word === "visible" ? "Visible" : `At best ${word}`}: ${screenText(error)}`,
    against: `CIEDE2000 against all terms of ${COMPONENTS} images${also}; what degree 9 lacks adds to it`,
  };
}

/**
 * The same where the error of all terms against direct integration is known of a metal that resembles
 * the material: the sum of both is as large as the whole error, or larger.
 *
 * @param {ScreenError} error against all terms with the same sources
 * @param {Direct} direct
 */
export function wholeVerdict(error, { light, roughness, sources, error: { mean, most } }) {
  const whole = { mean: error.mean + mean, most: error.most + most };
  const word = seen(whole);
  const also = error.most > 0 ? ", and what this picture leaves out" : "";
  return {
    error: `${word[0].toUpperCase()}${word.slice(1)}: ${screenText(whole)}`,
    against: `CIEDE2000 against direct integration: that of a metal of roughness ${roughness} in ${light} with ${sources ? counted(sources, "source") : "no sources"}${also}`,
  };
}
