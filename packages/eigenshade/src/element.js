// <eigen-shade light="park" material="red-fabric2"></eigen-shade>

import { Preview, Scene } from "./index.js";
import { isChannels, parameters } from "./input.js";
import { lightOf, materialOf } from "./presets.js";
import { checkLook } from "./preview.js";
import { checkWindow } from "./window.js";

/** @typedef {import("./input.js").MetallicRoughness} MetallicRoughness */

const Base = /** @type {typeof HTMLElement} */ (globalThis.HTMLElement ?? Object);

/** The attributes of which a picture is made anew; the others change how it is shown. */
const INPUTS = ["light", "material", "base-color", "metallic", "roughness", "sources", "window"];

/** The attributes in whose place an object may be given. */
const OBJECTS = ["light", "material", "base-color"];

/** The property of an attribute. */
const property = (/** @type {string} */ attribute) => attribute.replace("-c", "C");

/** @type {WeakMap<Document, CSSStyleSheet>} Of all elements of a document. */
const sheets = new WeakMap();

/** Unlike an element `style`, allowed by a page's Content-Security-Policy. */
function sheet(/** @type {Document} */ document) {
  let found = sheets.get(document);
  if (!found) {
    found = new (document.defaultView ?? globalThis).CSSStyleSheet();
    found.replaceSync(`:host { display: inline-block; width: 12em; aspect-ratio: 1; }
:host([hidden]), [hidden], p:empty { display: none; }
canvas:not([hidden]) { width: 100%; height: 100%; display: block; }`);
    sheets.set(document, found);
  }
  return found;
}

/**
 * A sphere of a material under a light, as an element. Attributes:
 *
 * - `light`, `material`: presets' names;
 * - `base-color`, `metallic`, `roughness`: a glTF material; with `material`, an error;
 * - `sources`: how many of the light's small sources are drawn, at most, for sharp highlights;
 *   `auto` by default, as few as the material needs;
 * - `window`: the width of a window over the light, `none`, or `auto`, the default;
 * - `yaw`, `pitch`, `roll`: the turn of the light, in degrees;
 * - `exposure`, `tone`: from irradiance to display; `exposure` is `auto` by default, and chosen.
 *
 * Each is a property, too, whose name is in camel case: `element.yaw = 30` sets the attribute.
 * `element.light = { r, g, b }` gives coefficients, and `element.material = { roughness: 0.3 }` a
 * glTF material, until the attribute or the property is set again.
 *
 * Attributes that change together are drawn together, before an event `load` or, if the element is
 * not shown, once it is. There is no canvas before the first picture. If an attribute is wrong, the
 * picture stays: the element says why, and so does the `message` of an event `error`. Where there
 * are no elements, as in Node, this module defines none.
 */
class Sphere extends Base {
  static observedAttributes = [...INPUTS, "yaw", "pitch", "roll", "exposure", "tone"];

  /** @type {Preview | undefined} */
  #preview;
  #canvas;
  #message;
  /** @type {Map<string, { value: any, number: number }>} In place of attributes, numbered. */
  #objects = new Map();
  #count = 0;
  /** The light and the material of the preview. */
  #set = "";
  #hasSources = false;
  /** The last update that was asked for. */
  #update = 0;

  static {
    for (const attribute of this.observedAttributes) {
      Object.defineProperty(this.prototype, property(attribute), {
        configurable: true,
        enumerable: true,
        /** @this {Sphere} */
        get() {
          const given = this.#value(attribute);
          const isNumber = typeof given === "string" && given.trim() !== "" && !isNaN(Number(given));
          return isNumber ? Number(given) : given;
        },
        /** @this {Sphere} */
        set(value) {
          this.#give(attribute, value);
        },
      });
    }
  }

  constructor() {
    super();
    const root = this.attachShadow({ mode: "open" });
    // Not as a text, which a page may forbid.
    this.#canvas = this.ownerDocument.createElement("canvas");
    this.#canvas.setAttribute("role", "img");
    this.#canvas.hidden = true;
    this.#message = this.ownerDocument.createElement("p");
    this.#message.setAttribute("role", "alert");
    root.append(this.#canvas, this.#message);
  }

  /** The preview, once it is drawn. */
  get preview() {
    return this.#preview;
  }

  connectedCallback() {
    // Another document takes no sheet of the one before.
    /** @type {ShadowRoot} */ (this.shadowRoot).adoptedStyleSheets = [sheet(this.ownerDocument)];
    // Properties that were set before the element was defined.
    for (const name of Sphere.observedAttributes.map(property)) {
      const element = /** @type {any} */ (this);
      if (!Object.hasOwn(element, name)) continue;
      const value = element[name];
      delete element[name];
      element[name] = value;
    }
    this.#changed();
  }

  disconnectedCallback() {
    this.#update++;
    this.#free();
  }

  /** @param {string} name */
  attributeChangedCallback(name) {
    this.#objects.delete(name);
    if (this.isConnected) this.#changed();
  }

  /**
   * @param {string} attribute
   * @returns {any}
   */
  #value(attribute) {
    return this.#objects.get(attribute)?.value ?? this.getAttribute(attribute);
  }

