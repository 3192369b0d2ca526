// A light on a material: what is drawn, by a shader or on the CPU.

import { engine as shared, lightCount, materialCount } from "./engine.js";
import { lightPreset, materialPreset } from "./presets.js";

/** @typedef {import("./presets.js").Channels} Channels */
/** @typedef {import("./engine.js").Engine} Engine */

/**
 * A glTF material: a GGX lobe over a matte base. A roughness below 0.2 is drawn as 0.2.
 *
 * @typedef {object} MetallicRoughness
 * @property {string | ArrayLike<number>} [baseColor] `"#rrggbb"` in sRGB, or three linear numbers
 *   from 0 to 1; white by default
 * @property {number} [metallic] from 0 to 1; 0 by default
 * @property {number} [roughness] from 0 to 1; 0.5 by default
 */

/**
 * What a scene is made of: a preset's name or coefficients of the light, and of the material, or the
 * parameters of a glTF material. An engine of `load` has a table of your own.
 *
 * @typedef {object} Inputs
 * @property {string | Channels} light
 * @property {string | Channels | MetallicRoughness} material
 * @property {Engine} [engine]
 */

/**
 * A rotation of the light: a quaternion `[x, y, z, w]`, or angles in radians, applied in the order
 * roll (about z, toward the camera), pitch (about x, to the right), yaw (about y, up).
 *
 * @typedef {ArrayLike<number> | { yaw?: number, pitch?: number, roll?: number }} Turn
 */

/**
 * What a scene with fewer terms leaves out, in the unit of the irradiance, root mean square over a
 * sphere's normals.
 *
 * @typedef {object} Truncation
 * @property {number} terms terms of the polynomials that are left
 * @property {number} azimuths azimuths that are left
 * @property {number} bound the largest difference, over the channels, from the scene of all terms
 * @property {number} floor an estimate of the table's own error
 * @property {number} peak the largest irradiance, about
 */

/**
 * Where a GLSL function finds the coefficients: a uniform array, of which WebGL 2 promises 224
 * vectors (all terms are 194), a uniform block `Eigenshade` for up to 1,024, or a float texture of
 * one row.
 *
 * @typedef {"uniforms" | "block" | "texture"} Storage
 */

/** @type {readonly string[]} */
const LANGUAGES = ["uniforms", "block", "texture", "wgsl"];

/**
 * The effects, in the module's order: the response to the mean light, Lambertian shading, rough and
 * backscattering lobes, and highlights.
 */
export const EFFECTS = Object.freeze(/** @type {const} */ (["ambient", "diffuse", "broad", "gloss"]));

/** @typedef {typeof EFFECTS[number]} Effect */

/** Largest degree of a light that turns. */
const TURNED = 12;

/** The bits of all effects. */
const ALL = 0b1111;

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

/** The tone curves, in the module's order. */
export const TONES = Object.freeze(/** @type {const} */ (["linear", "reinhard", "filmic"]));

/** @typedef {typeof TONES[number]} Tone */

/**
 * A light on a material.
 *
 * Setting a light, a turn or a material costs nothing by itself; what depends on it is computed when
 * it is read.
 */
export class Scene {
  /** @type {Engine} */
  #engine;
  #light;
  #turn = Float32Array.of(0, 0, 0, 1);
  #material;
  #effects = ALL;
  /** @type {number | undefined} */
  #components;
  /** @type {number | undefined} */
  #tolerance;
  /** @type {Truncation | undefined} */
  #truncation;
  /** What this scene is now; a new object after each change. */
  #state = {};
  /** The material as it is now. */
  #transfer = {};

  /**
   * A scene, with lights and materials of the package by name.
   *
   * @param {Inputs} inputs
   * @returns {Promise<Scene>}
   * @throws {RangeError} for an unknown name, or as {@link Scene#light} and {@link Scene#material}
   */
  static async create({ light, material, engine }) {
    const [loaded, of, on] = await Promise.all([
      engine ?? shared(),
      lightOf(light),
      materialOf(material),
    ]);
    return new Scene(loaded, of, on);
  }

  /**
   * @param {Engine} engine
   * @param {Channels} light
   * @param {Channels | MetallicRoughness} material
   */
  constructor(engine, light, material) {
    this.#engine = engine;
    this.#light = new Float32Array(engine.light.length);
    this.#material = new Float32Array(engine.material.length);
    this.light(light);
    this.material(material);
  }

