// A coin with the shadows that it casts on itself, and without them, in the page's light. This script
// and its files are loaded when they are needed.

import { Scene } from "../eigenshade/src/index.js";
import { ShadowedObject } from "../eigenshade/src/shadowed.js";
import { show } from "./cpu.js";
import { find } from "./dom.js";

/** The share of the automatic exposure, with which lit metal would be white beside its shadows. */
const DARKER = 0.5;

/** The material of the coin, a gray metal. */
const MATERIAL = { baseColor: [0.9, 0.9, 0.9], metallic: 1, roughness: 0.5 };

/** A file that `site/build` made. */
async function file(/** @type {string} */ name) {
  const response = await fetch(new URL(`../shadows/${name}`, import.meta.url));
  if (!response.ok) throw new Error(`shadows/${name}: ${response.status} ${response.statusText}; run site/build`);
  return response;
}

/** @type {Promise<Coin> | undefined} */
let loading;
/** The coin, once it is loaded. */
let coin = /** @type {Coin | undefined} */ (undefined);
let isDescribed = false;

/**
 * Shows the panel, and the coin from the first time on that the switch is on.
 *
 * @param {import("./state.js").State} state
 * @param {import("./state.js").Light} light
 */
export async function showShadows({ shadows: hasShadows, turn, exposure }, light) {
  if (!isDescribed) describe(await (await file("about.json")).json());
  isDescribed = true;
  if (hasShadows && !coin) {
    loading ??= Coin.load();
    // A failed download may be tried again.
    loading.catch(() => (loading = undefined));
    coin = await loading;
  }
  if (!coin) return;
  const canvas = find("shadowed");
  coin.draw(canvas, { light, turn, exposure: 2 ** exposure }, hasShadows);
  canvas.parentElement.hidden = false;
  canvas.setAttribute("aria-label", `A coin ${hasShadows ? "with" : "without"} shadows`);
  for (const [id, isShown] of [["shadowed-with", hasShadows], ["shadowed-without", !hasShadows]]) {
    if (isShown) find(/** @type {string} */ (id)).setAttribute("aria-current", "true");
    else find(/** @type {string} */ (id)).removeAttribute("aria-current");
  }
}

/**
 * Shows the errors of each way, the mean CIEDE2000 and the rms in percent of white of the median
 * picture, and bytes.
 *
 * @typedef {{ rms: number, mean: number }} Errors
 * @param {{ without: Errors, with: Errors, bytes: Record<"object" | "normals" | "module", number> }} about
 */
function describe({ bytes, ...errors }) {
  const kilobytes = (/** @type {number[]} */ ...counts) => `${Math.round(counts.reduce((a, b) => a + b) / 1000)}\u00a0KB`;
  const { object, normals, module } = bytes;
  find("shadowed-bytes").textContent =
    `${kilobytes(object)}, loaded when it is turned on, with ${kilobytes(normals, module)} of normals and code.`;
  for (const way of /** @type {const} */ (["without", "with"])) {
    const [mean, rms] = find(`shadowed-${way}`).querySelectorAll("td");
    const digits = (/** @type {number} */ value) => value.toFixed(value < 9.95 ? 1 : 0);
    mean.textContent = digits(errors[way].mean);
    rms.textContent = `${digits(errors[way].rms)}\u00a0%`;
  }
}

class Coin {
  #object;
  #scene;
  /** The normals of the pixels, component by component. */
  #normals;
  #light = /** @type {unknown} */ (undefined);
  #exposure = 1;

  static async load() {
    const [bytes, codes] = await Promise.all(["object.bin", "normals.bin"].map(async (name) => (await file(name)).arrayBuffer()));
    const light = { r: [1], g: [1], b: [1] };
    const made = await Promise.all([ShadowedObject.load(bytes), Scene.create({ light, material: MATERIAL })]);
    return new Coin(...made, normalsOf(new Int8Array(codes)));
  }

  /**
   * @param {ShadowedObject} object
   * @param {Scene} scene
   * @param {Float32Array[]} normals
   */
  constructor(object, scene, normals) {
    [this.#object, this.#scene, this.#normals] = [object, scene, normals];
  }

  /**
   * Draws the coin. Its exposure is the same with and without shadows.
   *
   * @param {HTMLCanvasElement} canvas
   * @param {{ light: import("./state.js").Light, turn: number[], exposure: number }} look the exposure
   *   is a factor of the automatic one
   * @param {boolean} hasShadows
   */
  draw(canvas, { light, turn, exposure }, hasShadows) {
    if (this.#light !== light) {
      const { r, g, b } = light;
      this.#object.light(light);
      // Without its sources, as the object.
      this.#scene.light({ r, g, b });
      [this.#light, this.#exposure] = [light, this.#object.exposure()];
    }
    const look = { exposure: DARKER * exposure * this.#exposure };
    const { width, height } = this.#object;
    const picture = this.#object.turn(turn).pixels(look);
    if (!hasShadows) {
      const [x, y, z] = this.#normals;
      const plain = this.#scene.turn(turn).pixels(x, y, z, look);
      for (let at = 0; at < picture.length; at += 4) picture.set(plain.subarray(at, at + 3), at);
    }
    show(canvas, new ImageData(picture, width, height));
  }
}

/** The unit normals of a `NormalMap`'s codes; toward the camera where there is none. */
function normalsOf(/** @type {Int8Array} */ codes) {
  const axes = [0, 1, 2].map(() => new Float32Array(codes.length / 2));
  axes[0].forEach((_, k) => {
    const [u, v] = codes.subarray(2 * k);
    const length = Math.hypot(u, v);
    const angle = (Math.PI / 2) * Math.min(1, length / 127);
    const scale = length > 0 && length < 128.5 ? Math.sin(angle) / length : 0;
    [axes[0][k], axes[1][k], axes[2][k]] = scale ? [u * scale, v * scale, Math.cos(angle)] : [0, 0, 1];
  });
  return axes;
}
