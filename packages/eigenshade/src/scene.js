// A light on a material: what is drawn, by a shader or on the CPU.

import { Engine, engine as shared, lightCount, materialCount } from "./engine.js";
import {
  EFFECTS, SOURCE, checkExposure, checkNames, checkNormals, checkSources, checkTolerance, checkWhole,
  effectBits, glossOf, isChannels, parameters, put, quaternion, refuse, sourcesOf, toneNumber,
} from "./input.js";
import { setAssets } from "./assets.js";
import { DISC, metered } from "./exposure.js";
import { lightOf, materialOf } from "./presets.js";
import { countOf } from "./steps.js";
import { glsl, wgsl } from "./shader.js";
import { checkWindow, weakest, windowed } from "./window.js";

/** @typedef {import("./engine.js").Truncation} Truncation */
/** @typedef {import("./input.js").Effect} Effect */
/** @typedef {import("./input.js").MetallicRoughness} MetallicRoughness */
/** @typedef {import("./input.js").Numbers} Numbers */
/** @typedef {import("./input.js").Tone} Tone */
/** @typedef {import("./input.js").Turn} Turn */
/** @typedef {import("./input.js").Channels} Channels */

/** Largest degree of a light that turns. */
const TURNED = 16;

/** The bits of all effects. */
const ALL = 0b1111;

/** The quaternion of no turn. */
const UNTURNED = Float32Array.of(0, 0, 0, 1);

/**
 * Makes the module hold a scene. For `sphere`, which draws by the module itself.
 *
 * @type {(scene: Scene, what: string, look: { exposure?: number, tone?: Tone }) =>
 *   { engine: Engine, exposure: number, curve: number }}
 */
export let prepared;

/**
 * The light of a scene, for materials other than its own; another object after each change but a
 * turn.
 *
 * @typedef {object} Illumination
 * @property {Engine} engine
 * @property {Float32Array} rest the light without its sources
 * @property {Float32Array} sources all of a light, or the most that a material of any roughness needs
 * @property {number} effects their bits
 * @property {number} [components]
 * @property {import("./window.js").Window} window
 */

/** @type {(scene: Scene) => Illumination} For materials of three.js, which mix their own reflectance. */
export let illumination;

/**
 * A light on a material.
 *
 * Setting a light, a turn or a material costs nothing by itself; what depends on it is computed when
 * it is read.
 */
