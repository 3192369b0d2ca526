// A light on a material: what is drawn, by a shader or on the CPU.

import { engine as shared, lightCount, materialCount } from "./engine.js";
import {
  EFFECTS, checkExposure, checkNormals, checkSources, glossOf, isChannels, isNumber, nameOf, parameters, put,
  quaternion, toneNumber,
} from "./input.js";
import { lightOf, materialOf } from "./presets.js";

/** @typedef {import("./engine.js").Engine} Engine */
/** @typedef {import("./input.js").Effect} Effect */
/** @typedef {import("./input.js").MetallicRoughness} MetallicRoughness */
/** @typedef {import("./input.js").Tone} Tone */
/** @typedef {import("./input.js").Turn} Turn */
/** @typedef {import("./input.js").Channels} Channels */

/**
 * What a scene is made of: a preset's name or coefficients of the light, and of the material, or the
 * parameters of a glTF material. An engine of `load` has a table of your own.
 *
 * With `sources`, at most this many small bright sources of a light by name, up to 32, are shaded on
 * their own, for sharp highlights. Such a scene has a larger module. {@link Scene#sources} is the
 * number of those drawn.
 *
 * @typedef {object} Inputs
 * @property {string | Channels} light
 * @property {string | Channels | MetallicRoughness} material
 * @property {number} [sources] 0 by default
 * @property {Engine} [engine]
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
 * vectors (all terms are 194, and sources take one and four each), a uniform block `Eigenshade` for up to 1,024, or a float texture of
 * one row.
 *
 * @typedef {"uniforms" | "block" | "texture"} Storage
 */

/** @type {readonly string[]} */
const LANGUAGES = ["uniforms", "block", "texture", "wgsl"];

/** What bright pixels have after {@link Scene#exposure}. */
const BRIGHT = 0.8;

/** Largest degree of a light that turns. */
const TURNED = 12;

/** The roughness from which on a material is drawn without sources: they would change nothing. */
const MATTE = Math.fround(0.6);

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

/**
 * A light on a material.
 *
 * Setting a light, a turn or a material costs nothing by itself; what depends on it is computed when
 * it is read.
 */
export class Scene {
  /** @type {Engine} */
  #engine;
  /** @type {Float32Array} */
  #light;
  /**
   * The light without its sources.
   *
   * @type {Float32Array}
   */
  #rest;
  #sources = new Float32Array();
  #turn = Float32Array.of(0, 0, 0, 1);
  #material;
  /** @type {Float32Array | undefined} */
  #gloss;
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
  static async create(inputs) {
    if (inputs === null || typeof inputs !== "object") {
      throw new TypeError("Scene: expected { light, material }");
    }
    const { light, material, sources = 0, engine } = inputs;
    checkSources(sources);
    const [loaded, givenLight, givenMaterial] = await Promise.all([
      engine ?? shared(sources > 0),
      lightOf(light, sources),
      materialOf(material),
    ]);
    return new Scene(loaded, givenLight, givenMaterial);
  }

