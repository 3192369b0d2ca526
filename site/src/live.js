// The light that follows, the slider, and the numbers of the first sight.

import { CHIPS, frameOf } from "./boards.js";
import { busy, find } from "./dom.js";
import { ALL_TERMS, toleranceOf } from "./measure.js";
import { Parts, normalsOf } from "./parts.js";
import { lookUp } from "./packed.js";
import { colorsOf, screenError, seen } from "./screen.js";

/** The color difference is measured in every 23rd pixel. */
const SPACING = 23;
/** The display of the frames. */
const DISPLAY = 240;

/** @typedef {import("./packed.js").Packed} Packed */

export class Live {
  /** Called when the slider needs a new picture. */
  changed = () => {};
  #object;
  #paint;
  #parts;
  #palettes;
  #pixels;
  #turn = [0, 0, 0, 1];
  #idle = 0;
  #isAwaited = false;

  /**
   * @param {Packed} object
   * @param {(palettes: Float32Array) => void} paint
   */
  static async create(object, paint) {
    return new Live(object, paint, await Parts.create(object.about.regions));
  }

  /**
   * @param {Packed} object
   * @param {(palettes: Float32Array) => void} paint
   * @param {Parts} parts
   */
  constructor(object, paint, parts) {
    this.#object = object;
    this.#paint = paint;
    this.#parts = parts;
    this.#palettes = object.palettes.slice();
    this.#pixels = sampled(object);
    find("chip").append(...CHIPS.map(({ name }) => new Option(name)));
    find("chip").value = "RP2350";
    find("first-step").disabled = false;
    find("first-step").addEventListener("input", () => {
      find("open-details").href = `#step=${find("first-step").value}`;
      this.announce();
      this.changed();
    });
    find("chip").addEventListener("change", () => this.#showFrames());
  }

  /** Turns the light. */
  turn(/** @type {number[]} */ turn) {
    this.#turn = turn;
  }

  /** The step of the slider. */
  get #step() {
    return Number(find("first-step").value);
  }

  /** Turns the light, and takes the terms of a step, by default that of the slider. */
  #set(step = this.#step) {
    this.#parts.set(this.#turn, toleranceOf(step), this.#object.about.exposure);
  }

  /** Another picture will follow. */
  announce() {
    this.#isAwaited = true;
    busy(true);
  }

  /** Draws the picture, and its numbers a little later. `isAwaited`: another picture follows. */
  draw(isAwaited = false) {
    this.#isAwaited = isAwaited;
    busy(true);
    this.#set();
    this.#paint(this.#parts.palettes(this.#object.about.exposure, this.#palettes));
    this.#showFrames();
    this.#idle ||= setTimeout(() => {
      this.#idle = 0;
      this.#showError();
    }, 150);
  }

  /** Saves a file of this kind of the egg as it is shown. */
  async download(/** @type {string} */ kind) {
    const [{ texts }, { download }] = await Promise.all([import("./take-egg.js"), import("./download.js")]);
    this.#set();
    const { exposure, regions } = this.#object.about;
    const seen = { turn: this.#turn, exposure, regions, tolerance: toleranceOf(this.#step) ?? 0 };
    const name = kind === "py" ? "gold-sphere.py" : `egg.${kind}`;
    await download(kind, name, find("object"), texts(this.#parts.scenes, seen));
  }

  #showFrames() {
    const chip = CHIPS.find(({ name }) => name === find("chip").value) ?? CHIPS[0];
    const { height, about: { regions } } = this.#object;
    const covered = regions.reduce((/** @type {number} */ sum, /** @type {any} */ { pixels }) => sum + pixels, 0);
    const frame = frameOf(chip.board, this.#parts.costs, covered * (DISPLAY / height) ** 2);
    const rate = chip.clock / frame;
    find("frames").textContent = rate < 9.95 ? rate.toFixed(1) : rate.toFixed(0);
    find("frame-cost").textContent = `${(frame / 1e6).toFixed(1)} million instructions of a ${chip.core} at ${chip.clock / 1e6} MHz${chip.counted ? `, ${chip.counted}` : ""}`;
    this.#describe();
  }

  /**
   * The color difference of the picture from one of all terms in every pixel, plus that of all terms from
   * direct integration under the whole map, which is known of spheres of like materials and stays
   * at any accuracy.
   */
  error() {
    const { about: { exposure, regions } } = this.#object;
    const found = { r: [], g: [], b: [] };
    const light = [0, 0, 0];
    for (const { pixels } of this.#pixels) {
      for (const pixel of pixels) {
        lookUp(this.#object, this.#palettes, pixel, light);
        ["r", "g", "b"].forEach((channel, c) => found[channel].push(light[c]));
      }
    }
    this.#set(ALL_TERMS);
    const exact = { r: [], g: [], b: [] };
    this.#pixels.forEach(({ pixels, normals }, region) => {
      const [black, white] = this.#parts.shade(region, normals);
      pixels.forEach((pixel, k) => {
        const color = 4 * this.#object.texels[4 * pixel + 2];
        ["r", "g", "b"].forEach((channel, c) =>
          exact[channel].push(exposure * (black[channel][k] + this.#object.colors[color + c] * (white[channel][k] - black[channel][k]))),
        );
      });
    });
    this.#set();
    const error = { ...screenError(colorsOf(/** @type {any} */ (found), 1), colorsOf(/** @type {any} */ (exact), 1)), stays: 0 };
    const all = found.r.length;
    regions.forEach((/** @type {any} */ { direct }, /** @type {number} */ k) => {
      const share = this.#pixels[k].pixels.length / all;
      error.stays += share * direct.mean;
      error.most += share * direct.most;
    });
    error.mean += error.stays;
    return error;
  }

  /** Says the numbers as the value of the slider. */
  #describe() {
    find("first-step").setAttribute("aria-valuetext", `color difference ${find("difference").textContent}, ${find("frames").textContent} frames a second`);
  }

  #showError() {
    if (find("first").hidden) return;
    const error = this.error();
    find("difference").textContent = error.mean.toFixed(1);
    find("seen").textContent = seen(error);
    find("most").textContent = error.most.toFixed(1);
    find("stays").textContent = error.stays.toFixed(1);
    this.#describe();
    busy(this.#isAwaited);
  }
}

/**
 * Pixels of each region that the object covers completely, and their normals.
 *
 * @param {Packed} object
 */
function sampled({ texels, about: { regions } }) {
  const pixels = regions.map(() => /** @type {number[]} */ ([]));
  for (let k = 0; k < texels.length / 4; k += SPACING) {
    const covered = texels[4 * k + 3];
    if (covered >> 2 === 63) pixels[covered & 3].push(k);
  }
  return pixels.map((/** @type {number[]} */ of) => {
    const [u, v] = [0, 1].map((axis) => of.map((pixel) => texels[4 * pixel + axis] - 128));
    return { pixels: of, normals: normalsOf(u, v) };
  });
}
