// The reflection of the page's object: for each region a black and a white base color, between
// which all its base colors are.

import { Scene } from "../eigenshade/src/index.js";
import { MOST, NODES, SIDE } from "./packed.js";

/** The light of the object, and how many of its small sources are drawn. */
export const LIGHT = "apartment";
export const SOURCES = 4;
/** The mean direction of these sources, weighted by their luminance. */
export const LAMP = [0.629, 0.212, -0.748];

/** Normals of the nodes of a palette; beyond the rim those of the rim. */
const AXES = normalsOf(
  Array.from({ length: NODES }, (_, k) => 8 * (k % SIDE) - 128),
  Array.from({ length: NODES }, (_, k) => 8 * Math.floor(k / SIDE) - 128),
);

/**
 * The normals of codes: azimuthal equidistant, 127 at the rim.
 *
 * @param {number[]} u
 * @param {number[]} v
 */
export function normalsOf(u, v) {
  const axes = [u, v, u].map(({ length }) => new Float32Array(length));
  u.forEach((_, k) => {
    const distance = Math.hypot(u[k], v[k]);
    const angle = (Math.min(1, distance / 127) * Math.PI) / 2;
    const scale = distance ? Math.sin(angle) / distance : 0;
    [u[k] * scale, v[k] * scale, Math.max(0, Math.cos(angle))].forEach((along, axis) => (axes[axis][k] = along));
  });
  return axes;
}

/** The scenes of an object's regions. */
export class Parts {
  #scenes;
  #regions;

  /** @param {{ metallic: number, roughness: number }[]} regions */
  static async create(regions) {
    const scenes = regions.flatMap(({ metallic, roughness }) =>
      [0, 1].map((base) =>
        Scene.create({ light: LIGHT, sources: SOURCES, window: "auto", material: { baseColor: [base, base, base], metallic, roughness } }),
      ),
    );
    return new Parts(await Promise.all(scenes), regions);
  }

  /** @param {Scene[]} scenes @param {{ metallic: number, roughness: number }[]} regions */
  constructor(scenes, regions) {
    this.#scenes = scenes;
    this.#regions = regions;
  }

  /** Black and white of each region. */
  get scenes() {
    return this.#scenes;
  }

  /** Terms and sources of each part. */
  get costs() {
    return this.#scenes.map(({ terms, sources }) => ({ terms, sources }));
  }

  /** The exposure of the white part of a region. */
  exposure(region = 0) {
    return this.#scenes[2 * region + 1].exposure();
  }

  /**
   * Turns the light, and leaves out as many terms as this share of white allows.
   *
   * @param {number[]} turn
   * @param {number | undefined} share
   * @param {number} exposure
   */
  set(turn, share, exposure) {
    for (const scene of this.#scenes) scene.turn(turn).within(share, exposure);
  }

  /**
   * The exposed irradiances of all nodes: of each region those of black, then those of white; red, green,
   * blue and 1.
   *
   * @param {number} exposure
   * @param {Float32Array} [to]
   */
  palettes(exposure, to = new Float32Array(8 * NODES * this.#regions.length).fill(1)) {
    this.#scenes.forEach((scene, part) => {
      const { r, g, b } = scene.shade(AXES[0], AXES[1], AXES[2]);
      [r, g, b].forEach((values, c) =>
        values.forEach((value, k) => (to[4 * (NODES * part + k) + c] = Math.min(MOST, Math.max(0, exposure * value)))),
      );
    });
    return to;
  }

  /**
   * The irradiances of normals of a region, black and white.
   *
   * @param {number} region
   * @param {Float32Array[]} normals
   */
  shade(region, normals) {
    return [0, 1].map((base) => this.#scenes[2 * region + base].shade(normals[0], normals[1], normals[2]));
  }
}
