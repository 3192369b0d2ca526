// A canvas that shows a sphere of a material under a light.

import { checkExposure, checkNames, checkSources, refuse, shown, toneNumber } from "./input.js";
import { lightOf, materialOf } from "./presets.js";
import { renderer } from "./renderer.js";
import { Scene } from "./scene.js";
import { sphere } from "./sphere.js";

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

/** Number of previews that were asked for. */
let asked = 0;

/** @type {WeakMap<HTMLCanvasElement, { number: number, preview?: Preview }>} The last one of a canvas. */
const owners = new WeakMap();

/** @type {WeakMap<HTMLCanvasElement, string>} The labels of canvases that are not the page's own. */
const labels = new WeakMap();

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
  /** @type {{ sources: number | "auto" } | undefined} The same of the light that is loading. */
  #asking;
  /** The exposure of the picture, if it is chosen; it lasts until the light or the material changes. */
  #chosen = 0;
  /** @type {Window | undefined} Whose next frame draws. */
  #frame;
  /** Its signal ends what listens. */
  #end = new AbortController();
  /** Numbers of the inputs that were asked for, and of those that were set: the last one wins. */
  #asked = { light: 0, material: 0 };
  #set = { light: 0, material: 0 };
  /** Draws for this density of the screen, and again once a zoom or another screen changes it. */
  #denser = () => {
    const view = this.#view;
    const query = view.matchMedia(`(resolution: ${view.devicePixelRatio}dppx)`);
    query.addEventListener("change", this.#denser, { once: true, signal: this.#end.signal });
    this.#changed();
  };

  /**
   * A preview, after its light and material are loaded. It frees an earlier one of the canvas.
   *
   * @param {HTMLCanvasElement} canvas
   * @param {import("./input.js").Inputs & Look & { signal?: AbortSignal }} options the signal, once it
   *   is aborted, keeps the preview from being made or frees it
   * @returns {Promise<Preview>}
   * @throws {TypeError | RangeError} for a canvas, a light, a material or a look that is none
   * @throws {DOMException} `AbortError` if a later preview has the canvas by then; the reason of the
   *   signal
   */
  static async create(canvas, options) {
    checkCanvas(canvas);
    checkNames("Preview", options, "light, material, sources, window, engine, assets, exposure, tone, signal");
    const { exposure, tone, signal, ...given } = options;
    const inputs = { ...given, sources: given.sources ?? "auto", window: given.window ?? "auto" };
    const look = { exposure, tone };
    checkLook("Preview", look);
    signal?.throwIfAborted();
    const number = ++asked;
    const scene = await Scene.create(inputs);
    signal?.throwIfAborted();
    if ((owners.get(canvas)?.number ?? 0) > number) {
      throw new DOMException("Preview: a later preview has the canvas", "AbortError");
    }
    const preview = new Preview(canvas, scene, look, inputs.sources);
    owners.set(canvas, { number, preview });
    signal?.addEventListener("abort", () => preview.free(), { once: true, signal: preview.#end.signal });
    return preview;
  }

  /**
   * A preview of a scene. It frees an earlier one of the canvas.
   *
   * @param {HTMLCanvasElement} canvas
   * @param {Scene} scene
   * @param {Look} [look]
   * @param {number | "auto"} [sources] most small sources of later lights by name, `"auto"` by
   *   default; none, if the scene was created without
   */
  constructor(canvas, scene, look = {}, sources = /** @type {number | "auto"} */ ("auto")) {
    checkCanvas(canvas);
    if (!(scene instanceof Scene)) refuse("Preview", scene, "a Scene");
    checkSources(sources);
    const context = canvas.getContext("2d");
    if (!context) throw new TypeError("Preview: the canvas already has a context of another kind");
    this.#canvas = canvas;
    this.#context = context;
    this.#scene = scene;
    this.#sources = sources;
    this.#setLook("Preview", look).draw();
    owners.get(canvas)?.preview?.free();
    owners.set(canvas, { number: ++asked, preview: this });
    if (!canvas.hasAttribute("role")) canvas.setAttribute("role", "img");
    this.#denser();
    const { signal } = this.#end;
    const resized = new this.#view.ResizeObserver(() => this.#changed());
    resized.observe(canvas);
    signal.addEventListener("abort", () => resized.disconnect());
    renderer()?.restored.addEventListener("restored", () => this.#changed(), { signal });
  }

  /** As that of `Scene`. */
  get [Symbol.toStringTag]() {
    return "Preview";
  }

  /** The scene, which also writes shaders and shades normals. Call {@link draw} after changing it. */
  get scene() {
    return this.#scene;
  }

  /**
   * Sets the light.
   *
   * @param {string | Channels} light a preset's name, or coefficients
   * @param {{ sources?: number | "auto" }} [options] most small sources of this light and later ones,
   *   as before by default; a number above 0 only if the preview was not created with 0
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
    this.#frame = undefined;
    this.#describe();
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
    if (this.#freed) return;
    this.#end.abort();
    const owner = owners.get(this.#canvas);
    if (owner?.preview === this) owner.preview = undefined;
  }

  get #freed() {
    return this.#end.signal.aborted;
  }

  /** The window of the canvas, which may be another one than that of this script. */
  get #view() {
    return /** @type {Window & typeof globalThis} */ (this.#canvas.ownerDocument.defaultView ?? globalThis);
  }

  /** Labels the canvas, unless the page does. */
  #describe() {
    const canvas = this.#canvas;
    const { label } = this.#scene;
    const isOurs = (canvas.getAttribute("aria-label") ?? undefined) === labels.get(canvas);
    if (!isOurs || canvas.hasAttribute("aria-labelledby")) return;
    labels.set(canvas, label);
    canvas.setAttribute("aria-label", label);
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
    const view = this.#view;
    const style = view.getComputedStyle(canvas);
    const { width: across, height: down } = style;
    const inside = [
      clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight),
      clientHeight - parseFloat(style.paddingTop) - parseFloat(style.paddingBottom),
    ];
    if (!inside.every((length) => length > 0)) return [0, 0];
    const ratio = Math.min(view.devicePixelRatio, LARGEST / Math.max(...inside));
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
    const view = this.#view;
    if (this.#freed || this.#frame === view) return this;
    this.#frame = view;
    view.requestAnimationFrame(() => {
      if (!this.#freed && this.#frame === view) this.draw();
    });
    return this;
  }

  #alive() {
    if (this.#freed) throw new Error("Preview: it was freed");
  }
}

/** @param {HTMLCanvasElement} canvas */
function checkCanvas(canvas) {
  // Another document has a class of its own for its canvases.
  if (shown(canvas) !== "[object HTMLCanvasElement]") refuse("Preview", canvas, "a canvas of a page");
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
