// The page's scenes of one light and one material, and what is computed once for them.

import { Scene } from "../eigenshade/src/index.js";
import { ambient } from "./harmonics.js";
import * as measure from "./measure.js";
import { nineTerms } from "./nine.js";

/** @typedef {Awaited<ReturnType<typeof import("./state.js").inputsOf>>} Inputs */

export class Scenes {
  /** The inputs, and how many were accepted. */
  loaded = /** @type {Inputs | undefined} */ (undefined);
  accepted = 0;
  /** The exposure of the reference, and the nine-term formula. */
  exposure = 1;
  nine = new Float32Array(27);

  static async create() {
    // With sources, for their module.
    const inputs = { light: "studio", material: "gold-metallic-paint", sources: 1 };
    const window = /** @type {const} */ ("auto");
    return new Scenes(await Promise.all([1, 2, 3, 4].map(() => Scene.create({ ...inputs, window }))));
  }

  /** @param {Scene[]} scenes */
  constructor([ours, whole, best, scratch]) {
    /** What is shown. */
    this.ours = ours;
    /** All terms of all effects. */
    this.whole = whole;
    /** The same with all sources of the light: the reference. */
    this.best = best;
    /** Whatever is asked of it. */
    this.scratch = scratch;
  }

  /** Takes inputs, or throws and leaves all as it was. */
  accept(/** @type {Inputs} */ inputs) {
    this.accepted++;
    try {
      this.#give(inputs);
    } catch (fault) {
      if (this.loaded) this.#give(this.loaded);
      throw fault;
    }
  }

  #give(/** @type {Inputs} */ inputs) {
    const { light, best, material } = inputs;
    for (const scene of [this.whole, this.ours]) scene.light(light).material(material);
    this.best.light(best).material(material);
    const albedo = measure.meanOf(measure.pictureOf(this.scratch.light(ambient()).material(material)));
    const [exposure, nine] = [this.best.exposure(), nineTerms(light, albedo)];
    [this.exposure, this.nine, this.loaded] = [exposure, nine, inputs];
  }
}
