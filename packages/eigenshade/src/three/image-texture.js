// Images of a scene's light as a texture, and the weights of those that are blended.

import {
  DataArrayTexture, DataTexture, DataUtils, HalfFloatType, LinearFilter, Quaternion, RGBAFormat,
} from "three";
import { Images } from "../images.js";
import { KNOTS, WEIGHTS } from "../roughness-weights.js";

/** A layer for each image, exposed as the scene. */
export class ImageTexture {
  #images;
  /** @type {import("../scene.js").Illumination | undefined} */
  #illumination;
  #turn = new Quaternion();

  /** @param {number} [roughness] of one; else any roughness is a blend of five */
  constructor(roughness) {
    this.#images = new Images(roughness === undefined ? KNOTS : [roughness]);
    this.isBlended = roughness === undefined;
    const { texels, side, layers } = this.#images;
    this.texture = new DataArrayTexture(texels, side, side, layers);
    this.texture.type = HalfFloatType;
    this.texture.minFilter = this.texture.magFilter = LinearFilter;
    /** The exposure of the texels. */
    this.exposure = 1;
  }

  /**
   * Fills the texture if the light or its turn is another one.
   *
   * @param {import("../scene.js").Illumination} illumination
   * @param {Quaternion} turn
   * @param {number} exposure
   */
  update(illumination, turn, exposure) {
    const isSame = this.#illumination === illumination && this.exposure === exposure;
    if (isSame && this.#turn.equals(turn)) return;
    this.#illumination = illumination;
    this.#turn.copy(turn);
    this.exposure = exposure;
    this.#images.fill(illumination, turn.toArray(), exposure);
    this.texture.needsUpdate = true;
  }
}

/** @type {DataTexture | undefined} */
let table;

/** Two rows over the roughness from 0.2 to 1: the first four weights, and the fifth. */
export function weights() {
  if (!table) {
    const count = WEIGHTS.length / 5;
    const texels = new Uint16Array(8 * count);
    WEIGHTS.forEach((weight, k) => {
      const [row, knot] = [Math.floor(k / 5), k % 5];
      texels[4 * ((knot >> 2) * count + row) + (knot & 3)] = DataUtils.toHalfFloat(weight);
    });
    table = new DataTexture(texels, count, 2, RGBAFormat, HalfFloatType);
    table.minFilter = table.magFilter = LinearFilter;
    table.needsUpdate = true;
  }
  return table;
}
