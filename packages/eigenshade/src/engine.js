// The WebAssembly module: one instance serves all scenes of a page.

import { misplaced, required } from "./assets.js";
import { SOURCE } from "./input.js";

const HEAD = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10];
const ZERO = [65, 0, 253, 15];
/** Modules of one instruction each, to see which variant this machine takes: the fastest first. */
const VARIANTS = [
  { name: ".relaxed", probe: [...HEAD, 19, 1, 17, 0, ...ZERO, ...ZERO, ...ZERO, 253, 133, 2, 11] },
  { name: ".simd", probe: [...HEAD, 10, 1, 8, 0, ...ZERO, 253, 98, 11] },
];

/** @type {Map<string, Promise<Engine>>} */
const shared = new Map();

/**
 * The engine of the package, loaded once. That of scenes with sources is another one, which serves
 * later scenes without sources too.
 *
 * @param {boolean} sources
 * @returns {Promise<Engine>}
 */
export function engine(sources) {
  const variant = VARIANTS.find(({ probe }) => WebAssembly.validate(Uint8Array.from(probe)))?.name ?? "";
  const larger = `wasm/eigenshade.sources${variant}.wasm`;
  const name = sources || shared.has(larger) ? larger : `wasm/eigenshade${variant}.wasm`;
  let found = shared.get(name);
  if (!found) {
    found = required(name).then((bytes) => {
      if (!isModule(bytes)) throw misplaced(name, "is no WebAssembly module");
      return load(bytes);
    });
    shared.set(name, found);
    // A failed download may be tried again.
    found.catch(() => shared.delete(name));
  }
  return found;
}

/**
 * Whether bytes start as a WebAssembly module does. Servers answer an address that they do not know
 * with a page.
 *
 * @param {unknown} bytes
 */
function isModule(bytes) {
  const { buffer, byteOffset, byteLength } = ArrayBuffer.isView(bytes)
    ? bytes
    : new Uint8Array(/** @type {ArrayBuffer} */ (bytes));
  return byteLength > 4 && new DataView(buffer, byteOffset).getUint32(0) === 0x0061736d;
}

/**
 * An engine with a table of your own: a module `color` or `color-sources` that
 * `crates/wasm/build` made.
 *
 * @param {ArrayBuffer | ArrayBufferView | Response | Promise<Response>} source the module's bytes, such
 *   as `fetch(url)`
 * @returns {Promise<Engine>} for the option `engine` of `Scene.create` and `Preview.create`
 * @throws {Error} if it cannot be fetched, or is no such module
 */
export async function load(source) {
  const given = await source;
  let [bytes, name] = [given, "this"];
  if (typeof Response !== "undefined" && given instanceof Response) {
    if (!given.ok) throw new Error(`${given.url}: ${given.status} ${given.statusText}`);
    [bytes, name] = [await given.arrayBuffer(), given.url || name];
  }
  if (!isModule(bytes)) {
    throw new TypeError(`load: ${name} is no WebAssembly module; give one that crates/wasm/build made`);
  }
  const { instance } = await WebAssembly.instantiate(/** @type {BufferSource} */ (bytes));
  if (!("shade" in instance.exports)) {
    throw new Error("load: this is another module; give one that crates/wasm/build made");
  }
  return new Engine(instance);
}

/**
 * Number of coefficients of a light of this degree.
 *
 * @param {number} degree
 */
export const lightCount = (degree) => (degree + 1) ** 2;

/**
 * Number of coefficients of a material up to this order.
 *
 * @param {number} order
 */
export function materialCount(order) {
  let count = 0;
  for (let o = 0; o <= order; o++) {
    const half = Math.floor(o / 2);
    count += ((half + 1) * (half + 2)) / 2;
  }
  return count;
}

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
 * What a scene asks of the module.
 *
 * @typedef {object} SceneRequest
 * @property {Float32Array} light the light, without the sources that are drawn
 * @property {Float32Array} sources
 * @property {Float32Array} turn
 * @property {Float32Array} material
 * @property {Float32Array} [gloss]
 * @property {number} effects their bits
 * @property {object} transfer what stands for material and effects
 * @property {number} [components]
 * @property {{ share: number, exposure: number }} [tolerance] a share of white
 */

