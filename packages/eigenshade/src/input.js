// What a user gives: names of choices, and checks that throw one clear error.

import { unlike } from "./suggest.js";

/**
 * An array, maybe a typed one.
 *
 * @typedef {readonly number[] | (ArrayBufferView & ArrayLike<number>)} Numbers
 */

/** The numbers of a source. */
export const SOURCE = 7;

/**
 * Coefficients in three channels: (degree + 1)² of a light in radiance, or those of a material in
 * 1/sr.
 *
 * Small bright sources of a light are seven numbers each: direction, energy and spread. The gloss of
 * a material is ten numbers from 0 to 1: roughness, reflectance in three channels at normal and at
 * grazing incidence, and albedo. No number may exceed 1e15.
 *
 * A light of `lightPreset` with the sources `"auto"` has steps that say how many a gloss needs.
 *
 * @typedef {object} Channels
 * @property {Numbers} r
 * @property {Numbers} g
 * @property {Numbers} b
 * @property {Numbers | null} [sources]
 * @property {import("./steps.js").Steps} [steps]
 * @property {Numbers | null} [gloss]
 * @property {string} [name] what a picture's label calls it
 */

/**
 * What a scene is made of: a preset's name or coefficients of the light, and of the material, or the
 * parameters of a glTF material. An engine of `load` has a table of your own.
 *
 * With `sources`, the first small bright sources of a light by name, at most this many, are shaded on
 * their own, for sharp highlights; `"auto"` takes as few as the
 * material needs to be close on a screen, at most 8. Such a scene has a larger module.
 * `Scene.sources` is the number of those drawn. A scene that is created without, and with a light
 * that has none, takes no light with sources; one with an engine of `load` does if the engine can.
 *
 * @typedef {object} Inputs
 * @property {string | Channels} light
 * @property {string | Channels | MetallicRoughness} material
 * @property {number | "auto"} [sources] 0 by default, and `"auto"` for `Preview`
 * @property {import("./window.js").Window} [window] as `Scene.window`: `"none"` by default, and
 *   `"auto"` for `Preview`
 * @property {import("./engine.js").Engine} [engine]
 * @property {import("./assets.js").Assets} [assets] where the package's files are, for the whole
 *   page, as {@link setAssets}
 */

/**
 * A glTF material: a GGX lobe over a matte base. A roughness below 0.2 is drawn as 0.2, and
 * highlights of small sources as sharp as 0.065.
 *
 * @typedef {object} MetallicRoughness
 * @property {string | Numbers} [baseColor] `"#rrggbb"` in sRGB, or three linear numbers
 *   from 0 to 1; white by default
 * @property {number} [metallic] from 0 to 1; 0 by default
 * @property {number} [roughness] from 0 to 1; 0.5 by default
 */

/**
 * A rotation of the light: a quaternion `[x, y, z, w]`, which three.js's `Quaternion` is too, or
 * angles in radians, applied in the order roll (about z, toward the camera), pitch (about x, to the
 * right), yaw (about y, up).
 *
 * @typedef {{ yaw?: number, pitch?: number, roll?: number }} Angles
 * @typedef {(Iterable<number> & { length: unknown }) | Angles} Turn
 */

/**
 * The effects, in the module's order: the response to the mean light, Lambertian shading, rough and
 * backscattering lobes, and highlights.
 */
export const EFFECTS = Object.freeze(/** @type {const} */ (["ambient", "diffuse", "broad", "gloss"]));

/** @typedef {typeof EFFECTS[number]} Effect */

/** The tone curves, in the module's order. */
export const TONES = Object.freeze(/** @type {const} */ (["linear", "reinhard", "filmic"]));

/** @typedef {typeof TONES[number]} Tone */

/** The largest number of a light or a material: products of larger ones may exceed f32. */
export const LARGEST = 1e15;

/**
 * @param {unknown} value
 * @returns {value is number}
 */
export const isNumber = (value) => typeof value === "number" && !Number.isNaN(value);

/**
 * Whether this is an array, or a typed one, of whatever.
 *
 * @param {unknown} value
 * @returns {value is Numbers}
 */
const isArray = (value) => Array.isArray(value) || (ArrayBuffer.isView(value) && "length" in value);

/** What kind of object this is, such as `"[object Date]"`. */
const kindOf = (/** @type {unknown} */ value) => Object.prototype.toString.call(value);

/**
 * Whether this is an object with names, and no array, date, map or promise.
 *
 * @param {unknown} value
 * @returns {value is object}
 */
const isRecord = (value) =>
  typeof value === "object" && /^\[object (Object|Module)\]$/.test(kindOf(value));

/**
 * @param {unknown} value
 * @returns {value is Channels}
 */
export const isChannels = (value) => value !== null && typeof value === "object" && "r" in value;

/** A value as messages have it. */
export function shown(/** @type {unknown} */ value) {
  if (typeof value === "string") return `"${value}"`;
  return Object(value) === value ? kindOf(value) : String(value);
}