  /**
   * @param {Engine} engine
   * @param {Channels} light
   * @param {Channels | MetallicRoughness} material
   */
  constructor(engine, light, material) {
    this.#engine = engine;
    this.#rest = this.#light = new Float32Array(engine.light.length);
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
   * Sets the light: in each channel (degree + 1)² coefficients in radiance, up to {@link degree}, and
   * maybe sources, which are part of it.
   *
   * @param {Channels} light
   * @returns {this}
   * @throws {TypeError | RangeError} unless these are numbers of a light; the scene is then unchanged
   */
  light(light) {
    const numbers = new Float32Array(this.#light.length);
    put("light", light, numbers, lightCount, this.#engine.degree);
    const sources = Float32Array.from(light.sources ?? []);
    this.#rest = this.#without(sources, numbers);
    this.#light = numbers;
    this.#sources = sources;
    this.#changed();
    return this;
  }

  /**
   * Sets the material: in each channel coefficients in 1/sr up to {@link order} and maybe a gloss, or
   * the parameters of a glTF material.
   *
   * @param {Channels | MetallicRoughness} material
   * @returns {this}
   * @throws {TypeError | RangeError} unless these are a material; the scene is then unchanged
   */
  material(material) {
    if (isChannels(material)) {
      const { gloss } = material;
      if (gloss && !(gloss.length === 10 && Array.from(gloss).every((n) => isNumber(n) && n >= 0 && n <= 1))) {
        throw new RangeError("material: gloss is not ten numbers from 0 to 1");
      }
      put("material", material, this.#material, materialCount, this.#engine.order);
      this.#gloss = gloss && Float32Array.from(gloss);
    } else {
      const given = parameters(material);
      this.#engine.parameters.set(given);
      if (!this.#engine.metallicRoughness()) throw new Error("material: the module rejected it");
      this.#material.set(this.#engine.material);
      this.#gloss = Float32Array.from(glossOf(given));
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
      throw new RangeError(
        `turn: the table has degree ${this.#engine.degree}; lights turn up to degree ${TURNED}`,
      );
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
    if (typeof effects === "string") throw new TypeError("effects: expected a list of names");
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
   * @param {number} [tolerance] from 1e-30 to less than 1
   * @returns {this}
   * @throws {RangeError} for another tolerance
   */
  within(tolerance) {
    if (tolerance !== undefined && !(isNumber(tolerance) && tolerance >= 1e-30 && tolerance < 1)) {
      throw new RangeError(
        `within: the tolerance is ${tolerance}, expected a number from 1e-30 to less than 1`,
      );
    }
    this.#tolerance = tolerance;
    this.#changed();
    return this;
  }

  /**
   * Number of small sources that are drawn: 0 if the light has none, the material has a
   * roughness of 0.6 or more, or no gloss, or effects are left out. The light is then drawn as a whole.
   */
  get sources() {
    const glossy = this.#gloss && this.#gloss[0] < MATTE && this.#effects === ALL;
    return glossy ? this.#sources.length / 10 : 0;
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
    this.#ready();
    return this.#engine.terms();
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
   * goes, so that a new light or material is an upload. Sources are a loop over their number.
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
    checkNormals("shade", [x, y, z]);
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
   * sphere's picture. A table that has a mean image adds it.
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
    checkNormals("eigenimage", [x, y, z]);
    const values = new Float32Array(x.length);
    this.#chunks(
      "eigenimage",
      [x, y, z],
      (start, count) => values.set(this.#engine.irradiance.subarray(0, count), start),
      () => {
        this.#engine.held.scene = undefined;
        this.#engine.highlights?.(0);
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
    checkNormals("pixels", [x, y, z]);
    const pixels = new Uint8ClampedArray(4 * x.length);
    this.#chunks("pixels", [x, y, z], (start, count) => {
      this.#engine.encode(count, exposure, curve);
      pixels.set(this.#engine.pixels.subarray(0, 4 * count), 4 * start);
    });
    return pixels;
  }

  /**
   * The exposure of a picture: this share of a sphere's pixels is at most 0.8 before the tone curve, in
   * all channels, where 1 is white.
   *
   * @param {number} [share] from 0 to 1
   * @returns {number} 1 for a black picture
   * @throws {RangeError} unless the share is from 0 to 1
   */
  exposure(share = 0.95) {
    if (!(isNumber(share) && share >= 0 && share <= 1)) {
      throw new RangeError(`exposure: the share is ${share}, expected a number from 0 to 1`);
    }
    const [x, y, z] = DISC;
    const { r, g, b } = this.shade(x, y, z);
    const largest = r.map((red, k) => Math.max(red, g[k], b[k])).sort();
    const white = largest[Math.round(share * (largest.length - 1))];
    return white > 0 && 1 / white < Infinity ? BRIGHT / white : 1;
  }

  /**
   * Shades checked normals in parts of the size of the module's buffers.
   *
   * @param {string} what
   * @param {ArrayLike<number>[]} normals
   * @param {(start: number, count: number) => void} done
   * @param {() => void} ready makes the module hold what is shaded
   */
  #chunks(what, normals, done, ready = () => this.#ready()) {
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
   * @param {string} [why] it may reject its input
   */
  #call(step, why = "the module rejected its input") {
    if (!this.#engine[step](this.#effects)) throw new RangeError(`${step}: ${why}`);
  }

  #changed() {
    this.#state = {};
  }

  /**
   * A light without its sources.
   *
   * @param {Float32Array} sources
   * @param {Float32Array} light
   */
  #without(sources, light) {
    const count = sources.length / 10;
    if (count === 0) return light;
    const { light: buffer, sources: list, residual } = this.#engine;
    if (!list || !residual) {
      throw new RangeError("light: this scene has no sources; create it with the option `sources`");
    }
    checkSources(count);
    buffer.set(light);
    list.set(sources);
    if (!residual(count)) throw new RangeError("light: its sources are not as Channels describes them");
    return buffer.slice();
  }

  /** Makes the module hold this scene. */
  #ready() {
    const { held } = this.#engine;
    if (held.scene === this.#state) return;
    held.scene = undefined;
    if (held.material !== this.#transfer) {
      held.material = undefined;
      this.#engine.material.set(this.#material);
      this.#call("transfer");
      held.material = this.#transfer;
    }
    const { sources } = this;
    this.#engine.light.set(sources ? this.#rest : this.#light);
    this.#engine.turn.set(this.#turn);
    if (sources) {
      this.#engine.sources?.set(this.#sources);
      this.#engine.gloss?.set(/** @type {Float32Array} */ (this.#gloss));
    }
    if (this.#engine.highlights?.(sources) === 0) throw new Error("sources: the module rejected them");
    this.#call("relight", "its numbers are too large for f32");
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