/**
 * The buffers and functions of a module. One engine serves any number of scenes, one at a time.
 *
 * @hideconstructor
 */
export class Engine {
  /** @param {WebAssembly.Instance} instance */
  constructor(instance) {
    const { exports } = instance;
    const { memory } = /** @type {{ memory: WebAssembly.Memory }} */ (exports);
    /**
     * @template T
     * @param {string} name
     * @param {new (buffer: ArrayBuffer, place: number, length: number) => T} kind
     * @param {number} length
     * @returns {T}
     */
    const view = (name, kind, length) => {
      const { value } = /** @type {WebAssembly.Global} */ (exports[name]);
      return new kind(/** @type {ArrayBuffer} */ (memory.buffer), value, length);
    };
    /**
     * The functions of the module.
     *
     * @type {Record<string, (...numbers: number[]) => number>}
     */
    this.wasm = /** @type {any} */ (exports);
    const [degree, order, components, normals] = view("shape", Uint32Array, 4);
    this.degree = degree;
    this.order = order;
    this.components = components;
    /** Maximum number of normals in a call. */
    this.normals = normals;
    this.light = view("light", Float32Array, 3 * lightCount(degree));
    this.material = view("material", Float32Array, 3 * materialCount(order));
    this.turn = view("turn", Float32Array, 4);
    this.parameters = view("parameters", Float32Array, 5);
    this.d = view("d", Float32Array, 3 * components);
    this.report = view("report", Float32Array, 5);
    this.axes = view("normals", Float32Array, 3 * normals);
    this.irradiance = view("irradiance", Float32Array, 3 * normals);
    this.points = view("points", Int32Array, 2 * normals);
    this.scales = view("scales", Float32Array, normals);
    this.pixels = view("pixels", Uint8ClampedArray, 4 * normals);
    /** Whether this module draws small sources. */
    this.hasSources = "residual" in exports;
    if (this.hasSources) {
      const [most, dielectric, matte] = view("limits", Float32Array, 3);
      this.dielectric = dielectric;
      this.matte = matte;
      this.sources = view("sources", Float32Array, SOURCE * most);
      this.gloss = view("gloss", Float32Array, 10);
    }
    /** The vectors of the scene's shader: a copy. */
    this.vectors = () => view("uniform_array", Float32Array, 4 * this.wasm.uniforms()).slice();
    /** The text of the scene's shader. */
    this.shader = (/** @type {number} */ language) =>
      new TextDecoder().decode(view("text", Uint8Array, this.wasm.shader(language)));
    /** What the module holds now: a scene's inputs, so that nothing is computed twice. */
    this.held = {
      material: /** @type {unknown} */ (undefined),
      scene: /** @type {unknown} */ (undefined),
    };
  }

  /**
   * Computes a scene.
   *
   * @param {SceneRequest} request
   * @returns {Truncation | undefined} what is left out, with a tolerance
   */
  compute({
    light, sources, turn, material, gloss, effects, transfer, components = this.components, tolerance,
  }) {
    if (this.held.material !== transfer) {
      this.held.material = undefined;
      this.material.set(material);
      if (!this.wasm.transfer(effects)) {
        throw new Error("transfer: the module rejected its input");
      }
      this.held.material = transfer;
    }
    this.light.set(light);
    this.turn.set(turn);
    this.sources?.set(sources);
    if (gloss) this.gloss?.set(gloss);
    if (this.wasm.highlights?.(sources.length / SOURCE) === 0) {
      throw new Error("sources: the module rejected them");
    }
    if (!this.wasm.relight()) {
      throw new RangeError("relight: its numbers are too large for f32");
    }
    for (let from = components; from < this.d.length; from += this.components) {
      this.d.fill(0, from, from + this.components - components);
    }
    if (tolerance === undefined) {
      if (!this.wasm.collapse()) {
        throw new RangeError("collapse: its numbers are too large for f32");
      }
      return undefined;
    }
    const { share, exposure } = tolerance;
    if (!this.wasm.collapse_within(share, exposure)) throw new Error("within: the module rejected it");
    const [terms, azimuths, bound, floor, peak] = this.report;
    return { terms, azimuths, bound, floor, peak };
  }