  /** Largest degree of a light. */
  get degree() {
    return this.#engine.degree;
  }

  /** Largest order of a material. */
  get order() {
    return this.#engine.order;
  }

  /**
   * Sets the light: in each channel (degree + 1)² coefficients in radiance, up to {@link degree}.
   *
   * @param {Channels} light
   * @returns {this}
   * @throws {TypeError | RangeError} unless these are numbers of a light; the scene is then unchanged
   */
  light(light) {
    put("light", light, this.#light, lightCount, this.#engine.degree);
    this.#changed();
    return this;
  }

  /**
   * Sets the material: in each channel coefficients in 1/sr up to {@link order}, or the parameters of
   * a glTF material.
   *
   * @param {Channels | MetallicRoughness} material
   * @returns {this}
   * @throws {TypeError | RangeError} unless these are a material; the scene is then unchanged
   */
  material(material) {
    if (isChannels(material)) {
      put("material", material, this.#material, materialCount, this.#engine.order);
    } else {
      this.#engine.parameters.set(parameters(material));
      if (!this.#engine.metallicRoughness()) throw new Error("material: the module rejected it");
      this.#material.set(this.#engine.material);
    }
    this.#transfer = {};
    this.#changed();
    return this;
  }

  /**
   * Turns the light from where it was set: light that came from ω comes from Rω.
   *
   * @param {Turn} turn
   * @returns {this}
   * @throws {RangeError} unless this is a rotation; the scene is then unchanged
   */
  turn(turn) {
    const rotation = quaternion(turn);
    if (this.#engine.degree > TURNED) {
      throw new RangeError(`turn: the table has degree ${this.#engine.degree}; lights turn up to degree ${TURNED}`);
    }
    this.#turn.set(rotation);
    this.#changed();
    return this;
  }

  /**
   * Keeps only these effects. A picture is the sum of the pictures of its effects.
   *
   * @param {Iterable<Effect>} [effects] all by default
   * @returns {this}
   * @throws {RangeError} for a name that is no effect
   */
  effects(effects = EFFECTS) {
    let bits = 0;
    for (const effect of effects) bits |= 1 << nameOf("effects", effect, EFFECTS);
    this.#effects = bits;
    this.#transfer = {};
    this.#changed();
    return this;
  }

  /**
   * Keeps only the first of the eigenimages.
   *
   * @param {number} [count] all by default
   * @returns {this}
   * @throws {RangeError} unless this is a whole number from 0 to their number
   */
  components(count) {
    if (count !== undefined && !(Number.isInteger(count) && count >= 0 && count <= this.#engine.components)) {
      throw new RangeError(
        `components: ${count} is not a whole number from 0 to ${this.#engine.components}`,
      );
    }
    this.#components = count;
    this.#changed();
    return this;
  }

  /**
   * Leaves out as many terms as this error allows: root mean square over a sphere's normals, as a
   * fraction of the peak, the same terms in all channels. Without a number, all terms are kept again.
   *
   * @param {number} [tolerance] above 0
   * @returns {this}
   * @throws {RangeError} unless the tolerance is above 0
   */
  within(tolerance) {
    if (tolerance !== undefined && !(tolerance > 0 && tolerance < Infinity)) {
      throw new RangeError(`within: the tolerance is ${tolerance}, expected a number above 0`);
    }
    this.#tolerance = tolerance;
    this.#changed();
    return this;
  }

  /**
   * What is left out, or `undefined` without a tolerance.
   *
   * @returns {Truncation | undefined}
   */
  get truncation() {
    this.#ready();
    return this.#truncation;
  }

  /** Number of terms of the polynomials: multiplications and additions a pixel and channel, about. */
  get terms() {
    return this.uniforms().length / 4;
  }

  /**
   * The coefficients d of the eigenimages, in each channel.
   *
   * @returns {{ r: Float32Array, g: Float32Array, b: Float32Array }}
   */
  coefficients() {
    this.#ready();
    return channels(this.#engine.d, this.#engine.components, this.#engine.components);
  }

  /**
   * The array of the shader: four numbers for each vector.
   *
   * @returns {Float32Array}
   */
  uniforms() {
    this.#ready();
    return this.#engine.vectors();
  }

  /**
   * The function `vec3 irradiance(vec3 normal)` in GLSL ES 3.00, and the array `eigenshade` that it
   * reads, to be filled with {@link uniforms}. The text stays the same as long as no term comes or
   * goes, so that a new light or material is an upload.
   *
   * @param {Storage} [storage]
   * @returns {string}
   */
  glsl(storage = "uniforms") {
    const language = LANGUAGES.slice(0, 3).indexOf(storage);
    if (language < 0) {
      throw new RangeError(`glsl: "${storage}" is not one of uniforms, block and texture`);
    }
    this.#ready();
    return this.#engine.shader(language);
  }

  /**
   * The function `fn irradiance(normal: vec3f) -> vec3f` in WGSL. It reads a uniform buffer with
   * {@link uniforms} at group 0, binding 0.
   *
   * @returns {string}
   */
  wgsl() {
    this.#ready();
    return this.#engine.shader(LANGUAGES.indexOf("wgsl"));
  }

  /**
   * The irradiance of normals, given component by component: visible unit vectors in the camera's
   * frame, x to the right, y up, z toward the camera.
   *
   * @param {ArrayLike<number>} x
   * @param {ArrayLike<number>} y
   * @param {ArrayLike<number>} z
   * @param {{ r: Float32Array, g: Float32Array, b: Float32Array }} [irradiance] where to write it; new
   *   arrays by default
   * @returns {{ r: Float32Array, g: Float32Array, b: Float32Array }}
   * @throws {RangeError} if the lengths differ, or a normal is not a unit vector or points away
   */
  shade(x, y, z, irradiance) {
    const [r, g, b] = [0, 1, 2].map(() => new Float32Array(irradiance ? 0 : x.length));
    const to = irradiance ?? { r, g, b };
    if (![to.r, to.g, to.b].every((channel) => channel?.length === (irradiance ? x.length : r.length))) {
      throw new RangeError(`shade: expected { r, g, b } with ${x.length} numbers each, as x has`);
    }
    const { irradiance: from, normals } = this.#engine;
    this.#chunks("shade", [x, y, z], (start, count) => {
      to.r.set(from.subarray(0, count), start);
      to.g.set(from.subarray(normals, normals + count), start);
      to.b.set(from.subarray(2 * normals, 2 * normals + count), start);
    });
    return to;
  }

  /**
   * The values of an eigenimage at normals, as {@link shade}. Eigenimages are orthonormal over a
   * sphere's picture.
   *
   * @param {number} index from 0
   * @param {ArrayLike<number>} x
   * @param {ArrayLike<number>} y
   * @param {ArrayLike<number>} z
   * @returns {Float32Array}
   * @throws {RangeError} as {@link shade}, or if there is no such eigenimage
   */
  eigenimage(index, x, y, z) {
    const { d, components } = this.#engine;
    if (!(Number.isInteger(index) && index >= 0 && index < components)) {
      throw new RangeError(`eigenimage: ${index} is not a whole number from 0 to ${components - 1}`);
    }
    const values = new Float32Array(x.length);
    this.#chunks(
      "eigenimage",
      [x, y, z],
      (start, count) => values.set(this.#engine.irradiance.subarray(0, count), start),
      () => {
        this.#engine.held.scene = undefined;
        d.fill(0);
        d[index] = 1;
        this.#call("collapse");
      },
    );
    return values;
  }

  /**
   * The pixels of normals, as {@link shade}: red, green, blue and 255, for `ImageData`.
   *
   * @param {ArrayLike<number>} x
   * @param {ArrayLike<number>} y
   * @param {ArrayLike<number>} z
   * @param {{ exposure?: number, tone?: Tone }} [options] the factor from irradiance to display, 1 by
   *   default, and the tone curve, `"filmic"` by default
   * @returns {Uint8ClampedArray}
   * @throws {RangeError} as {@link shade}, or for an exposure that is not above 0
   */
  pixels(x, y, z, { exposure = 1, tone = "filmic" } = {}) {
    checkExposure("pixels", exposure);
    const curve = toneNumber("pixels", tone);
    const pixels = new Uint8ClampedArray(4 * x.length);
    this.#chunks("pixels", [x, y, z], (start, count) => {
      this.#engine.encode(count, exposure, curve);
      pixels.set(this.#engine.pixels.subarray(0, 4 * count), 4 * start);
    });
    return pixels;
  }

  /**
   * The exposure at which this share of a sphere's pixels is at most white before the tone curve, in
   * all channels.
   *
   * @param {number} [share] from 0 to 1
   * @returns {number} 1 for a black picture
   * @throws {RangeError} unless the share is from 0 to 1
   */
  exposure(share = 0.95) {
    if (!(share >= 0 && share <= 1)) {
      throw new RangeError(`exposure: the share is ${share}, expected a number from 0 to 1`);
    }
    const [x, y, z] = DISC;
    const { r, g, b } = this.shade(x, y, z);
    const largest = r.map((red, k) => Math.max(red, g[k], b[k])).sort();
    const white = largest[Math.round(share * (largest.length - 1))];
    return white > 0 && 1 / white < Infinity ? 1 / white : 1;
  }

  /**
   * Shades in parts of the size of the module's buffers.
   *
   * @param {string} what
   * @param {ArrayLike<number>[]} normals
   * @param {(start: number, count: number) => void} done
   * @param {() => void} ready makes the module hold what is shaded
   */
  #chunks(what, normals, done, ready = () => this.#ready()) {
    checkNormals(what, normals);
    ready();
    const { axes, normals: most } = this.#engine;
    const { length } = normals[0];
    for (let start = 0; start < length; start += most) {
      const count = Math.min(most, length - start);
      normals.forEach((axis, which) => {
        const part = ArrayBuffer.isView(axis) ? /** @type {Float32Array} */ (axis).subarray(start, start + count) : axis;
        if (part !== axis) axes.set(part, which * most);
        else for (let k = 0; k < count; k++) axes[which * most + k] = axis[start + k];
      });
      if (this.#engine.shade(count) !== count) throw new Error(`${what}: the module rejected the normals`);
      done(start, count);
    }
  }

  /**
   * Calls a function of the module.
   *
   * @param {"transfer" | "relight" | "collapse"} step
   * @param {number[]} numbers
   */
  #call(step, ...numbers) {
    if (!this.#engine[step](...numbers)) throw new Error(`${step}: the module rejected its input`);
  }

  #changed() {
    this.#state = {};
  }

  /** Makes the module hold this scene. */
  #ready() {
    const { held } = this.#engine;
    if (held.scene === this.#state) return;
    held.scene = undefined;
    if (held.material !== this.#transfer) {
      held.material = undefined;
      this.#engine.material.set(this.#material);
      this.#call("transfer", this.#effects);
      held.material = this.#transfer;
    }
    this.#engine.light.set(this.#light);
    this.#engine.turn.set(this.#turn);
    this.#call("relight");
    if (this.#components !== undefined) {
      const { d, components } = this.#engine;
      for (let from = this.#components; from < d.length; from += components) {
        d.fill(0, from, from + components - this.#components);
      }
    }
    this.#truncation = undefined;
    if (this.#tolerance === undefined) {
      this.#call("collapse");
    } else {
      if (!this.#engine.truncate(this.#tolerance)) throw new Error("within: the module rejected it");
      const [terms, azimuths, bound, floor, peak] = this.#engine.report;
      this.#truncation = { terms, azimuths, bound, floor, peak };
    }
    held.scene = this.#state;
  }
}

/**
 * A light, by name or as it is.
 *
 * @param {string | Channels} light
 */
export const lightOf = (light) => (typeof light === "string" ? lightPreset(light) : light);

/**
 * A material, by name or as it is.
 *
 * @param {string | Channels | MetallicRoughness} material
 */
export const materialOf = (material) =>
  typeof material === "string" ? materialPreset(material) : material;

/**
 * @param {unknown} value
 * @returns {value is Channels}
 */
const isChannels = (value) => value !== null && typeof value === "object" && "r" in value;

/**
 * Copies checked coefficients to `to`, with zeros above their degree or order.
 *
 * @param {string} what
 * @param {Channels} given
 * @param {Float32Array} to
 * @param {(largest: number) => number} count
 * @param {number} most the largest degree or order
 */
function put(what, given, to, count, most) {
  if (!isChannels(given)) {
    throw new TypeError(`${what}: expected { r, g, b } with arrays of coefficients`);
  }
  const counts = Array.from({ length: most + 1 }, (_, largest) => count(largest));
  const checked = /** @type {const} */ (["r", "g", "b"]).map((name) => {
    const numbers = given[name];
    if (!(Array.isArray(numbers) || ArrayBuffer.isView(numbers))) {
      throw new TypeError(`${what}: ${name} is not an array of numbers`);
    }
    if (!counts.includes(numbers.length)) {
      const beyond = numbers.length > counts[most] ? "; leave out the rest" : "";
      throw new RangeError(
        `${what}: ${name} has ${numbers.length} coefficients, expected ${counts.join(", ")}${beyond}`,
      );
    }
    const floats = Float32Array.from(numbers);
    const bad = floats.findIndex((number) => !Number.isFinite(number));
    if (bad >= 0) {
      throw new RangeError(`${what}: coefficient ${bad} of ${name} is ${numbers[bad]}, not a finite f32`);
    }
    return floats;
  });
  to.fill(0);
  checked.forEach((floats, channel) => to.set(floats, (channel * to.length) / 3));
}

/**
 * @param {MetallicRoughness} material
 * @returns {number[]}
 */
function parameters(material) {
  if (material === null || typeof material !== "object") {
    throw new TypeError("material: expected { r, g, b } or { baseColor, metallic, roughness }");
  }
  const { baseColor = [1, 1, 1], metallic = 0, roughness = 0.5, ...other } = material;
  const [unknown] = Object.keys(other);
  if (unknown !== undefined) {
    throw new TypeError(`material: no parameter is called ${unknown}; there are baseColor, metallic and roughness`);
  }
  const color = typeof baseColor === "string" ? linear(baseColor) : Array.from(baseColor);
  if (color.length !== 3) {
    throw new RangeError(`material: baseColor has ${color.length} numbers, expected 3`);
  }
  const all = [...color, metallic, roughness];
  const names = ["red", "green", "blue", "metallic", "roughness"];
  all.forEach((number, k) => {
    if (!(number >= 0 && number <= 1)) {
      throw new RangeError(`material: ${names[k]} is ${number}, expected a number from 0 to 1`);
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
 * @returns {ArrayLike<number>} x, y, z, w
 */
function quaternion(turn) {
  if (turn === null || typeof turn !== "object") {
    throw new TypeError("turn: expected a quaternion [x, y, z, w] or { yaw, pitch, roll }");
  }
  if ("length" in turn) {
    const square = Array.from(turn).reduce((sum, number) => sum + number * number, 0);
    if (turn.length !== 4 || !(square > 1e-12 && square < 1e12)) {
      throw new RangeError(`turn: [${Array.from(turn)}] is not a quaternion`);
    }
    return turn;
  }
  const { yaw = 0, pitch = 0, roll = 0 } = turn;
  for (const [name, angle] of Object.entries({ yaw, pitch, roll })) {
    if (!Number.isFinite(angle)) throw new RangeError(`turn: ${name} is ${angle}, expected a number`);
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
 * @param {ArrayLike<number>[]} normals
 */
function checkNormals(what, normals) {
  const [x, y, z] = normals;
  for (const [name, axis] of Object.entries({ x, y, z })) {
    if (!(Array.isArray(axis) || ArrayBuffer.isView(axis))) {
      throw new TypeError(`${what}: ${name} is not an array of numbers`);
    }
    if (axis.length !== x.length) {
      throw new RangeError(`${what}: x has ${x.length} numbers, ${name} has ${axis.length}`);
    }
  }
  const { length } = x;
  for (let k = 0; k < length; k++) {
    const up = z[k];
    if (!(Math.abs(x[k] * x[k] + y[k] * y[k] + up * up - 1) <= 1e-3 && up >= -1e-3)) {
      throw new RangeError(
        `${what}: normal ${k} is (${x[k]}, ${y[k]}, ${z[k]}), expected a unit vector with z >= 0`,
      );
    }
  }
}

/**
 * @param {string} what
 * @param {number} exposure
 */
export function checkExposure(what, exposure) {
  if (!(exposure > 0 && exposure < Infinity)) {
    throw new RangeError(`${what}: the exposure is ${exposure}, expected a number above 0`);
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
function nameOf(what, name, names) {
  const place = names.indexOf(name);
  if (place < 0) throw new RangeError(`${what}: "${name}" is not one of ${names.join(", ")}`);
  return place;
}

/**
 * Three parts of an array, copied.
 *
 * @param {Float32Array} all
 * @param {number} stride
 * @param {number} count
 */
function channels(all, stride, count) {
  const [r, g, b] = [0, 1, 2].map((channel) => all.slice(channel * stride, channel * stride + count));
  return { r, g, b };
}