/**
 * Throws for input of another kind.
 *
 * @param {string} what
 * @param {unknown} given
 * @param {string} expected
 * @returns {never}
 */
export function refuse(what, given, expected) {
  const hint = given instanceof Promise ? "; await it" : "";
  throw new TypeError(`${what}: it is ${shown(given)}, expected ${expected}${hint}`);
}

/**
 * Throws unless this is an object without other names than these.
 *
 * @param {string} what
 * @param {unknown} given
 * @param {string} known
 * @param {string} [expected]
 */
export function checkNames(what, given, known, expected = `{ ${known} }`) {
  if (!isRecord(given)) refuse(what, given, expected);
  const names = known.split(", ");
  const unknown = Object.keys(given).find((name) => !names.includes(name));
  if (unknown !== undefined) throw new TypeError(`${what}: "${unknown}" ${unlike(unknown, names)}`);
}

/**
 * The numbers of a light or a material.
 *
 * @param {string} what
 * @param {string} name
 * @param {unknown} numbers
 * @param {number[]} [counts] how many there may be, from the least
 */
function checked(what, name, numbers, counts) {
  if (!isArray(numbers)) throw new TypeError(`${what}: ${name} is not an array of numbers`);
  const { length } = numbers;
  if (counts && !counts.includes(length)) {
    const beyond = length > counts[counts.length - 1] ? "; leave out the rest" : "";
    throw new RangeError(
      `${what}: ${name} has ${length} coefficients, expected ${counts.join(", ")}${beyond}`,
    );
  }
  const isWrong = (/** @type {unknown} */ x) => !(isNumber(x) && Math.abs(x) <= LARGEST);
  const bad = Array.from(numbers).findIndex(isWrong);
  if (bad < 0) return Float32Array.from(numbers);
  throw new RangeError(
    `${what}: ${name}[${bad}] is ${shown(numbers[bad])}, expected a number from -1e15 to 1e15`,
  );
}

/**
 * Copies checked coefficients to `to`, with zeros above their degree or order.
 *
 * @param {string} what
 * @param {Channels} given
 * @param {Float32Array} to
 * @param {(largest: number) => number} count
 * @param {number} most the largest degree or order
 */
export function put(what, given, to, count, most) {
  if (!isChannels(given)) {
    refuse(what, given, `{ r, g, b } with arrays of coefficients, which ${what}Preset(name) loads`);
  }
  const counts = Array.from({ length: most + 1 }, (_, largest) => count(largest));
  const channels = /** @type {const} */ (["r", "g", "b"]).map((name) =>
    checked(what, name, given[name], counts),
  );
  to.fill(0);
  channels.forEach((floats, channel) => to.set(floats, (channel * to.length) / 3));
}

/**
 * The sources of a light; JSON has `null` for none.
 *
 * @param {Channels} light
 */
export const sourcesOf = ({ sources }) => checked("light", "sources", sources ?? []);

/**
 * The gloss of a material; JSON has `null` for none.
 *
 * @param {Channels} material
 */
export function glossOf({ gloss }) {
  if (gloss === undefined || gloss === null) return undefined;
  if (gloss.length !== 10 || !Array.from(gloss).every(isShare)) {
    throw new RangeError("material: gloss is not ten numbers from 0 to 1");
  }
  return Float32Array.from(gloss);
}

const isShare = (/** @type {unknown} */ value) => isNumber(value) && value >= 0 && value <= 1;

/**
 * @param {MetallicRoughness} material
 * @returns {number[]}
 */
export function parameters(material) {
  checkNames(
    "material", material, "baseColor, metallic, roughness",
    "{ r, g, b }, which materialPreset(name) loads, or { baseColor, metallic, roughness }",
  );
  const { baseColor = [1, 1, 1], metallic = 0, roughness = 0.5 } = material;
  if (typeof baseColor !== "string" && !(isArray(baseColor) && baseColor.length === 3)) {
    throw new TypeError('material: baseColor is neither "#rrggbb" nor three numbers');
  }
  const color = typeof baseColor === "string" ? linear(baseColor) : Array.from(baseColor);
  const all = [...color, metallic, roughness];
  const names = ["red", "green", "blue", "metallic", "roughness"];
  all.forEach((number, k) => {
    if (!isShare(number)) {
      throw new RangeError(
        `material: ${names[k]} is ${shown(number)}, expected a number from 0 to 1`,
      );
    }
  });
  return all;
}

/**
 * The linear color of `"#rrggbb"`.
 *
 * @param {string} text
 */
function linear(text) {
  if (!/^#[0-9a-f]{6}$/i.test(text)) {
    throw new RangeError(`material: baseColor is "${text}", expected "#rrggbb" or three numbers`);
  }
  return [1, 3, 5].map((at) => {
    const encoded = parseInt(text.slice(at, at + 2), 16) / 255;
    return encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4;
  });
}

