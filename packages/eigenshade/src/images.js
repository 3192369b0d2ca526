// Images of a light on the parts of glTF's materials. A shader mixes any color, metallic and
// roughness from them: E = base (1 - metallic) (1 - f0) D(n) + f0 S_r(n) + R_r(n).
//
// An image is a map of the hemisphere with equal areas and without a seam: the normal n is at
// (n.x, n.y) / √(1 + n.z) in the unit circle. Irradiance is smooth up to its rim and beyond.

import { DISC } from "./exposure.js";
import { weakest, windowed } from "./window.js";

/** @typedef {import("./scene.js").Illumination} Illumination */

/** Texels on a side, and between the rim and the edge. */
const SIDE = 96;
export const MARGIN = 2.5;

/** The least roughness that images show, and the reflectance of dielectrics. */
const [LEAST, DIELECTRIC] = [0.2, 0.04];

/** One channel of one image; no number where no texel is used. */
const IMAGE = new Float32Array(SIDE * SIDE).fill(NaN);

const UNTURNED = [0, 0, 0, 1];
const NONE = new Float32Array();

/**
 * Half floats: layers of red, green, blue and 0, first matte, then metal and rim of each roughness.
 *
 * A texel is the irradiance of its normal minus the mean error of linear interpolation around it,
 * which is a twelfth of the second differences. Two fifths of the error are left.
 */
export class Images {
  #roughnesses;
  #shades;
  /** @type {Float32Array[]} The coefficients of each layer. */
  #parts = [];
  /** @type {Illumination | undefined} */
  #illumination;
  /** The light of each layer, with a window. */
  #light = new Float32Array();

  /** @param {readonly number[]} roughnesses from 0 to 1; below 0.2 they are drawn as 0.2 */
  constructor(roughnesses) {
    this.#roughnesses = roughnesses.map((roughness) => Math.max(LEAST, roughness));
    this.side = SIDE;
    this.layers = 1 + 2 * roughnesses.length;
    this.texels = new Uint16Array(4 * SIDE ** 2 * this.layers);
    const [r, g, b] = USED.normals.map(({ length }) => new Float32Array(length));
    this.#shades = { r, g, b };
  }

  /**
   * Fills the texels.
   *
   * @param {Illumination} illumination
   * @param {number[]} turn the light's, as a quaternion
   * @param {number} exposure a factor of all texels, which saturate at 65,504
   */
  fill(illumination, turn, exposure) {
    const { engine, rest } = illumination;
    if (this.#illumination !== illumination) {
      this.#illumination = illumination;
      this.#parts = [matteOf(engine)];
      for (const roughness of this.#roughnesses) this.#parts.push(...lobeOf(engine, roughness));
      this.#light = windowed(rest, this.#width(illumination, exposure));
    }
    this.#parts.forEach((part, layer) => {
      const of = { ...illumination, sources: NONE };
      const shades = draw(of, this.#light, turn, part, USED.normals, this.#shades);
      const first = 4 * SIDE ** 2 * layer;
      [shades.r, shades.g, shades.b].forEach((plane, channel) =>
        put(plane, exposure, this.texels.subarray(first + channel), USED.places),
      );
    });
  }

  /** The width of the window, with `"auto"` the weakest for a white metal of the least roughness. */
  #width(/** @type {Illumination} */ illumination, /** @type {number} */ exposure) {
    const { engine, rest, window } = illumination;
    if (window !== "auto") return window === "none" ? Infinity : window;
    const [, metal, rim] = this.#parts;
    const white = metal.map((number, k) => number + rim[k]);
    const gloss = Float32Array.of(this.#roughnesses[0], 1, 1, 1, 1, 1, 1, 0, 0, 0);
    const of = { ...illumination, gloss };
    return weakest(engine.degree, (width) => {
      const { r, g, b } = draw(of, windowed(rest, width), UNTURNED, white, DISC);
      return exposure * Math.min(...r, ...g, ...b);
    });
  }
}

