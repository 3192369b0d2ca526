// The texts of a scene's shader: their languages and names.

import { checkNames, checkWhole, nameOf, shown } from "./input.js";

/**
 * Where a GLSL function finds the coefficients, in the module's order before WGSL: a uniform array, of
 * which WebGL 2 promises 224 vectors (all terms are 194, and sources take one and four each), a uniform
 * block `Eigenshade` for up to 1,024, or a float texture of one row.
 */
export const STORAGES = Object.freeze(/** @type {const} */ (["uniforms", "block", "texture"]));

/** @typedef {typeof STORAGES[number]} Storage */

/** @typedef {(language: number) => string} Texts the module's text in each language */

/**
 * As `Scene.glsl`.
 *
 * @param {Texts} texts
 * @param {Storage} storage
 * @param {{ prefix?: string }} options
 */
export function glsl(texts, storage, options) {
  const language = nameOf("glsl", storage, STORAGES);
  checkNames("glsl", options, "prefix");
  checkPrefix("glsl", options.prefix);
  return prefixed(texts(language), options.prefix);
}

/**
 * As `Scene.wgsl`.
 *
 * @param {Texts} texts
 * @param {{ prefix?: string, group?: number, binding?: number }} options
 */
export function wgsl(texts, options) {
  checkNames("wgsl", options, "prefix, group, binding");
  const { prefix, group = 0, binding = 0 } = options;
  checkPrefix("wgsl", prefix);
  checkWhole("wgsl: group", group, 1000);
  checkWhole("wgsl: binding", binding, 1000);
  const text = texts(STORAGES.length);
  const place = `@group(${group}) @binding(${binding})`;
  return prefixed(text.replace("@group(0) @binding(0)", place), prefix);
}

/**
 * Throws unless names of GLSL and WGSL may begin with this. GLSL reserves `gl_`, and two underscores in
 * a row.
 *
 * @param {string} what
 * @param {unknown} prefix
 */
function checkPrefix(what, prefix = "") {
  const isPrefix = typeof prefix === "string" && /^(?!gl_)([a-z]\w*)?$/i.test(prefix);
  if (!isPrefix || prefix.includes("__")) {
    throw new RangeError(
      `${what}: the prefix is ${shown(prefix)}, expected a letter, then letters, digits and single underscores`,
    );
  }
}

/**
 * A text whose names begin with a prefix.
 *
 * @param {string} text
 * @param {string} [prefix]
 */
const prefixed = (text, prefix = "") =>
  text.replaceAll(/\b(irradiance|eigenshade|Eigenshade)\b/g, `${prefix}$1`);