/**
 * @param {Turn} turn
 * @returns {number[]} x, y, z, w
 */
export function quaternion(turn) {
  if (turn !== null && typeof turn === "object" && "length" in turn) {
    const numbers = Array.from(turn);
    const square = numbers.reduce((sum, x) => sum + (isNumber(x) ? x * x : NaN), 0);
    if (numbers.length !== 4 || !(square > 1e-12 && square < 1e12)) {
      throw new RangeError(`turn: [${numbers.map(shown)}] is not a quaternion`);
    }
    return numbers;
  }
  const names = "yaw, pitch, roll";
  checkNames("turn", turn, names, `a quaternion [x, y, z, w] or { ${names} }`);
  const { yaw = 0, pitch = 0, roll = 0 } = turn;
  for (const [name, angle] of Object.entries({ yaw, pitch, roll })) {
    if (!Number.isFinite(angle)) {
      throw new RangeError(`turn: ${name} is ${shown(angle)}, expected a number`);
    }
  }
  const [sy, sp, sr] = [yaw, pitch, roll].map((angle) => Math.sin(angle / 2));
  const [cy, cp, cr] = [yaw, pitch, roll].map((angle) => Math.cos(angle / 2));
  return [
    cy * sp * cr + sy * cp * sr,
    sy * cp * cr - cy * sp * sr,
    cy * cp * sr - sy * sp * cr,
    cy * cp * cr + sy * sp * sr,
  ];
}

/**
 * @param {string} what
 * @param {Numbers[]} normals
 */
export function checkNormals(what, normals) {
  const [x, y, z] = normals;
  for (const [name, axis] of Object.entries({ x, y, z })) {
    if (!isArray(axis)) {
      throw new TypeError(`${what}: ${name} is not an array of numbers`);
    }
    if (axis.length !== x.length) {
      throw new RangeError(`${what}: x has ${x.length} numbers, ${name} has ${axis.length}`);
    }
  }
  const { length } = x;
  for (let k = 0; k < length; k++) {
    const up = z[k];
    const isNormal = isNumber(x[k]) && isNumber(y[k]) && isNumber(up);
    if (!(isNormal && Math.abs(x[k] * x[k] + y[k] * y[k] + up * up - 1) <= 1e-3 && up >= -1e-3)) {
      throw new RangeError(
        `${what}: normal ${k} is (${shown(x[k])}, ${shown(y[k])}, ${shown(up)}), expected a unit vector with z >= 0`,
      );
    }
  }
}

/**
 * The bits of effects, in the module's order.
 *
 * @param {Iterable<Effect>} effects
 */
export function effectBits(effects) {
  if (!effects?.[Symbol.iterator] || typeof effects === "string") {
    refuse("effects", effects, "a list of names");
  }
  let bits = 0;
  for (const effect of effects) bits |= 1 << nameOf("effects", effect, EFFECTS);
  return bits;
}

/**
 * @param {string} what
 * @param {number} number
 * @param {number} most
 */
export function checkWhole(what, number, most) {
  if (!(Number.isInteger(number) && number >= 0 && number <= most)) {
    throw new RangeError(`${what}: ${shown(number)} is not a whole number from 0 to ${most}`);
  }
}

/** @param {number} tolerance */
export function checkTolerance(tolerance) {
  if (!(isNumber(tolerance) && tolerance >= 1e-30 && tolerance < 1)) {
    throw new RangeError(
      `within: the tolerance is ${shown(tolerance)}, expected a number from 1e-30 to less than 1`,
    );
  }
}

/** @param {number | "auto"} sources */
export function checkSources(sources) {
  if (sources !== "auto" && !(Number.isInteger(sources) && sources >= 0)) {
    throw new RangeError(`sources: ${shown(sources)} is neither "auto" nor a whole number, 0 or more`);
  }
}

/**
 * Whether f32 has this exposure as a normal number above 0.
 *
 * @param {unknown} exposure
 * @returns {exposure is number}
 */
export function isExposure(exposure) {
  const float = isNumber(exposure) ? Math.fround(exposure) : 0;
  return float >= 2 ** -126 && float < Infinity;
}

/**
 * @param {string} what
 * @param {number} exposure
 */
export function checkExposure(what, exposure) {
  if (!isExposure(exposure)) {
    throw new RangeError(
      `${what}: the exposure is ${shown(exposure)}, expected a number from 1.2e-38 to 3.4e38`,
    );
  }
}

/**
 * @param {string} what
 * @param {string} tone
 */
export const toneNumber = (what, tone) => nameOf(what, tone, TONES);

/**
 * The place of a name in a list.
 *
 * @param {string} what
 * @param {string} name
 * @param {readonly string[]} names
 */
export function nameOf(what, name, names) {
  const place = names.indexOf(name);
  if (place < 0) throw new RangeError(`${what}: ${shown(name)} ${unlike(String(name), names)}`);
  return place;
}
