// <eigen-shade light="park" material="red-fabric2"></eigen-shade>

import { Preview } from "./preview.js";

/** @typedef {import("./input.js").MetallicRoughness} MetallicRoughness */

/**
 * A sphere of a material under a light, as an element. Attributes:
 *
 * - `light`, `material`: presets' names;
 * - `base-color`, `metallic`, `roughness`: a glTF material instead of `material`;
 * - `sources`: most small sources of the light, for sharp highlights;
 * - `yaw`, `pitch`, `roll`: the turn of the light, in degrees;
 * - `exposure`, `tone`: from irradiance to display; without `exposure`, it is chosen.
 *
 * An attribute that is wrong is said in the element, and in an event `error` whose `message` says it.
 */
export class EigenShade extends HTMLElement {
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
    root.innerHTML = `<style>
      :host { display: inline-block; width: 12em; aspect-ratio: 1; }
      :host([hidden]) { display: none; }
      canvas { width: 100%; height: 100%; display: block; }
      p:empty { display: none; }
    </style><canvas role="img"></canvas><p role="alert"></p>`;
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
    this.#preview?.free();
    this.#preview = undefined;
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
          await Promise.all([this.#preview.light(light, { sources }), this.#preview.material(material)]);
        }
      } else {
        const preview = await Preview.create(this.#canvas, { light, material, sources });
        if (update !== this.#update) return preview.free();
        this.#preview?.free();
        [this.#preview, this.#hasSources] = [preview, sources > 0];
      }
      this.#set = set;
      if (update !== this.#update) return;
      this.#preview.look(look).turn(turn);
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
    const [yaw, pitch, roll] = ["yaw", "pitch", "roll"].map(
      (angle) => (number(angle, 0) * Math.PI) / 180,
    );
    return {
      light,
      material,
      sources: number("sources", 0),
      look: {
        exposure: this.hasAttribute("exposure") ? number("exposure", 1) : /** @type {const} */ ("auto"),
        tone: /** @type {import("./input.js").Tone} */ (this.getAttribute("tone") ?? "filmic"),
      },
      turn: { yaw, pitch, roll },
      label: `A sphere of ${name ?? "a glTF material"} under the light ${light}`,
    };
  }
}

customElements.define("eigen-shade", EigenShade);
