// <eigen-shade light="park" material="red-fabric2"></eigen-shade>

import { parameters } from "./input.js";
import { lightOf, materialOf } from "./presets.js";
import { Preview, checkLook } from "./preview.js";
import { Scene } from "./scene.js";

/** @typedef {import("./input.js").MetallicRoughness} MetallicRoughness */

const Base = /** @type {typeof HTMLElement} */ (globalThis.HTMLElement ?? Object);

/** Unlike an element `style`, allowed by a page's Content-Security-Policy. */
function sheet() {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(`:host { display: inline-block; width: 12em; aspect-ratio: 1; }
:host([hidden]), [hidden], p:empty { display: none; }
canvas:not([hidden]) { width: 100%; height: 100%; display: block; }`);
  return sheet;
}

/** @type {CSSStyleSheet | undefined} Of all elements. */
let style;

/**
 * A sphere of a material under a light, as an element. Attributes:
 *
 * - `light`, `material`: presets' names;
 * - `base-color`, `metallic`, `roughness`: a glTF material instead of `material`;
 * - `sources`: the largest set of at most this many small sources of the light, for sharp
 *   highlights;
 * - `yaw`, `pitch`, `roll`: the turn of the light, in degrees;
 * - `exposure`, `tone`: from irradiance to display; `exposure` is `auto` by default, and chosen.
 *
 * Attributes that change together are drawn together, before an event `load` or, if the element is
 * not shown, once it is. There is no canvas before the first picture. If an attribute is wrong, the
 * picture stays: the element says why, and so does the `message` of an event `error`. Where there
 * are no elements, as in Node, this module defines none.
 */
export class EigenShade extends Base {
  static observedAttributes = [
    "light", "material", "base-color", "metallic", "roughness", "sources", "yaw", "pitch", "roll", "exposure", "tone",
  ];

  /** @type {Preview | undefined} */
  #preview;
  #canvas;
  #message;
  /** The light and the material of the preview. */
  #set = "";
  #hasSources = false;
  /** The last update that was asked for. */
  #update = 0;

  constructor() {
    super();
    const root = this.attachShadow({ mode: "open" });
    root.innerHTML = `<canvas role="img" hidden></canvas><p role="alert"></p>`;
    root.adoptedStyleSheets = [(style ??= sheet())];
    this.#canvas = /** @type {HTMLCanvasElement} */ (root.querySelector("canvas"));
    this.#message = /** @type {HTMLElement} */ (root.querySelector("p"));
  }

  /** The preview, once it is drawn. */
  get preview() {
    return this.#preview;
  }

  connectedCallback() {
    this.#changed();
  }

  disconnectedCallback() {
    this.#update++;
    this.#free();
  }

  attributeChangedCallback() {
    if (this.isConnected) this.#changed();
  }

  async #changed() {
    const update = ++this.#update;
    // Several attributes that change together are one update.
    await undefined;
    if (update !== this.#update) return;
    try {
      const { light, material, sources, look, turn, label } = this.#read();
      const set = JSON.stringify([light, material, sources]);
      // Sources need another module.
      if (this.#preview && this.#hasSources === sources > 0) {
        // The same inputs again would choose another exposure.
        if (set !== this.#set) {
          // All that can fail comes before what is set.
          const given = await Promise.all([lightOf(light, sources), materialOf(material)]);
          if (update !== this.#update) return;
          const preview = this.#preview;
          await Promise.all([preview.light(given[0], { sources }), preview.material(given[1])]);
        }
      } else {
        const scene = await Scene.create({ light, material, sources });
        if (update !== this.#update) return;
        this.#free();
        // A canvas that is not shown is not drawn, and one without a picture has no name.
        this.#canvas.hidden = false;
        this.#preview = new Preview(this.#canvas, scene, look, sources);
        this.#hasSources = sources > 0;
      }
      this.#set = set;
      if (update !== this.#update) return;
      this.#preview.look(look).turn(turn).draw();
      this.#canvas.setAttribute("aria-label", label);
      this.#message.textContent = "";
      this.dispatchEvent(new Event("load"));
    } catch (fault) {
      if (update !== this.#update) return;
      const message = fault instanceof Error ? fault.message : String(fault);
      this.#message.textContent = message;
      this.dispatchEvent(new ErrorEvent("error", { message, error: fault }));
    }
  }

  #free() {
    this.#preview?.free();
    this.#preview = undefined;
  }

  /** What the attributes say. */
  #read() {
    const number = (/** @type {string} */ name, /** @type {number} */ otherwise) => {
      const text = this.getAttribute(name);
      if (text === null) return otherwise;
      const value = text.trim() === "" ? NaN : Number(text);
      if (!Number.isFinite(value)) throw new RangeError(`${name}="${text}" is not a number`);
      return value;
    };
    const light = this.getAttribute("light") ?? "park";
    const name = this.getAttribute("material");
    /** @type {string | MetallicRoughness} */
    const material = name ?? {
      baseColor: this.getAttribute("base-color") ?? "#ffffff",
      metallic: number("metallic", 0),
      roughness: number("roughness", 0.5),
    };
    if (typeof material !== "string") parameters(material);
    const exposure = this.getAttribute("exposure")?.trim() ?? "auto";
    /** @type {import("./preview.js").Look} */
    const look = {
      exposure: exposure === "auto" ? exposure : number("exposure", 1),
      tone: /** @type {import("./input.js").Tone} */ (this.getAttribute("tone") ?? "filmic"),
    };
    checkLook("look", look);
    const [yaw, pitch, roll] = ["yaw", "pitch", "roll"].map(
      (angle) => (number(angle, 0) * Math.PI) / 180,
    );
    return {
      light,
      material,
      sources: number("sources", 0),
      look,
      turn: { yaw, pitch, roll },
      label: `A sphere of ${name ?? "a glTF material"} under the light ${light}`,
    };
  }
}

globalThis.customElements?.define("eigen-shade", EigenShade);