/** Where the texels of an image are that are used, and their normals. */
function usedTexels() {
  const radius = SIDE / 2 - MARGIN;
  const places = /** @type {number[]} */ ([]);
  const axes = [places, places, places].map(() => /** @type {number[]} */ ([]));
  for (let k = 0; k < SIDE ** 2; k++) {
    const [u, v] = [k % SIDE, Math.floor(k / SIDE)].map((at) => (at + 0.5 - SIDE / 2) / radius);
    const square = u * u + v * v;
    if (square > (1 + MARGIN / radius) ** 2) continue;
    const scale = Math.sqrt(2 - square);
    places.push(k);
    [u * scale, v * scale, 1 - square].forEach((number, axis) => axes[axis].push(number));
  }
  return { places: Uint32Array.from(places), normals: axes.map((axis) => Float32Array.from(axis)) };
}

const USED = usedTexels();

/**
 * The coefficients of a glTF material of these parameters, in each channel.
 *
 * @param {import("./engine.js").Engine} engine
 * @param {number[]} parameters
 */
function coefficients(engine, parameters) {
  engine.parameters.set(parameters);
  if (!engine.wasm.metallic_roughness()) {
    throw new RangeError(`material: the roughness is ${parameters[4]}, expected a number from 0 to 1`);
  }
  const count = engine.material.length / 3;
  return [0, 1, 2].map((channel) => engine.material.slice(channel * count, (channel + 1) * count));
}

/** Those of metal (f0 = 1, without the rim) and rim (f0 = 0), from a black and a white metal. */
function lobeOf(/** @type {import("./engine.js").Engine} */ engine, /** @type {number} */ roughness) {
  const [rim, white] = coefficients(engine, [0, 1, 1, 1, roughness]);
  return [white.map((number, k) => number - rim[k]), rim];
}

/** Those of a white matte base below no lobe, from a white and a black dielectric. */
function matteOf(/** @type {import("./engine.js").Engine} */ engine) {
  const [black, white] = coefficients(engine, [0, 1, 1, 0, 1]);
  return white.map((number, k) => (number - black[k]) / (1 - DIELECTRIC));
}

/**
 * Shades normals.
 *
 * @param {Illumination & { gloss?: Float32Array }} illumination
 * @param {Float32Array} light
 * @param {number[]} turn
 * @param {Float32Array} part coefficients of all channels
 * @param {Float32Array[]} normals
 * @param {import("./exposure.js").Picture} [shades] where to
 */
function draw({ engine, sources, gloss, effects, components }, light, turn, part, normals, shades) {
  const material = Float32Array.of(...part, ...part, ...part);
  engine.held.scene = undefined;
  engine.compute({
    light, sources, turn: Float32Array.from(turn), material, gloss, effects, components, transfer: part,
  });
  return engine.picture("images", normals, shades);
}

/**
 * Puts texels into every fourth half float. Those below 2^-14 become 0.
 *
 * @param {Float32Array} shades
 * @param {number} factor
 * @param {Uint16Array} texels
 * @param {Uint32Array} places of the shades
 */
function put(shades, factor, texels, places) {
  const image = IMAGE;
  for (let k = 0; k < places.length; k++) image[places[k]] = factor * shades[k];
  const float = new Float32Array(1);
  const bits = new Uint32Array(float.buffer);
  for (const at of places) {
    const shade = image[at];
    const around = image[at - 1] + image[at + 1] + image[at - SIDE] + image[at + SIDE];
    const fitted = shade + (4 * shade - around) / 12;
    // The outermost texels lack a neighbor.
    float[0] = Number.isNaN(fitted) ? shade : fitted;
    const magnitude = bits[0] & 0x7fffffff;
    const rounded = magnitude < 0x38800000 ? 0 : Math.min(0x7bff, (magnitude - 0x37fff000) >> 13);
    texels[4 * at] = ((bits[0] >>> 16) & 0x8000) | rounded;
  }
}
