// A canvas that shows a sphere of a material under a light.

import { checkExposure, checkNames, checkSources, refuse, toneNumber } from "./input.js";
import { lightOf, materialOf } from "./presets.js";
import { renderer, sphere } from "./renderer.js";
import { Scene } from "./scene.js";

/** @typedef {import("./input.js").Channels} Channels */
/**
 * How the picture is shown. The exposure is the factor from irradiance to display; `"auto"`, the
 * default, chooses it anew for each light and material of the preview, but not when the light
 * turns, or its {@link Preview#scene | scene} is changed. The tone curve is `"filmic"` by default.
 *
 * @typedef {{ exposure?: number | "auto", tone?: import("./input.js").Tone }} Look
 */
/** @typedef {import("./input.js").MetallicRoughness} MetallicRoughness */
/** @typedef {import("./input.js").Turn} Turn */

/** Most pixels of a side. */
const LARGEST = 4096;

/** The canvases of previews. */
const taken = new WeakSet();

/**
 * A sphere on a canvas. It is drawn anew in the next frame after a change, as large as the canvas is
 * shown.
 *
 * All previews of a page share one WebAssembly module and one WebGL context. Without WebGL 2, or
 * while the context is lost, the CPU draws.
 */
export class Preview {
  #canvas;
  #context;
  #scene;
  /** @type {Required<Look>} */
  #look = { exposure: "auto", tone: "filmic" };
  /** The most small sources of lights by name, as the present light has them. */
  #sources;
  /** @type {{ sources: number } | undefined} The same of the light that is loading. */
  #asking;
  /** The exposure of the picture, if it is chosen; it lasts until the light or the material changes. */
  #chosen = 0;
  #frame = 0;
  #freed = false;
  /** Numbers of the inputs that were asked for, and of those that were set: the last one wins. */
  #asked = { light: 0, material: 0 };
  #set = { light: 0, material: 0 };
  #resized;
  #restored = () => this.#changed();
  /** @type {MediaQueryList | undefined} */
  #density;
  /** Draws for this density of the screen, and again once a zoom or another screen changes it. */
  #denser = () => {
    this.#density = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
    this.#density.addEventListener("change", this.#denser, { once: true });
    this.#changed();
  };

  /**
   * A preview, after its light and material are loaded.
   *
   * @param {HTMLCanvasElement} canvas
   * @param {import("./input.js").Inputs & Look} options
   * @returns {Promise<Preview>}
   * @throws {TypeError | RangeError} for a canvas, a light, a material or a look that is none
   * @throws {Error} if the canvas has a preview that is not freed
   */
  static async create(canvas, options) {
    checkCanvas(canvas);
    checkNames("Preview", options, "light, material, sources, engine, exposure, tone");
    const { exposure, tone, ...inputs } = options;
    const look = { exposure, tone };
    checkLook("Preview", look);
    return new Preview(canvas, await Scene.create(inputs), look, inputs.sources);
  }

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Scene} scene
   * @param {Look} [look]
   * @param {number} [sources] most small sources of later lights by name, 0 by default
   */
  constructor(canvas, scene, look = {}, sources = 0) {
    checkCanvas(canvas);
    if (!(scene instanceof Scene)) refuse("Preview", scene, "a Scene");
    checkSources(sources);
    if (taken.has(canvas)) throw new Error("Preview: the canvas has a preview; free it first");
    const context = canvas.getContext("2d");
    if (!context) throw new TypeError("Preview: the canvas already has a context of another kind");
    this.#canvas = canvas;
    this.#context = context;
    this.#scene = scene;
    this.#sources = sources;
    this.#resized = new ResizeObserver(() => this.#changed());
    this.#setLook("Preview", look).draw();
    taken.add(canvas);
    this.#denser();
    this.#resized.observe(canvas);
    renderer()?.restored.addEventListener("restored", this.#restored);
  }

  /** The scene, which also writes shaders and shades normals. Call {@link draw} after changing it. */
  get scene() {
    return this.#scene;
  }

  /**
   * Sets the light.
   *
   * @param {string | Channels} light a preset's name, or coefficients
   * @param {{ sources?: number }} [options] most small sources of this light and later ones, as before
   *   by default; more than 0 only if the preview was created with some
   * @returns {Promise<this>} once it is set; the last of several lights wins
   * @throws {TypeError | RangeError} as {@link Scene#light}; the picture then stays
   */
  async light(light, options = {}) {
    this.#alive();
    checkNames("light", options, "sources");
    const { sources = this.#asking?.sources ?? this.#sources } = options;
    checkSources(sources);
    const asking = (this.#asking = { sources });
    try {
      return await this.#load("light", lightOf(light, sources), (loaded) => {
        this.#scene.light(loaded);
        this.#sources = sources;
      });
    } finally {
      if (this.#asking === asking) this.#asking = undefined;
    }
  }

  /**
   * Sets the material.
   *
   * @param {string | Channels | MetallicRoughness} material a preset's name, coefficients, or the
   *   parameters of a glTF material
   * @returns {Promise<this>} once it is set; the last of several materials wins
   * @throws {TypeError | RangeError} as {@link Scene#material}; the picture then stays
   */
  async material(material) {
    this.#alive();
    return this.#load("material", materialOf(material), (loaded) => this.#scene.material(loaded));
  }

  /**
   * Turns the light.
   *
   * @param {Turn} turn
   * @returns {this}
   * @throws {TypeError | RangeError} as {@link Scene#turn}; the picture then stays
   */
  turn(turn) {
    this.#alive();
    this.#scene.turn(turn);
    return this.#changed();
  }

  /**
   * Sets the exposure and the tone curve.
   *
   * @param {Look} look what is left out stays
   * @returns {this}
   * @throws {TypeError | RangeError} for an exposure that is no normal f32 above 0, an unknown
   *   curve or name
   */
  look(look) {
    this.#alive();
    return this.#setLook("look", look).#changed();
  }

  /** Draws now instead of in the next frame. A canvas that is not shown is drawn once it is. */
  draw() {
    this.#alive();
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    const [width, height] = this.#resize();
    if (!width) return this;
    const size = Math.min(width, height);
    const place = [Math.floor((width - size) / 2), Math.floor((height - size) / 2)];
    const { exposure: given, tone } = this.#look;
    const exposure = given === "auto" ? (this.#chosen ||= this.#scene.exposure()) : given;
    const drawn = renderer()?.draw(this.#scene, size, { exposure, tone });
    this.#context.clearRect(0, 0, width, height);
    if (drawn) {
      this.#context.drawImage(drawn, place[0], place[1]);
    } else {
      const pixels = sphere(this.#scene, size, { exposure, tone });
      this.#context.putImageData(new ImageData(pixels, size, size), place[0], place[1]);
    }
    return this;
  }

  /** Ends the preview; the canvas keeps its picture. Later calls throw an `Error`. */
  free() {
    // A canvas that was freed may have another preview by now.
    if (!this.#freed) taken.delete(this.#canvas);
    this.#freed = true;
    cancelAnimationFrame(this.#frame);
    this.#resized.disconnect();
    this.#density?.removeEventListener("change", this.#denser);
    renderer()?.restored.removeEventListener("restored", this.#restored);
  }

  /**
   * Gives the canvas the pixels of the screen that it covers inside its padding, at most 4096 a
   * side.
   *
   * @returns {number[]} width and height; 0 and 0 if the canvas is not shown
   */
  #resize() {
    const canvas = this.#canvas;
    const { clientWidth, clientHeight } = canvas;
    const style = getComputedStyle(canvas);
    const { width: across, height: down } = style;
    const inside = [
      clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight),
      clientHeight - parseFloat(style.paddingTop) - parseFloat(style.paddingBottom),
    ];
    if (!inside.every((length) => length > 0)) return [0, 0];
    const ratio = Math.min(devicePixelRatio, LARGEST / Math.max(...inside));
    const [width, height] = inside.map((length) => Math.max(1, Math.round(ratio * length)));
    if (canvas.width !== width || canvas.height !== height) {
      [canvas.width, canvas.height] = [width, height];
      // Without a size in CSS it would grow with its pixels.
      if (canvas.clientWidth !== clientWidth) canvas.style.width = across;
      if (canvas.clientHeight !== clientHeight) canvas.style.height = down;
    }
    return [width, height];
  }

  /**
   * @param {string} what
   * @param {Look} look
   */
  #setLook(what, look) {
    checkLook(what, look);
    const { exposure = this.#look.exposure, tone = this.#look.tone } = look;
    this.#look = { exposure, tone };
    return this;
  }

  /**
   * @template T
   * @param {"light" | "material"} what
   * @param {T | Promise<T>} input
   * @param {(loaded: T) => void} set
   */
  async #load(what, input, set) {
    const asked = ++this.#asked[what];
    const loaded = await input;
    // Input that fails does not keep an earlier one from being set.
    if (asked > this.#set[what] && !this.#freed) {
      set(loaded);
      this.#set[what] = asked;
      this.#chosen = 0;
      this.#changed();
    }
    return this;
  }

  #changed() {
    if (!this.#freed) this.#frame ||= requestAnimationFrame(() => this.draw());
    return this;
  }

  #alive() {
    if (this.#freed) throw new Error("Preview: it was freed");
  }
}

/** @param {HTMLCanvasElement} canvas */
function checkCanvas(canvas) {
  if (!(globalThis.HTMLCanvasElement && canvas instanceof HTMLCanvasElement)) {
    refuse("Preview", canvas, "a canvas of this page");
  }
}

/**
 * @param {string} what
 * @param {Look} look
 */
export function checkLook(what, look) {
  checkNames(what, look, "exposure, tone");
  const { exposure = "auto", tone = "filmic" } = look;
  if (exposure !== "auto") checkExposure(what, exposure);
  toneNumber(what, tone);
}
