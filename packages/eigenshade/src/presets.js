// The shipped lights and materials, each a file of its own that is fetched by name.

import { asset, misplaced, required } from "./assets.js";
import { SOURCE, checkNames, checkSources } from "./input.js";
import { near } from "./suggest.js";

/** @typedef {import("./input.js").Channels} Channels */
/** @typedef {import("./input.js").MetallicRoughness} MetallicRoughness */

/** @type {Map<string, Promise<any>>} */
const loaded = new Map();

/**
 * What is read from a file, once.
 *
 * @template T
 * @param {string} path
 * @param {() => Promise<T>} read
 * @returns {Promise<T>}
 */
function once(path, read) {
  let found = loaded.get(path);
  if (!found) {
    found = read();
    loaded.set(path, found);
    // A failed download may be tried again.
    found.catch(() => loaded.delete(path));
  }
  return found;
}

/**
 * The coefficients of a shipped light, to degree 9, and its first small sources, at most this many.
 * With `"auto"`, a scene takes as many of the first 8 as a material needs. Lights without a map have
 * none. Each call makes a copy.
 *
 * @param {string} name such as `"park"`; {@link presetNames} lists all
 * @param {{ sources?: number | "auto" }} [options] 0 sources by default
 * @returns {Promise<Channels>}
 * @throws {TypeError | RangeError} if there is no light of this name, for options that are none, or
 *   another number of sources
 */
export async function lightPreset(name, options = {}) {
  checkNames("lightPreset", options, "sources");
  const { sources = 0 } = options;
  checkSources(sources);
  const light = await preset("light", name);
  if (sources === 0) return light;
  const { steps, all } = await sourcesOf(name);
  if (sources !== "auto") return { ...light, sources: all.slice(0, SOURCE * sources) };
  return { ...light, sources: all.slice(), steps };
}

/**
 * What a file has of sources: steps of three numbers each, whether they are of metals, up to which
 * roughness, and how many sources; then the sources as `Channels` has them.
 *
 * @param {string} name
 */
const sourcesOf = (name) => {
  const path = `presets/sources/${name}.bin`;
  return once(path, async () => {
    const bytes = await required(path);
    const numbers = new Float32Array(bytes.byteLength % 4 ? [-1] : bytes);
    const start = 1 + 3 * numbers[0];
    if (!(start <= numbers.length && (numbers.length - start) % SOURCE === 0)) {
      throw misplaced(path, `is no preset: it has ${bytes.byteLength} bytes`);
    }
    const steps = Array.from({ length: numbers[0] }, (_, k) => {
      const [isMetal, roughness, count] = numbers.subarray(1 + 3 * k);
      return { isMetal: isMetal === 1, roughness, count };
    });
    return { steps, all: numbers.subarray(start) };
  });
};

/**
 * The coefficients of a shipped material, to order 7, a copy at each call.
 *
 * @param {string} name such as `"gold-metallic-paint"`; {@link presetNames} lists all
 * @returns {Promise<Channels>}
 * @throws {RangeError} if there is no material of this name
 */
export const materialPreset = (name) => preset("material", name);

/**
 * A light, by name or as it is.
 *
 * @param {string | Channels} light
 * @param {number | "auto"} sources of a light by name
 */
export const lightOf = (light, sources) =>
  typeof light === "string" ? lightPreset(light, { sources }) : light;

/**
 * A material, by name or as it is.
 *
 * @param {string | Channels | MetallicRoughness} material
 */
export const materialOf = (material) =>
  typeof material === "string" ? materialPreset(material) : material;

/**
 * The names of the shipped lights and materials.
 *
 * @returns {Promise<{ light: string[], material: string[] }>}
 */
export async function presetNames() {
  const path = "presets/names.json";
  const text = new TextDecoder().decode(await required(path));
  try {
    return JSON.parse(text);
  } catch {
    throw misplaced(path, "is no list of presets");
  }
}

/**
 * @param {"light" | "material"} kind
 * @param {string} name
 * @returns {Promise<Channels>}
 */
async function preset(kind, name) {
  const path = `presets/${kind}/${name}.bin`;
  const count = kind === "light" ? 100 : 40;
  const numbers = await once(path, () => read(kind, name, path, count));
  // Copies, which the caller may change.
  const [r, g, b] = [0, 1, 2].map((channel) =>
    numbers.slice(channel * count, (channel + 1) * count),
  );
  const gloss = numbers.slice(3 * count);
  return gloss.length ? { r, g, b, gloss, name } : { r, g, b, name };
}

/**
 * @param {"light" | "material"} kind
 * @param {string} name
 * @param {string} path
 * @param {number} count
 */
async function read(kind, name, path, count) {
  const bytes = /^[a-z0-9-]+$/.test(name) ? await asset(path) : undefined;
  const gloss = bytes ? bytes.byteLength - 12 * count : NaN;
  if (bytes && (gloss === 0 || (gloss === 40 && kind === "material"))) {
    // Little-endian, as every machine that runs WebAssembly in a browser is.
    return new Float32Array(bytes);
  }
  // Servers answer an address that they do not know with a page, too.
  const names = (await presetNames())[kind];
  if (!names.includes(name)) throw unknown(kind, String(name), names);
  throw misplaced(path, bytes ? `is no preset: it has ${bytes.byteLength} bytes` : "is missing");
}

/**
 * The error for a name that does not exist, with names that resemble it.
 *
 * @param {"light" | "material"} kind
 * @param {string} name
 * @param {string[]} names
 */
function unknown(kind, name, names) {
  const parts = name.toLowerCase().split(/[^a-z0-9]+/).filter(Boolean);
  const score = (/** @type {string} */ other) =>
    parts.filter((part) => other.split("-").some((word) => word.startsWith(part))).length;
  const alike = names.filter((other) => score(other) > 0).sort((a, b) => score(b) - score(a));
  const slips = near(name, names);
  const offered = (slips.length ? slips : alike).slice(0, 3).join(", ");
  const hint = offered ? `did you mean ${offered}?` : `there are ${names.join(", ")}`;
  return new RangeError(`no ${kind} is called "${name}"; ${hint}`);
}
