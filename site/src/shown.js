// The object that is shown: one of the page's, or one of the user's.

import { Drawing, KINDS } from "./draw.js";
import { coin, coinNormals, relief } from "./objects.js";

const meshes = /** @type {Record<string, any>} */ ({});

export class Shown {
  /** @type {import("./objects.js").Mesh | undefined} */
  #mesh;
  /** @type {import("./model.js").Model | undefined} */
  #model;
  /** What the drawing has. */
  #drawn = "";

  /** Whether there is an object of the user's. */
  get hasOwn() {
    return Boolean(this.#mesh ?? this.#model);
  }

  /** The object of the user's with its own materials, if the state shows it. */
  modelOf(/** @type {import("./state.js").State} */ { object }) {
    return object === "own" ? this.#model : undefined;
  }

  /** Takes an object of the user's in place of the last one. */
  takeMesh(/** @type {import("./objects.js").Mesh} */ mesh) {
    this.#model?.free();
    [this.#mesh, this.#model] = [mesh, undefined];
    this.forget();
  }

  /** The same of one with its own materials. */
  takeModel(/** @type {import("./model.js").Model} */ model) {
    this.#model?.free();
    [this.#mesh, this.#model] = [undefined, model];
  }

  /** The drawing lost its object, or has another one of the same name. */
  forget() {
    this.#drawn = "";
  }

  /** Gives the object to the drawing, unless it has it. */
  give(/** @type {Drawing} */ drawing, /** @type {string} */ object) {
    this.#model?.hide();
    if (this.#drawn === object) return;
    this.#drawn = object;
    if (object === "sphere") drawing.object(KINDS.sphere);
    if (object === "relief") drawing.object(KINDS.mesh, (meshes.relief ??= relief()));
    if (object === "own") drawing.object(KINDS.mesh, this.#mesh, false);
    if (object === "coin") {
      drawing.object(KINDS.map, (meshes.coin ??= coin()));
      drawing.map(512, (meshes.coinNormals ??= coinNormals(512)));
    }
  }
}