  /**
   * The gloss of a glTF material, from its parameters; `undefined` without small sources.
   *
   * @param {number[]} parameters
   */
  glossOf([red, green, blue, metallic, roughness]) {
    const { dielectric } = this;
    if (dielectric === undefined) return undefined;
    const color = [red, green, blue];
    const reflectance = color.map((base) => dielectric * (1 - metallic) + base * metallic);
    const albedo = color.map((base) => base * (1 - metallic));
    return Float32Array.of(roughness, ...reflectance, 1, 1, 1, ...albedo);
  }

  /**
   * A light without its sources.
   *
   * @param {Float32Array} light
   * @param {Float32Array} sources
   */
  without(light, sources) {
    const count = sources.length / SOURCE;
    if (count === 0) return light;
    if (!this.sources) {
      throw new RangeError("light: the engine has no sources; build the module `color-sources`");
    }
    const most = this.sources.length / SOURCE;
    if (!Number.isInteger(count) || count > most) {
      const expected = `expected up to ${most} of seven numbers each`;
      throw new RangeError(`light: it has ${count} sources, ${expected}`);
    }
    this.light.set(light);
    this.sources.set(sources);
    if (!this.wasm.residual(count)) {
      throw new RangeError("light: its sources are not as Channels describes them");
    }
    return this.light.slice();
  }

  /** As that of `Scene`. */
  get [Symbol.toStringTag]() {
    return "Engine";
  }

  /** Makes the scene one eigenimage. */
  eigenimage(/** @type {number} */ index) {
    this.held.scene = undefined;
    this.wasm.highlights?.(0);
    this.d.fill(0);
    this.d[index] = 1;
    this.wasm.collapse();
  }

  /**
   * The irradiance of checked normals.
   *
   * @param {string} what
   * @param {import("./input.js").Numbers[]} normals
   * @param {{ r: Float32Array, g: Float32Array, b: Float32Array }} [to] new arrays by default
   */
  picture(what, normals, to) {
    const [r, g, b] = [0, 1, 2].map(() => new Float32Array(to ? 0 : normals[0].length));
    const found = to ?? { r, g, b };
    const { irradiance: from, normals: most } = this;
    this.shadeAll(what, normals, (start, count) => {
      found.r.set(from.subarray(0, count), start);
      found.g.set(from.subarray(most, most + count), start);
      found.b.set(from.subarray(2 * most, 2 * most + count), start);
    });
    return found;
  }

  /**
   * Shades checked normals in parts of the size of the buffers.
   *
   * @param {string} what
   * @param {import("./input.js").Numbers[]} normals
   * @param {(start: number, count: number) => void} done
   */
  shadeAll(what, normals, done) {
    const { axes, normals: most } = this;
    const { length } = normals[0];
    for (let start = 0; start < length; start += most) {
      const count = Math.min(most, length - start);
      normals.forEach((axis, which) => {
        if (ArrayBuffer.isView(axis)) {
          const part = /** @type {Float32Array} */ (axis).subarray(start, start + count);
          axes.set(part, which * most);
        } else {
          for (let k = 0; k < count; k++) axes[which * most + k] = axis[start + k];
        }
      });
      if (this.wasm.shade(count) !== count) {
        throw new Error(`${what}: the module rejected the normals`);
      }
      done(start, count);
    }
  }
}
