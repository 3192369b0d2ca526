// `eigenshade/shadowed`: an object of one material with the shadows that it casts on itself.

import { misplaced, required } from "./assets.js";
import { lightCount } from "./engine.js";
import { TONES } from "./index.js";
import { checkExposure, checkNames, nameOf, put, quaternion, refuse } from "./input.js";

/** @typedef {import("./input.js").Channels} Channels */
/** @typedef {import("./input.js").Tone} Tone */
/** @typedef {import("./input.js").Turn} Turn */

/**
 * What a picture is written to: an `ImageData`, or another record of its size and bytes.
 *
 * @typedef {{ width: number, height: number, data: Uint8Array | Uint8ClampedArray }} Picture
 */

const MODULE = "wasm/eigenshade.shadowed.wasm";

/** Bytes of `Places` and of the shape in `crates/wasm/shadowed`, and of a page of memory. */
const [PLACES, SHAPE, PAGE] = [36, 16, 65536];

/** @type {Promise<WebAssembly.Module> | undefined} */
let compiled;

/** The module, loaded once. */
function loaded() {
  compiled ??= required(MODULE).then(async (bytes) => {
    return WebAssembly.compile(bytes).catch(() => {
      throw misplaced(MODULE, "is no WebAssembly module");
    });
  });
  // A failed download may be tried again.
  compiled.catch(() => (compiled = undefined));
  return compiled;
}

/**
 * An object that shadows itself, of one material and seen from one side, under light that turns. Units
 * of light, irradiance and exposure are those of `Scene`.
 *
 * Light is harmonics alone: small sources stay in it. Cost of a picture of the program's defaults in a
 * material with color: 166,000 products for the light and 24 for each color.
 */
export class ShadowedObject {
  /** @type {Record<string, (...numbers: number[]) => number>} */
  #wasm;
  /** @type {WebAssembly.Memory} */
  #memory;
  /** @type {Record<"start" | "light" | "colors" | "pixels", number>} Addresses. */
  #places;
  #light;
  #turn = /** @type {ArrayLike<number>} */ ([0, 0, 0, 1]);

  /**
   * The object of a file.
   *
   * @param {ArrayBuffer | ArrayBufferView} file what `eigenshade pack-object --shadows --out F.bin` wrote
   * @returns {Promise<ShadowedObject>} without a light: it is black
   * @throws {TypeError | RangeError} if this is something else, was cut or changed, or is too
   *   large for memory
   */
  static async load(file) {
    if (!(file instanceof ArrayBuffer || ArrayBuffer.isView(file))) {
      refuse("ShadowedObject", file, "the bytes of a file, such as an ArrayBuffer");
    }
    const bytes = ArrayBuffer.isView(file)
      ? new Uint8Array(file.buffer, file.byteOffset, file.byteLength)
      : new Uint8Array(file);
    return new ShadowedObject(await WebAssembly.instantiate(await loaded()), bytes);
  }