  /**
   * @param {string} attribute
   * @param {unknown} value
   */
  #give(attribute, value) {
    if (value !== null && typeof value === "object" && OBJECTS.includes(attribute)) {
      this.#objects.set(attribute, { value, number: ++this.#count });
    } else {
      this.#objects.delete(attribute);
      if (value === null || value === undefined) this.removeAttribute(attribute);
      else this.setAttribute(attribute, String(value));
    }
    if (this.isConnected) this.#changed();
  }

  async #changed() {
    const update = ++this.#update;
    // Several attributes that change together are one update.
    await undefined;
    if (update !== this.#update) return;
    try {
      const { light, material, sources, window, look, turn } = this.#read();
      const inputs = INPUTS.map((name) => this.#objects.get(name)?.number ?? this.#value(name));
      const set = JSON.stringify(inputs);
      const hasSources = sources !== 0 || Boolean(light.sources?.length);
      // Sources need another module.
      if (this.#preview && this.#hasSources === hasSources) {
        // The same inputs again would choose another exposure.
        if (set !== this.#set) {
          // All that can fail comes before what is set.
          const given = await Promise.all([lightOf(light, sources), materialOf(material)]);
          if (update !== this.#update) return;
          const preview = this.#preview;
          await Promise.all([preview.light(given[0], { sources }), preview.material(given[1])]);
          preview.scene.window(window);
        }
      } else {
        const scene = await Scene.create({ light, material, sources, window });
        if (update !== this.#update) return;
        this.#free();
        // A canvas that is not shown is not drawn, and one without a picture has no name.
        this.#canvas.hidden = false;
        this.#preview = new Preview(this.#canvas, scene, look, sources);
        this.#hasSources = hasSources;
      }
      this.#set = set;
      if (update !== this.#update) return;
      this.#preview.look(look).turn(turn).draw();
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

  /** What the attributes and properties say. */
  #read() {
    const number = (/** @type {string} */ name, /** @type {number} */ otherwise) => {
      const text = this.getAttribute(name);
      if (text === null) return otherwise;
      const value = text.trim() === "" ? NaN : Number(text);
      if (!Number.isFinite(value)) throw new RangeError(`${name}="${text}" is not a number`);
      return value;
    };
    const given = this.#value("material");
    const glTF = ["base-color", "metallic", "roughness"];
    const beside = glTF.find((name) => this.#value(name) !== null);
    if (given !== null && beside) {
      throw new TypeError(`${beside} is beside material; leave out one of them`);
    }
    /** @type {string | import("./input.js").Channels | MetallicRoughness} */
    const material = given ?? {
      baseColor: this.#value("base-color") ?? "#ffffff",
      metallic: number("metallic", 0),
      roughness: number("roughness", 0.5),
    };
    if (typeof material !== "string" && !isChannels(material)) parameters(material);
    /** A number, `"auto"`, which is the default, or another word. */
    const choice = (/** @type {string} */ name, other = "auto") => {
      const word = this.getAttribute(name)?.trim() ?? "auto";
      return word === "auto" || word === other ? /** @type {"auto"} */ (word) : number(name, 0);
    };
    /** @type {import("./preview.js").Look} */
    const look = {
      exposure: choice("exposure"),
      tone: /** @type {import("./input.js").Tone} */ (this.getAttribute("tone") ?? "filmic"),
    };
    checkLook("look", look);
    const window = /** @type {import("./window.js").Window} */ (choice("window", "none"));
    checkWindow(window);
    const [yaw, pitch, roll] = ["yaw", "pitch", "roll"].map(
      (angle) => (number(angle, 0) * Math.PI) / 180,
    );
    return {
      light: this.#value("light") ?? "park",
      material,
      sources: choice("sources"),
      window,
      look,
      turn: { yaw, pitch, roll },
    };
  }
}

const registered = globalThis.customElements?.get("eigen-shade");
if (!registered) globalThis.customElements?.define("eigen-shade", Sphere);

/** The class of the page's elements: that of another copy of this package, if it came first. */
export const EigenShade = /** @type {typeof Sphere} */ (registered ?? Sphere);