export class Scene {
  static {
    prepared = (scene, what, look) => {
      const checked = checkedLook(what, look);
      scene.#ready();
      return { engine: scene.#engine, ...checked };
    };
    illumination = (scene) => (scene.#illumination ??= scene.#illuminates());
  }

  /** @type {Engine} */
  #engine;
  /** @type {Float32Array} */
  #light;
  /** Its sources, in the order of their worth. */
  #sources = new Float32Array();
  /** @type {import("./steps.js").Steps | undefined} How many of them a material needs, if not all. */
  #steps;
  /** @type {Map<number, Float32Array>} The light without the first sources, once it was drawn. */
  #rests = new Map();
  #hasSources;
  #turn = UNTURNED.slice();
  #material;
  /** @type {Float32Array | undefined} */
  #gloss;
  #effects = ALL;
  /** @type {number | undefined} */
  #components;
  /** @type {{ share: number, exposure?: number } | undefined} */
  #tolerance;
  /** @type {import("./window.js").Window} */
  #window = "none";
  /** What is chosen for the light as it was set: the width of the window and the exposure. */
  #chosen = { width: 0, exposure: 0 };
  /** @type {Truncation | undefined} */
  #truncation;
  /** What this scene is now; a new object after each change. */
  #state = {};
  /** @type {Illumination | undefined} */
  #illumination;
  /** The material as it is now. */
  #transfer = {};
  #texts = (/** @type {number} */ language) => {
    this.#ready();
    return this.#engine.shader(language);
  };
  /** What the light and the material are called. */
  #names = { light: "a light", material: "a material" };

  /**
   * A scene, with lights and materials of the package by name.
   *
   * @param {import("./input.js").Inputs} inputs
   * @returns {Promise<Scene>}
   * @throws {TypeError | RangeError} for an unknown name, or as {@link Scene#light} and
   *   {@link Scene#material}
   */
  static async create(inputs) {
    checkNames("Scene", inputs, "light, material, sources, window, engine, assets");
    const { light, material, sources = 0, window = "none", engine, assets } = inputs;
    checkSources(sources);
    checkWindow(window);
    if (assets !== undefined) setAssets(assets);
    if (light instanceof Promise) refuse("light", light, "{ r, g, b } or a name");
    const own = typeof light === "object" && light?.sources?.length;
    const hasSources = sources !== 0 || Boolean(own);
    const [loaded, givenLight, givenMaterial] = await Promise.all([
      engine ?? shared(hasSources),
      lightOf(light, sources),
      materialOf(material),
    ]);
    // The package's engine may be one that another scene needed.
    const scene = new Scene(loaded, givenLight, givenMaterial, engine ? undefined : hasSources);
    return scene.window(window);
  }

  /**
   * @param {Engine} engine
   * @param {Channels} light
   * @param {Channels | MetallicRoughness} material
   * @param {boolean} [hasSources] whether lights may have sources; if the engine can, by default
   */
  constructor(engine, light, material, hasSources = true) {
    if (!(engine instanceof Engine)) refuse("engine", engine, "what load(module) returns");
    this.#engine = engine;
    this.#hasSources = hasSources;
    this.#light = new Float32Array(engine.light.length);
    this.#material = new Float32Array(engine.material.length);
    this.light(light);
    this.material(material);
  }

  /** Not `Object`: libraries that watch objects, such as Vue, would wrap it, which has private fields. */
  get [Symbol.toStringTag]() {
    return "Scene";
  }

  /** What a picture of this scene shows, for those who do not see it. */
  get label() {
    return `A sphere of ${this.#names.material} under ${this.#names.light}`;
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
   * maybe sources, which are part of it, if the scene has sources. No number may exceed 1e15. Of
   * a light of `lightPreset` with `"auto"`, each material takes as many as it needs.
   *
   * @param {Channels} light
   * @returns {this}
   * @throws {TypeError | RangeError} unless these are numbers of a light; the scene is then unchanged
   */
  light(light) {
    const numbers = new Float32Array(this.#light.length);
    put("light", light, numbers, lightCount, this.#engine.degree);
    const canDraw = this.#hasSources && this.#engine.hasSources;
    const sources = light.steps && !canDraw ? new Float32Array() : sourcesOf(light);
    if (sources.length && !this.#hasSources) {
      throw new RangeError("light: this scene has no sources; create it with the option `sources`");
    }
    this.#rests = new Map([[sources.length / SOURCE, this.#engine.without(numbers, sources)]]);
    this.#sources = sources;
    this.#steps = light.steps;
    this.#light = numbers;
    this.#names.light = light.name ? `the light ${light.name}` : "a light";
    this.#changed(true);
    return this;
  }

  /**
   * Sets the material: in each channel coefficients in 1/sr up to {@link order} and maybe a gloss, or
   * the parameters of a glTF material. No number may exceed 1e15.
   *
   * @param {Channels | MetallicRoughness} material
   * @returns {this}
   * @throws {TypeError | RangeError} unless these are a material; the scene is then unchanged
   */
  material(material) {
    if (isChannels(material)) {
      const gloss = glossOf(material);
      put("material", material, this.#material, materialCount, this.#engine.order);
      this.#gloss = gloss;
      this.#names.material = material.name ?? "a material";
    } else {
      const given = parameters(material);
      this.#engine.parameters.set(given);
      if (!this.#engine.wasm.metallic_roughness()) {
        throw new Error("material: the module rejected it");
      }
      this.#material.set(this.#engine.material);
      this.#gloss = this.#engine.glossOf(given);
      this.#names.material = "a glTF material";
    }
    this.#transfer = {};
    this.#changed(true);
    return this;
  }

  /**
   * Turns the light from where it was set: light that came from ω comes from Rω.
   *
   * @param {Turn} turn
   * @returns {this}
   * @throws {TypeError | RangeError} unless this is a rotation; the scene is then unchanged
   */
  turn(turn) {
    const rotation = quaternion(turn);
    if (this.#engine.degree > TURNED) {
      throw new RangeError(
        `turn: the table has degree ${this.#engine.degree}; lights turn up to degree ${TURNED}`,
      );
    }
    this.#turn.set(rotation);
    this.#state = {};
    return this;
  }

  /**
   * Keeps only these effects. A picture is the sum of the pictures of its effects.
   *
   * @param {Iterable<Effect>} [effects] all by default
   * @returns {this}
   * @throws {TypeError | RangeError} unless this is a list of effects
   */
  effects(effects = EFFECTS) {
    this.#effects = effectBits(effects);
    this.#transfer = {};
    this.#changed(true);
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
    if (count !== undefined) checkWhole("components", count, this.#engine.components);
    this.#components = count;
    this.#chosen.exposure = 0;
    this.#changed();
    return this;
  }

  /**
   * Leaves out as many terms as this error allows: root mean square over a sphere's normals, as a
   * share of white, the same terms in all channels. Without a number, all terms are kept again.
   *
   * @param {number} [share] from 1e-30 to less than 1
   * @param {number} [exposure] the factor from irradiance to white; {@link exposure} by default
   * @returns {this}
   * @throws {RangeError} for another share or exposure
   */
  within(share, exposure) {
    if (share !== undefined) checkTolerance(share);
    if (exposure !== undefined) checkExposure("within", exposure);
    this.#tolerance = share === undefined ? undefined : { share, exposure };
    this.#changed();
    return this;
  }

  /**
   * Sets the window over what sources leave of the light, which keeps its picture from dark rings: a
   * width in degrees, or `"none"`. `"auto"` chooses the weakest that does for each light and
   * material as they are set; a light that turns keeps it.
   *
   * @param {import("./window.js").Window} window
   * @returns {this}
   * @throws {RangeError} for another window
   */
  window(window) {
    checkWindow(window);
    this.#window = window;
    this.#changed(true);
    return this;
  }

  /** The width of the window, which is infinite without one. */
  get windowWidth() {
    if (typeof this.#window === "number") return this.#window;
    return this.#window === "none" ? Infinity : (this.#chosen.width ||= this.#weakest());
  }

  /** Whether sources change pictures of the material; false in a scene without sources. */
  get isGlossy() {
    const { matte = 0 } = this.#engine;
    return this.#hasSources && this.#gloss !== undefined && this.#gloss[0] < matte;
  }

  /**
   * Number of small sources that are drawn: 0 if the light has none, the material is not
   * {@link isGlossy | glossy}, or effects are left out. The light is then drawn as a whole.
   */
  get sources() {
    return this.#drawn.sources.length / SOURCE;
  }

  /** The sources that are drawn, and what they leave of the light. */
  get #drawn() {
    const none = { sources: new Float32Array(), rest: this.#light };
    if (!this.isGlossy || this.#effects !== ALL || !this.#gloss) return none;
    const all = this.#sources.length / SOURCE;
    const count = this.#steps ? Math.min(countOf(this.#steps, this.#gloss), all) : all;
    return this.#apart(count);
  }

  /** The first sources, and what they leave of the light. */
  #apart(/** @type {number} */ count) {
    const sources = this.#sources.subarray(0, SOURCE * count);
    const rest = this.#rests.get(count) ?? this.#engine.without(this.#light, sources);
    this.#rests.set(count, rest);
    return { sources, rest };
  }

  /** @returns {Illumination} */
  #illuminates() {
    const all = this.#sources.length / SOURCE;
    const needed = this.#steps ? Math.max(0, ...this.#steps.map(({ count }) => count)) : all;
    const none = { sources: new Float32Array(), rest: this.#light };
    return {
      ...(this.#effects === ALL ? this.#apart(Math.min(needed, all)) : none),
      engine: this.#engine,
      effects: this.#effects,
      components: this.#components,
      window: this.#window,
    };
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
    return this.#engine.wasm.terms();
  }

  /**
   * The coefficients d of the eigenimages, in each channel.
   *
   * @returns {Record<"r" | "g" | "b", Float32Array<ArrayBuffer>>}
   */
  coefficients() {
    this.#ready();
    const { d, components } = this.#engine;
    const [r, g, b] = [0, 1, 2].map((channel) => d.slice(channel * components, (channel + 1) * components));
    return { r, g, b };
  }

  /**
   * The array of the shader: four numbers for each vector.
   *
   * @returns {Float32Array<ArrayBuffer>}
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
   * @param {import("./shader.js").Storage} [storage]
   * @param {{ prefix?: string }} [options] what the names of the function, the array and the block
   *   begin with, such as `"front_"`; nothing by default
   * @returns {string}
   * @throws {TypeError | RangeError} for another storage, or a prefix that begins no name of GLSL
   */
  glsl(storage = "uniforms", options = {}) {
    return glsl(this.#texts, storage, options);
  }

  /**
   * The function `fn irradiance(normal: vec3f) -> vec3f` in WGSL. It reads a uniform buffer with
   * {@link uniforms}.
   *
   * @param {{ prefix?: string, group?: number, binding?: number }} [options] what the names of the
   *   function and the buffer begin with, nothing by default; and the buffer's group and binding, both
   *   0 by default
   * @returns {string}
   * @throws {TypeError | RangeError} for a prefix that begins no name of WGSL, or other numbers
   */
  wgsl(options = {}) {
    return wgsl(this.#texts, options);
  }

  /**
   * The irradiance of normals, given component by component: visible unit vectors in the camera's
   * frame, x to the right, y up, z toward the camera.
   *
   * @param {Numbers} x
   * @param {Numbers} y
   * @param {Numbers} z
   * @template {Float32Array} [T=Float32Array<ArrayBuffer>]
   * @param {{ r: T, g: T, b: T }} [irradiance] where to write it; new arrays by default
   * @returns {{ r: T, g: T, b: T }}
   * @throws {TypeError | RangeError} unless these are arrays of one length, of unit vectors that do
   *   not point away
   */
  shade(x, y, z, irradiance) {
    checkNormals("shade", [x, y, z]);
    const { length } = x;
    const to = irradiance;
    const fits = (/** @type {unknown} */ to) => to instanceof Float32Array && to.length === length;
    if (to && ![to.r, to.g, to.b].every(fits)) {
      throw new RangeError(
        `shade: expected { r, g, b }, each a Float32Array of length ${length}, as x has`,
      );
    }
    this.#ready();
    return /** @type {any} */ (this.#engine.picture("shade", [x, y, z], to));
  }

  /**
   * The values of an eigenimage at normals, as {@link shade}. Eigenimages are orthonormal over a
   * sphere's picture. A table that has a mean image adds it.
   *
   * @param {number} index from 0
   * @param {Numbers} x
   * @param {Numbers} y
   * @param {Numbers} z
   * @returns {Float32Array<ArrayBuffer>}
   * @throws {TypeError | RangeError} as {@link shade}, or if there is no such eigenimage
   */
  eigenimage(index, x, y, z) {
    checkWhole("eigenimage", index, this.#engine.components - 1);
    checkNormals("eigenimage", [x, y, z]);
    this.#engine.eigenimage(index);
    const values = new Float32Array(x.length);
    this.#engine.shadeAll("eigenimage", [x, y, z], (start, count) => {
      values.set(this.#engine.irradiance.subarray(0, count), start);
    });
    return values;
  }

  /**
   * The pixels of normals, as {@link shade}: red, green, blue and 255, for `ImageData`.
   *
   * @param {Numbers} x
   * @param {Numbers} y
   * @param {Numbers} z
   * @param {{ exposure?: number, tone?: Tone }} [options] the factor from irradiance to display, 1 by
   *   default, and the tone curve, `"filmic"` by default
   * @returns {Uint8ClampedArray<ArrayBuffer>}
   * @throws {TypeError | RangeError} as {@link shade}, or for an exposure that is no normal f32
   *   above 0
   */
  pixels(x, y, z, options = {}) {
    const { exposure, curve } = checkedLook("pixels", options);
    checkNormals("pixels", [x, y, z]);
    const pixels = new Uint8ClampedArray(4 * x.length);
    this.#ready();
    this.#engine.shadeAll("pixels", [x, y, z], (start, count) => {
      if (this.#engine.wasm.rgb888(count, exposure, curve) !== count) {
        throw new Error("pixels: the module rejected the exposure");
      }
      pixels.set(this.#engine.pixels.subarray(0, 4 * count), 4 * start);
    });
    return pixels;
  }

  /**
   * The exposure of a sphere's picture with all terms: one pixel in a hundred is brighter than white
   * before the tone curve, in its brightest channel. Where that leaves the median darker than 0.12 of
   * white, up to one in ten is. The light is as it was set, without its {@link turn}, so that a light
   * that turns keeps its exposure.
   *
   * @returns {number} 1 for a black picture
   */
  exposure() {
    return (this.#chosen.exposure ||= metered(this.#untouched({})));
  }

  /** @param {boolean} [chooses] whether window and exposure are chosen anew */
  #changed(chooses = false) {
    this.#state = {};
    this.#illumination = undefined;
    if (chooses) this.#chosen = { width: 0, exposure: 0 };
  }

  /** The window of a picture of all components and effects, under its exposure without a window. */
  #weakest() {
    const all = this.#effects === ALL ? {} : { effects: ALL, transfer: {} };
    const of = (/** @type {number} */ width) =>
      this.#untouched({ ...all, components: undefined, light: windowed(this.#drawn.rest, width) });
    const plain = of(Infinity);
    const exposure = metered(plain);
    return weakest(this.degree, (width) => {
      const { r, g, b } = width === Infinity ? plain : of(width);
      return exposure * r.reduce((least, red, k) => Math.min(least, red, g[k], b[k]), Infinity);
    });
  }

  /**
   * A sphere's picture with all terms under the light as it was set.
   *
   * @param {Partial<import("./engine.js").SceneRequest>} changes
   */
  #untouched(changes) {
    const engine = this.#engine;
    engine.held.scene = undefined;
    engine.compute({ ...this.#request(changes.light), turn: UNTURNED, ...changes });
    return engine.picture("exposure", DISC);
  }

  /** @returns {import("./engine.js").SceneRequest} */
  #request(/** @type {Float32Array} */ light = windowed(this.#drawn.rest, this.windowWidth)) {
    return {
      light,
      sources: this.#drawn.sources,
      turn: this.#turn,
      material: this.#material,
      gloss: this.#gloss,
      effects: this.#effects,
      transfer: this.#transfer,
      components: this.#components,
    };
  }

  /** Makes the module hold this scene. */
  #ready() {
    const { held } = this.#engine;
    if (held.scene === this.#state) return;
    const { share, exposure = this.exposure() } = this.#tolerance ?? { exposure: 1 };
    const tolerance = share === undefined ? undefined : { share, exposure };
    // Before `held`, which the choice of a window and the exposure change.
    const request = this.#request();
    held.scene = undefined;
    this.#truncation = this.#engine.compute({ ...request, tolerance });
    held.scene = this.#state;
  }
}

/**
 * The exposure and the number of the tone curve.
 *
 * @param {string} what
 * @param {{ exposure?: number, tone?: Tone }} look
 */
function checkedLook(what, look) {
  checkNames(what, look, "exposure, tone");
  const { exposure = 1, tone = "filmic" } = look;
  checkExposure(what, exposure);
  return { exposure, curve: toneNumber(what, tone) };
}