  /**
   * Use {@link ShadowedObject.load}.
   *
   * @param {WebAssembly.Instance} instance
   * @param {Uint8Array} file
   */
  constructor(instance, file) {
    const { memory, ...functions } = instance.exports;
    this.#memory = /** @type {WebAssembly.Memory} */ (memory);
    this.#wasm = /** @type {any} */ (functions);
    const start = this.#grown(PLACES + SHAPE + file.length);
    const shape = start + PLACES;
    new Uint8Array(this.#memory.buffer).set(file, shape + SHAPE);
    new Uint32Array(this.#memory.buffer, start, 2).set([shape + SHAPE, file.length]);
    if (!this.#wasm.read(start, shape)) {
      throw new RangeError(
        "ShadowedObject: this is no object with shadows, or was cut or changed; give a file that " +
          "`eigenshade pack-object --shadows --out F.bin` wrote",
      );
    }
    const [width, height, codes, degree] = new Uint32Array(this.#memory.buffer, shape, 4);
    /** Pixels across. */
    this.width = width;
    /** Pixels down. */
    this.height = height;
    /** The number of colors that a picture has, apart from pixels that it covers in part. */
    this.colors = codes;
    /** Largest degree of a light. */
    this.degree = degree;
    const numbers = 3 * lightCount(degree);
    const light = this.#grown(4 * (numbers + codes + width * height));
    const colors = light + 4 * numbers;
    this.#places = { start, light, colors, pixels: colors + 4 * codes };
    this.#light = new Float32Array(numbers);
  }

  /** Not `Object`, as `Scene`. */
  get [Symbol.toStringTag]() {
    return "ShadowedObject";
  }

  /** The address of new memory of so many bytes. */
  #grown(/** @type {number} */ bytes) {
    try {
      return PAGE * this.#memory.grow(Math.ceil(bytes / PAGE));
    } catch {
      throw new RangeError(`ShadowedObject: there is no memory for ${bytes} bytes; give a smaller object`);
    }
  }

  /**
   * Sets the light: in each channel (degree + 1)² coefficients in radiance, up to {@link degree}, as
   * `lightPreset(name)` loads. Its sources are not taken out of it. No number may exceed 1e15.
   *
   * @param {Channels} light
   * @returns {this}
   * @throws {TypeError | RangeError} unless these are numbers of a light; the light is then unchanged
   */
  light(light) {
    const numbers = new Float32Array(this.#light.length);
    put("light", light, numbers, lightCount, this.degree);
    this.#light = numbers;
    return this;
  }

  /**
   * Turns the light from where it was set: light that came from ω comes from Rω.
   *
   * @param {Turn} turn
   * @returns {this}
   * @throws {TypeError | RangeError} unless this is a rotation; the turn is then unchanged
   */
  turn(turn) {
    this.#turn = quaternion(turn);
    return this;
  }

  /**
   * The exposure of the picture under the light as it was set, without its {@link turn}, within 7 %:
   * one pixel in a hundred is brighter than white before the tone curve, as `Scene.exposure`.
   *
   * @returns {number} 1 for a black picture
   */
  exposure() {
    this.#place([0, 0, 0, 1]);
    return this.#wasm.meter(this.#places.start) || 1;
  }

  /**
   * The picture.
   *
   * @param {{ exposure?: number, tone?: Tone }} [look] the factor from irradiance to display, 1 by
   *   default, and the tone curve, `"filmic"` by default
   * @returns {Uint8ClampedArray<ArrayBuffer>} red, green, blue and opacity, row by row from the top
   * @throws {TypeError | RangeError} for another look, or a light whose numbers are too large
   */
  pixels(look = {}) {
    checkNames("pixels", look, "exposure, tone");
    const { exposure = 1, tone = "filmic" } = look;
    checkExposure("pixels", exposure);
    const curve = nameOf("pixels", tone, TONES);
    this.#place(this.#turn);
    const { start, pixels } = this.#places;
    if (!this.#wasm.draw(start, exposure, curve)) {
      throw new RangeError("pixels: the light's numbers are too large for f32");
    }
    const buffer = /** @type {ArrayBuffer} */ (this.#memory.buffer);
    return new Uint8ClampedArray(buffer, pixels, 4 * this.width * this.height).slice();
  }

  /**
   * Draws the picture, in place of what is there.
   *
   * @param {HTMLCanvasElement | OffscreenCanvas | Picture} target a canvas, which gets the size of the
   *   object, or an `ImageData` of this size
   * @param {{ exposure?: number, tone?: Tone }} [look] as {@link pixels}
   * @returns {this}
   * @throws {TypeError | RangeError} as {@link pixels}, for a canvas without a 2D context, or an
   *   `ImageData` of another size
   */
  draw(target, look) {
    const { width, height } = this;
    const picture = this.pixels(look);
    if ("data" in target) {
      if (target.width !== width || target.height !== height) {
        throw new RangeError(
          `draw: the target has ${target.width} x ${target.height} pixels, expected ${width} x ${height}`,
        );
      }
      target.data.set(picture);
      return this;
    }
    const context = /** @type {CanvasRenderingContext2D | null} */ (target.getContext("2d"));
    if (!context) refuse("draw", target, "a canvas with a 2D context, or an ImageData");
    Object.assign(target, { width, height });
    context.putImageData(new ImageData(picture, width, height), 0, 0);
    return this;
  }

  /** Places the light and how it is turned. */
  #place(/** @type {ArrayLike<number>} */ turn) {
    const { start, light, colors, pixels } = this.#places;
    const { buffer } = this.#memory;
    new Float32Array(buffer, light, this.#light.length).set(this.#light);
    new Uint32Array(buffer, start + 8, 1)[0] = light;
    new Float32Array(buffer, start + 12, 4).set(turn);
    new Uint32Array(buffer, start + 28, 2).set([colors, pixels]);
  }
}
